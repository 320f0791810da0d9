#include "validation/page/summary.h"

#include <algorithm>
#include <map>

#include "output/build_info.h"
#include "output/machine.h"
#include "validation/page/age_words.h"
#include "validation/page/html.h"
#include "validation/page/judgements.h"
#include "validation/page/kept_files.h"
#include "validation/page/mutants.h"
#include "validation/page/names.h"
#include "validation/page/page_parts.h"
#include "validation/page/run_words.h"

namespace furrow::validation {
namespace {

std::string grouped(std::size_t n) { return in_groups(std::to_string(n)); }

// Of the page's own: those that hold, of how many.
std::string claims_in_short(const std::vector<StudyResult>& studies) {
  std::size_t all = 0, refuted = 0;
  for (const StudyResult& study : studies) all += claims_in(study), refuted += refuted_claims(study).size();
  if (all == 0) return {};
  return " <a href=\"#failing\">" + std::to_string(all - refuted) + " of this page's own " + std::to_string(all) +
         " claims hold</a>.";
}

std::string verdict_line(const Evidence& evidence, const std::vector<RunRecord>& runs,
                         const std::vector<StudyResult>& studies) {
  const Verdict v = verdict_of(evidence);
  const auto ended = std::count_if(runs.begin(), runs.end(), [](const RunRecord& run) { return run.finished(); });
  const std::size_t missing_parts = missing_evidence(evidence).size();
  const bool good =
      v.checks > 0 && v.failed == 0 && v.noticed == v.faults && ended == std::ssize(runs) && missing_parts == 0;
  std::string words =
      v.checks == 0 ? "<strong>No checks here" + (v.trouble.empty() ? "" : ": " + escaped(v.trouble)) + ".</strong>"
                    : "<strong>" + grouped(v.checks) + " checks of " + grouped(v.requirements) +
                          " requirements: " + grouped(v.failed) + " failed.</strong>";
  if (v.faults > 0)
    words += " " + grouped(v.noticed) + " of " + grouped(v.faults) +
             " faults put into the source on purpose were noticed" +
             (v.old > 0 ? ", " + grouped(v.old) + " of them by an older solver or older tests" : "") +
             (v.untried > 0 ? "; " + grouped(v.untried) + " more are not tried yet." : ".");
  if (const std::string edits = mutants_in_short(evidence.mutants); !edits.empty())
    words += " Tests notice " + edits + ".";
  words += " " + std::to_string(ended) + " of " + std::to_string(runs.size()) + " scenes came to their end.";
  words += claims_in_short(studies);
  if (const std::size_t absent = missing_parts + evidence_not_given(evidence).size(); absent > 0)
    words += " <a href=\"#missing\">" + std::to_string(absent) +
             (absent == 1 ? " part is missing" : " parts are missing") + "</a> on this page.";
  return "<p id=\"verdict\" class=\"verdict " + std::string(good ? "good" : "bad") + "\"><span class=\"chip " +
         (good ? "good\">✓ good" : "bad\">✗ not good") + "</span> " + words + "</p>\n";
}

std::string made_line(const Evidence& evidence) {
  const BuildInfo& build = build_info();
  std::string words =
      "furrow " + std::string(build.version) + ", commit <b id=\"commit\">" + escaped(build.commit) + "</b>";
  if (!evidence.when.empty())
    words += ", page made <time id=\"made_at\" datetime=\"" + evidence.when + "\">" + evidence.when.substr(0, 10) +
             " " + evidence.when.substr(11, 5) + " UTC</time>";
  return element("p", words + " on " + escaped(processor_name()) + ", " + escaped(build.compiler), "made_line");
}

struct Tile {
  std::string id, part, question, value, text;
};

// A study's headline for a tile; several join.
void take_headlines(const std::vector<StudyResult>& studies, std::vector<Tile>& tiles) {
  for (const StudyResult& study : studies) {
    for (const Json& headline : study.report.at("headlines")) {
      const auto tile =
          std::find_if(tiles.begin(), tiles.end(), [&](const Tile& t) { return t.id == headline.at("tile"); });
      if (tile == tiles.end()) continue;
      const std::string value = typeset(escaped(headline.at("value").get<std::string>())),
                        words = typeset(escaped(headline.at("text").get<std::string>())) +
                                (rests_on(headline, study.old_times) ? " Older than the solver." : "");
      if (tile->value.empty())
        tile->value = value, tile->text = words;
      else
        tile->text += " <b>" + value + "</b> " + words;
    }
  }
}

std::string tiles_of(const Evidence& evidence, const std::vector<StudyResult>& studies) {
  const Verdict v = verdict_of(evidence);
  std::vector<Tile> tiles{{"right", "right", "Are the equations solved right?", "", ""},
                          {"accurate", "accurate", "How accurate is it?", "", ""},
                          {"breaks", "breaks", "Where does it break?", "", ""},
                          {"fast", "fast", "How fast is it?", "", ""},
                          {"engines", "fast", "How do other engines do?", "", ""},
                          {"paper", "paper", "What of the paper stands?", "", ""}};
  if (v.checks > 0) {
    tiles[0].value = grouped(v.checks - v.failed) + " of " + grouped(v.checks);
    tiles[0].text = "checks against closed forms, or what was computed independently, hold.";
  }
  take_headlines(studies, tiles);
  const auto engines = std::find_if(tiles.begin(), tiles.end(), [](const Tile& t) { return t.id == "engines"; });
  engines->text += " " + judged_in_short(evidence.judgements);
  std::string html;
  for (const Tile& t : tiles) {
    const std::string value = t.value.empty() ? missing : t.value;
    html += "<li><a class=\"tile\" id=\"tile_" + t.id + "\" href=\"#part_" + t.part + "\"><span class=\"question\">" +
            t.question + "</span><strong>" + value + "</strong><span>" + t.text + "</span></a></li>\n";
  }
  return element("ul", html, "tiles");
}

// Behind the link to all numbers, on the same line.
std::string age_of_finding(const StudyResult& study) {
  if (study.numbers.old == 0) return {};
  return ", <a href=\"#how_it_was_made\">" + std::to_string(study.numbers.old) + " of " +
         std::to_string(study.numbers.results) + " older than the solver</a>";
}

std::string finding(const std::vector<RunRecord>& runs, const std::vector<StudyResult>& studies, Page& page) {
  for (const StudyResult& study : studies) {
    for (const Json& headline : study.report.at("headlines")) {
      if (headline.at("tile") != "finding") continue;
      const std::string words = element("p", typeset(escaped(headline.at("value").get<std::string>()))) +
                                element("p", typeset(escaped(headline.at("text").get<std::string>()))) +
                                beyond_hertz(runs);
      const std::string drawing = study.report.contains("first_figure") ? first_figure(study, page) : "";
      return "<section id=\"summary_finding\" class=\"finding\"><div><h2>The finding</h2>" + words +
             "<p><a href=\"#part_finding\">All its numbers</a>" + age_of_finding(study) + "</p></div>" + drawing +
             "</section>\n";
    }
  }
  return {};
}

std::string failing(const std::vector<StudyResult>& studies) {
  std::string rows, waiting;
  std::size_t count = 0, all = 0, old = 0;
  for (const StudyResult& study : studies) {
    all += claims_in(study);
    for (const Refuted& claim : refuted_claims(study)) {
      if (claim.old) {
        waiting += (old++ == 0 ? "" : ", ") + ("<a href=\"#" + claim.id + "\">" + claim.value + "</a>");
        continue;
      }
      ++count;
      rows += "<li><strong>" + (claim.value.empty() ? "no value" : claim.value) + "</strong>" +
              (claim.aim.empty() ? "" : " (aim: " + claim.aim + ")") + ": " + claim.text + " <a href=\"#" + claim.id +
              "\">where</a></li>\n";
    }
  }
  if (all == 0) return {};
  const std::string head =
      count + old == 0 ? "All " + std::to_string(all) + " claims of this page hold"
                       : std::to_string(count) + " of this page's own " + std::to_string(all) + " claims do not hold";
  if (old > 0)
    waiting = element("p",
                      std::to_string(old) +
                          " more rest on times that are older than the solver, and are not counted as "
                          "kept until they are measured again: " +
                          waiting + ".",
                      "note");
  return "<section id=\"failing\" class=\"failing\"><h2>" + head + "</h2>" + (rows.empty() ? "" : element("ul", rows)) +
         waiting + "</section>\n";
}

// "2026-01-31"; of results that do not say when, a dash.
std::string when(const std::string& utc) { return utc.size() < 10 ? "–" : utc.substr(0, 10); }

std::string makers_of(const Age& age, const std::set<std::string>& machines) {
  return escaped(listed(age.commits, age.commits.size())) +
         element("small", escaped(listed({machines.begin(), machines.end()}, machines.size())));
}

std::string row_of(const std::string& id, const std::string& title, std::size_t entries, const Age& age,
                   const std::string& makers, const std::string& command, std::size_t old_read = 0) {
  return element("tr", "<th scope=\"row\"><a href=\"#" + id + "\">" + title + "</a></th>" +
                           element("td", std::to_string(entries), "number") + element("td", when(age.first), "when") +
                           element("td", when(age.last), "when") + element("td", makers) +
                           element("td", age_chip(age, old_read)) +
                           element("td", "<code>" + command + "</code>", "command"));
}

}  // namespace

std::string beyond_hertz(const std::vector<RunRecord>& runs) {
  std::string overlaps, scenes;
  double small = 0;
  for (const RunRecord& run : runs) {
    const WatchedFact* overlap = watch_of(run, "overlap");
    if (overlap == nullptr || overlap->worst <= overlap->warns_above) continue;
    small = overlap->warns_above;
    overlaps += (overlaps.empty() ? "" : ", ") + shown(overlap->worst);
    scenes += (scenes.empty() ? "" : ", ") + scene_words(run.name);
  }
  if (overlaps.empty()) return {};
  return element("p", "Overlaps here reach " + overlaps + " R (" + scenes +
                          "); Hertz's law is for small ones, here up to " + shown(small) + " R.");
}

std::string summary(const std::vector<RunRecord>& runs, const Evidence& evidence,
                    const std::vector<StudyResult>& studies, Page& page) {
  return made_line(evidence) + "<h1>A plate through soil and stem: what of it can be trusted</h1>\n" +
         verdict_line(evidence, runs, studies) + finding(runs, studies, page) + tiles_of(evidence, studies) +
         failing(studies);
}

std::string ages(const std::vector<StudyResult>& studies, const Evidence& evidence, Page& page) {
  std::string rows;
  for (const StudyResult& study : studies)
    rows += row_of("study_" + study.name, typeset(escaped(study.report.at("title").get<std::string>())),
                   study.numbers.results, study.numbers, makers_of(study.numbers, study.machines), study.made_by,
                   study.old_read);
  for (const KeptFile& file : kept_files(evidence)) {
    std::set<std::string> machines;
    for (const Maker& maker : file.numbers.makers()) machines.insert(maker.machine);
    rows += row_of(file.id, file.title, file.entries, file.age, makers_of(file.age, machines), file.made_by);
  }
  if (rows.empty()) return {};
  return framed({page.id("table ages"),
                 "When the kept numbers of each section were made, and whether the solver has changed since.",
                 "Ages of the kept numbers", "study",
                 head_cell("Section") + head_cell("Results", true) + head_cell("Oldest") + head_cell("Newest") +
                     head_cell("By commit, on machine") + head_cell("Against today's solver") + head_cell("Made by"),
                 rows});
}

}  // namespace furrow::validation
