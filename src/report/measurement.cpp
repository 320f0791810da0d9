#include "report/measurement.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <fstream>
#include <mutex>
#include <new>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "output/files.h"
#include "output/kept_result.h"
#include "output/machine.h"
#include "output/strict_json.h"
#include "report/seal.h"
#include "scene/hash.h"
#include "scene/interrupt.h"
#include "scene/read.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;

std::string form_of(bool quick) { return quick ? "quick" : "full"; }

bool ends_within_a_line(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream || stream.tellg() <= 0) return false;
  stream.seekg(-1, std::ios::end);
  return stream.get() != '\n';
}

// Every line begins as those that Lines writes, also one that was cut short later on.
bool is_list_of_runs(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::string beginning = std::string("{\"study\":").substr(0, line.size());
    if (!line.starts_with(beginning)) return false;
  }
  return true;
}

// Results as they come, each a line with its own seal, so that an end at any moment loses none.
class Lines {
 public:
  Lines(const fs::path& file, std::string study, std::string form, const Maker& maker)
      : file_(file), study_(std::move(study)), form_(std::move(form)), maker_(maker) {
    if (file.empty()) return;
    fs::create_directories(file.parent_path());
    const bool cut = ends_within_a_line(file);
    out_.open(file, std::ios::app);
    if (cut) out_ << "\n";
    if (!out_) throw FileError("cannot write " + file.string());
  }

  void add(const Result& result) {
    if (!out_.is_open()) return;
    Numbers one(study_, form_);
    one.add(result, maker_);
    out_ << one.line() << std::endl;
    if (!out_) throw FileError("cannot write all of " + file_.string());
  }

 private:
  fs::path file_;
  std::string study_, form_;
  const Maker& maker_;
  std::ofstream out_;
};

void refuse_twins(const std::vector<Task>& tasks) {
  std::set<std::string> keys;
  for (const Task& task : tasks) {
    if (!keys.insert(task.key).second) throw std::logic_error("two runs of a study with the key '" + task.key + "'");
  }
}

// Work at the tasks from several threads; what one throws ends all and is thrown on.
class Workers {
 public:
  Workers(std::size_t count, std::function<void(std::size_t)> work) : count_(count), work_(std::move(work)) {}

  void run(unsigned jobs) {
    std::vector<std::jthread> others;
    for (unsigned k = 1; k < jobs; ++k) others.emplace_back([this] { take(); });
    take();
    others.clear();
    if (broken_) std::rethrow_exception(broken_);
  }

 private:
  void take() {
    try {
      for (std::size_t k; (k = next_++) < count_;) work_(k);
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      if (!broken_) broken_ = std::current_exception();
      next_ = count_;
    }
  }

  std::size_t count_;
  std::function<void(std::size_t)> work_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::exception_ptr broken_;
};

}  // namespace

std::string hash_of_scene(Scene scene) {
  scene.title.clear();  // words
  return hexadecimal(scene_hash(scene));
}

// A method's failure is a result. That the machine failed, or that somebody interrupted it, is none: it ends the study.
std::pair<Json, double> result_of(const Task& task) {
  const double begun = cpu_seconds();
  const auto spent = [begun] { return to_digits(std::max(0.0, cpu_seconds() - begun), 3); };
  try {
    Json value = task.run();
    return {std::move(value), spent()};
  } catch (const Interrupted&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::system_error&) {
    throw;
  } catch (const FileError&) {
    throw;
  } catch (const std::exception& failure) {
    return {Json{{"failed", failure.what()}}, spent()};
  }
}

Measurement::Measurement(std::string study, const Settings& settings, const Sources& sources)
    : study_(std::move(study)), settings_(settings), maker_(this_maker(sources)) {
  earlier_ = numbers_ = Numbers(study_, form_of(settings.quick));
  if (settings.directory.empty()) return;
  const fs::path whole = settings.directory / (study_ + ".json"), lines = settings.directory / (study_ + ".runs.jsonl");
  refuse_what_is_not("the numbers of study " + study_, whole,
                     [this](const std::string& text) { return Numbers::is_one(study_, text); });
  refuse_what_is_not("a list of runs of a study", lines, is_list_of_runs);
  if (settings.anew) return;
  if (fs::exists(whole)) {
    if (Numbers before = Numbers::read(whole); before.form() == earlier_.form()) earlier_ = std::move(before);
  }
  take_lines(lines);
}

// A line that was cut short by a crash bears no seal.
void Measurement::take_lines(const fs::path& file) {
  std::ifstream stream = regular_file(file);
  for (std::string line; std::getline(stream, line);) {
    const Json json = json_or_discarded(line);
    if (!broken_seal(json).empty() || json.at("study") != study_ || json.at("form") != earlier_.form()) continue;
    const Numbers one = Numbers::of(json, file);
    for (const Result& result : one.results()) earlier_.add(result, one.makers().at(result.maker));
  }
}

