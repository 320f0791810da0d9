// Does the suite notice a fault? Applies each fault of faults.toml, one at a time, to a copy of the tree, runs the
// verification tests on it, and notes which fail; then finds for each constant the smallest relative change that some
// test notices.
//
// usage: fault_study TREE BUILD WORK [--quick] [--rebuild] [--jobs N] [--only NAME]...
//   TREE       the project; it is only read
//   BUILD      a build of it that holds verification_tests
//   WORK       directory for the copies, the verdicts and the result, faults.json. Verdicts that WORK holds already are
//              not tried again, so a study that was stopped goes on, and only what has changed is run
//   --quick    only the faults marked quick, and no constants
//   --rebuild  compile the pages anew for each fault, as those marked `rebuild` are anyway: the slow way to the same
// Exit codes: 0 every fault was noticed; 1 some were not, or one could not be applied or built; 4 a file cannot be
// read.
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <regex>
#include <thread>

#include "fault_study/workshop.h"

namespace furrow::verification {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct Fault {
  std::string name, says;
  Change change;  // of a constant with the word CHANGE in new_text
  bool constant = false, quick = false, rebuild = false;
};

struct Options {
  std::vector<fs::path> places;
  std::set<std::string> only;  // names; empty: all
  bool quick = false, rebuild = false;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
};

std::vector<Fault> faults_in(const fs::path& file) {
  const toml::table all = toml::parse_file(file.string());
  std::vector<Fault> faults;
  for (const char* kind : {"fault", "constant"}) {
    const toml::array* list = all[kind].as_array();
    for (std::size_t k = 0; list != nullptr && k < list->size(); ++k) {
      const toml::table& entry = *list->get(k)->as_table();
      const auto text = [&](const char* key) { return entry[key].value_or<std::string>(""); };
      faults.push_back({text("name"),
                        text("says"),
                        {text("file"), text("old"), text("new")},
                        std::string(kind) == "constant",
                        entry["quick"].value_or(false),
                        entry["rebuild"].value_or(false)});
    }
  }
  return faults;
}

std::string commit_of(const fs::path& tree) {
  std::string commit;
  std::FILE* git = popen(("git -C '" + tree.string() + "' describe --always --dirty 2>/dev/null").c_str(), "r");
  for (int letter = 0; git != nullptr && (letter = std::fgetc(git)) > ' ';) commit += static_cast<char>(letter);
  if (git != nullptr) pclose(git);
  return commit.empty() ? "unknown" : commit;
}

ordered_json try_fault(Workshop& workshop, const std::vector<Page>& pages, const Fault& fault) {
  ordered_json result{{"name", fault.name}, {"says", fault.says}, {"file", fault.change.file}, {"kind", "fault"}};
  std::set<std::string> failed;
  const std::string trouble = workshop.build(fault.change);
  if (trouble.empty()) {
    for (const Page& page : pages) failed.merge(workshop.failing_tests(page));
  } else {
    result["trouble"] = trouble;
  }
  result["failed"] = failed;
  return result;
}

// The smallest power of ten that some test notices as a relative change. `pages` is left with the one that noticed last
// in front: it is the likeliest to notice the next change.
ordered_json smallest_noticed(Workshop& workshop, std::vector<Page>& pages, const Fault& constant) {
  ordered_json result{{"name", constant.name}, {"says", constant.says}, {"kind", "constant"}};
  int seen = 0;
  int unseen = 16;
  while (unseen - seen > 1) {
    const int middle = (seen + unseen) / 2;
    Change change = constant.change;
    change.new_text = std::regex_replace(change.new_text, std::regex("CHANGE"), "1e-" + std::to_string(middle));
    const std::string trouble = workshop.build(change);
    if (!trouble.empty()) {
      result["trouble"] = trouble;
      return result;
    }
    std::set<std::string> failed;
    const auto notices = [&](const Page& page) { return !(failed = workshop.failing_tests(page)).empty(); };
    const auto noticing = std::find_if(pages.begin(), pages.end(), notices);
    const bool noticed = noticing != pages.end();
    (noticed ? seen : unseen) = middle;
    if (!noticed) continue;
    result["by"] = failed;
    std::rotate(pages.begin(), noticing, noticing + 1);
  }
  result["smallest_noticed"] = std::pow(10.0, -seen);
  return result;
}

bool failed(const ordered_json& result) {
  return result.contains("trouble") || (result["kind"] == "fault" && result["failed"].empty());
}

std::string in_words(const ordered_json& result) {
  if (result.contains("trouble")) return "TROUBLE: " + result["trouble"].get<std::string>();
  if (result["kind"] == "fault")
    return failed(result) ? "NOT NOTICED" : "noticed by " + std::to_string(result["failed"].size()) + " tests";
  char text[64];
  std::snprintf(text, sizeof text, "noticed from a relative change of %g", result["smallest_noticed"].get<double>());
  return text;
}

class Study {
 public:
  Study(Places places, std::vector<Fault> faults)
      : places_(std::move(places)), pages_(pages_of(places_)), faults_(std::move(faults)), results_(faults_.size()) {}

