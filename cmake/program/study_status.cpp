#include "study_status.h"

#include <cstdio>

#include "output/files.h"
#include "program/exit_code.h"
#include "validation/page/age_words.h"
#include "validation/page/kept_files.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;

std::string date(const std::string& when) { return when.substr(0, 10); }

std::string status_of(const Study& study, const fs::path& directory) {
  const fs::path file = directory / (study.name + ".json");
  const Numbers numbers = Numbers::read(file);
  if (numbers.study() != study.name) throw FileError(file.string() + " has the numbers of " + numbers.study());
  if (numbers.results().empty()) throw FileError(file.string() + " has no numbers");
  try {
    const auto [age, not_kept] = age_today(study, numbers);
    const std::size_t more = not_kept.size();
    return status_line(age) + (more == 0 ? "" : "; not made yet: " + validation::listed(not_kept, 3));
  } catch (const std::exception& error) {  // the search of a study goes by numbers that are not there
    return status_line(age_of(numbers, study.sources())) + "; inputs are not compared: " + error.what();
  }
}

void print(const std::string& name, const std::string& line) { std::printf("%-16s %s\n", name.c_str(), line.c_str()); }

}  // namespace

std::string status_line(const Age& age) {
  char counts[64];
  std::snprintf(counts, sizeof counts, "%8zu %6zu %12s %12s  ", age.results, age.old, date(age.first).c_str(),
                date(age.last).c_str());
  std::string since;
  const auto add = [&](const std::string& words) { since += (since.empty() ? "" : "; ") + words; };
  std::string files;
  for (const std::string& one : age.changed) files += (files.empty() ? "" : " ") + one;
  if (!files.empty()) add(files);
  if (!age.inputs.empty()) add("the input of " + validation::listed(age.inputs, 3));
  if (age.unknown > 0) add(std::to_string(age.unknown) + " by an earlier form, which does not say of which sources");
  return counts + since;
}

int print_status(const std::vector<const Study*>& studies, const fs::path& directory, bool beside) {
  std::printf("%-16s %8s %6s %12s %12s  %s\n", "study", "numbers", "old", "first", "last", "changed since");
  int status = good;
  for (const Study* study : studies) {
    try {
      print(study->name, status_of(*study, directory));
    } catch (const FileError& error) {
      print(study->name, error.what());
      status = io_failed;
    }
  }
  if (!beside) return status;
  const fs::path above = (directory / "..").lexically_normal();
  validation::Evidence evidence;
  if (fs::exists(above / "faults.json")) evidence.faults = above / "faults.json";
  if (fs::exists(above / "judgements.json")) evidence.judgements = above / "judgements.json";
  for (const validation::KeptFile& file : validation::kept_files(evidence)) print(file.id, status_line(file.age));
  for (const std::string& why : validation::missing_evidence(evidence)) {
    std::printf("%s\n", why.c_str());
    status = io_failed;
  }
  return status;
}

}  // namespace furrow
