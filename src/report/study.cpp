#include "report/study.h"

#include <unistd.h>

#include <atomic>
#include <exception>
#include <fstream>
#include <map>
#include <mutex>
#include <new>
#include <set>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "output/build_info.h"
#include "output/files.h"
#include "output/kept_result.h"
#include "output/machine.h"
#include "report/embedded.h"
#include "report/seal.h"
#include "run/prepare.h"
#include "scene/read.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;

// 64-bit FNV-1a of the running program, the scenes that it carries included: results of another build are not taken for
// this one's.
std::string program_hash() {
  static const std::string hash = [] {
    std::ifstream self("/proc/self/exe", std::ios::binary);
    if (!self) return "unknown, of process " + std::to_string(getpid());  // shown to be no other's
    std::uint64_t sum = 0xcbf29ce484222325ULL;
    for (std::istreambuf_iterator<char> at(self), end; at != end; ++at)
      sum = (sum ^ static_cast<unsigned char>(*at)) * 0x100000001b3ULL;
    return std::to_string(sum);
  }();
  return hash;
}

std::string form_of(const Settings& settings) { return settings.quick ? "quick" : "full"; }

bool ends_within_a_line(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream || stream.tellg() <= 0) return false;
  stream.seekg(-1, std::ios::end);
  return stream.get() != '\n';
}

// Every line begins as those that Kept writes, also one that was cut short later on.
bool is_list_of_runs(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::string beginning = std::string("{\"program\":").substr(0, line.size());
    if (!line.starts_with(beginning)) return false;
  }
  return true;
}

// Results of earlier, interrupted calls, and of this one as they come. What makes a result is in its line: program,
// machine, study, form and key. A failure is not taken: it may have been one of the machine, so it is tried again.
class Kept {
 public:
  Kept(const std::string& study, const Settings& settings)
      : made_by_{
            {"program", program_hash()}, {"machine", processor_name()}, {"study", study}, {"form", form_of(settings)}} {
    if (settings.directory.empty()) return;
    fs::create_directories(settings.directory);
    file_ = settings.directory / (study + ".runs.jsonl");
    refuse_what_is_not("a list of runs of a study", file_, is_list_of_runs);
    std::ifstream earlier(file_);
    for (std::string line; std::getline(earlier, line);) take(Json::parse(line, nullptr, false));
    const bool cut = ends_within_a_line(file_);
    out_.open(file_, std::ios::app);
    if (cut) out_ << "\n";
    if (!out_) throw FileError("cannot write " + file_.string());
  }

  const Json* find(const std::string& key) const {
    const auto found = known_.find(key);
    return found == known_.end() ? nullptr : &found->second;
  }

  void add(const std::string& key, const Json& result) {
    if (!out_.is_open()) return;
    Json entry = made_by_;
    entry["key"] = key;
    entry["result"] = result;
    seal(entry);
    out_ << entry.dump() << std::endl;
    if (!out_) throw FileError("cannot write all of " + file_.string());
  }

 private:
  void take(const Json& entry) {  // a line that was cut short by a crash bears no seal
    if (!broken_seal(entry).empty()) return;
    for (const auto& [key, value] : made_by_.items()) {
      if (entry.value(key, Json()) != value) return;
    }
    if (!entry.at("result").contains("failed")) known_[entry.at("key")] = entry.at("result");
  }

  Json made_by_;
  fs::path file_;
  std::map<std::string, Json> known_;
  std::ofstream out_;
};

void refuse_twins(const std::vector<Task>& tasks) {
  std::set<std::string> keys;
  for (const Task& task : tasks) {
    if (!keys.insert(task.key).second) throw std::logic_error("two runs of a study with the key '" + task.key + "'");
  }
}

// A method's failure is a result. That the machine failed, or that somebody interrupted it, is none: it ends the study.
Json result_of(const Task& task) {
  try {
    return task.run();
  } catch (const Interrupted&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::system_error&) {
    throw;
  } catch (const FileError&) {
    throw;
  } catch (const std::exception& failure) {
    return {{"failed", failure.what()}};
  }
}

// Earlier ones do not say of which study they are.
bool is_result(const std::string& name, const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  return json.is_object() && json.contains("parts") && json.contains("claims") && json.value("study", name) == name;
}

}  // namespace

