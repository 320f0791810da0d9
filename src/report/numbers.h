// What a study leaves: numbers only, each under a key that names it, with what made it and what it depends on. The words
// about them are a chapter's (validation/page/chapters).
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/sources.h"

namespace furrow {

using Json = nlohmann::ordered_json;

// A number as it is kept: the nearest to its decimal of so many significant digits.
double to_digits(double value, int digits);

// "2026-01-31T12:00:00Z"
std::string now_in_utc();

// What made results: shared by all those of one call of the program.
struct Maker {
  std::string commit, when, compiler, flags, machine;  // when: UTC, "2026-01-31T12:00:00Z"
  double load = 0;                                     // of the machine when it began, processes that want to run
  Sources sources;  // those that decide the numbers; empty in files of an earlier form, which do not say
  bool operator==(const Maker&) const = default;
};

Maker this_maker(const Sources& sources);
Json json_of(const Maker& maker);
Maker maker_of(const Json& json);

// The place of a maker in a list, to which it is added if it is new.
std::size_t place_in(std::vector<Maker>& makers, const Maker& maker);

// Of a file that is no study's: what its list "makers" has at the place that the result names under `key`. Of a file of
// an earlier form, which has no such list, what the result or the file says of commit, day and machine. Throws
// std::out_of_range or what nlohmann::json throws.
Maker maker_in(const Json& kept, const Json& result, const char* key = "maker");

struct Result {
  std::string key;    // names it among all results of the study: scene, method, settings, seed
  std::string input;  // hash of what goes into it: its scene, what is asked of it; empty if nothing does
  bool timed = false;
  double cpu = 0;  // s, what it took
  std::size_t maker = 0;
  Json value;  // {"failed": why} if the method or the scene failed: a result too
  bool failed() const { return value.is_object() && value.contains("failed"); }
};

// The results of one form of a study.
class Numbers {
 public:
  Numbers() = default;
  Numbers(std::string study, std::string form) : study_(std::move(study)), form_(std::move(form)) {}
  // Throws FileError if the file is missing, cut, changed by hand or of another schema.
  static Numbers read(const std::filesystem::path& file);
  // Of what write() or line() has written; `file` is named in errors.
  static Numbers of(const Json& kept, const std::filesystem::path& file);
  // Whether a text is what write() has written, whole or not: one that may be replaced.
  static bool is_one(const std::string& study, const std::string& text);
  void write(const std::filesystem::path& file) const;
  // All of it in one line, sealed.
  std::string line() const;

  const std::string& study() const { return study_; }
  bool quick() const { return form_ == "quick"; }
  const std::string& form() const { return form_; }
  const std::vector<Maker>& makers() const { return makers_; }
  const std::vector<Result>& results() const { return results_; }

  // Null if there is none of that key.
  const Result* find(const std::string& key) const;
  // The value of a result. Throws std::out_of_range that names study and key.
  const Json& at(const std::string& key) const;

  // A result that replaces one of the same key.
  void add(Result result, const Maker& maker);

 private:
  Json json() const;

  std::string study_, form_;
  std::vector<Maker> makers_;
  std::vector<Result> results_;
  std::map<std::string, std::size_t> places_;
};

}  // namespace furrow
