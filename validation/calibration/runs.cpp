#include "validation/calibration/runs.h"

#include <fstream>
#include <thread>

#include "output/files.h"
#include "output/kept_result.h"
#include "report/seal.h"
#include "scene/interrupt.h"

namespace furrow::validation {
namespace {

namespace fs = std::filesystem;

constexpr const char* beginning = "{\"run\":";

bool is_list_of_runs(const std::string& text) {
  const std::string start = std::string(beginning).substr(0, text.size());
  return text.starts_with(start);
}

bool ends_within_a_line(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream || stream.tellg() <= 0) return false;
  stream.seekg(-1, std::ios::end);
  return stream.get() != '\n';
}

class Place {
 public:
  explicit Place(std::counting_semaphore<>& free) : free_(free) { free_.acquire(); }
  ~Place() { free_.release(); }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

 private:
  std::counting_semaphore<>& free_;
};

}  // namespace

Runs::Runs(const fs::path& directory, unsigned jobs, std::function<bool(long)> heard)
    : free_(static_cast<std::ptrdiff_t>(jobs)), heard_(std::move(heard)) {
  if (directory.empty()) return;
  const fs::path file = directory / "runs.jsonl";
  refuse_what_is_not("the runs of a calibration", file, is_list_of_runs);
  read(file);
  fs::create_directories(directory);
  const bool cut = ends_within_a_line(file);
  begin_appending(file, beginning);
  out_.open(file, std::ios::app);
  if (cut) out_ << "\n";
  if (!out_) throw FileError("cannot write " + file.string());
}

// A line that was cut short by a crash bears no seal; the next one begins on a line of its own.
void Runs::read(const fs::path& file) {
  std::ifstream stream = regular_file(file);
  for (std::string line; std::getline(stream, line);) {
    Json json = Json::parse(line, nullptr, false);
    if (broken_seal(json).empty()) kept_[json.at("input")] = json.at("value");
  }
}

std::vector<Json> Runs::of(const std::vector<Task>& tasks) {
  std::vector<std::shared_future<Json>> results;
  std::vector<std::jthread> workers;
  for (const Task& task : tasks) {
    const std::scoped_lock lock(mutex_);
    const auto [place, fresh] = results_.try_emplace(task.input);
    if (fresh) {
      auto work = std::make_shared<std::packaged_task<Json()>>([this, &task] { return make(task); });
      place->second = work->get_future().share();
      workers.emplace_back([work] { (*work)(); });
    }
    results.push_back(place->second);
  }
  workers.clear();
  std::vector<Json> values;
  for (const auto& result : results) values.push_back(result.get());
  return values;
}

Json Runs::make(const Task& task) {
  {
    const std::scoped_lock lock(mutex_);
    if (const auto known = kept_.find(task.input); known != kept_.end()) return ++replayed_, known->second;
  }
  const Place place(free_);
  throw_if_interrupted();
  const auto [value, cpu] = result_of(task);
  Json line{{"run", task.key}, {"input", task.input}, {"cpu", cpu}, {"value", value}};
  seal(line);
  const std::scoped_lock lock(mutex_);
  if (out_.is_open() && !(out_ << line.dump() << std::endl)) throw FileError("cannot write all of runs.jsonl");
  ++made_;
  if (heard_ && !heard_(made_)) throw Interrupted(interrupt_words() + "; the runs that ended are kept");
  return value;
}

}  // namespace furrow::validation
