// Reads the records of all checks, says what is missing, and prints the checks closest to their limits.
//
// usage: gather RECORDS REQUIREMENTS TESTS
//   RECORDS       directory with one .jsonl file a test; checks.json and summary.txt are written into it
//   REQUIREMENTS  directory with .toml files
//   TESTS         file with the output of --gtest_list_tests: every test must have left records
// Exit codes: 0 good, 1 a check failed, a test left no record, a requirement has no check or a check no requirement;
// 4 a file cannot be read.
#include <toml++/toml.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "report/numbers.h"
#include "report/seal.h"

namespace {

using nlohmann::ordered_json;

std::vector<std::string> tests_in(const std::filesystem::path& list) {
  std::ifstream stream(list);
  std::vector<std::string> tests;
  std::string suite;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line.rfind("Running", 0) == 0) continue;
    if (line[0] != ' ') {
      suite = line;
    } else {
      tests.push_back(suite + line.substr(2));
    }
  }
  return tests;
}

std::map<std::string, std::string> requirements_in(const std::filesystem::path& directory) {
  std::map<std::string, std::string> all;
  for (const auto& file : std::filesystem::directory_iterator(directory)) {
    const toml::table groups = toml::parse_file(file.path().string());
    for (const auto& [group, table] : groups) {
      if (!table.is_table()) throw std::runtime_error(std::string(group.str()) + " is no table of requirements");
      for (const auto& [key, sentence] : *table.as_table()) {
        const std::string id = std::string(group.str()) + "." + std::string(key.str());
        const auto text = sentence.value_or<std::string>("");
        if (text.empty()) throw std::runtime_error("requirement " + id + " has no sentence");
        if (!all.emplace(id, text).second) throw std::runtime_error(id + " is there twice");
      }
    }
  }
  return all;
}

// "nan" and "inf" are text in the records.
double number(const ordered_json& value) { return value.is_number() ? value.get<double>() : HUGE_VAL; }

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 4) {
    std::fprintf(stderr, "usage: gather RECORDS REQUIREMENTS TESTS\n");
    return 2;
  }
  const std::filesystem::path records = argv[1];
  const auto requirements = requirements_in(argv[2]);
  std::set<std::string> faults;  // each said once
  std::vector<ordered_json> checks;
  std::set<std::string> used;
  const auto tests = tests_in(argv[3]);
  if (tests.empty()) faults.insert("there are no verification tests");
  for (const std::string& test : tests) {
    std::ifstream stream(records / (test + ".jsonl"));
    const std::size_t before = checks.size();
    for (std::string line; std::getline(stream, line);) checks.push_back(ordered_json::parse(line));
    if (checks.size() == before) faults.insert(test + " left no record: it did not run, or crashed");
  }
  std::size_t failed = 0;
  for (ordered_json& check : checks) {
    const std::string id = check["requirement"];
    if (!check["good"].get<bool>()) ++failed;
    used.insert(id);
    const auto found = requirements.find(id);
    if (found == requirements.end()) {
      faults.insert(check["test"].get<std::string>() + ": no requirement " + id + " in verification/requirements");
    } else {
      check["sentence"] = found->second;
    }
  }
  for (const auto& [id, sentence] : requirements) {
    if (used.count(id) == 0) faults.insert("requirement " + id + " has no check: " + sentence);
  }
  std::stable_sort(checks.begin(), checks.end(), [](const ordered_json& a, const ordered_json& b) {
    return number(a["of_limit"]) > number(b["of_limit"]);
  });
  std::ofstream out(records / "checks.json");
  ordered_json all{{"made_by", json_of(furrow::this_maker(furrow::that_decide("faults")))},
                   {"tests", tests.size()},
                   {"missing", faults},
                   {"checks", checks}};
  furrow::seal(all);
  out << all.dump(1) << "\n";
  out.close();
  if (!out) throw std::runtime_error("cannot write " + (records / "checks.json").string());

  std::FILE* summary = std::fopen((records / "summary.txt").c_str(), "w");
  if (summary == nullptr) throw std::runtime_error("cannot write " + (records / "summary.txt").string());
  for (std::FILE* to : {stdout, summary}) {
    std::fprintf(to, "%zu checks of %zu requirements in %zu tests, %zu failed; closest to their limits:\n",
                 checks.size(), requirements.size(), tests.size(), failed);
    std::fprintf(to, "  %8s  %-10s  %-10s  %s\n", "of limit", "error", "tolerance", "check");
    for (std::size_t k = 0; k < std::min<std::size_t>(12, checks.size()); ++k) {
      const ordered_json& c = checks[k];
      std::fprintf(to, "  %6.1f %%  %-10.2e  %-10.2e  %s: %s\n", 100 * number(c["of_limit"]), number(c["error"]),
                   number(c["tolerance"]), c["test"].get<std::string>().c_str(), c["name"].get<std::string>().c_str());
    }
    for (const std::string& fault : faults) std::fprintf(to, "FAULT: %s\n", fault.c_str());
  }
  std::fclose(summary);
  return failed == 0 && faults.empty() ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "gather: error: %s\n", error.what());
  return 4;
}
