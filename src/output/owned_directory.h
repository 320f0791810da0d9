// A directory that belongs to one run, or one report: a marker in it, .furrow.json, says of what kind it is, who made
// it and which files it made, and how they were when it ended. Whoever takes the directory again removes these files and
// no others: a file of the same name that another has put there, or has changed, is none of them. Directories in it that
// have a marker of their own are left alone.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "output/made_files.h"

namespace furrow {

class OwnedDirectory {
 public:
  enum class Earlier { replaced, kept };

  // Takes a new directory, an empty one, or one that `kind` has left in whatever way, for `files`: names
  // relative to the directory, which is held against other processes until the end. A directory that holds anything
  // else, that another process holds, or in which something else stands where a file must be written, is refused by a
  // FileError, and nothing is changed. Files of the owner before are removed, or kept to be continued.
  OwnedDirectory(std::filesystem::path directory, std::string kind, const std::vector<std::string>& files,
                 Earlier earlier = Earlier::replaced);
  ~OwnedDirectory();
  OwnedDirectory(const OwnedDirectory&) = delete;
  OwnedDirectory& operator=(const OwnedDirectory&) = delete;

  const std::filesystem::path& path() const { return directory_; }

  // More files that are about to be made. Throws FileError where something stands that is not the owner's.
  void add(const std::vector<std::string>& files);

  // Removes one of its own files, finished or .partial, if it is there.
  void discard(const std::string& file);

  // Removes all of its own files but these.
  void keep_only(const std::vector<std::string>& files);

  // Says in the marker how its owner ended, and leaves in the list only what is there. Without this it says "failed".
  void conclude(const std::string& standing);

 private:
  void lock();
  void take(const std::vector<std::string>& files, Earlier earlier);
  void make_directories(const std::vector<std::string>& files) const;
  void write_marker(const std::string& standing) const;

  std::filesystem::path directory_;
  std::string kind_, began_;
  MadeFiles made_;
  int lock_ = -1;  // descriptor of the directory
  bool concluded_ = false;
};

}  // namespace furrow
