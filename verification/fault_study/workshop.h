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

// When a page is run: for every fault; for faults of the methods and for what nothing before noticed; only for that.
enum Turn { always, methods, costly };

// One source of verification/ and its tests, but for the costly ones: these are a page of their own.
struct Page {
  std::string name;
  std::vector<std::string> tests;  // "Suite.Test"
  std::string object;              // a hash of the bytes of what it was compiled to, and of the studies that it calls
  Turn turn = always;
  std::string program{};  // that has them; empty: the one of the pages
};

// Where things are. The sound build must hold verification_tests.
struct Places {
  std::filesystem::path tree, sound_build, work;
  std::filesystem::path objects() const { return sound_build / "verification/page_objects.txt"; }  // a path a line
  std::filesystem::path verdicts() const { return work / "verdicts"; }
};

std::string text_of(const std::filesystem::path& file);
// All lines of the files under src/ of a tree, but for comments: what a kept verdict depends on.
std::string code_of(const std::filesystem::path& tree);
// `methods` are names of pages, `costly` of tests.
std::vector<Page> pages_of(const Places& places, const std::set<std::string>& methods,
                           const std::set<std::string>& costly);

// The test that holds the kernel against the reference, as a page of its own.
Page kernel_is_reference(const Places& places);

// One copy of the tree with one build directory, in which changes are tried one after the other. Verdicts are kept in
// places.verdicts() under what they depend on: the source but for its comments, the page's object and the scenes.
class Workshop {
 public:
  // `only`: files of src that are compiled, if not all: the rest is the sound build's. No change may be of another file.
  Workshop(const Places& places, const std::string& name, unsigned jobs, bool rebuild, std::set<std::string> only = {});

  // Puts the change in place of the one before. Throws std::runtime_error if its text does not stand just once.
  void put(const Change& change);

  // Those of the page's tests that fail, or do not end. Builds what is needed for a verdict that is not kept, or that is
  // bad and of no change; throws std::runtime_error if it does not build.
  std::set<std::string> failing_tests(const Page& page);

 private:
  void configure();
  void build(const std::string& program);
  const std::string& program_of(const Page& page) const { return page.program.empty() ? target_ : page.program; }
  std::set<std::string> run(const Page& page) const;

  Places places_;
  std::filesystem::path home_;
  std::string target_;
  std::set<std::string> only_;
  std::string changed_;  // file
  std::string source_;   // what all verdicts on the change depend on
  bool configured_ = false;
  std::set<std::string> built_;  // programs, with the change
  unsigned jobs_;
};

}  // namespace furrow::verification
