// Tries changes of the source on the verification tests.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace furrow::verification {

// `old_text` stands exactly once in `file`.
struct Change {
  std::string file, old_text, new_text;
};

// One source of verification/ and its tests.
struct Page {
  std::string name;
  std::vector<std::string> tests;  // "Suite.Test"
  std::string object;              // the bytes of the object file
};

// Where things are. The sound build must hold verification_tests.
struct Places {
  std::filesystem::path tree, sound_build, work;
  std::filesystem::path objects() const { return sound_build / "verification/CMakeFiles/verification_tests.dir"; }
  std::filesystem::path verdicts() const { return work / "verdicts"; }
};

std::string text_of(const std::filesystem::path& file);
std::vector<Page> pages_of(const Places& places);

// One copy of the tree with one build directory, in which changes are tried one after the other. Verdicts are kept in
// places.verdicts() under what they hang on: the library, the page's object and the scenes.
class Workshop {
 public:
  Workshop(const Places& places, const std::string& name, unsigned jobs, bool rebuild);

  // Puts the change in place of the one before, and builds. Not empty: why that was not possible.
  std::string build(const Change& change);

  // Those of the page's tests that fail, or do not end.
  std::set<std::string> failing_tests(const Page& page) const;

 private:
  std::set<std::string> run(const Page& page) const;

  Places places_;
  std::filesystem::path home_;
  std::string target_, configure_trouble_, library_;  // library_: the bytes of what was built
  std::string changed_;                               // file
  unsigned jobs_;
};

}  // namespace furrow::verification
