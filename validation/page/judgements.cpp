#include "validation/page/judgements.h"

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "output/files.h"
#include "report/seal.h"
#include "validation/page/age_words.h"
#include "validation/page/html.h"
#include "validation/page/kept_files.h"

namespace furrow::validation {
namespace {

using Json = nlohmann::ordered_json;

struct Sign {
  const char *verdict, *sign, *kind;
};
constexpr std::array<Sign, 5> signs{{{"right", "✓", "good"},
                                     {"lower order", "≈", "partly"},
                                     {"another law", "✗", "bad"},
                                     {"failed", "!", "bad"},
                                     {"cannot", "–", "none"}}};
constexpr const char* not_asked = "·";  // of "cannot", where it is the adapter that cannot

std::string name_of(const Json& engine) {
  const std::string program = engine.at("engine"), method = engine.at("method");
  return program + (method.empty() ? "" : ", " + method);
}

bool own(const Json& engine) { return engine.at("engine").get<std::string>().starts_with("furrow"); }

// [verdict, words]; null where the engine was not asked.
Json said_of(const Json& engine, const std::string& name) {
  const auto found = engine.at("verdicts").find(name);
  return found == engine.at("verdicts").end() ? Json() : *found;
}

// A program between the judge and an engine, which has no way to ask for a case, says so; the engine may well do it.
bool of_adapter(const Json& said) {
  return said.at(0) == "cannot" && said.at(1).get<std::string>().starts_with("this adapter");
}

// With which a reader sees a row for himself; empty of judgements that do not say which program was asked.
std::string command_of(const Json& engine, const std::string& name) {
  const std::string asked = engine.value("command", "");
  return asked.empty() ? "" : "furrow judge --engine '" + asked + "' --cases " + name;
}

std::map<std::string, int> counts_of(const Json& engine) {
  std::map<std::string, int> counts;
  for (const auto& [name, said] : engine.at("verdicts").items()) ++counts[said.at(0).get<std::string>()];
  return counts;
}

std::string cell_of(const Json& said, bool foreign) {
  if (said.is_null()) return element("td", "");
  const std::string verdict = said.at(0);
  const auto sign = std::find_if(signs.begin(), signs.end(), [&](const Sign& s) { return s.verdict == verdict; });
  if (sign == signs.end()) return element("td", escaped(verdict));
  // What an engine does instead has a table of its own, and why a method of furrow cannot stands below it.
  const bool cannot = foreign && verdict == "cannot";
  return "<td class=\"judged " + std::string(sign->kind) + "\" aria-label=\"" + verdict +
         (of_adapter(said) ? ", of the adapter" : "") + "\"" +
         (cannot ? " title=\"" + escaped(said.at(1).get<std::string>()) + "\"" : "") + ">" +
         (of_adapter(said) ? not_asked : sign->sign) + "</td>";
}

std::string matrix(const Json& kept, Page& page) {
  std::string head = head_cell("Case"), rows;
  for (const Json& engine : kept.at("engines"))
    head += "<th scope=\"col\" class=\"upright\"><span>" + escaped(name_of(engine)) + "</span></th>";
  for (const auto& [name, title] : kept.at("cases").items()) {
    std::string cells = "<th scope=\"row\">" + escaped(title.get<std::string>()) + "<small><code>" + escaped(name) +
                        "</code></small></th>";
    for (const Json& engine : kept.at("engines")) cells += cell_of(said_of(engine, name), !own(engine));
    rows += element("tr", cells);
  }
  std::string legend;
  for (const Sign& s : signs) legend += (legend.empty() ? "" : ", ") + std::string(s.sign) + " " + s.verdict;
  legend += ": the engine, " + std::string(not_asked) + " cannot: this adapter";
  return framed({page.id("table cases by engines"), "Cases by engines: " + legend + ".", "Cases by engines",
                 "matrix plain", head, rows});
}

bool is_instead(const Json& said) { return said.at(0) != "right" && said.at(0) != "cannot"; }

// Which cases a method of furrow cannot do, and why not the first of them. Of another engine the matrix says it.
std::string what_methods_cannot(const Json& kept) {
  std::string items;
  for (const Json& engine : kept.at("engines")) {
    if (!own(engine)) continue;
    int count = 0;
    std::string first;
    for (const auto& [name, said] : engine.at("verdicts").items()) {
      if (said.at(0) != "cannot") continue;
      if (++count == 1) first = name + ": " + said.at(1).get<std::string>();
    }
    if (count > 0)
      items +=
          element("li", typeset(escaped(name_of(engine) + " cannot do " + std::to_string(count) + " cases; " + first)));
  }
  return items.empty() ? items : element("ul", items);
}

// What engines do instead, others before furrow.
std::string instead(const Json& kept, Page& page) {
  std::string rows;
  const auto row = [&](const Json& engine, const std::string& cases, const Json& said, const std::string& shown_by) {
    rows += element("tr", element("td", escaped(name_of(engine))) + element("td", typeset(escaped(cases))) +
                              element("td", chip_or_words(said.at(0))) +
                              element("td", typeset(escaped(said.at(1).get<std::string>()))) +
                              element("td", element("code", escaped(command_of(engine, shown_by)))));
  };
  for (const Json& engine : kept.at("engines")) {
    for (const auto& [name, said] : engine.at("verdicts").items())
      if (!own(engine) && is_instead(said)) row(engine, kept.at("cases").value(name, name), said, name);
  }
  // Of a method of furrow the cases with the same verdict share a row, with the words on the first; the matrix has all
  // their names.
  for (const Json& engine : kept.at("engines")) {
    std::map<std::string, std::vector<std::string>> by_verdict;
    for (const auto& [name, said] : engine.at("verdicts").items())
      if (own(engine) && is_instead(said)) by_verdict[said.at(0)].push_back(name);
    for (const auto& [verdict, names] : by_verdict)
      row(engine, listed(names, 6), engine.at("verdicts").at(names[0]), names[0]);
  }
  if (rows.empty()) return {};
  return framed({page.id("table what engines do instead"), "Where an answer is not right, what it is instead.",
                 "What engines do instead", "study grouped",
                 head_cell("Engine") + head_cell("Case") + head_cell("Verdict") + head_cell("What it does") +
                     head_cell("The command that shows it"),
                 rows}) +
         what_methods_cannot(kept);
}

std::string counts(const Json& kept, Page& page) {
  std::string head = head_cell("Engine"), rows;
  for (const Sign& s : signs)
    head += head_cell(s.verdict == std::string("cannot") ? "cannot: the engine" : s.verdict, true);
  head += head_cell("cannot: this adapter", true);
  for (const Json& engine : kept.at("engines")) {
    auto of = counts_of(engine);
    const auto adapter = std::count_if(engine.at("verdicts").begin(), engine.at("verdicts").end(), of_adapter);
    of["cannot"] -= static_cast<int>(adapter);
    std::string cells = "<th scope=\"row\">" + escaped(name_of(engine)) + "</th>";
    for (const Sign& s : signs)
      cells += element("td", std::to_string(of.contains(s.verdict) ? of.at(s.verdict) : 0), "number");
    cells += element("td", std::to_string(adapter), "number");
    rows += element("tr", cells);
  }
  return framed({page.id("table verdicts by engine"), "How many cases each engine gets right.", "Verdicts by engine",
                 "study", head, rows});
}

}  // namespace

std::string unusable_judgements(const std::filesystem::path& file) {
  try {
    const Json kept = read_sealed(file);
    for (const char* key : {"cases", "engines"}) {
      if (!kept.contains(key)) return file.string() + ": does not say its " + key;
    }
    for (const Json& engine : kept.at("engines")) {
      if (maker_in(kept, engine).commit.empty()) return file.string() + ": does not say by which commit";
    }
    return kept.at("engines").empty() ? file.string() + ": holds no engines" : "";
  } catch (const FileError& error) {
    return error.what();
  } catch (const std::exception& error) {
    return file.string() + ": is not what scripts/judge keeps (" + error.what() + ")";
  }
}

std::string judged_in_short(const std::filesystem::path& file) {
  if (file.empty() || !unusable_judgements(file).empty()) return {};
  const Json kept = read_sealed(file);
  std::string words;
  for (const Json& engine : kept.at("engines")) {
    const bool variant =
        engine.at("engine").get<std::string>().find(',') != std::string::npos;  // an engine asked otherwise
    if (own(engine) || variant || !engine.value("foreign", false)) continue;
    const auto counts = counts_of(engine);
    const auto number = [&](const char* verdict) { return counts.contains(verdict) ? counts.at(verdict) : 0; };
    const auto can = static_cast<int>(kept.at("cases").size()) - number("cannot");
    const std::string name = engine.at("engine");  // and its version
    words += (words.empty() ? "" : ", ") + escaped(name.substr(0, name.find(' '))) + " " +
             std::to_string(number("right")) + " of " + std::to_string(can);
  }
  if (words.empty()) return words;
  const Age age = age_of_judgements(kept);
  return "Right, of the verification cases that they can express: " + words + "." +
         (age.old > 0 ? " " + std::to_string(age.old) + " of " + std::to_string(age.results) +
                            " verdicts are older than the solver or the judge."
                      : "");
}

std::string judgements_section(const std::filesystem::path& file, const std::string& number, Page& page) {
  const std::string begin =
      "<section id=\"judgements\">" + heading(3, page.id("judged by the same cases"),
                                              element("span", number, "section") + "Engines judged by the same cases");
  const std::string why =
      file.empty() ? "No judgement here: the page was made without one (--judgements)." : unusable_judgements(file);
  if (!why.empty()) return begin + element("p", escaped(why), "missing") + "</section>\n";
  const Json kept = read_sealed(file);
  return begin +
         element(
             "p",
             "Does an engine solve the equations that it is asked to solve? <code>furrow judge</code> gives small "
             "problems with a closed form or an integrated answer to any program, each at three or more "
             "resolutions, and looks where its answers go. Right: the error falls as the method promises, or is "
             "below a floor. Another law: the answers settle on something else, so that a finer step does not "
             "help. Cannot: the engine has no such law, or the adapter, the small program that asks it, has no way to "
             "ask. Furrow is judged by each of its methods that take a fixed step: one that controls its error "
             "chooses its own step, so that there are no resolutions to ask for, and its step "
             "against its estimate is verified by a page of its own (step control). The independent engine shares "
             "nothing with it.",
             "lead") +
         element("p",
                 "To judge an engine of your own: a program that takes a case as JSON on its standard input and prints "
                 "what it saw as JSON. <code>furrow cases --protocol</code> says how on one page, with an example of "
                 "twenty lines; <code>furrow judge --engine ./mine</code> then prints this table for it, and "
                 "<code>furrow cases --json</code> all cases, to take away.") +
         counts(kept, page) + instead(kept, page) + "<details class=\"unfold\"><summary>All " +
         std::to_string(kept.at("cases").size()) + " cases by all engines</summary>" + matrix(kept, page) +
         "</details>\n" +
         element("p",
                 age_chip(age_of_judgements(kept)) + " By <code>scripts/judge --keep</code>: " +
                     escaped(words_of(numbers_of_judgements(kept), age_of_judgements(kept))),
                 "note") +
         "</section>\n";
}

}  // namespace furrow::validation
