#include "studies/study.h"

#include <atomic>
#include <exception>
#include <fstream>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "output/build_info.h"
#include "output/files.h"
#include "output/machine.h"
#include "page/embedded.h"
#include "scene/read.h"
#include "system/prepare.h"

namespace furrow::studies {
namespace {

namespace fs = std::filesystem;

// 64-bit FNV-1a of the running program: results of another build are not taken for this one's.
std::string program_hash() {
  static const std::string hash = [] {
    std::ifstream self("/proc/self/exe", std::ios::binary);
    std::uint64_t sum = 0xcbf29ce484222325ULL;
    for (std::istreambuf_iterator<char> at(self), end; at != end; ++at)
      sum = (sum ^ static_cast<unsigned char>(*at)) * 0x100000001b3ULL;
    return std::to_string(sum);
  }();
  return hash;
}

// Results of earlier, interrupted calls, and of this one as they come.
class Kept {
 public:
  Kept(const std::string& study, const fs::path& directory) {
    if (directory.empty()) return;
    fs::create_directories(directory);
    const fs::path file = directory / (study + ".runs.jsonl");
    std::ifstream earlier(file);
    for (std::string line; std::getline(earlier, line);) {
      const Json entry = Json::parse(line, nullptr, false);  // a line cut short by a crash is not valid
      if (entry.is_object() && entry.value("program", "") == program_hash()) known_[entry["key"]] = entry["result"];
    }
    out_.open(file, std::ios::app);
    if (!out_) throw FileError("cannot write " + file.string());
  }

  const Json* find(const std::string& key) const {
    const auto found = known_.find(key);
    return found == known_.end() ? nullptr : &found->second;
  }

  void add(const std::string& key, const Json& result) {
    if (out_.is_open()) out_ << Json{{"program", program_hash()}, {"key", key}, {"result", result}}.dump() << std::endl;
  }

 private:
  std::map<std::string, Json> known_;
  std::ofstream out_;
};

}  // namespace

Scene scene_named(const std::string& name) {
  const std::string file = "validation/scenes/" + name + ".toml";
  return parse_scene(embedded(file), file);
}

std::vector<Json> run_tasks(const std::string& study, const Settings& settings, const std::vector<Task>& tasks) {
  Kept kept(study, settings.directory);
  std::vector<Json> results(tasks.size());
  std::mutex mutex;
  std::atomic<std::size_t> next = 0;
  std::size_t done = 0;
  bool stopped = false;
  const auto work = [&] {
    for (std::size_t k; (k = next++) < tasks.size();) {
      const Task& task = tasks[k];
      const Json* known = kept.find(task.key);
      Json result;
      if (known) {
        result = *known;
      } else {
        try {
          result = task.run();
        } catch (const std::exception& failure) {
          result = {{"failed", failure.what()}};
        }
      }
      const std::scoped_lock lock(mutex);
      if (!known) kept.add(task.key, result);
      results[k] = std::move(result);
      if (settings.progress && !settings.progress(static_cast<double>(++done), static_cast<double>(tasks.size()))) {
        stopped = true;
        next = tasks.size();
      }
    }
  };
  std::vector<std::jthread> others;
  for (unsigned k = 1; k < settings.jobs; ++k) others.emplace_back(work);
  work();
  others.clear();
  if (stopped) throw Interrupted("interrupted; the runs that ended are kept");
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

std::vector<std::string> run_study(const std::string& name, const Settings& settings) {
  std::string known;
  for (const Study& study : catalogue()) {
    known += (known.empty() ? "" : ", ") + study.name;
    if (study.name != name) continue;
    const Json result = study.run(settings);
    OutputFile file(settings.directory / (name + ".json"));
    file << result.dump(1) << "\n";
    file.finish();
    fs::remove(settings.directory / (name + ".runs.jsonl"));
    std::vector<std::string> refuted;
    for (const Json& claim : result.at("claims")) {
      if (!claim.at("holds").get<bool>()) refuted.push_back(claim.at("text"));
    }
    return refuted;
  }
  throw std::invalid_argument("no study '" + name + "'; there are " + known);
}

}  // namespace furrow::studies
