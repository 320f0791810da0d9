// Does the suite notice a fault? Applies each fault of faults.toml, one at a time, to a copy of the tree, runs the
// verification tests on it, and notes which fail; then finds for each constant the smallest relative change that some
// test notices.
//
// Faults of the kernel are also given to the test that holds the kernel against the reference, and to nothing else: it
// must notice each by itself.
//
// usage: fault_study TREE BUILD WORK [--quick] [--rebuild] [--property] [--jobs N] [--only NAME]... [--into REPORT]
//   TREE       the project; it is only read
//   BUILD      a build of it that holds verification_tests
//   WORK       directory for the copies, the verdicts and the result, faults.json. Verdicts that WORK holds already are
//              not tried again, so a study that was stopped goes on, and only what has changed is run
//   --quick    only the faults marked quick, and no constants, on the pages that these faults name
//   --into     take the verdicts into an earlier report, whose others stay; each names the commit that it was tried on
//   --property only that test, on the faults of the kernel; the report that it goes into keeps all its other verdicts
//   --rebuild  compile the pages again for each fault, as those marked `rebuild` are: slower, with the same result
// Exit codes: 0 every fault was noticed; 1 some were not, or one could not be applied or built; 4 a file cannot be
// read.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "output/files.h"
#include "report/inputs.h"
#include "report/measured_process.h"
#include "report/seal.h"
#include "verification/fault_study/faults.h"
#include "verification/fault_study/trial.h"
#include "verification/fault_study/verdicts.h"

namespace furrow::verification {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct Options {
  std::vector<fs::path> places;
  std::set<std::string> only;  // names; empty: all
  fs::path into;               // an earlier report; empty: a new one
  bool quick = false, rebuild = false, property = false;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
};

ordered_json head_of(const Fault& fault) {
  return {{"name", fault.name},
          {"says", fault.says},
          {"file", fault.change.file},
          {"kind", fault.constant ? "constant" : "fault"},
          {"input", input_of_fault(fault.change.file, fault.change.old_text, fault.change.new_text)}};
}

bool of_kernel(const Fault& fault) { return !fault.constant && fault.change.file.starts_with("src/kernel/"); }

class Study {
 public:
  Study(Places places, Faults faults, std::vector<std::string> names, const Options& options)
      : places_(std::move(places)),
        options_(options),
        names_(std::move(names)),
        pages_(pages_of(places_, faults.methods_pages, faults.costly_tests)),
        property_(kernel_is_reference(places_)),
        faults_(std::move(faults)),
        results_(faults_.all.size()) {
    std::set<std::string> tests;
    for (const Page& page : pages_) tests.insert(page.tests.begin(), page.tests.end());
    std::set<std::string> mentioned = faults_.costly_tests;
    for (const auto& [test, why] : faults_.silent) mentioned.insert(test);
    for (const std::string& test : mentioned) {
      if (tests.count(test) == 0) throw std::runtime_error("faults.toml: there is no test " + test);
    }
    if (!options_.quick) return;
    std::set<std::string> named;
    for (const Fault& fault : faults_.all) named.insert(fault.quick);
    std::erase_if(pages_, [&](const Page& page) { return named.count(page.name) == 0; });
  }

  // Tries those that are built in this way, `workers` at a time; not if the sound tree is not green.
  void try_all(bool rebuild, unsigned workers) {
    for (std::size_t k = 0; k < faults_.all.size(); ++k) {
      if (faults_.all[k].rebuild == rebuild) work_.push_back(k);
    }
    std::reverse(work_.begin(), work_.end());
    if (work_.empty()) return;
    const std::string name = rebuild ? "rebuilt_" : "";
    std::set<std::string> only;
    for (const std::size_t k : work_) {
      if (options_.quick) only.insert(faults_.all[k].change.file);
    }
    Workshop first(places_, (options_.quick ? "quick_" : "") + name + "0",
                   std::max(1U, std::thread::hardware_concurrency()), rebuild, std::move(only));
    if (!(options_.property ? sound_property(first) : sound(first, Turn::methods) && sound_property(first))) {
      bad_ += static_cast<int>(work_.size());
      work_.clear();
      return;
    }
    std::vector<std::thread> threads;
    for (unsigned k = 1; k < std::min<std::size_t>(workers, work_.size()); ++k) {
      threads.emplace_back([this, k, rebuild, &name] {
        Workshop workshop(places_, name + std::to_string(k), 1, rebuild);
        try_in(workshop);
      });
    }
    try_in(first);
    for (std::thread& thread : threads) thread.join();
    const bool ran_costly = std::any_of(results_.begin(), results_.end(), [](const ordered_json& result) {
      return result.contains("left_out") && result["left_out"].empty();
    });
    if (ran_costly && !sound(first, Turn::costly)) ++bad_;
  }

  int bad() const { return bad_; }  // not noticed, or not tried

  ordered_json report(const ordered_json& earlier) const {
    const Tried tried{maker_of_verdicts(places_.tree), names_, pages_, faults_.silent, results_};
    return options_.property ? with_property(tried, earlier) : report_of(tried, earlier);
  }

 private:
  bool sound(Workshop& workshop, Turn last) {
    std::vector<Page> those;
    std::copy_if(pages_.begin(), pages_.end(), std::back_inserter(those),
                 [&](const Page& p) { return p.turn <= last; });
    return sound(workshop, those);
  }

