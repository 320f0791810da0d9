#include "benchmarks/tracking/gate.h"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <stdexcept>

#include "output/build_info.h"
#include "output/files.h"

namespace furrow::benchmarks {
namespace {

namespace fs = std::filesystem;

constexpr double allowed = 0.02;  // of the accepted count; the same build varies by less than 1e-5
constexpr int skipped = 77;

Json read(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream) throw FileError("cannot read " + file.string());
  return Json::parse(stream);
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm date{};
  gmtime_r(&now, &date);
  char text[11];
  std::strftime(text, sizeof text, "%Y-%m-%d", &date);
  return text;
}

bool is_answer(const Json& entry) {
  return entry.is_object() && entry.value("answer", Json()).is_string() && !entry["answer"].get<std::string>().empty();
}

bool is_count(const Json& entry) {
  const Json count = entry.is_object() ? entry.value("instructions", Json()) : Json();
  return count.is_number() && std::isfinite(count.get<double>()) && count.get<double>() > 0;
}

}  // namespace

// The answers are the same bits on every machine, so they are checked even where the counts say nothing.
int check_answers(const Json& accepted, const Json& results) {
  int status = good;
  const auto fail = [&](const std::string& name, const std::string& why) {
    std::printf("%-20s %s\n", name.c_str(), why.c_str());
    status = failed;
  };
  if (!accepted.is_object() || accepted.empty() || !results.is_object() || results.empty())
    fail("nothing", "was compared: there must be accepted kernels and results");
  for (const auto& [name, entry] : accepted.items()) {
    if (!results.contains(name)) fail(name, "is accepted, but was not run");
  }
  for (const auto& [name, result] : results.items()) {
    if (!accepted.contains(name))
      fail(name, "has no accepted count yet: scripts/track --accept");
    else if (!is_answer(accepted.at(name)) || !is_answer(result))
      fail(name, "has no answer to compare");
    else if (accepted.at(name).at("answer") != result.at("answer"))
      fail(name, "WRONG ANSWER " + result["answer"].get<std::string>() + ", accepted is " +
                     accepted[name]["answer"].get<std::string>());
  }
  return status;
}

int check_counts(const Json& accepted, const Json& results) {
  int status = good;
  for (const auto& [name, result] : results.items()) {
    if (!accepted.contains(name)) continue;
    if (!is_count(accepted.at(name)) || !is_count(result)) {
      std::printf("%-20s has no count to compare\n", name.c_str());
      status = failed;
      continue;
    }
    const double was = accepted.at(name).at("instructions"), is = result.at("instructions");
    const double change = is / was - 1;
    const bool slower = change > allowed, faster = change < -allowed;
    std::printf("%-20s %12.0f %12.0f %+8.2f %%%s\n", name.c_str(), was, is, 100 * change,
                slower   ? "  TOO MANY"
                : faster ? "  fewer: scripts/track --accept would keep the gain"
                         : "");
    if (slower) status = failed;
  }
  return status;
}

int gate(const fs::path& accepted_file, const Build& build) {
  const Json accepted = read(accepted_file);
  make_beds(build);
  Json results;
  for (const std::string& name : kernel_names(build)) results[name] = timed(build, name, 0);
  if (results.empty()) throw std::runtime_error("there are no kernels");
  const std::string here = identity(results.front());
  const int answers = check_answers(accepted.at("kernels"), results);
  if (here != accepted.at("build")) {
    std::printf("SKIPPED: the accepted counts belong to\n  %s\nand this is\n  %s\n",
                accepted["build"].get<std::string>().c_str(), here.c_str());
    return answers == good ? skipped : failed;
  }
  std::printf("%-20s %12s %12s\n", "instructions", "accepted", "now");
  const int counts = check_counts(accepted.at("kernels"), counted(build));
  if (counts != good)
    std::printf("If this is the price of something better: scripts/track --accept --reason \"what is better\"\n");
  return answers == good && counts == good ? good : failed;
}

int accept(const fs::path& file, const Build& build, const std::string& reason) {
  Json accepted = fs::exists(file) ? read(file) : Json::object();
  make_beds(build);
  const Json results = counted(build);
  accepted["build"] = identity(results.front());
  accepted["kernels"] = Json::object();
  for (const auto& [name, result] : results.items())
    accepted["kernels"][name] = {{"instructions", result["instructions"]}, {"answer", result["answer"]}};
  accepted["reasons"].push_back({{"date", today()}, {"after", build_info().commit}, {"reason", reason}});
  OutputFile out = OutputFile::replacing(file);
  out << accepted.dump(1) << "\n";
  out.finish();
  return good;
}

}  // namespace furrow::benchmarks
