#include "report/study.h"

#include <algorithm>

#include "output/files.h"
#include "report/embedded.h"
#include "scene/read.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;

// Before a study is measured, which may take an hour: its chapter needs the numbers of another.
void require_numbers(const std::string& study, const std::string& of, const fs::path& directory) {
  const fs::path file = directory / (of + ".json");
  const std::string makes = "; furrow study " + of + " --out " + directory.string() + " makes it";
  if (!fs::exists(file))
    throw FileError(study + " reads the numbers of " + of + ", and there is no " + file.string() + makes);
  if (Numbers::read(file).study() != of) throw FileError(file.string() + ": is not the study " + of + makes);
}

std::vector<std::string> refuted(const Json& report, const std::set<std::string>& old_times) {
  std::vector<std::string> texts;
  for (const Json& claim : report.at("claims")) {
    if (holds_today(claim, old_times)) continue;
    const bool waits = claim.at("holds").get<bool>();
    texts.push_back(claim.at("text").get<std::string>() + (waits ? " (by times that are older than the solver)" : ""));
  }
  return texts;
}

Json json_of(Figure figure) {
  return {{"kind", "figure"},
          {"name", std::move(figure.name)},
          {"script", std::move(figure.script)},
          {"caption", std::move(figure.caption)},
          {"description", std::move(figure.description)},
          {"variables", std::move(figure.variables)},
          {"blocks", std::move(figure.blocks)},
          {"folded", std::move(figure.folded)}};
}

}  // namespace

Scene scene_named(const std::string& name) {
  const std::string file = "validation/scenes/" + name + ".toml";
  return parse_scene(embedded(file), file);
}

Report::Report(std::string title, std::string question) {
  json_ = {{"title", std::move(title)},
           {"question", std::move(question)},
           {"headlines", Json::array()},
           {"parts", Json::array()},
           {"claims", Json::array()}};
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
  json_["parts"].push_back(json_of(std::move(figure)));
  return *this;
}

Report& Report::first_figure(const Figure& figure) {
  json_["first_figure"] = json_of(figure);
  return *this;
}

Report& Report::claim(Claim claim) {
  json_["claims"].push_back({{"text", std::move(claim.text)},
                             {"value", std::move(claim.value)},
                             {"aim", std::move(claim.aim)},
                             {"holds", claim.holds},
                             {"timed", claim.timed},
                             {"numbers", std::move(claim.numbers)}});
  return *this;
}

Report& Report::headline(Headline headline) {
  json_["headlines"].push_back({{"tile", std::move(headline.tile)},
                                {"value", std::move(headline.value)},
                                {"text", std::move(headline.text)},
                                {"numbers", std::move(headline.numbers)}});
  return *this;
}

Report& Report::append(const Report& other) {
  for (const char* list : {"headlines", "parts", "claims"}) {
    for (const Json& one : other.json_.at(list)) json_[list].push_back(one);
  }
  return *this;
}

Report& Report::data(Json data) {
  json_["data"] = std::move(data);
  return *this;
}

const Numbers& Shelf::of(const std::string& study) const {
  const auto known = read_.find(study);
  return known != read_.end() ? known->second
                              : read_.emplace(study, Numbers::read(directory_ / (study + ".json"))).first->second;
}

void Shelf::put(Numbers numbers) { read_.insert_or_assign(numbers.study(), std::move(numbers)); }

std::set<std::string> old_times_of(const Study& study, const Shelf& shelf, const std::vector<Study>& all) {
  std::set<std::string> old = age_of(shelf.of(study.name), study.sources()).old_times;
  for (const Study& other : all) {
    if (std::find(study.reads.begin(), study.reads.end(), other.name) == study.reads.end()) continue;
    old.merge(age_of(shelf.of(other.name), other.sources()).old_times);
  }
  return old;
}

bool rests_on(const Json& said, const std::set<std::string>& old_times) {
  const Json numbers = said.value("numbers", Json::array());
  if (numbers.empty()) return !old_times.empty();
  return std::any_of(numbers.begin(), numbers.end(),
                     [&](const Json& key) { return old_times.count(key.get<std::string>()) > 0; });
}

bool holds_today(const Json& claim, const std::set<std::string>& old_times) {
  return claim.at("holds").get<bool>() && !(claim.value("timed", false) && rests_on(claim, old_times));
}

std::vector<std::string> run_study(const Study& study, const Settings& settings, const std::vector<Study>& all) {
  for (const std::string& read : study.reads) require_numbers(study.name, read, settings.directory);
  Measurement measurement(study.name, settings, study.sources());
  study.measure(measurement);
  measurement.numbers().write(settings.directory / (study.name + ".json"));
  fs::remove(settings.directory / (study.name + ".runs.jsonl"));
  Shelf shelf(settings.directory);
  shelf.put(measurement.numbers());
  try {
    return refuted(study.chapter(shelf).json(), old_times_of(study, shelf, all));
  } catch (const Json::exception& error) {
    throw FileError(settings.directory.string() + ": " + no_chapter(study, error.what()));
  }
}

std::string no_chapter(const Study& study, const std::string& why) {
  std::string read = study.name;
  for (const std::string& other : study.reads) read += ", " + other;
  return "of the numbers of " + read + " no chapter can be made (" + why +
         "): some are of an earlier form, or the chapter asks for others; " + study.command() + " makes them again";
}

AgeToday age_today(const Study& study, const Numbers& kept) {
  const Sources sources = study.sources();
  InputsToday today(study.name, kept, sources);
  study.measure(today);
  return {age_of(kept, {[&](const Result&) -> const Sources& { return sources; }, today.inputs()}), today.not_kept()};
}

Checked check_study(const Study& study, const fs::path& directory, std::uint64_t draw, double most_cpu) {
  const fs::path file = directory / (study.name + ".json");
  const Numbers kept = Numbers::read(file);
  if (kept.study() != study.name) throw FileError(file.string() + ": is of the study " + kept.study());
  Recomputation sample(study.name, kept, study.sources(), draw, most_cpu);
  study.measure(sample);
  Checked checked{sample.compared(), sample.wrong()};
  for (const Result& result : kept.results()) {
    if (!sample.numbers().find(result.key))
      checked.wrong.push_back(result.key + ": is kept, and no result of the study");
  }
  if (sample.has_numbers() && checked.compared == 0) checked.wrong.emplace_back("no number was compared");
  return checked;
}

}  // namespace furrow
