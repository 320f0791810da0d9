#include "validation/page/report.h"

#include <algorithm>
#include <cmath>

#include "methods/method.h"
#include "output/files.h"
#include "report/embedded.h"
#include "validation/page/film.h"
#include "validation/page/html.h"
#include "validation/page/judgements.h"
#include "validation/page/names.h"
#include "validation/page/observables.h"
#include "validation/page/page.h"
#include "validation/page/page_parts.h"
#include "validation/page/report_films.h"
#include "validation/page/runs_table.h"
#include "validation/page/scene_section.h"
#include "validation/page/studies.h"
#include "validation/page/summary.h"
#include "validation/page/svg.h"
#include "validation/page/template.h"
#include "validation/page/terms.h"
#include "validation/page/tool_section.h"
#include "validation/page/validity_part.h"
#include "validation/page/verification.h"

namespace furrow::validation {
namespace {

// N, of all steps, where run.json says it.
double largest_force(const RunRecord& run) {
  return run.largest_force.empty() ? measure(run, "largest_force").value : run.largest_force.front().f;
}

// The runs in a table for a page in Markdown.
std::string scene_table(const std::vector<RunRecord>& runs) {
  std::string table =
      "| scene | steps | evaluations | CPU [s] | largest force of all steps [N] | links torn | state hash |\n"
      "|---|--:|--:|--:|--:|--:|---|\n";
  for (const RunRecord& run : runs) {
    table += "| " + scene_words(run.name) + (run.finished() ? "" : " (" + fact_shown(run, "ended") + ")") + " | " +
             fact_shown(run, "steps") + " | " + fact_shown(run, "rhs_evaluations") + " | " +
             fact_shown(run, "cpu_seconds") + " | " + shown(largest_force(run)) + " | " +
             std::to_string(run.torn.size()) + " | `" + fact_shown(run, "state_hash") + "` |\n";
  }
  return table;
}

std::string missing_part(const Evidence& evidence) {
  std::string lines;
  for (const std::string& why : missing_evidence(evidence)) lines += element("li", escaped(why));
  for (const std::string& what : evidence_not_given(evidence)) lines += element("li", escaped(what));
  return lines.empty() ? lines
                       : "<section id=\"missing\">" + element("h2", "What is missing here") +
                             element("ul", lines, "missing") + "</section>";
}

// A table of all methods, to stand before their names are used.
std::string methods_table(Page& page) {
  std::string rows;
  for (const MethodInfo& m : method_catalogue()) {
    rows += element(
        "tr", "<th scope=\"row\" id=\"" + page.id(id_of_method(m.name)) + "\"><code>" + escaped(m.name) +
                  "</code></th>" + element("td", escaped(m.title)) + element("td", std::to_string(m.order), "number") +
                  element("td",
                          m.evaluations == 0 ? "varies"
                                             : std::to_string(m.evaluations) +
                                                   (m.dense_jacobian ? ", and one a number of the state" : ""),
                          "number") +
                  element("td", m.controlled ? "chosen by a tolerance" : "fixed"));
  }
  return framed({page.id("table methods"), "The methods, as furrow names them.", "Methods", "study",
                 head_cell("Name") + head_cell("What it is") + head_cell("Order", true) +
                     head_cell("Evaluations a step", true) + head_cell("Step"),
                 rows});
}

// What the sections of a part are, in order, and the lines of the contents that lead to them.
struct PartText {
  std::string html, contents;
};

std::string line_of(const std::string& id, const std::string& number, const std::string& words) {
  return "<li><a href=\"#" + id + "\"><span>" + number + "</span> " + words + "</a></li>\n";
}

class PageWriter {
 public:
  // records: links to what is recorded of the runs.
  PageWriter(const std::vector<RunRecord>& runs, const std::vector<std::string>& records, const Films& films,
             const Besides& besides, const std::vector<OtherRun>& tools, const Evidence& evidence, Page& page)
      : runs_(runs),
        records_(records),
        films_(films),
        besides_(besides),
        tools_(tools),
        evidence_(evidence),
        page_(page),
        studies_(study_results(evidence)) {}

