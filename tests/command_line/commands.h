// The commands of the program as it lists them itself, so that a new one is not left out of a test.
#pragma once

#include <sys/stat.h>

#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "output/file_list.h"
#include "tests/command_line/program.h"

namespace furrow::test {

// The first words below "Subcommands:".
inline std::vector<std::string> commands_in(const std::string& help) {
  std::istringstream lines(help.substr(help.find("\nSubcommands:") + 1));
  std::vector<std::string> names;
  std::string line, word;
  std::getline(lines, line);
  while (std::getline(lines, line) && !line.empty())
    if (line[2] != ' ' && std::istringstream(line) >> word) names.push_back(word);
  return names;
}

// The command lines below "Examples".
inline std::vector<std::string> examples_in(const std::string& help) {
  std::istringstream lines(help.substr(std::min(help.find("\nExamples"), help.size())));
  std::vector<std::string> examples;
  std::string line;
  while (std::getline(lines, line))
    if (line.starts_with("  furrow ")) examples.push_back(line.substr(2));
  return examples;
}

// How to call a command such that it does not end: it works, or waits for what does not come.
struct Call {
  enum class Kind { works, waits, ends_at_once };
  std::string arguments;
  Kind kind = Kind::works;
  std::string input = "/dev/null";
};

class Commands : public Program {
 protected:
  static constexpr Call::Kind waits = Call::Kind::waits, ends_at_once = Call::Kind::ends_at_once;

  // A bed that takes minutes to place or to settle.
  void put_large_bed(const std::string& file, const std::string& count, const std::string& side,
                     const std::string& more = "") const {
    put(file, "title = \"large\"\n[model]\ngravity = 9.81\n[time]\nstep = 1e-5\nend = 1.0\n" + more +
                  "[contact]\nfriction = 0.5\ndamping_factor = 1.0\n[[material]]\nname = \"sand\"\nyoung = "
                  "1e8\npoisson = 0.3\n[[packing]]\nmaterial = \"sand\"\ncount = " +
                  count + "\nradius_min = 0.01\nradius_max = 0.01\nlower_left = [0.0, 0.0]\nupper_right = [" + side +
                  ", " + side +
                  "]\nseed = 1\n[[wall]]\npoint = [0.0, 0.0]\nnormal = [0.0, 1.0]\nmaterial = \"sand\"\n");
  }

  // What the calls need: a bed far beyond what random placing reaches, a pipe that nobody writes to, a run whose list
  // of files has one that takes minutes to read, the numbers that a study reads.
  void put_what_takes_long() const {
    for (const char* file :
         {"large.toml", "scenes/scenario_1.toml", "scenes/scenario_2.toml", "scenes/scenario_3.toml"})
      put_large_bed(file, "2000000", "39.0");
    ASSERT_EQ(mkfifo((directory_ / "pipe.toml").c_str(), 0600), 0);
    fs::create_directory(directory_ / "numbers_of_statements");
    for (const char* study : {"ensemble", "convergence", "readings"})
      fs::copy_file(FURROW_SOURCE_DIR "/reference_data/studies/" + std::string(study) + ".json",
                    directory_ / "numbers_of_statements" / (std::string(study) + ".json"));
    put("film/rows.csv", "");
    fs::resize_file(directory_ / "film/rows.csv", std::uintmax_t{1} << 37);  // bytes, none of them on the disk
    put("film/run.json", sealed_text({{"ended", "finished"}, {"files", {{"rows.csv", "another"}}}}));
  }

  const std::map<std::string, Call> calls_{
      {"run", {"run large.toml --out ran"}},
      {"check", {"check pipe.toml", waits}},
      {"explain", {"explain large.toml"}},
      {"export", {"export large.toml --out deck"}},
      {"methods", {"methods", ends_at_once}},
      {"keys", {"keys", ends_at_once}},
      {"stability", {"stability large.toml"}},
      {"cases", {"cases", ends_at_once}},
      {"judge", {"judge --engine 'sleep 1000' --cases spring", waits}},
      {"engine", {"engine", waits, "pipe.toml"}},
      {"report", {"report --scenes scenes --out page"}},
      {"view", {"view film"}},
      {"study", {"study order --jobs 1 --out numbers"}},
      {"ensemble", {"ensemble --jobs 1 --out numbers_of_ensemble"}},
      {"statements", {"statements --jobs 1 --out numbers_of_statements"}},
      {"golden", {"golden --goldens '" FURROW_SOURCE_DIR "/reference_data/golden'"}},
      {"calibrate",
       {"calibrate '" FURROW_SOURCE_DIR
        "/src/python/stem.toml' --vary 'lattice[0].structural.stiffness=5e3:3e4:log' --to "
        "'" FURROW_SOURCE_DIR
        "/validation/calibration/example/bent_stem.toml' --points 100000 --jobs 1 --out fitted"}}};
};

}  // namespace furrow::test