const Result* Measurement::kept(const Task& task) const {
  const Result* known = earlier_.find(task.key);
  if (!known || known->failed() || known->input != task.input || known->timed != task.timed) return nullptr;
  const Maker& maker = earlier_.makers().at(known->maker);
  if (!changed_since(maker.sources, maker_.sources).empty()) return nullptr;
  const bool same_time =
      maker.machine == maker_.machine && maker.compiler == maker_.compiler && maker.flags == maker_.flags;
  return task.timed && !same_time ? nullptr : known;
}

void Measurement::note(const Task& task, Json value, double cpu, const Maker& maker) {
  numbers_.add({task.key, task.input, task.timed, cpu, 0, std::move(value)}, maker);
}

std::vector<Json> Measurement::run(const std::vector<Task>& tasks) {
  refuse_twins(tasks);
  Lines lines(settings_.directory.empty() ? fs::path() : settings_.directory / (study_ + ".runs.jsonl"), study_,
              earlier_.form(), maker_);
  std::vector<Result> results(tasks.size());
  std::vector<const Maker*> makers(tasks.size(), &maker_);
  std::mutex mutex;
  std::size_t done = 0;
  const auto work_on = [&](std::size_t k) {
    const Task& task = tasks[k];
    if (const Result* known = kept(task)) {
      results[k] = *known;
      makers[k] = &earlier_.makers().at(known->maker);
    } else {
      auto [value, cpu] = result_of(task);
      results[k] = {task.key, task.input, task.timed, cpu, 0, std::move(value)};
      const std::scoped_lock lock(mutex);
      lines.add(results[k]);
    }
    const std::scoped_lock lock(mutex);
    ++done;
    if (settings_.progress && !settings_.progress(static_cast<double>(done), static_cast<double>(tasks.size())))
      throw Interrupted(interrupt_words() + (settings_.directory.empty() ? "" : "; the runs that ended are kept"));
  };
  Workers(tasks.size(), work_on).run(settings_.jobs);
  std::vector<Json> values;
  for (std::size_t k = 0; k < tasks.size(); ++k) {
    numbers_.add(results[k], *makers[k]);
    values.push_back(std::move(results[k].value));
  }
  return values;
}

InputsToday::InputsToday(std::string study, const Numbers& kept, const Sources& sources)
    : Measurement(std::move(study), {.quick = kept.quick()}, sources) {
  earlier_ = kept;
}

std::vector<Json> InputsToday::run(const std::vector<Task>& tasks) {
  std::vector<Json> values;
  for (const Task& task : tasks) {
    const Result* known = earlier_.find(task.key);
    inputs_[task.key] = task.input;
    if (!known) not_kept_.push_back(task.key);
    values.push_back(known ? known->value : Json{{"failed", "is not kept"}});
    if (known) note(task, known->value, known->cpu, earlier_.makers().at(known->maker));
  }
  return values;
}

void InputsToday::take(Result result, const Maker& maker) {
  const Result* known = earlier_.find(result.key);
  if (!known) not_kept_.push_back(result.key);
  inputs_[result.key] = known && known->value == result.value ? known->input : "another";
  Measurement::take(std::move(result), maker);
}

Recomputation::Recomputation(std::string study, const Numbers& kept, const Sources& sources, std::uint64_t draw,
                             double most_cpu)
    : Measurement(std::move(study), {.quick = kept.quick()}, sources), draw_(draw), left_(most_cpu) {
  earlier_ = kept;
}

std::vector<Json> Recomputation::run(const std::vector<Task>& tasks) {
  std::vector<Json> values;
  std::vector<std::pair<std::size_t, std::size_t>> order;  // a draw without repetition
  for (std::size_t k = 0; k < tasks.size(); ++k) {
    const Result* known = earlier_.find(tasks[k].key);
    if (!known) wrong_.push_back(tasks[k].key + ": is not kept");
    if (known && known->input != tasks[k].input) wrong_.push_back(tasks[k].key + ": is of another input");
    if (known && known->timed != tasks[k].timed)
      wrong_.push_back(tasks[k].key + ": is kept as a time, or should be one");
    numbers_there_ = numbers_there_ || !tasks[k].timed;
    values.push_back(known ? known->value : Json{{"failed", "is not kept"}});
    if (known) note(tasks[k], known->value, known->cpu, earlier_.makers().at(known->maker));
    if (known && !known->timed) order.emplace_back(std::hash<std::string>{}(tasks[k].key + std::to_string(draw_)), k);
  }
  std::sort(order.begin(), order.end());
  for (const auto& [drawn, k] : order) {
    const Result& known = *earlier_.find(tasks[k].key);
    if (known.cpu > left_) continue;
    const auto [now, cpu] = result_of(tasks[k]);
    left_ -= cpu;
    ++compared_;
    if (now.dump() != known.value.dump())
      wrong_.push_back(tasks[k].key + ": now " + now.dump() + ", kept " + known.value.dump());
  }
  return values;
}

}  // namespace furrow
