#include "validation/page/mutants.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "output/files.h"
#include "output/strict_json.h"
#include "validation/page/html.h"

namespace furrow::validation {
namespace {

using Json = nlohmann::ordered_json;

Json read(const std::filesystem::path& file) {
  std::ifstream stream = regular_file(file);
  return json_or_discarded(stream);
}

// "91 %", and its 95 % interval.
std::string share(const Json& row, const char* which, bool interval = true) {
  const Json& s = row.at(which);
  if (!s.at("share").is_number()) return "–";
  const auto percent = [&](const char* key) { return std::to_string(std::lround(100 * s.at(key).get<double>())); };
  return percent("share") + " %" + (interval ? " (" + percent("low") + " to " + percent("high") + ")" : "");
}

std::string row_of(const Json& row) {
  return element(
      "tr", "<th scope=\"row\">" + escaped(row.at("name").get<std::string>()) + "</th>" +
                element("td", row.at("tried").dump(), "number") + element("td", row.at("noticed").dump(), "number") +
                element("td", row.at("equivalent").dump(), "number") + element("td", share(row, "raw"), "number") +
                element("td", share(row, "adjusted"), "number"));
}

}  // namespace

std::string unusable_mutants(const std::filesystem::path& file) {
  const Json kept = read(file);
  if (!std::filesystem::is_regular_file(file)) return file.string() + ": is no file that can be read";
  if (!kept.is_object()) return file.string() + ": is not what scripts/mutants writes";
  for (const char* key : {"commit", "seed", "all", "rooms", "mutants"}) {
    if (!kept.contains(key)) return file.string() + ": does not say its " + key;
  }
  const Json& all = kept["all"];
  return all["tried"] == kept["mutants"].size() ? "" : file.string() + ": contradicts itself about how many were tried";
}

std::string mutants_in_short(const std::filesystem::path& file) {
  if (file.empty() || !unusable_mutants(file).empty()) return {};
  const Json kept = read(file);
  return share(kept["all"], "adjusted", false) + " of " + kept["all"]["tried"].dump() +
         " small random edits of the source";
}

std::string mutants_part(const std::filesystem::path& file, Page& page) {
  if (file.empty()) return {};
  if (const std::string why = unusable_mutants(file); !why.empty()) return element("p", escaped(why), "missing");
  const Json kept = read(file);
  std::string rows;
  for (const Json& row : kept["rooms"]) rows += row_of(row);
  rows += row_of(kept["all"]);
  return element("p", "Beside these faults, which were thought of, small random edits were drawn, seed " +
                          kept["seed"].dump() +
                          ", and all tests tried on each. Equivalent: one that changes nothing, by "
                          "proof or because the same program comes out. Adjusted: without these. Tried on commit " +
                          escaped(kept["commit"].get<std::string>()) + ".") +
         framed({page.id("table random edits"),
                 "Random edits of the source by its part, and how many of them some test notices; in brackets the 95 % "
                 "interval.",
                 "Random edits", "study",
                 head_cell("Part of the source") + head_cell("Tried", true) + head_cell("Noticed", true) +
                     head_cell("Equivalent", true) + head_cell("Share noticed", true) + head_cell("Adjusted", true),
                 rows});
}

}  // namespace furrow::validation
