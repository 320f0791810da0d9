#include "page/studies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "page/embedded.h"
#include "page/gnuplot.h"
#include "page/html.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct Result {
  std::string name;
  ordered_json json;
};

// In the order in which a reader wants them; others follow by name. The first comes before the scenes: it says how
// their numbers are to be taken.
constexpr std::array<std::string_view, 10> usual_order{"convergence", "statements", "ensemble",  "geometry",
                                                       "outlook",     "order",      "stability", "work_precision",
                                                       "need",        "speed"};

std::vector<Result> results_in(const fs::path& directory, StudyPlace place_on_page) {
  std::vector<Result> results;
  if (directory.empty() || !fs::is_directory(directory)) return results;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
    const bool first = entry.path().stem() == usual_order[0];
    if (entry.path().extension() != ".json" || first != (place_on_page == StudyPlace::before_scenes)) continue;
    std::ifstream stream(entry.path());
    try {
      results.push_back({entry.path().stem(), ordered_json::parse(stream)});
    } catch (const ordered_json::parse_error& error) {
      throw std::runtime_error(entry.path().string() + ": " + error.what());
    }
  }
  const auto place = [](const Result& r) {
    return std::pair(std::find(usual_order.begin(), usual_order.end(), r.name), r.name);
  };
  std::sort(results.begin(), results.end(), [&](const Result& a, const Result& b) { return place(a) < place(b); });
  return results;
}

std::string text(const ordered_json& entry, const char* key) { return escaped(entry.at(key).get<std::string>()); }

// Long names may break at their underscores.
std::string breakable(const std::string& words) {
  std::string html;
  for (const char c : escaped(words)) html += c == '_' ? std::string("_<wbr>") : std::string(1, c);
  return html;
}

std::string cell(const ordered_json& value) {
  if (value.is_number()) return element("td", shown(value.get<double>()), "number");
  return element("td", value.is_string() ? breakable(value.get<std::string>()) : missing);
}

// A column whose first row is a number is set to the right, its heading too.
std::string table_of(const ordered_json& part) {
  const ordered_json& rows = part.at("rows");
  std::string head, body;
  for (std::size_t k = 0; k < part.at("head").size(); ++k) {
    const bool number = !rows.empty() && rows[0].size() > k && rows[0][k].is_number();
    head += number ? "<th class=\"number\">" : "<th>";
    head += escaped(part.at("head")[k].get<std::string>()) + "</th>";
  }
  for (const ordered_json& row : rows) {
    std::string cells;
    for (const ordered_json& value : row) cells += cell(value);
    body += element("tr", cells);
  }
  return "<div class=\"scroll\"><table class=\"study\"><caption>" + text(part, "caption") + "</caption>" +
         element("thead", element("tr", head)) + element("tbody", body) + "</table></div>\n";
}

std::string figure_of(const ordered_json& part, const fs::path& out) {
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
  const std::string drawn =
      draw(input, script("palettes.gp") + script(part.at("script")),
           out / (part.at("name").get<std::string>() + ".svg"), part.at("description").get<std::string>());
  return figure(drawn, text(part, "caption"));
}

std::string part_of(const ordered_json& part, const fs::path& out) {
  const std::string kind = part.at("kind");
  if (kind == "heading") return element("h3", text(part, "text"));
  if (kind == "text") return element("p", text(part, "text"));
  if (kind == "table") return table_of(part);
  return figure_of(part, out);
}

std::string claims_of(const ordered_json& claims) {
  std::string rows;
  for (const ordered_json& claim : claims) {
    rows += claim.at("holds").get<bool>() ? element("li", text(claim, "text"))
                                          : element("li", "Does not hold: " + text(claim, "text"), "refuted");
  }
  return rows.empty() ? rows : element("ul", rows, "claims");
}

}  // namespace

std::string study_contents(const fs::path& directory, StudyPlace place) {
  std::string lines;
  for (const Result& result : results_in(directory, place)) {
    lines += element("li", "<a href=\"#study_" + result.name + "\">" + text(result.json, "title") + "</a>");
  }
  return lines;
}

std::string study_sections(const fs::path& directory, StudyPlace place, const fs::path& out) {
  std::string sections;
  for (const Result& result : results_in(directory, place)) {
    const ordered_json& json = result.json;
    std::string html = element("h2", text(json, "title")) + element("p", text(json, "question"), "lead");
    html += claims_of(json.at("claims"));
    for (const ordered_json& part : json.at("parts")) html += part_of(part, out);
    html += element("p",
                    "By <code>furrow study " + result.name + "</code>, commit " + text(json, "commit") + ", " +
                        text(json, "compiler") + ", " + text(json, "machine") + ".",
                    "note");
    sections += "<section id=\"study_" + result.name + "\">\n" + html + "</section>\n";
  }
  return sections;
}

}  // namespace furrow
