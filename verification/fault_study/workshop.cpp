#include "verification/fault_study/workshop.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "report/measured_process.h"

namespace furrow::verification {
namespace {

namespace fs = std::filesystem;

void write_all(const fs::path& file, const std::string& text, std::ios::openmode mode) {
  std::ofstream stream(file, std::ios::binary | mode);
  stream << text;
  stream.close();
  if (!stream) throw std::runtime_error("cannot write all of " + file.string());
}

// Whether the program ends well; what it says goes into `log`. No shell reads the names.
bool succeeds(MeasuredCommand command, const fs::path& log) {
  fs::remove(log);
  command.errors = log;
  const MeasuredEnd ran = run_measured(command);
  write_all(log, ran.output, std::ios::app);
  return ran.status == 0;
}

bool can_start(const std::string& program) try {
  return run_measured({.words = {program, "--version"}}).status == 0;
} catch (const std::runtime_error&) {
  return false;
}

// Only what differs is written, so that nothing else is built again.
void write(const fs::path& file, const std::string& text) {
  if (!fs::exists(file) || text_of(file) != text) write_all(file, text, std::ios::trunc);
}

void copy_tree(const fs::path& from, const fs::path& to) {
  for (const char* part :
       {"src", "cmake", "tests/determinism", "tests/property", "tests/studies", "verification", "CMakeLists.txt"}) {
    if (!fs::is_directory(from / part)) {
      write(to / part, text_of(from / part));
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(from / part)) {
      if (!entry.is_regular_file()) continue;
      const fs::path target = to / fs::relative(entry.path(), from);
      fs::create_directories(target.parent_path());
      write(target, text_of(entry.path()));
    }
  }
}

std::string scenes_of(const fs::path& tree) {
  std::set<fs::path> files;  // sorted
  for (const auto& entry : fs::recursive_directory_iterator(tree / "validation/scenes")) {
    if (entry.is_regular_file()) files.insert(entry.path());
  }
  std::string text;
  for (const fs::path& file : files) text += text_of(file);
  return text;
}

// The page's object; of pages that were compiled together (FURROW_UNITY), all of them: which holds this one is not known.
std::string compiled(const Places& places, const fs::path& page) {
  std::istringstream lines(text_of(places.objects()));
  std::string all;
  for (std::string object; std::getline(lines, object);) {
    const std::string bytes = text_of(object);
    if (fs::path(object).filename() == page.filename().string() + ".o") return bytes;
    all += bytes;
  }
  return all;
}

}  // namespace

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::string code_of(const fs::path& tree) {
  std::set<fs::path> files;  // sorted
  for (const auto& entry : fs::recursive_directory_iterator(tree / "src")) {
    if (entry.is_regular_file()) files.insert(entry.path());
  }
  std::string code;
  for (const fs::path& file : files) {
    std::istringstream lines(text_of(file));
    for (std::string line; std::getline(lines, line);) {
      const std::size_t first = line.find_first_not_of(' ');
      if (first != std::string::npos && line.compare(first, 2, "//") != 0) code += line + "\n";
    }
  }
  return code;
}

std::vector<Page> pages_of(const Places& places, const std::set<std::string>& methods,
                           const std::set<std::string>& costly) {
  std::set<fs::path> sources;  // sorted
  for (const auto& entry : fs::directory_iterator(places.tree / "verification")) {
    if (entry.path().extension() == ".cpp") sources.insert(entry.path());
  }
  std::vector<Page> pages;
  static const std::regex test(R"(\bTEST\((\w+), (\w+)\))");
  for (const fs::path& source : sources) {
    Page usual{source.stem(), {}, {}, methods.count(source.stem()) != 0 ? Turn::methods : Turn::always};
    Page later{source.stem(), {}, {}, Turn::costly};
    const std::string text = text_of(source);
    for (std::sregex_iterator found(text.begin(), text.end(), test), end; found != end; ++found) {
      const std::string name = (*found)[1].str() + "." + (*found)[2].str();
      (costly.count(name) != 0 ? later : usual).tests.push_back(name);
    }
    for (Page* page : {&usual, &later}) {
      if (page->tests.empty()) continue;
      page->object = compiled(places, source);
      if (page->turn != Turn::always) page->object += text_of(places.sound_build / "libfurrow_studies.a");
      page->object = std::to_string(std::hash<std::string>{}(page->object));
      pages.push_back(std::move(*page));
    }
  }
  std::stable_sort(pages.begin(), pages.end(), [](const Page& a, const Page& b) { return a.turn < b.turn; });
  return pages;
}

Page kernel_is_reference(const Places& places) {
  const fs::path home = places.tree / "tests/property";
  Page page{.name = "kernel_is_reference", .program = "property_of_faulty"};
  const std::string text =
      text_of(home / "kernel_is_reference_test.cpp") + text_of(home / "kernel_is_reference_cases_test.cpp");
  static const std::regex test(R"(\b(?:TEST|RC_GTEST_PROP)\((KernelIsReference), (\w+)\b)");
  for (std::sregex_iterator found(text.begin(), text.end(), test), end; found != end; ++found)
    page.tests.push_back((*found)[1].str() + "." + (*found)[2].str());
  if (page.tests.empty()) throw std::runtime_error("tests/property: there is no test KernelIsReference");
  page.object = std::to_string(
      std::hash<std::string>{}(text + text_of(home / "both_solvers.h") + text_of(home / "differences.h")));
  return page;
}

Workshop::Workshop(const Places& places, const std::string& name, unsigned jobs, bool rebuild,
                   std::set<std::string> only)
    : places_(places),
      home_(places.work / name),
      target_(rebuild ? "rebuilt_tests" : "faulty_tests"),
      only_(std::move(only)),
      jobs_(jobs) {
  fs::create_directories(home_ / "tree");
  fs::create_directories(places.verdicts());
  copy_tree(places.tree, home_ / "tree");
}

void Workshop::configure() {
  const fs::path log = home_ / "configure.log";
  MeasuredCommand cmake{.words = {"cmake", "-S", places_.tree / "verification/fault_study", "-B", home_ / "build", "-G",
                                  "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DTREE=" + (home_ / "tree").string(),
                                  "-DSOURCE_DIR=" + places_.tree.string(), "-DBUILD=" + places_.sound_build.string()}};
  std::string only;
  for (const std::string& file : only_) only += (only.empty() ? "" : ";") + file;
  cmake.words.push_back("-DONLY=" + only);
  if (can_start("ccache")) cmake.words.emplace_back("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache");
  if (!succeeds(cmake, log)) {
    throw std::runtime_error("the copy cannot be configured, see " + log.string());
  }
  configured_ = true;
}

void Workshop::put(const Change& change) {
  if (!only_.empty() && !change.file.empty() && only_.count(change.file) == 0)
    throw std::runtime_error(change.file + " is not compiled here");
  if (!changed_.empty()) write(home_ / "tree" / changed_, text_of(places_.tree / changed_));
  changed_ = change.file;
  built_.clear();
  if (!change.file.empty()) {
    std::string text = text_of(places_.tree / change.file);
    const std::size_t at = text.find(change.old_text);
    if (change.old_text.empty() || at == std::string::npos)
      throw std::runtime_error("the text to change is not in " + change.file);
    if (text.find(change.old_text, at + 1) != std::string::npos)
      throw std::runtime_error("the text to change stands twice in " + change.file);
    write(home_ / "tree" / change.file, text.replace(at, change.old_text.size(), change.new_text));
  }
  source_ = code_of(home_ / "tree") + text_of(places_.tree / "verification/fault_study/CMakeLists.txt");
}

void Workshop::build(const std::string& program) {
  if (!configured_) configure();
  const fs::path log = home_ / "build.log";
  const MeasuredCommand cmake{
      .words = {"cmake", "--build", home_ / "build", "--target", program, "-j", std::to_string(jobs_)},
      .environment = {"CCACHE_NOHASHDIR=1", "CCACHE_BASEDIR=" + home_.string()}};
  if (!succeeds(cmake, log)) {
    throw std::runtime_error("does not build, see " + log.string());
  }
  built_.insert(program);
}

std::set<std::string> Workshop::failing_tests(const Page& page) {
  const std::hash<std::string> hash;
  std::string tests;
  for (const std::string& test : page.tests) tests += test + "\n";
  char key[64];
  std::snprintf(key, sizeof key, "%s-%016zx%016zx", program_of(page).substr(0, 1).c_str(), hash(source_),
                hash(page.object + tests + scenes_of(places_.tree)));
  const fs::path kept = places_.verdicts() / key;
  std::set<std::string> failing;
  // What failed without a change is tried again: it may have been the machine.
  if (changed_.empty() && fs::exists(kept) && fs::file_size(kept) > 0) fs::remove(kept);
  if (!fs::exists(kept)) {
    if (built_.count(program_of(page)) == 0) build(program_of(page));
    const fs::path part = kept.string() + "." + home_.filename().string();
    std::string text;
    for (const std::string& test : run(page)) text += test + "\n";
    write(part, text);
    fs::rename(part, kept);
  }
  std::istringstream lines(text_of(kept));
  for (std::string test; std::getline(lines, test);) failing.insert(test);
  return failing;
}

// A page has a minute of the processor for what takes seconds, and four for what takes half a minute to a minute, which on
// a busy machine is twice as much: the tests of the methods and the costly ones. A test that neither failed nor passed
// brought the page down. Random scenes are the same each time.
std::set<std::string> Workshop::run(const Page& page) const {
  std::string filter;
  for (const std::string& test : page.tests) filter += (filter.empty() ? "" : ":") + test;
  const fs::path log = home_ / "run.log";
  fs::remove_all(home_ / "tmp");  // a page that was killed leaves its files
  fs::create_directories(home_ / "tmp");
  const std::string seconds = page.turn == Turn::always ? "60" : "240";
  succeeds({.words = {"prlimit", "--cpu=" + seconds, "--as=4096000000", home_ / "build" / program_of(page),
                      "--gtest_filter=" + filter},
            .environment = {"TMPDIR=" + (home_ / "tmp").string(), "FURROW_RECORDS_IN=" + (home_ / "records").string(),
                            "RC_PARAMS=seed=1 noshrink=1"}},
           log);
  const std::string text = text_of(log);
  const auto tests_with = [&](const char* mark) {
    const std::regex line(std::string(mark) + R"( (\w+\.\w+))");
    std::set<std::string> tests;
    for (std::sregex_iterator found(text.begin(), text.end(), line), end; found != end; ++found)
      tests.insert((*found)[1]);
    return tests;
  };
  std::set<std::string> failing = tests_with(R"(\[ RUN      \])");
  if (failing.empty()) return {page.tests.begin(), page.tests.end()};
  for (const std::string& good : tests_with(R"(\[       OK \])")) failing.erase(good);
  return failing;
}

}  // namespace furrow::verification
