#include "validation/page/studies.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <vector>

#include "validation/page/age_words.h"
#include "validation/page/evidence.h"
#include "validation/page/gnuplot.h"
#include "validation/page/html.h"
#include "validation/page/kept_files.h"
#include "validation/page/template.h"

namespace furrow::validation {
namespace {

using nlohmann::ordered_json;

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
  const std::string said = value.get<std::string>(), words = said == "-" ? "–" : said, chip = chip_or_words(words);
  if (chip[0] == '<') return element("td", chip);
  return element("td", breakable(words), in_numbers && words.find(' ') == std::string::npos ? "number" : "");
}

// A cell may be an object: "text", "id" for its row to be linked to, "links", of which the first that leads to a part of
// the page is taken, and "below", in small print, with "file", one beside the page.
std::string rich_cell(const ordered_json& value, Page& page) {
  std::string words = breakable(value.at("text").get<std::string>()), link;
  for (const ordered_json& id : value.value("links", ordered_json::array()))
    if (link.empty() && page.has(id.get<std::string>())) link = id.get<std::string>();
  if (!link.empty()) words = "<a href=\"#" + link + "\">" + words + "</a>";
  if (value.contains("below")) {
    const std::string below = text(value, "below"), file = value.value("file", "");
    words += element("small", file.empty() ? below : "<a href=\"" + file + "\">" + below + "</a>");
  }
  return element("td", words);
}

std::string row_of(const std::string& cells, const ordered_json& row, Page& page) {
  for (const ordered_json& value : row)
    if (value.is_object() && value.contains("id"))
      return "<tr id=\"" + page.id(value.at("id").get<std::string>()) + "\">" + cells + "</tr>\n";
  return element("tr", cells);
}

constexpr std::size_t wide = 8;    // columns: as many go into the page in small print only
constexpr std::size_t groups = 3;  // rows that begin alike, on average: from there they fold

// Whether rows that follow each other begin with the same words, as those of one scene do.
bool comes_in_groups(const ordered_json& rows) {
  std::size_t begun = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (rows[k].empty() || !rows[k][0].is_string()) return false;
    begun += k == 0 || rows[k][0] != rows[k - 1][0] ? 1 : 0;
  }
  return begun > 1 && rows.size() >= groups * begun;
}

// A column whose first row is a number is set to the right, its heading too.
std::string table_of(const ordered_json& part, const std::string& under, Page& page) {
  const ordered_json& rows = part.at("rows");
  const std::size_t columns = part.at("head").size();
  const auto is_number = [&](std::size_t k) { return !rows.empty() && rows[0].size() > k && rows[0][k].is_number(); };
  TableFrame table;
  for (std::size_t k = 0; k < columns; ++k)
    table.head += head_cell(breakable(part.at("head")[k].get<std::string>()), is_number(k));
  for (const ordered_json& row : rows) {
    std::string cells;
    for (std::size_t k = 0; k < std::max(columns, row.size()); ++k)
      cells += k >= row.size()      ? element("td", "")
               : row[k].is_object() ? rich_cell(row[k], page)
                                    : cell(row[k], is_number(k));
    table.body += row_of(cells, row, page);
  }
  table.caption = text(part, "caption");
  table.name = escaped(under);
  table.id = page.id("table " + under + " " + bare(table.caption));
  table.kind = std::string("study") + (columns >= wide ? " wide" : "") + (comes_in_groups(rows) ? " grouped" : "");
  return framed(table);
}

std::string figure_of(const ordered_json& part, Page& page) {
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
  const std::string name = part.at("name");
  const std::string svg = drawn(input, part.at("script"), page.files, name, part.at("description"));
  const std::string html =
      framed(page, {page.id("figure " + name), "<div class=\"plot\">" + svg + "</div>", text(part, "caption"), name});
  if (part.value("folded", "").empty()) return html;
  return "<details class=\"unfold\">" + element("summary", text(part, "folded")) + html + "</details>\n";
}

std::string id_of_claim(const StudyResult& result, std::size_t k) {
  return "claim_" + result.name + "_" + std::to_string(k + 1);
}

// Value first, then the aim, then the mark and what it is about.
std::string claims_of(const StudyResult& result) {
  const ordered_json& claims = result.report.at("claims");
  std::string rows;
  for (std::size_t k = 0; k < claims.size(); ++k) {
    const ordered_json& claim = claims[k];
    const bool holds = holds_today(claim, result.old_times), waits = !holds && claim.at("holds").get<bool>();
    std::string words = claim.value("value", "").empty() ? "" : element("strong", text(claim, "value"));
    if (!claim.value("aim", "").empty()) words += " (aim: " + text(claim, "aim") + ")";
    const std::string mark = waits   ? "<span class=\"chip none\">times older than the solver</span> "
                             : holds ? "<span class=\"chip good\">✓ holds</span> "
                                     : "<span class=\"chip bad\">✗ does not hold</span> ";
    if (!words.empty()) words += " ";
    rows += "<li id=\"" + id_of_claim(result, k) + "\"" +
            (holds   ? ">"
             : waits ? " class=\"waits\">"
                     : " class=\"refuted\">") +
            words + mark + text(claim, "text") + "</li>\n";
  }
  return rows.empty() ? rows : element("ul", rows, "claims");
}

