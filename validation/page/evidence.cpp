#include "validation/page/evidence.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "output/files.h"
#include "report/seal.h"
#include "validation/page/judgements.h"
#include "validation/page/mutants.h"
#include "validation/page/page_parts.h"

namespace furrow::validation {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string text_in(const ordered_json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

const ordered_json& list_in(const ordered_json& object, const char* key) {
  static const ordered_json none = ordered_json::array();
  const auto found = object.find(key);
  return found != object.end() && found->is_array() ? *found : none;
}

// Empty if `check` finds nothing wrong with the file's content.
template <class Check>
std::string unusable(const fs::path& file, const Check& check) {
  try {
    const std::string why = check(read_sealed(file));
    return why.empty() ? "" : file.string() + ": " + why;
  } catch (const FileError& error) {
    return error.what();
  } catch (const std::exception& error) {
    return file.string() + ": " + error.what();
  }
}

// A chapter that cannot be made of the numbers lacks some: of an earlier form of the study, or of another study.
std::string unfit_numbers(const Study& study, const fs::path& directory) {
  const fs::path file = directory / (study.name + ".json");
  try {
    const Shelf shelf(directory);
    const Numbers& numbers = shelf.of(study.name);
    if (numbers.study() != study.name) return file.string() + ": is not the study " + study.name;
    if (numbers.quick()) return file.string() + ": is of the quick form";
    if (numbers.results().empty()) return file.string() + ": holds no results";
    study.chapter(shelf);
    return {};
  } catch (const FileError& error) {
    return error.what();
  } catch (const Json::exception& error) {
    return directory.string() + ": " + no_chapter(study, error.what());
  } catch (const std::exception& error) {
    return file.string() + ": no chapter can be made of it (" + error.what() + ")";
  }
}

// Whether a check is good follows from what it says.
bool consistent(const ordered_json& check) {
  if (!check.is_object() || text_in(check, "test").empty() || text_in(check, "requirement").empty()) return false;
  const auto good = check.find("good"), error = check.find("error"), limit = check.find("tolerance");
  if (good == check.end() || !good->is_boolean() || error == check.end() || limit == check.end()) return false;
  const bool within = error->is_number() && limit->is_number() && error->get<double>() <= limit->get<double>();
  return good->get<bool>() == within;
}

std::string unfit_checks(const ordered_json& all) {
  const ordered_json& checks = list_in(all, "checks");
  if (checks.empty()) return "holds no checks";
  if (const auto missing = list_in(all, "missing"); !missing.empty())
    return "holds " + std::to_string(checks.size()) + " checks only; " + std::to_string(missing.size()) +
           " faults of the suite, the first: " +
           (missing[0].is_string() ? missing[0].get<std::string>() : missing[0].dump());
  const auto bad = std::find_if(checks.begin(), checks.end(), [](const ordered_json& c) { return !consistent(c); });
  return bad == checks.end() ? "" : "check " + std::to_string(bad - checks.begin()) + " contradicts itself";
}

std::string unfit_faults(const ordered_json& study) {
  const ordered_json& results = list_in(study, "results");
  if (results.empty()) return "holds no faults";
  for (const ordered_json& result : results) {
    const std::string name = result.is_object() ? text_in(result, "name") : "";
    if (name.empty()) return "a fault without a name";
    if (maker_in(study, result).commit.empty()) return name + " does not say by which commit it was tried";
    if (result.contains("trouble")) return name + " could not be tried: " + text_in(result, "trouble");
    if (text_in(result, "kind") == "fault" && list_in(result, "failed").empty()) return name + " was not noticed";
    if (result.contains("by_property") && list_in(result, "by_property").empty())
      return name + " was not noticed where the kernel is held against the reference";
    if (text_in(result, "kind") == "constant" && !result.contains("smallest_noticed")) return name + " was not noticed";
  }
  return {};
}

// One kind of evidence: how the page speaks of it, the option that names where it is, and the command that makes it.
struct Kind {
  fs::path Evidence::*place;
  const char *name, *option, *made_by;
  std::string (*unusable)(const fs::path&);  // none: a directory of several files
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {&Evidence::checks, "the checks of verification", "--checks", "scripts/test", unusable_checks},
      {&Evidence::faults, "the fault study", "--faults", "scripts/faults", unusable_faults},
      {&Evidence::mutants, "random edits of the source", "--mutants", "scripts/mutants", unusable_mutants},
      {&Evidence::judgements, "what other engines answer", "--judgements", "scripts/judge --keep", unusable_judgements},
      {&Evidence::studies, "the studies", "--studies", "scripts/studies", nullptr}};
  return all;
}

}  // namespace

const std::vector<std::string>& studies_of_the_page() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> names;
    for (const PagePart& part : page_parts()) names.insert(names.end(), part.studies.begin(), part.studies.end());
    return names;
  }();
  return all;
}

std::string unusable_study(const Evidence& evidence, const std::string& name) {
  for (const Study& study : evidence.catalogue) {
    if (study.name == name) return unfit_numbers(study, evidence.studies);
  }
  return "no chapter tells of the study " + name;
}

std::string unusable_checks(const fs::path& file) { return unusable(file, unfit_checks); }
std::string unusable_faults(const fs::path& file) { return unusable(file, unfit_faults); }

std::vector<std::string> missing_evidence(const Evidence& evidence) {
  std::vector<std::string> all;
  const auto note = [&](const std::string& why, const std::string& made_by) {
    if (!why.empty()) all.push_back(why + "; made by: " + made_by);
  };
  for (const Kind& kind : kinds()) {
    if (kind.unusable != nullptr && !(evidence.*kind.place).empty())
      note(kind.unusable(evidence.*kind.place), kind.made_by);
    if (kind.unusable == nullptr && !(evidence.*kind.place).empty())
      for (const std::string& name : studies_of_the_page())
        note(unusable_study(evidence, name), kind.made_by + (" " + name));
  }
  for (const fs::path& scene : evidence.scenes)
    if (!fs::is_regular_file(scene))
      all.push_back("cannot read " + scene.string() + ", whose run the players show; it comes with the source tree");
  return all;
}

std::vector<std::string> evidence_not_given(const Evidence& evidence) {
  std::vector<std::string> all;
  for (const Kind& kind : kinds()) {
    if ((evidence.*kind.place).empty())
      all.push_back(std::string(kind.name) + ": not given by " + kind.option + "; made by: " + kind.made_by);
  }
  return all;
}

}  // namespace furrow::validation