  std::string html() {
    std::string contents, parts, films;
    for (const auto& [name, some] : films_) films += film_elements(some);
    const std::string first = summary(runs_, evidence_, studies_, page_);
    const std::string methods = methods_table(page_);
    int number = 0;
    for (const PagePart& part : page_parts()) {
      const PartText text = part_text(part, std::to_string(++number));
      contents += "<li><a href=\"#part_" + part.id + "\"><span>" + std::to_string(number) + "</span> " + part.title +
                  "</a>" + (text.contents.empty() ? "" : element("ol", text.contents)) + "</li>\n";
      parts += "<section class=\"part\" id=\"part_" + part.id + "\">\n" +
               heading(2, page_.id(part.title), element("span", std::to_string(number), "section") + part.title) +
               element("p", part.question, "lead") + text.html + "</section>\n";
    }
    return filled(page_file("page.html"),
                  {{"style", page_file("page.css") + page_file("player.css")},
                   {"marks", shared_marks()},
                   {"paper", escaped(paper_.title)},
                   {"contents", contents},
                   {"summary", first},
                   {"missing", missing_part(evidence_)},
                   {"methods", methods},
                   {"parts", parts},
                   {"films", films},
                   {"script", page_file("page.js") + page_file("curves.js") + page_file("player.js")}});
  }

 private:
  PartText part_text(const PagePart& part, const std::string& number) {
    PartText text;
    int section = 0;
    const auto next = [&] { return number + "." + std::to_string(++section); };
    if (part.id == "scenes") {
      for (const RunRecord& run : runs_) {
        const std::string here = next();
        text.contents +=
            line_of(run.name, here,
                    capital(scene_words(run.name)) +
                        (run.finished() ? "" : ": " + element("strong", fact_shown(run, "ended"), "missing")));
        text.html += with_terms(scene_section(run, paper_, here, besides_.at(run.name), page_));
      }
    }
    if (part.id == "scenes" && films_.contains("tool")) {
      const std::string here = next();
      text.contents += line_of("tool", here, "A tool that bends");
      text.html += tool_section(tools_, films_.at("tool"), here, page_);
    }
    if (part.id == "right") {
      text.contents += line_of("verification", next(), "Checks");
      text.contents += line_of("faults", next(), "Faults put in");
      text.html += with_terms(verification_section(evidence_, number, page_));
    }
    for (const StudyResult& study : studies_) {
      if (std::find(part.studies.begin(), part.studies.end(), study.name) == part.studies.end()) continue;
      const std::string here = next();
      text.contents +=
          line_of("study_" + study.name, here, typeset(escaped(study.report.at("title").get<std::string>())));
      text.html += with_terms(study_section(study, here, page_));
    }
    if (part.id == "fast") {
      const std::string here = next();
      text.contents += line_of("judgements", here, "Engines judged by the same cases");
      text.html += with_terms(judgements_section(evidence_.judgements, here, page_));
    }
    if (part.id == "made")
      text.html += ages(studies_, evidence_, page_) + runs_table(runs_, records_, page_) +
                   element("p",
                           "The state hash is of every bit of the final state; the determinism tests show that it does "
                           "not depend on compiler, optimisation or vector width.",
                           "note");
    return text;
  }

  const std::vector<RunRecord>& runs_;
  const std::vector<std::string>& records_;
  const Films& films_;
  const Besides& besides_;
  const std::vector<OtherRun>& tools_;
  const Evidence& evidence_;
  Page& page_;
  std::vector<StudyResult> studies_;
  Publication paper_ = read_publication(embedded("validation/statements.toml"));
};

}  // namespace

std::vector<std::string> page_files() { return {"index.html", "scenes.md"}; }

void write_report(OwnedDirectory& directory, const std::vector<ReportedRun>& reported, const Evidence& evidence,
                  const std::vector<OtherRun>& tools) {
  std::vector<RunRecord> runs;
  std::vector<std::string> records;
  Films films;
  Besides besides;
  const Shelf shelf(evidence.studies);
  for (const ReportedRun& r : reported) {
    runs.push_back(read_run(r.name, r.directory));
    records.push_back(link_to_record(directory.path(), r.directory));
    films[r.name] = films_of(r, runs.back());
    besides[r.name] = {player_element(films[r.name]), force_band(shelf, r.name), by_step(r, runs.back())};
    keep_stills(runs.back(), r.stills);
  }
  add_tool_films(tools, films);
  Page page;
  const std::string html = PageWriter(runs, records, films, besides, tools, evidence, page).html();
  Drawings& files = page.files;
  files["index.html"] = html;
  files["statements.toml"] = embedded("validation/statements.toml");  // where the paper says what is judged
  files["scenes.md"] = scene_table(runs) + "\nWhat they do to the validity of their laws:\n\n" + validity_table(runs);
  std::vector<std::string> names;
  for (const auto& [name, text] : files) names.push_back(name);
  directory.add(names);
  for (const auto& [name, text] : files) {
    OutputFile file(directory.path() / name);
    file << text;
    file.finish();
  }
}

}  // namespace furrow::validation
