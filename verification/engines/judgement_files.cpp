#include "verification/engines/judgement_files.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "scene/utf8.h"

namespace furrow::verification {
namespace {

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : visible(text)) {  // XML has no controls
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '"')
      safe += "&quot;";
    else
      safe += c;
  }
  return safe;
}

Json finding_as_json(const Finding& f) {
  Json one{{"name", f.name},         {"unit", f.unit},     {"verdict", to_string(f.verdict)},
           {"expected", f.expected}, {"values", f.values}, {"error", f.error}};
  if (std::isfinite(f.order) && f.order != 0) one["order"] = f.order;
  if (f.verdict == CaseVerdict::another_law) one["limit"] = f.limit;
  if (std::isfinite(f.left)) one["left"] = f.left;
  one["words"] = f.words;
  return one;
}

}  // namespace

std::string table_row(const Judgement& j) {
  char text[600];
  std::snprintf(text, sizeof text, "%-34s %-12s %s", j.name.c_str(), to_string(j.verdict).c_str(), j.words.c_str());
  return text;
}

std::string count_line(const std::vector<Judgement>& all) {
  std::string line;
  for (const CaseVerdict v : {CaseVerdict::right, CaseVerdict::lower_order, CaseVerdict::another_law,
                              CaseVerdict::failed, CaseVerdict::cannot}) {
    const auto count = std::count_if(all.begin(), all.end(), [v](const Judgement& j) { return j.verdict == v; });
    line += (line.empty() ? "" : ", ") + std::to_string(count) + " " + to_string(v);
  }
  return std::to_string(all.size()) + " cases: " + line;
}

Json judgements_as_json(const std::vector<Judgement>& all, const std::string& partial) {
  Json list = Json::array();
  for (const Judgement& j : all) {
    Json findings = Json::array();
    for (const Finding& f : j.findings) findings.push_back(finding_as_json(f));
    list.push_back({{"case", j.name},
                    {"title", j.title},
                    {"engine", j.engine},
                    {"method", j.method},
                    {"order", j.claimed},
                    {"verdict", to_string(j.verdict)},
                    {"words", j.words},
                    {"steps", j.steps},
                    {"observables", findings}});
    if (!j.input.empty()) list.back()["input"] = j.input;
    if (!j.command.empty()) list.back()["command"] = j.command;
    if (!partial.empty()) list.back()["partial"] = partial;
  }
  return list;
}

std::string judgements_as_junit(const std::vector<Judgement>& all, const std::string& partial) {
  const auto bad =
      std::count_if(all.begin(), all.end(), [](const Judgement& j) { return j.verdict > CaseVerdict::cannot; });
  const auto skipped =
      std::count_if(all.begin(), all.end(), [](const Judgement& j) { return j.verdict == CaseVerdict::cannot; });
  std::string text = std::string(judgements_begin_junit) + " tests=\"" + std::to_string(all.size()) + "\" failures=\"" +
                     std::to_string(bad) + "\" skipped=\"" + std::to_string(skipped) + "\"" +
                     (partial.empty() ? "" : " errors=\"1\"") + ">\n";
  for (const Judgement& j : all) {
    text += "  <testcase classname=\"" + escaped(j.engine) + "\" name=\"" + escaped(j.name) + "\">";
    const std::string message = " message=\"" + escaped(to_string(j.verdict) + ": " + j.words) + "\"/>";
    if (j.verdict == CaseVerdict::cannot) text += "<skipped" + message;
    if (j.verdict > CaseVerdict::cannot) text += "<failure" + message;
    text += "</testcase>\n";
  }
  if (!partial.empty())
    text +=
        "  <testcase classname=\"furrow judge\" name=\"all cases\"><error message=\"interrupted: " + escaped(partial) +
        "\"/></testcase>\n";
  return text + "</testsuite>\n";
}

}  // namespace furrow::verification