  bool sound_property(Workshop& workshop) {
    const bool asked = !options_.quick && std::any_of(faults_.all.begin(), faults_.all.end(), of_kernel);
    return !asked || sound(workshop, std::vector<Page>{property_});
  }

  bool sound(Workshop& workshop, const std::vector<Page>& pages) try {
    workshop.put({});
    for (const Page& page : pages) {
      for (const std::string& test : workshop.failing_tests(page)) throw std::runtime_error(test + " fails");
    }
    return true;
  } catch (const std::runtime_error& error) {
    std::printf("FAILED: the sound tree is not green: %s\n", error.what());
    return false;
  }

  ordered_json tried(Workshop& workshop, std::vector<Page>& pages, const Fault& fault) const {
    ordered_json result = head_of(fault);
    const auto concerned = [&](const std::string& file) { return fault.change.file.find(file) == 0; };
    const auto& files = faults_.methods_files;
    const bool of_methods = std::any_of(files.begin(), files.end(), concerned);
    const Turn last = fault.on_all ? Turn::costly : of_methods ? Turn::methods : Turn::always;
    try {
      if (fault.constant) {
        smallest_noticed(workshop, pages, fault.change, result);
      } else if (!options_.property) {
        try_fault(workshop, pages_, last, fault.change, result);
      }
      if (of_kernel(fault) && !options_.quick) {
        workshop.put(fault.change);
        result["by_property"] = workshop.failing_tests(property_);
      }
    } catch (const std::runtime_error& error) {
      result["trouble"] = error.what();
    }
    return result;
  }

  void try_in(Workshop& workshop) {
    std::vector<Page> pages = pages_;
    for (std::unique_lock lock(mutex_); !work_.empty();) {
      const std::size_t mine = work_.back();
      work_.pop_back();
      lock.unlock();
      ordered_json result = tried(workshop, pages, faults_.all[mine]);
      lock.lock();
      bad_ += failed(result) ? 1 : 0;
      std::printf("%-40s %s\n", faults_.all[mine].name.c_str(), in_words(result).c_str());
      std::fflush(stdout);
      results_[mine] = std::move(result);
    }
  }

  Places places_;
  Options options_;
  std::vector<std::string> names_;  // of all faults, in their order
  std::vector<Page> pages_;
  Page property_;
  Faults faults_;
  std::vector<ordered_json> results_;
  std::vector<std::size_t> work_;  // indices of what is still to be tried, the next one last
  std::mutex mutex_;
  int bad_ = 0;
};

// What the property notices stands beside the verdict of the pages.
void refuse_unknown(const std::vector<Fault>& faults, const ordered_json& report) {
  std::set<std::string> known;
  for (const auto& result : report.at("results")) known.insert(result.at("name").get<std::string>());
  for (const Fault& fault : faults) {
    if (known.count(fault.name) == 0)
      throw std::runtime_error("the report has no verdict on " + fault.name + ": try it without --property first");
  }
}

bool read_options(int argc, char** argv, Options& options) {
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    if (word == "--quick") {
      options.quick = true;
    } else if (word == "--rebuild") {
      options.rebuild = true;
    } else if (word == "--property") {
      options.property = true;
    } else if (word == "--jobs" && k + 1 < argc) {
      options.jobs = static_cast<unsigned>(std::max(1, std::atoi(argv[++k])));
    } else if (word == "--into" && k + 1 < argc) {
      options.into = argv[++k];
    } else if (word == "--only" && k + 1 < argc) {
      options.only.insert(argv[++k]);
    } else {
      options.places.push_back(fs::absolute(word));
    }
  }
  return options.places.size() == 3 && (!options.property || !options.into.empty());
}

int main_of(int argc, char** argv) {
  Options options;
  if (!read_options(argc, argv, options)) {
    std::fprintf(stderr,
                 "usage: fault_study TREE BUILD WORK [--quick] [--rebuild] [--property] [--jobs N] [--only NAME]... "
                 "[--into REPORT]\n");
    return 2;
  }
  const Places places{options.places[0], options.places[1], options.places[2]};
  Faults faults = faults_in(places.tree / "verification/faults.toml");
  std::vector<std::string> names;
  for (const Fault& fault : faults.all) names.push_back(fault.name);
  for (const std::string& name : options.only)
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw std::runtime_error("faults.toml: there is no fault " + name);
  ordered_json earlier = ordered_json::object();
  if (!options.into.empty()) earlier = read_sealed(options.into);
  std::erase_if(faults.all, [&](const Fault& f) {
    return (options.quick && f.quick.empty()) || (options.property && !of_kernel(f)) ||
           (!options.only.empty() && options.only.count(f.name) == 0);
  });
  if (faults.all.empty()) throw std::runtime_error("no fault to try");
  if (options.property) refuse_unknown(faults.all, earlier);
  for (Fault& fault : faults.all) fault.rebuild = fault.rebuild || options.rebuild;
  // A handful: a second copy would not pay.
  if (options.quick) options.jobs = 1;
  const std::size_t count = faults.all.size();

  Study study(places, std::move(faults), std::move(names), options);
  study.try_all(false, options.jobs);
  study.try_all(true, options.jobs);
  const fs::path result = places.work / "faults.json";
  ordered_json report = study.report(earlier);
  seal(report);
  OutputFile file = OutputFile::rewriting(result);
  file << report.dump(1) << "\n";
  file.finish();
  std::printf("%zu tried, %d not noticed or in trouble; %s\n", count, study.bad(), result.c_str());
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
