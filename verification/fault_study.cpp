// Does the suite notice a fault? Applies each fault of faults.toml, one at a time, to a copy of the tree, builds the
// verification tests against it, runs them, and notes which tests fail; then finds for each constant the smallest
// relative change that some test notices.
//
// usage: fault_study TREE WORK [--quick] [--jobs N] [--only NAME]
//   TREE     the project; it is only read
//   WORK     directory for the copies and the result, faults.json; what it holds already is built upon
//   --quick  only the faults marked quick, and no constants
// Exit codes: 0 every fault was noticed; 1 some were not, or one could not be applied or built; 4 a file cannot be
// read.
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <thread>

namespace {

namespace fs = std::filesystem;

struct Fault {
  std::string name, says, file, old_text, new_text;
  bool quick = false, constant = false;
};

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::vector<Fault> faults_in(const fs::path& file) {
  const toml::table all = toml::parse_file(file.string());
  std::vector<Fault> faults;
  for (const char* kind : {"fault", "constant"}) {
    const toml::array* list = all[kind].as_array();
    for (std::size_t k = 0; list != nullptr && k < list->size(); ++k) {
      const toml::table& entry = *list->get(k)->as_table();
      const auto text = [&](const char* key) { return entry[key].value_or<std::string>(""); };
      faults.push_back({text("name"), text("says"), text("file"), text("old"), text("new"),
                        entry["quick"].value_or(false), std::string(kind) == "constant"});
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

// What the suite said to a change of the source.
struct Verdict {
  std::string trouble;           // not empty: the change could not be tried
  std::set<std::string> failed;  // tests; "(crash)" or "(no end)" among them
};

// One copy of the tree with one build directory, in which changes are tried one after the other.
class Workshop {
 public:
  // `jobs` compilers at a time.
  Workshop(const fs::path& tree, const fs::path& place, unsigned jobs)
      : tree_(tree), copy_(place / "tree"), build_(place / "build"), jobs_(jobs) {
    fs::remove_all(copy_);
    for (const char* part :
         {"src", "cmake", "tests", "verification", "validation", "benchmarks", "reference_data", "CMakeLists.txt"}) {
      fs::create_directories(copy_);
      fs::copy(tree / part, copy_ / part, fs::copy_options::recursive);
    }
    // -O1: half the time to build, the same bits.
    configured_ = std::system(("cmake -S '" + copy_.string() + "' -B '" + build_.string() +
                               "' -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O1 >'" +
                               build_.string() + ".log' 2>&1")
                                  .c_str()) == 0;
  }

  Verdict try_change(const std::string& file, const std::string& old_text, const std::string& new_text) {
    if (!configured_) return {"the copy cannot be configured, see " + build_.string() + ".log", {}};
    const std::string sound = text_of(tree_ / file);
    const std::size_t at = sound.find(old_text);
    if (old_text.empty() || at == std::string::npos) return {"the text to change is not in " + file, {}};
    if (sound.find(old_text, at + 1) != std::string::npos) return {"the text to change stands twice in " + file, {}};
    std::string faulty = sound;
    write(copy_ / file, faulty.replace(at, old_text.size(), new_text));
    Verdict verdict = build_and_run();
    write(copy_ / file, sound);
    return verdict;
  }

  Verdict build_and_run() const {
    const std::string log = (build_ / "run.log").string();
    if (std::system(("cmake --build '" + build_.string() + "' --target verification_tests -j " + std::to_string(jobs_) +
                     " >'" + log + "' 2>&1")
                        .c_str()) != 0) {
      return {"does not build, see " + log, {}};
    }
    const int status = std::system(
        ("timeout 300 '" + (build_ / "verification/verification_tests").string() + "' >'" + log + "' 2>&1").c_str());
    Verdict verdict;
    static const std::regex line(R"(\[  FAILED  \] (\w+\.\w+) \()");
    const std::string text = text_of(log);
    for (std::sregex_iterator found(text.begin(), text.end(), line), end; found != end; ++found)
      verdict.failed.insert((*found)[1]);
    if (text.find("[==========]") == text.rfind("[==========]"))
      verdict.failed.insert(WEXITSTATUS(status) == 124 ? "(no end)" : "(crash)");
    return verdict;
  }

 private:
  static void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

  fs::path tree_, copy_, build_;
  unsigned jobs_;
  bool configured_ = false;
};

// Largest power of ten that goes unnoticed, plus one: the smallest change that is noticed, to a decade.
nlohmann::ordered_json smallest_noticed(Workshop& workshop, const Fault& constant) {
  nlohmann::ordered_json result{{"name", constant.name}, {"says", constant.says}};
  const auto noticed = [&](int decade) -> std::optional<Verdict> {
    char change[16];
    std::snprintf(change, sizeof change, "1e-%d", decade);
    Verdict verdict = workshop.try_change(constant.file, constant.old_text,
                                          std::regex_replace(constant.new_text, std::regex("CHANGE"), change));
    if (!verdict.trouble.empty()) result["trouble"] = verdict.trouble;
    return verdict.failed.empty() ? std::nullopt : std::optional(verdict);
  };
  int seen = 0;
  int unseen = 16;
  while (unseen - seen > 1) {
    const int middle = (seen + unseen) / 2;
    const auto verdict = noticed(middle);
    if (result.contains("trouble")) return result;
    if (verdict) result["by"] = verdict->failed;
    (verdict ? seen : unseen) = middle;
  }
  result["smallest_noticed"] = seen == 0 ? 1.0 : std::pow(10.0, -seen);
  return result;
}

}  // namespace

int main(int argc, char** argv) try {
  std::vector<std::string> places;
  bool quick = false;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
  std::string only;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    if (word == "--quick") {
      quick = true;
    } else if (word == "--jobs" && k + 1 < argc) {
      jobs = static_cast<unsigned>(std::max(1, std::atoi(argv[++k])));
    } else if (word == "--only" && k + 1 < argc) {
      only = argv[++k];
    } else {
      places.push_back(word);
    }
  }
  if (places.size() != 2) {
    std::fprintf(stderr, "usage: fault_study TREE WORK [--quick] [--jobs N] [--only NAME]\n");
    return 2;
  }
  const fs::path tree = fs::absolute(places[0]);
  const fs::path work = fs::absolute(places[1]);
  std::vector<Fault> faults = faults_in(tree / "verification/faults.toml");
  std::erase_if(faults, [&](const Fault& f) { return (quick && !f.quick) || (!only.empty() && f.name != only); });
  if (faults.empty()) throw std::runtime_error("no fault to try");
  // To build a second copy takes longer than to try a handful of faults in the first.
  if (quick) jobs = 1;

  std::vector<nlohmann::ordered_json> results(faults.size());
  std::mutex mutex;
  std::size_t next = 0;
  int holes = 0;
  const auto worker = [&](unsigned number) {
    fs::create_directories(work / std::to_string(number));
    Workshop workshop(tree, work / std::to_string(number), std::max(1U, std::thread::hardware_concurrency() / jobs));
    const Verdict sound = workshop.build_and_run();
    if (!sound.trouble.empty() || !sound.failed.empty()) {
      const std::scoped_lock lock(mutex);
      std::printf("FAILED: the sound tree is not green (%s%s)\n", sound.trouble.c_str(),
                  sound.failed.empty() ? "" : sound.failed.begin()->c_str());
      ++holes;
      return;
    }
    while (true) {
      std::size_t mine = 0;
      {
        const std::scoped_lock lock(mutex);
        if (next == faults.size()) return;
        mine = next++;
      }
      const Fault& fault = faults[mine];
      nlohmann::ordered_json result;
      if (fault.constant) {
        result = smallest_noticed(workshop, fault);
        result["kind"] = "constant";
      } else {
        const Verdict verdict = workshop.try_change(fault.file, fault.old_text, fault.new_text);
        result = {{"name", fault.name},
                  {"says", fault.says},
                  {"file", fault.file},
                  {"failed", verdict.failed},
                  {"kind", "fault"}};
        if (!verdict.trouble.empty()) result["trouble"] = verdict.trouble;
      }
      const std::scoped_lock lock(mutex);
      const bool hole = result.contains("trouble") || (!fault.constant && result["failed"].empty());
      holes += hole ? 1 : 0;
      if (fault.constant && !result.contains("trouble")) {
        std::printf("%-40s noticed from a relative change of %g\n", fault.name.c_str(),
                    result["smallest_noticed"].get<double>());
      } else {
        std::printf("%-40s %s\n", fault.name.c_str(),
                    result.contains("trouble") ? ("TROUBLE: " + result["trouble"].get<std::string>()).c_str()
                    : hole                     ? "NOT NOTICED"
                           : ("noticed by " + std::to_string(result["failed"].size()) + " tests").c_str());
      }
      std::fflush(stdout);
      results[mine] = std::move(result);
    }
  };
  std::vector<std::thread> threads;
  for (unsigned k = 0; k < std::min<unsigned>(jobs, static_cast<unsigned>(faults.size())); ++k)
    threads.emplace_back(worker, k);
  for (std::thread& thread : threads) thread.join();
  nlohmann::ordered_json report;
  report["commit"] = commit_of(tree);
  report["results"] = results;
  std::ofstream(work / "faults.json") << report.dump(1) << "\n";
  std::printf("%zu tried, %d not noticed or in trouble; %s\n", faults.size(), holes, (work / "faults.json").c_str());
  return holes == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "fault_study: error: %s\n", error.what());
  return 4;
}
