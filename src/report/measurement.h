// Makes the numbers of a study: independent runs side by side, kept as they end, so that an interrupted study goes on
// where it stopped and only what is old is made.
#pragma once

#include <functional>
#include <map>
#include <set>

#include "report/numbers.h"
#include "scene/scene.h"

namespace furrow {

struct Settings {
  bool quick = false;                              // the form for every build: fewer runs, the same questions
  std::filesystem::path directory{};               // for the results NAME.json; empty: nothing is kept
  unsigned jobs = 1;                               // runs at a time; 1 where time is measured
  std::function<bool(double, double)> progress{};  // (runs done, of all); false stops the study
  bool anew = false;                               // nothing that is kept is taken
};

// One run of a study. `run` must not depend on any other run. What it throws becomes {"failed": what}: failure of a
// method is a result. Want of memory and errors of the system or of files are none: they end the study.
struct Task {
  std::string key;  // names it among all results of the study, its settings included
  std::function<Json()> run;
  std::string input{};  // hash of what goes into it, if anything does: hash_of_scene
  bool timed = false;   // measures time: holds for one machine alone
};

std::string hash_of_scene(Scene scene);

// How a measurement deals with what is kept.
class Measurement {
 public:
  // Takes what the same study, in the same form, has left in settings.directory and that is not old.
  Measurement(std::string study, const Settings& settings, const Sources& sources);
  virtual ~Measurement() = default;
  Measurement(const Measurement&) = delete;
  Measurement& operator=(const Measurement&) = delete;

  bool quick() const { return settings_.quick; }
  unsigned jobs() const { return settings_.jobs; }

  // The results in the order of the tasks. Each is kept in directory/STUDY.runs.jsonl as soon as it is there. Kept ones
  // are taken if they have the key and the input, were made by the same sources, on this machine by this compiler and its
  // flags if they are timed, and did not fail. Throws Interrupted if `progress` says so, std::logic_error if two tasks have one key, FileError.
  virtual std::vector<Json> run(const std::vector<Task>& tasks);

  // The numbers that a check compares with; null where numbers are made.
  virtual const Numbers* compared_with() const { return nullptr; }

  // A result that others have measured, with what they say of how.
  virtual void take(Result result, const Maker& maker) { numbers_.add(std::move(result), maker); }

  // All that run() has returned and what was taken, in that order.
  const Numbers& numbers() const { return numbers_; }

 protected:
  const Result* kept(const Task& task) const;
  void note(const Task& task, Json value, double cpu, const Maker& maker);

  std::string study_;
  Settings settings_;
  Maker maker_;
  Numbers earlier_, numbers_;

 private:
  void take_lines(const std::filesystem::path& file);
};

// What a task gives, and the CPU time of it in s: {"failed": what} if it throws what is a result.
std::pair<Json, double> result_of(const Task& task);

// Makes a sample of the cheap numbers of a study again, as chosen by `draw`, and returns the kept ones for all else.
class Recomputation final : public Measurement {
 public:
  Recomputation(std::string study, const Numbers& kept, const Sources& sources, std::uint64_t draw, double most_cpu);
  std::vector<Json> run(const std::vector<Task>& tasks) override;

  const Numbers* compared_with() const override { return &earlier_; }
  int compared() const { return compared_; }
  // Whether the study has results that are no times.
  bool has_numbers() const { return numbers_there_; }
  // "KEY: now 2, kept 1": what did not come out, or is not kept.
  const std::vector<std::string>& wrong() const { return wrong_; }

 private:
  std::uint64_t draw_;
  double left_;  // s
  int compared_ = 0;
  bool numbers_there_ = false;
  std::vector<std::string> wrong_;
};

// What goes into the results of a study today, without a run: what is kept stands for what would be made.
class InputsToday final : public Measurement {
 public:
  InputsToday(std::string study, const Numbers& kept, const Sources& sources);
  std::vector<Json> run(const std::vector<Task>& tasks) override;
  // A result that was taken over is its own input.
  void take(Result result, const Maker& maker) override;
  const Numbers* compared_with() const override { return &earlier_; }

  const std::map<std::string, std::string>& inputs() const { return inputs_; }  // by key
  const std::vector<std::string>& not_kept() const { return not_kept_; }        // keys

 private:
  std::map<std::string, std::string> inputs_;
  std::vector<std::string> not_kept_;
};

}  // namespace furrow
