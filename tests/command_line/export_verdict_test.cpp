// `furrow export --compare`: what it says is good, what is not, and what it does not judge.
#include "comparing.h"

namespace {

using furrow::test::Comparing;

TEST_F(Comparing, NothingComparedIsNoPass) {
  export_and_run(impact("slip_damping = false", "restitution = 0.5"), "--until 0.005 --set output.interval=1e-3");
  std::string force = title();
  for (int k = 0; k <= 5; ++k) force += std::to_string(250 * k) + " 0 0\n";
  put("deck/force.1.txt", force);
  put_end(1250);
  EXPECT_EQ(furrow("export --compare deck").code, 1) << out() << err();
  EXPECT_NE(out().find("choose a longer --early"), std::string::npos) << out();
  EXPECT_TRUE(compared("deck").at("good").is_null()) << "nothing is judged";
  EXPECT_TRUE(compared("deck").at("early").at("parts").at(0).at("good").is_null());
}

// The plate has no force in either; the rest is after --early or a place in a bed.
TEST_F(Comparing, WhatIsNotJudgedIsNotCalledGood) {
  good_discs();
  const auto json = compared("deck");
  EXPECT_EQ(json.at("good"), true);
  EXPECT_TRUE(json.at("early").at("parts").at(0).at("good").is_null()) << "no force";
  EXPECT_EQ(json.at("early").at("parts").at(1).at("good"), true);
  EXPECT_TRUE(json.at("end").at("good").is_null());
  EXPECT_NE(out().find("\nVerdict: good: the force on wall 0. Nothing else is judged.\n"), std::string::npos) << out();
  // The places at the end are another run's, 0.1 m off.
  put("deck/end.1.txt", std::regex_replace(text("deck/end.1.txt"), std::regex("\n([12]) \\S+ "), "\n$1 0.1 "));
  EXPECT_EQ(furrow("export --compare deck").code, 0) << out();
  EXPECT_GT(compared("deck").at("end").at("greatest_distance"), 0.09);
  EXPECT_TRUE(compared("deck").at("end").at("good").is_null());
}

TEST_F(Comparing, AForceThatTheEngineAloneHasIsNamedInTheVerdict) {
  good_discs();
  put("deck/force.1.txt", furrow::test::with_line(text("deck/force.1.txt"), 7, "400 1 0 0 0"));
  EXPECT_EQ(furrow("export --compare deck").code, 1) << out();
  const auto json = compared("deck");
  EXPECT_EQ(json.at("good"), false);
  EXPECT_EQ(json.at("early").at("parts").at(0).at("good"), false);
  EXPECT_NE(out().find("\nVerdict: not good: the force on plate 0"), std::string::npos) << out();
}

// A deck with another law agrees, or does not: neither says anything of the scene.
TEST_F(Comparing, ADeckWithAnotherLawHasNoVerdict) {
  good_discs("--set allow.behind_walls=true --allow allow.behind_walls");
  const std::string force = text("deck/force.1.txt");
  for (const std::string& theirs : {force, furrow::test::with_line(force, 7, "400 1 0 0 0")}) {
    put("deck/force.1.txt", theirs);
    EXPECT_EQ(furrow("export --compare deck").code, 0) << out();
    const auto json = compared("deck");
    EXPECT_TRUE(json.at("good").is_null());
    for (const auto& part : json.at("early").at("parts")) EXPECT_TRUE(part.at("good").is_null()) << part;
    EXPECT_NE(out().find("none of this is a verdict"), std::string::npos) << out();
    EXPECT_EQ(out().find("Verdict:"), std::string::npos) << out();
  }
}

}  // namespace
