#include "studies/study.h"

#include <algorithm>
#include <cstdio>
#include <thread>

#include "program/commands.h"
#include "program/progress.h"
#include "studies/few_members.h"
#include "studies/golden.h"

namespace furrow {
namespace {

unsigned processors() { return std::max(1U, std::thread::hardware_concurrency()); }

}  // namespace

int study_command(const StudyOptions& options) {
  if (options.name.empty()) {
    for (const studies::Study& study : studies::catalogue())
      std::printf("%-16s %s\n", study.name.c_str(), study.what.c_str());
    return good;
  }
  Progress progress;
  studies::Settings settings{.quick = options.quick, .directory = options.directory};
  settings.jobs = options.jobs > 0 ? options.jobs : processors();
  settings.progress = [&](double done, double total) { return progress.show(options.name, "running", done, total); };
  if (options.few) {
    const auto say = [](const std::string& line) { std::printf("%s\n", line.c_str()); };
    return studies::check_few(settings, say) ? good : check_failed;
  }
  const std::vector<std::string> refuted = studies::run_study(options.name, settings);
  std::printf("%s/%s.json\n", options.directory.c_str(), options.name.c_str());
  for (const std::string& claim : refuted) progress.say("furrow: does not hold: " + claim);
  return refuted.empty() ? good : check_failed;
}

int golden_command(const GoldenRequest& request) {
  Progress progress;
  studies::GoldenOptions options{.directory = request.directory, .quick = request.quick, .remake = request.remake};
  options.reason = request.reason;
  options.jobs = processors();
  options.progress = [&](double done, double total) { return progress.show("golden", "running", done, total); };
  options.say = [](const std::string& line) { std::printf("%s\n", line.c_str()); };
  return studies::check_goldens(options) == 0 ? good : check_failed;
}

}  // namespace furrow
