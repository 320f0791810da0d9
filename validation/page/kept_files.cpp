#include "validation/page/kept_files.h"

#include <nlohmann/json.hpp>

#include "report/inputs.h"
#include "report/seal.h"
#include "validation/page/judgements.h"

namespace furrow::validation {
namespace {

std::string judged_as(const Json& engine) {
  if (engine.value("foreign", false)) return "judged_others";
  return engine.at("engine").get<std::string>().starts_with("furrow") ? "judged_furrow" : "judged_independent";
}

std::string key_of(const Json& engine, const std::string& name) {
  const std::string method = engine.at("method");
  return engine.at("engine").get<std::string>() + (method.empty() ? "" : ", " + method) + ": " + name;
}

std::string by_property(const std::string& name) { return name + " by property"; }

}  // namespace

Numbers numbers_of_faults(const Json& kept) {
  Numbers numbers("faults", "full");
  for (const Json& fault : kept.at("results")) {
    const std::string name = fault.at("name"), input = fault.value("input", "");
    numbers.add({.key = name, .input = input, .value = {}}, maker_in(kept, fault));
    if (!fault.contains("by_property")) continue;
    Maker maker = maker_in(kept, fault, "property_maker");
    maker.commit = fault.value("property_commit", maker.commit);  // of an earlier form
    numbers.add({.key = by_property(name), .input = input, .value = {}}, maker);
  }
  return numbers;
}

Age age_of_faults(const Json& kept) {
  const Sources today = that_decide("faults");
  Inputs inputs;
  for (const auto& [name, hash] : inputs_of_faults()) inputs[name] = inputs[by_property(name)] = hash;
  return age_of(numbers_of_faults(kept), {[&](const Result&) -> const Sources& { return today; }, inputs});
}

Numbers numbers_of_judgements(const Json& kept) {
  Numbers numbers("judgements", "full");
  const Json inputs = kept.value("inputs", Json::object());
  for (const Json& engine : kept.at("engines")) {
    for (const auto& [name, said] : engine.at("verdicts").items())
      numbers.add({.key = key_of(engine, name), .input = inputs.value(name, ""), .value = judged_as(engine)},
                  maker_in(kept, engine));
  }
  return numbers;
}

Age age_of_judgements(const Json& kept) {
  std::map<std::string, Sources> today;
  for (const char* what : {"judged_furrow", "judged_independent", "judged_others"}) today[what] = that_decide(what);
  Inputs of_cases, inputs;
  for (const auto& [name, title] : kept.at("cases").items()) {
    if (is_case(name)) of_cases[name] = input_of_case(name);
  }
  for (const Json& engine : kept.at("engines")) {
    for (const auto& [name, hash] : of_cases) inputs[key_of(engine, name)] = hash;
  }
  return age_of(numbers_of_judgements(kept),
                {[&](const Result& r) -> const Sources& { return today.at(r.value.get<std::string>()); }, inputs});
}

Numbers numbers_of_checks(const Json& kept) {
  Numbers numbers("checks", "full");
  const Maker maker = kept.contains("made_by") ? maker_of(kept["made_by"]) : Maker();
  for (std::size_t k = 0; k < kept.at("checks").size(); ++k)
    numbers.add({.key = "check " + std::to_string(k), .value = {}}, maker);
  return numbers;
}

Age age_of_checks(const Json& kept) { return age_of(numbers_of_checks(kept), that_decide("faults")); }

std::vector<KeptFile> kept_files(const Evidence& evidence) {
  std::vector<KeptFile> files;
  if (!evidence.checks.empty() && unusable_checks(evidence.checks).empty()) {
    const Json kept = read_sealed(evidence.checks);
    files.push_back({"checks", "Checks of verification", "scripts/test", kept.at("checks").size(),
                     numbers_of_checks(kept), age_of_checks(kept)});
  }
  if (!evidence.faults.empty() && unusable_faults(evidence.faults).empty()) {
    const Json kept = read_sealed(evidence.faults);
    files.push_back({"faults", "Faults that they notice", "scripts/faults", kept.at("results").size(),
                     numbers_of_faults(kept), age_of_faults(kept)});
  }
  if (!evidence.judgements.empty() && unusable_judgements(evidence.judgements).empty()) {
    const Json kept = read_sealed(evidence.judgements);
    files.push_back({"judgements", "Engines judged by the same cases", "scripts/judge --keep",
                     kept.at("engines").size(), numbers_of_judgements(kept), age_of_judgements(kept)});
  }
  return files;
}

}  // namespace furrow::validation
