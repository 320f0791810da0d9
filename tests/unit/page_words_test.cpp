// How the page writes numbers, names and terms.
#include <gtest/gtest.h>

#include <cmath>

#include "methods/method.h"
#include "validation/page/html.h"
#include "validation/page/names.h"
#include "validation/page/summary.h"
#include "validation/page/terms.h"

namespace furrow::validation {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Numbers, AreGroupedFromFiveDigitsOn) {
  EXPECT_EQ(in_groups("4690"), "4690");
  EXPECT_EQ(in_groups("52348"), "52,348");
  EXPECT_EQ(in_groups("1000040"), "1,000,040");
  EXPECT_EQ(shown(1135), "1135");
  EXPECT_EQ(shown(-299510), "−299,510");
  EXPECT_EQ(shown(10696.9), "10,697");
}

TEST(Numbers, OfTextsAreWrittenAsThoseOfTables) {
  EXPECT_EQ(typeset("with 4,000 steps, 100000 times smaller (20000)."),
            "with 4000 steps, 100,000 times smaller (20,000).");
  EXPECT_EQ(typeset("E = 2e7 Pa, 1e9 N/m, 1e-9 m"), "E = 2 × 10<sup>7</sup> Pa, 10<sup>9</sup> N/m, 10<sup>−9</sup> m");
  EXPECT_EQ(typeset("1.9626e+00 and 2.857e+02"), "1.9626 and 2.857 × 10<sup>2</sup>");
  for (const std::string same : {"commit 1234567, 12e4567, 85c810d", "on 2026-11-30", "10,697 and 10,690,123",
                                 "0.123456", "rk4, 2.5e", "version 123456789"})
    EXPECT_EQ(typeset(same), same);
}

TEST(Names, OfAFileAreWords) {
  EXPECT_EQ(scene_words("scenario_1"), "scene 1");
  EXPECT_EQ(scene_words("step_scenario_2"), "step scene 2");
  EXPECT_EQ(scene_words("single_spring"), "single spring");
  EXPECT_EQ(scene_title("scenario_3", "Third scene of the paper: a plate"), "Scene 3: a plate");
  EXPECT_EQ(without_scene("the paper's second scene from 2 s on"), "from 2 s on");
  EXPECT_EQ(without_scene("the paper's first scene, 1.2 s"), "1.2 s");
  EXPECT_EQ(without_scene("a clamped lattice, 1 s"), "a clamped lattice, 1 s");
  EXPECT_EQ(scene_title("stem", "A plate breaks a stem"), "A plate breaks a stem");
}

TEST(Terms, AreLinkedWhereTheyAreFirstUsed) {
  const std::string html =
      with_terms("<p>By pece, not by pecece; pece again.</p><td>rk4 +t</td><td>odeint_<wbr>ab5</td>");
  EXPECT_TRUE(has(html, "By <a class=\"term\" href=\"#method_pece\" title=\"")) << html;
  EXPECT_TRUE(has(html, ">pecece</a>; pece again.")) << html;
  EXPECT_TRUE(has(html, "href=\"#method_rk4\"")) << html;
  EXPECT_TRUE(has(html, "href=\"#term_located\"") && has(html, ">+t</a>")) << html;
  EXPECT_TRUE(has(html, "href=\"#method_odeint_ab5\"") && has(html, ">odeint_<wbr>ab5</a>")) << html;
}

TEST(Terms, AreNoPartsOfWordsAndNoneInHeadingsLinksAndDrawings) {
  for (const std::string same :
       {"<h3>pece</h3>", "<a href=\"#x\">pece</a>", "<svg><text>pece</text></svg>", "<p title=\"pece\">x</p>",
        "<thead><tr><th>pece</th></tr></thead>", "<p>pece_more, a_pece, pece2, 1+tan, settled discs, glass spheres</p>",
        "<p>1 &lt; 2 <"})
    EXPECT_EQ(with_terms(same), same);
  EXPECT_TRUE(has(with_terms("<p>Scene 2, discs: 1</p>"), "Scene 2, <a class=\"term\" href=\"#term_reading\""));
}

TEST(Terms, NameEveryMethod) {
  for (const MethodInfo& m : method_catalogue())
    EXPECT_TRUE(has(with_terms("<p>" + m.name + "</p>"), "href=\"#" + id_of_method(m.name) + "\"")) << m.name;
}

RunRecord with_overlap(const std::string& name, double worst) {
  RunRecord run;
  run.name = name;
  WatchedFact overlap;
  overlap.name = "overlap";
  overlap.worst = worst;
  overlap.warns_above = 0.125;
  run.watched = {overlap};
  return run;
}

TEST(Finding, SaysHowFarTheRunsLeaveHertz) {
  EXPECT_EQ(beyond_hertz({with_overlap("scenario_1", 0.0625), with_overlap("scenario_2", 1.75)}),
            "<p>Overlaps here reach 1.75 R (scene 2); Hertz's law is for small ones, here up to "
            "0.125 R.</p>\n");
  EXPECT_EQ(beyond_hertz({with_overlap("scenario_1", 0.125)}), "");
  RunRecord unwatched = with_overlap("scenario_1", 3);
  unwatched.watched[0].time = std::nan("");
  EXPECT_EQ(beyond_hertz({unwatched}), "");
}

}  // namespace
}  // namespace furrow::validation
