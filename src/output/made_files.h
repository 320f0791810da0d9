// By what an owner of a directory knows the files that it made from any other that has their names: by what is in them.
//
//   while it runs  a journal in the directory: a line before each file is made, one before its first bytes are written, and
//                  one with its length and hash before it gets its name. So a process may be killed at any moment, and what
//                  it left may be copied to another place
//   when it ends   its length and CRC-32, in the marker
//
// A file that was finished is its own only while every byte is as it was; one that was not, .partial, while it begins as it
// did; an empty one with the name of one that was planned is.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "output/files.h"

namespace furrow {

inline constexpr const char* journal_name = ".furrow.made";
inline constexpr const char* file_endings[] = {"", ".partial"};

// Whether a file of that name is a journal, whole or cut.
bool is_journal(const std::filesystem::path& file);

class MadeFiles {
 public:
  MadeFiles() = default;
  MadeFiles(const MadeFiles&) = delete;
  MadeFiles& operator=(const MadeFiles&) = delete;
  ~MadeFiles();

  // Of this directory, once it is there: what its journal says, if it has one. Throws FileError where something else has the
  // journal's name.
  void open(const std::filesystem::path& directory);

  // What a marker says: by its name, with its ending, "120 cbf43926"; or nothing, in one of an earlier version, which
  // listed names alone and is believed.
  void know(const std::string& file, const std::string& content) { content_[file] = content; }

  // Without endings.
  std::set<std::string> names() const;

  // Whether this file, named with its ending, is one that was made here and is as it was left.
  bool is_own(const std::string& file) const;

  // From now on notes in the journal what is made. Throws FileError.
  void begin();

  // Forgets all that was noted so far.
  void forget();

  // Ends the journal.
  void end();

  // Of those that are there, and are own.
  std::map<std::string, std::string> contents() const;

 private:
  void hear(const std::filesystem::path& file, const FileNews& news);
  void note(const std::string& known, const std::string& name);
  void begin_anew() const;
  void write(const std::string& line) const;

  std::filesystem::path directory_, canonical_;
  int journal_ = -1;
  std::map<std::string, std::string> content_;          // by file, with its ending
  std::map<std::string, std::set<std::string>> known_;  // by name: what the journal says
  std::optional<FileWatch> watch_;                      // the last member: it ends before the others
};

}  // namespace furrow
