// By what an owner of a directory knows the files that it made from any other that has their names.
//
//   while it runs  a journal in the directory: a line before each file is made, and one with its inode and time of birth as
//                  soon as it is there. So a process may be killed at any moment: what was made is in the journal, or is
//                  empty and about to be in it
//   when it ends   its length and CRC-32, in the marker
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "output/files.h"

namespace furrow {

inline constexpr const char* journal_name = ".furrow.made";
inline constexpr const char* file_endings[] = {"", ".partial"};

class MadeFiles final : public FileWatcher {
 public:
  MadeFiles() = default;
  MadeFiles(const MadeFiles&) = delete;
  MadeFiles& operator=(const MadeFiles&) = delete;

  // Of this directory, once it is there: what its journal says, if it has one.
  void open(const std::filesystem::path& directory);
  ~MadeFiles() override;

  // What a marker says: by its name, with its ending, "120 cbf43926"; or nothing, in one of an earlier version, which
  // listed names alone and is believed.
  void know(const std::string& file, const std::string& content) { content_[file] = content; }

  // Without endings.
  std::set<std::string> names() const;

  // Whether this file, named with its ending, is one that was made here and is as it was left.
  bool is_own(const std::string& file) const;

  // Forgets all, and the journal.
  void forget();

  // Of those that are there, and are own.
  std::map<std::string, std::string> contents() const;

  void made(const std::filesystem::path& file, int descriptor) override;

 private:
  void note(const std::string& identity, const std::string& name);
  void read_journal();

  std::filesystem::path directory_, canonical_;
  int journal_ = -1;
  std::map<std::string, std::string> content_;             // by file, with its ending
  std::map<std::string, std::set<std::string>> identity_;  // by name; empty: about to be made
};

}  // namespace furrow
