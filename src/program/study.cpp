#include "studies/study.h"

#include <algorithm>
#include <cstdio>
#include <thread>

#include "program/commands.h"
#include "program/progress.h"

namespace furrow {

int study_command(const StudyOptions& options) {
  if (options.name.empty()) {
    for (const studies::Study& study : studies::catalogue())
      std::printf("%-16s %s\n", study.name.c_str(), study.what.c_str());
    return good;
  }
  Progress progress;
  studies::Settings settings{.quick = options.quick, .directory = options.directory};
  settings.jobs = options.jobs > 0 ? options.jobs : std::max(1U, std::thread::hardware_concurrency());
  settings.progress = [&](double done, double total) { return progress.show(options.name, "running", done, total); };
  const std::vector<std::string> refuted = studies::run_study(options.name, settings);
  std::printf("%s/%s.json\n", options.directory.c_str(), options.name.c_str());
  for (const std::string& claim : refuted) progress.say("furrow: does not hold: " + claim);
  return refuted.empty() ? good : check_failed;
}

}  // namespace furrow