  // Tries those that are built in this way, `workers` at a time.
  void try_all(bool rebuild, unsigned workers) {
    work_.clear();
    for (std::size_t k = 0; k < faults_.size(); ++k) {
      if (faults_[k].rebuild == rebuild) work_.push_back(k);
    }
    std::reverse(work_.begin(), work_.end());
    workers = std::min<unsigned>(workers, static_cast<unsigned>(work_.size()));
    const unsigned compilers = std::max(1U, std::thread::hardware_concurrency() / std::max(1U, workers));
    std::vector<std::thread> threads;
    for (unsigned k = 0; k < workers; ++k) {
      threads.emplace_back([this, k, compilers, rebuild] {
        Workshop workshop(places_, (rebuild ? "rebuilt_" : "") + std::to_string(k), compilers, rebuild);
        if (sound(workshop)) try_in(workshop);
      });
    }
    for (std::thread& thread : threads) thread.join();
    bad_ += static_cast<int>(work_.size());
  }

  int bad() const { return bad_; }  // not noticed, or not tried

  ordered_json report() const {
    std::set<std::string> silent;
    for (const Page& page : pages_) silent.insert(page.tests.begin(), page.tests.end());
    ordered_json tried = ordered_json::array();
    for (const ordered_json& result : results_) {
      if (result.is_null()) continue;  // the workshop closed before
      tried.push_back(result);
      for (const auto& test : result.value("failed", ordered_json::array())) silent.erase(test.get<std::string>());
    }
    return {{"commit", commit_of(places_.tree)}, {"results", tried}, {"noticed_nothing", silent}};
  }

 private:
  bool sound(Workshop& workshop) {
    std::string trouble = workshop.build({});
    for (const Page& page : pages_) {
      if (!trouble.empty()) break;
      for (const std::string& test : workshop.failing_tests(page)) trouble = test + " fails";
    }
    const std::scoped_lock lock(mutex_);
    if (!trouble.empty()) std::printf("FAILED: the sound tree is not green: %s\n", trouble.c_str());
    return trouble.empty();
  }

  void try_in(Workshop& workshop) {
    std::vector<Page> pages = pages_;
    for (std::unique_lock lock(mutex_); !work_.empty();) {
      const std::size_t mine = work_.back();
      work_.pop_back();
      lock.unlock();
      const Fault& fault = faults_[mine];
      ordered_json result =
          fault.constant ? smallest_noticed(workshop, pages, fault) : try_fault(workshop, pages, fault);
      lock.lock();
      bad_ += failed(result) ? 1 : 0;
      std::printf("%-40s %s\n", fault.name.c_str(), in_words(result).c_str());
      std::fflush(stdout);
      results_[mine] = std::move(result);
    }
  }

  Places places_;
  std::vector<Page> pages_;
  std::vector<Fault> faults_;
  std::vector<ordered_json> results_;
  std::vector<std::size_t> work_;  // indices of what is still to be tried, the next one last
  std::mutex mutex_;
  int bad_ = 0;
};

bool read_options(int argc, char** argv, Options& options) {
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    if (word == "--quick") {
      options.quick = true;
    } else if (word == "--rebuild") {
      options.rebuild = true;
    } else if (word == "--jobs" && k + 1 < argc) {
      options.jobs = static_cast<unsigned>(std::max(1, std::atoi(argv[++k])));
    } else if (word == "--only" && k + 1 < argc) {
      options.only.insert(argv[++k]);
    } else {
      options.places.push_back(fs::absolute(word));
    }
  }
  return options.places.size() == 3;
}

int main_of(int argc, char** argv) {
  Options options;
  if (!read_options(argc, argv, options)) {
    std::fprintf(stderr, "usage: fault_study TREE BUILD WORK [--quick] [--rebuild] [--jobs N] [--only NAME]...\n");
    return 2;
  }
  const Places places{options.places[0], options.places[1], options.places[2]};
  std::vector<Fault> faults = faults_in(places.tree / "verification/faults.toml");
  std::erase_if(faults, [&](const Fault& f) {
    return (options.quick && !f.quick) || (!options.only.empty() && options.only.count(f.name) == 0);
  });
  if (faults.empty()) throw std::runtime_error("no fault to try");
  for (Fault& fault : faults) fault.rebuild = fault.rebuild || options.rebuild;
  // To build a second copy takes longer than to try a handful of faults in the first.
  if (options.quick) options.jobs = 1;

  Study study(places, faults);
  study.try_all(false, options.jobs);
  study.try_all(true, options.jobs);
  const fs::path result = places.work / "faults.json";
  std::ofstream(result) << study.report().dump(1) << "\n";
  std::printf("%zu tried, %d not noticed or in trouble; %s\n", faults.size(), study.bad(), result.c_str());
  return study.bad() == 0 ? 0 : 1;
}

}  // namespace
}  // namespace furrow::verification

int main(int argc, char** argv) try {
  return furrow::verification::main_of(argc, argv);
} catch (const std::exception& error) {
  std::fprintf(stderr, "fault_study: error: %s\n", error.what());
  return 4;
}