Scene scene_named(const std::string& name) {
  const std::string file = "validation/scenes/" + name + ".toml";
  return parse_scene(embedded(file), file);
}

std::vector<Json> run_tasks(const std::string& study, const Settings& settings, const std::vector<Task>& tasks) {
  refuse_twins(tasks);
  Kept kept(study, settings);
  std::vector<Json> results(tasks.size());
  std::mutex mutex;
  std::atomic<std::size_t> next = 0;
  std::size_t done = 0;
  bool stopped = false;
  std::exception_ptr broken;
  const auto work_on = [&](std::size_t k) {
    const Json* known = kept.find(tasks[k].key);
    Json result = known ? *known : result_of(tasks[k]);
    const std::scoped_lock lock(mutex);
    if (!known) kept.add(tasks[k].key, result);
    results[k] = std::move(result);
    if (settings.progress && !settings.progress(static_cast<double>(++done), static_cast<double>(tasks.size()))) {
      stopped = true;
      next = tasks.size();
    }
  };
  const auto work = [&] {
    try {
      for (std::size_t k; (k = next++) < tasks.size();) work_on(k);
    } catch (const Interrupted&) {
      const std::scoped_lock lock(mutex);
      stopped = true;
      next = tasks.size();
    } catch (...) {
      const std::scoped_lock lock(mutex);
      broken = std::current_exception();
      next = tasks.size();
    }
  };
  std::vector<std::jthread> others;
  for (unsigned k = 1; k < settings.jobs; ++k) others.emplace_back(work);
  work();
  others.clear();
  if (broken) std::rethrow_exception(broken);
  if (stopped)
    throw Interrupted(interrupt_words() + (settings.directory.empty() ? "" : "; the runs that ended are kept"));
  return results;
}

Report::Report(std::string title, std::string question) {
  const BuildInfo& build = build_info();
  json_ = {{"title", std::move(title)}, {"question", std::move(question)},
           {"commit", build.commit},    {"compiler", build.compiler},
           {"flags", build.flags},      {"machine", processor_name()},
           {"parts", Json::array()},    {"claims", Json::array()}};
}

Report& Report::heading(std::string text) {
  json_["parts"].push_back({{"kind", "heading"}, {"text", std::move(text)}});
  return *this;
}

Report& Report::text(std::string text) {
  json_["parts"].push_back({{"kind", "text"}, {"text", std::move(text)}});
  return *this;
}

Report& Report::table(std::string caption, std::vector<std::string> head, std::vector<std::vector<Json>> rows) {
  json_["parts"].push_back(
      {{"kind", "table"}, {"caption", std::move(caption)}, {"head", std::move(head)}, {"rows", std::move(rows)}});
  return *this;
}

Report& Report::figure(Figure figure) {
  json_["parts"].push_back({{"kind", "figure"},
                            {"name", std::move(figure.name)},
                            {"script", std::move(figure.script)},
                            {"caption", std::move(figure.caption)},
                            {"description", std::move(figure.description)},
                            {"variables", std::move(figure.variables)},
                            {"blocks", std::move(figure.blocks)}});
  return *this;
}

Report& Report::claim(const std::string& text, bool holds) {
  json_["claims"].push_back({{"text", text}, {"holds", holds}});
  return *this;
}

Report& Report::append(const Report& other) {
  for (const char* list : {"parts", "claims"}) {
    for (const Json& one : other.json_.at(list)) json_[list].push_back(one);
  }
  return *this;
}

Report& Report::data(Json data) {
  json_["data"] = std::move(data);
  return *this;
}

std::vector<std::string> run_study(const Study& study, const Settings& settings) {
  const fs::path file = settings.directory / (study.name + ".json");
  refuse_what_is_not("a result of study " + study.name, file,
                     [&](const std::string& text) { return is_result(study.name, text); });
  Json result = study.run(settings);
  result["study"] = study.name;
  result["form"] = form_of(settings);
  result["sources"] = build_info().sources;
  seal(result);
  replace_file(file, result.dump(1) + "\n");
  fs::remove(settings.directory / (study.name + ".runs.jsonl"));
  std::vector<std::string> refuted;
  for (const Json& claim : result.at("claims")) {
    if (!claim.at("holds").get<bool>()) refuted.push_back(claim.at("text"));
  }
  return refuted;
}

}  // namespace furrow
