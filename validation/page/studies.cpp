#include "validation/page/studies.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <vector>

#include "report/embedded.h"
#include "validation/page/evidence.h"
#include "validation/page/gnuplot.h"
#include "validation/page/html.h"

namespace furrow::validation {
namespace {

using nlohmann::ordered_json;

struct Result {
  std::string name;
  ordered_json json;
  std::string age;  // HTML: when, by which commit and machine the numbers were made, and what changed since
  bool old_times = false;
};

std::string text(const ordered_json& entry, const char* key) {
  return typeset(escaped(entry.at(key).get<std::string>()));
}

// Long names may break at their underscores.
std::string breakable(const std::string& words) {
  std::string html;
  for (const char c : escaped(words)) html += c == '_' ? std::string("_<wbr>") : std::string(1, c);
  return typeset(html);
}

// Words in a column of numbers stand to the right only if they are one.
std::string cell(const ordered_json& value, bool in_numbers) {
  if (value.is_number()) return element("td", shown(value.get<double>()), "number");
  if (!value.is_string()) return element("td", missing, in_numbers ? "number" : "");
  const std::string words = value.get<std::string>();
  return element("td", breakable(words), in_numbers && words.find(' ') == std::string::npos ? "number" : "");
}

constexpr std::size_t wide = 8;  // columns: as many go into the page in small print only

// A column whose first row is a number is set to the right, its heading too.
std::string table_of(const ordered_json& part) {
  const ordered_json& rows = part.at("rows");
  const std::size_t columns = part.at("head").size();
  const auto is_number = [&](std::size_t k) { return !rows.empty() && rows[0].size() > k && rows[0][k].is_number(); };
  std::string head, body;
  for (std::size_t k = 0; k < columns; ++k) {
    head += is_number(k) ? "<th class=\"number\">" : "<th>";
    head += breakable(part.at("head")[k].get<std::string>()) + "</th>";
  }
  for (const ordered_json& row : rows) {
    std::string cells;
    for (std::size_t k = 0; k < std::max(columns, row.size()); ++k)
      cells += k < row.size() ? cell(row[k], is_number(k)) : element("td", "");
    body += element("tr", cells);
  }
  const std::string caption = text(part, "caption");
  return std::string("<div class=\"scroll\"><table class=\"study") + (columns >= wide ? " wide" : "") + "\">" +
         (caption.empty() ? "" : element("caption", caption)) + element("thead", element("tr", head)) +
         element("tbody", body) + "</table></div>\n";
}

std::string figure_of(const ordered_json& part, Drawings& drawings) {
  PlotInput input;
  for (const auto& [name, value] : part.at("variables").items()) {
    if (value.is_number()) {
      input.set(name, value.get<double>());
    } else {
      input.set(name, std::string_view(value.get_ref<const std::string&>()));
    }
  }
  for (const auto& [name, block] : part.at("blocks").items()) {
    std::vector<PlotInput::Row> rows;
    for (const ordered_json& row : block) {
      PlotInput::Row numbers;
      for (const ordered_json& value : row) {
        if (value.is_string()) {
          numbers.second = value.get<std::string>();
        } else {
          numbers.first.push_back(value.is_number() ? value.get<double>() : NAN);
        }
      }
      rows.push_back(std::move(numbers));
    }
    input.block(name, rows);
  }
  const auto script = [](const std::string& file) { return std::string(embedded("validation/figures/" + file)); };
  const std::string drawn = draw(input, script("palettes.gp") + script(part.at("script")), drawings,
                                 part.at("name").get<std::string>(), part.at("description").get<std::string>());
  return figure(drawn, text(part, "caption"));
}

std::string part_of(const ordered_json& part, Drawings& drawings) {
  const std::string kind = part.at("kind");
  if (kind == "heading") return element("h3", text(part, "text"));
  if (kind == "text") return element("p", text(part, "text"));
  if (kind == "table") return table_of(part);
  return figure_of(part, drawings);
}

std::string listed(const std::vector<std::string>& all, std::size_t most) {
  std::string list;
  for (std::size_t k = 0; k < std::min(most, all.size()); ++k) list += (k == 0 ? "" : ", ") + all[k];
  return list + (all.size() > most ? " and " + std::to_string(all.size() - most) + " more" : "");
}

std::string words_of(const Numbers& numbers, const Age& age) {
  std::set<std::string> machines;
  for (const Maker& maker : numbers.makers()) machines.insert(maker.machine);
  std::string words = std::to_string(age.results) + " results, made " + age.first.substr(0, 10) +
                      (age.last.substr(0, 10) != age.first.substr(0, 10) ? " to " + age.last.substr(0, 10) : "") +
                      " by commit " + listed(age.commits, 5) + " on " + listed({machines.begin(), machines.end()}, 3) +
                      ". ";
  if (age.old == 0) return words + "All are of today's solver.";
  return words + std::to_string(age.old) +
         " of them were made before these sources changed: " + listed(age.changed, 8) + ".";
}

// Those that can be shown; what cannot is said by missing_evidence.
std::vector<Result> results_in(const Evidence& evidence, StudyPlace place_on_page) {
  std::vector<Result> results;
  if (evidence.studies.empty()) return results;
  const Shelf shelf(evidence.studies);
  for (const std::string& name : studies_of_the_page()) {
    const bool first = name == studies_of_the_page().front();
    if (first != (place_on_page == StudyPlace::before_scenes) || !unusable_study(evidence, name).empty()) continue;
    const auto study = std::find_if(evidence.catalogue.begin(), evidence.catalogue.end(),
                                    [&](const Study& s) { return s.name == name; });
    Result result{name, study->chapter(shelf).json(), ""};
    std::vector<std::string> read{name};
    read.insert(read.end(), study->reads.begin(), study->reads.end());
    for (const Study& other : evidence.catalogue) {
      if (std::find(read.begin(), read.end(), other.name) == read.end()) continue;
      const Age age = age_of(shelf.of(other.name), other.sources());
      result.old_times = result.old_times || age.old_timed > 0;
      result.age += (other.name == name ? "" : " Of the study " + other.name + ": ") +
                    typeset(escaped(words_of(shelf.of(other.name), age)));
    }
    results.push_back(std::move(result));
  }
  return results;
}

// Value first, then the aim, then the sentence. Times that are older than the solver bear nothing out.
std::string claims_of(const ordered_json& claims, bool old_times) {
  std::string rows;
  for (const ordered_json& claim : claims) {
    const bool old = old_times && claim.value("timed", false), holds = claim.at("holds").get<bool>() && !old;
    std::string words = claim.value("value", "").empty() ? "" : element("strong", text(claim, "value"));
    if (!claim.value("aim", "").empty()) words += " (aim: " + text(claim, "aim") + ")";
    words += (words.empty() ? "" : ": ") + text(claim, "text");
    const char* mark = old ? "Not shown today, the times are older than the solver: " : "Does not hold: ";
    rows += holds ? element("li", words) : element("li", mark + words, "refuted");
  }
  return rows.empty() ? rows : element("ul", rows, "claims");
}

}  // namespace

std::string chapter_html(const ordered_json& json, bool old_times, Drawings& drawings) {
  std::string html = element("h2", text(json, "title")) + element("p", text(json, "question"), "lead");
  html += claims_of(json.at("claims"), old_times);
  for (const ordered_json& part : json.at("parts")) html += part_of(part, drawings);
  return html;
}

std::string study_contents(const Evidence& evidence, StudyPlace place) {
  std::string lines;
  for (const Result& result : results_in(evidence, place)) {
    lines += element("li", "<a href=\"#study_" + result.name + "\">" + text(result.json, "title") + "</a>");
  }
  return lines;
}

std::string study_sections(const Evidence& evidence, StudyPlace place, Drawings& drawings) {
  std::string sections;
  for (const Result& result : results_in(evidence, place)) {
    std::string html = chapter_html(result.json, result.old_times, drawings);
    html += element("p", "By <code>furrow study " + result.name + "</code>: " + result.age, "note");
    sections += "<section id=\"study_" + result.name + "\">\n" + html + "</section>\n";
  }
  return sections;
}

}  // namespace furrow::validation