const Study* of_the_page(const Evidence& evidence, const std::string& name) {
  if (!unusable_study(evidence, name).empty()) return nullptr;
  return &*std::find_if(evidence.catalogue.begin(), evidence.catalogue.end(),
                        [&](const Study& s) { return s.name == name; });
}

std::string ages_of_studies(const Evidence& evidence) {
  if (evidence.studies.empty()) return {};
  const Shelf shelf(evidence.studies);
  std::size_t results = 0, old = 0;
  std::string which;
  for (const std::string& name : studies_of_the_page()) {
    const Study* study = of_the_page(evidence, name);
    if (!study) continue;
    const Age age = age_of(shelf.of(name), study->sources());
    results += age.results;
    old += age.old;
    if (age.old > 0)
      which += (which.empty() ? "; older: " : ", ") + name + " (" + std::to_string(age.old) + " of " +
               std::to_string(age.results) + ")";
  }
  return std::to_string(results - old) + " of " + std::to_string(results) +
         " numbers of studies are of today's solver" + which;
}

}  // namespace

std::string ages_in_words(const Evidence& evidence) {
  std::string words = ages_of_studies(evidence);
  for (const KeptFile& file : kept_files(evidence))
    words += (words.empty() ? "" : "; ") + file.id + ": " + std::to_string(file.age.results - file.age.old) + " of " +
             std::to_string(file.age.results) + " of today's sources";
  return words;
}

std::vector<StudyResult> study_results(const Evidence& evidence) {
  std::vector<StudyResult> results;
  if (evidence.studies.empty()) return results;
  const Shelf shelf(evidence.studies);
  for (const std::string& name : studies_of_the_page()) {
    const Study* study = of_the_page(evidence, name);
    if (!study) continue;
    StudyResult result{name, study->chapter(shelf).json(), "", age_of(shelf.of(name), study->sources())};
    result.made_by = study->command();
    result.old_times = old_times_of(*study, shelf, evidence.catalogue);
    for (const Maker& maker : shelf.of(name).makers()) result.machines.insert(maker.machine);
    std::vector<std::string> read{name};
    read.insert(read.end(), study->reads.begin(), study->reads.end());
    for (const Study& other : evidence.catalogue) {
      if (std::find(read.begin(), read.end(), other.name) == read.end()) continue;
      const Age age = age_of(shelf.of(other.name), other.sources());
      if (other.name != name) result.old_read += age.old;
      result.age += (other.name == name ? " " : " Of the study " + other.name + ": ") +
                    typeset(escaped(words_of(shelf.of(other.name), age)));
    }
    results.push_back(std::move(result));
  }
  return results;
}

std::string chapter_html(const StudyResult& result, const std::string& number, Page& page) {
  const ordered_json& report = result.report;
  const std::string title = text(report, "title");
  std::string html = heading(3, page.id(result.name), element("span", number, "section") + title) +
                     element("p", text(report, "question"), "lead");
  html += claims_of(result);
  std::string under = report.at("title");
  for (const ordered_json& part : report.at("parts")) {
    const std::string kind = part.at("kind");
    if (kind == "heading") {
      under = part.at("text");
      html += heading(4, page.id(result.name + " " + under), text(part, "text"));
    } else if (kind == "text") {
      html += element("p", text(part, "text"));
    } else {
      html += kind == "table" ? table_of(part, under, page) : figure_of(part, page);
    }
  }
  return html;
}

std::string study_section(const StudyResult& result, const std::string& number, Page& page) {
  const std::string id = page.id("study " + result.name);
  const std::string made = " By <code>" + result.made_by + "</code>:" + result.age;
  return "<section id=\"" + id + "\">\n" + chapter_html(result, number, page) +
         element("p", age_chip(result.numbers, result.old_read) + made, "note") + "</section>\n";
}

std::string first_figure(const StudyResult& result, Page& page) {
  return figure_of(result.report.at("first_figure"), page);
}

std::size_t claims_in(const StudyResult& result) { return result.report.at("claims").size(); }

std::vector<Refuted> refuted_claims(const StudyResult& result) {
  std::vector<Refuted> all;
  const ordered_json& claims = result.report.at("claims");
  for (std::size_t k = 0; k < claims.size(); ++k) {
    const ordered_json& claim = claims[k];
    if (holds_today(claim, result.old_times)) continue;
    const auto words = [&](const char* key) { return claim.value(key, "").empty() ? std::string() : text(claim, key); };
    all.push_back({id_of_claim(result, k), words("value"), words("aim"), words("text"), claim.at("holds").get<bool>()});
  }
  return all;
}

}  // namespace furrow::validation
