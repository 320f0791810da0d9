#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene/interrupt.h"
#include "tests/judge/one_number.h"
#include "verification/engines/judge.h"
#include "verification/engines/judgement_files.h"

namespace furrow::test {
namespace {

using verification::CaseVerdict;
using verification::Finding;
using verification::Json;
using verification::judge_case;
using verification::judge_observable;
using verification::Judgement;

const std::vector<int> steps{250, 1000, 4000};

Finding judged(const std::function<double(double h)>& value, double claimed, const Json& more = Json::object()) {
  Json seen{{"name", "x"}, {"unit", "m"}, {"value", 2.0}, {"floor", 1e-12}, {"limit", 9}};
  seen.update(more);
  std::vector<double> h, values;
  for (const int n : steps) {
    h.push_back(1.0 / n);
    values.push_back(value(h.back()));
  }
  return judge_observable(seen, steps, h, values, claimed);
}

TEST(Verdict, AnErrorThatFallsWithTheClaimedOrderIsRight) {
  EXPECT_EQ(judged([](double h) { return 2 + 5 * h * h; }, 2).verdict, CaseVerdict::right);
  EXPECT_EQ(judged([](double h) { return 2 + 5 * h; }, 1).verdict, CaseVerdict::right);
}
TEST(Verdict, ALowerOrderThanClaimedIsLower) {
  EXPECT_EQ(judged([](double h) { return 2 + 5 * h; }, 2).verdict, CaseVerdict::lower_order);
}
TEST(Verdict, TheOrderThatTheCaseAllowsIsEnough) {
  EXPECT_EQ(judged([](double h) { return 2 + 5 * h; }, 4, {{"limit", 1}}).verdict, CaseVerdict::right);
}
TEST(Verdict, AnErrorBelowTheFloorIsRightWithoutAnOrder) {
  EXPECT_EQ(judged([](double) { return 2 + 1e-12; }, 4).verdict, CaseVerdict::right);
  EXPECT_NE(judged([](double) { return 2 + 1e-11; }, 4).verdict, CaseVerdict::right);
}
TEST(Verdict, WhatConvergesElsewhereIsAnotherLawWithItsLimit) {
  const Finding f = judged([](double h) { return 2.01 + 5 * h * h; }, 2);
  EXPECT_EQ(f.verdict, CaseVerdict::another_law);
  EXPECT_NEAR(f.limit, 2.01, 1e-6);
  EXPECT_EQ(judged([](double h) { return 2.01 + 5 * h; }, 1).verdict, CaseVerdict::another_law);
}
TEST(Verdict, WhatDoesNotSettleHasFailed) {
  EXPECT_EQ(judged([](double h) { return 2 + std::sin(1 / h); }, 2).verdict, CaseVerdict::failed);
}
TEST(Verdict, WildCoarseValuesDoNotMakeAWrongEndRight) {
  const auto of = [](std::vector<double> values, double claimed) {
    const Json seen{{"name", "x"}, {"unit", "m"}, {"value", 1.0}, {"floor", 1e-6}, {"limit", 9}};
    return judge_observable(seen, {250, 630, 1590, 4000}, {1. / 250, 1. / 630, 1. / 1590, 1. / 4000}, values, claimed);
  };
  EXPECT_EQ(of({1.2, 1.08, 1.03, 1.012}, 1).verdict, CaseVerdict::right);
  EXPECT_EQ(of({20, -18, 2, 2}, 1).verdict, CaseVerdict::another_law);
  EXPECT_EQ(of({200, -198, 2, 2}, 2).verdict, CaseVerdict::another_law);
  EXPECT_EQ(of({1.5, 0.6, 1.05, 1.05}, 1).verdict, CaseVerdict::another_law);
  EXPECT_NE(of({20, -18, 2.3, 2}, 1).verdict, CaseVerdict::right);
}
// Resolutions in groups: by chance two of them give one value, the others do not.
TEST(Verdict, ALastChangeThatIsSmallByChanceIsThatOfTheGroup) {
  const Json seen{{"name", "x"}, {"unit", "m"}, {"value", 1.0}, {"floor", 1e-6}, {"limit", 9}};
  const Finding f = judge_observable(seen, {100, 110, 400, 440, 1600, 1760},
                                     {1. / 100, 1. / 110, 1. / 400, 1. / 440, 1. / 1600, 1. / 1760},
                                     {1.2, 1.1, 1.05, 1.012, 1.003, 1.012}, 1);
  EXPECT_EQ(f.verdict, CaseVerdict::right) << f.words;
}
TEST(Verdict, AnEventIsRightWithinItsStepAndLateBeyond) {
  EXPECT_EQ(judged([](double h) { return 2 + 0.9 * h; }, 2, {{"kind", "step"}}).verdict, CaseVerdict::right);
  EXPECT_EQ(judged([](double h) { return 2 + 1.9 * h; }, 2, {{"kind", "step"}}).verdict, CaseVerdict::lower_order);
  EXPECT_EQ(judged([](double h) { return 2.1 + h; }, 2, {{"kind", "step"}}).verdict, CaseVerdict::another_law);
}
TEST(Verdict, AStatisticIsRightInsideItsInterval) {
  const Json band{{"kind", "interval"}, {"interval", {1.0, 3.0}}};
  EXPECT_EQ(judged([](double h) { return 1 + h; }, 2, band).verdict, CaseVerdict::right);
  EXPECT_EQ(judged([](double) { return 3.001; }, 2, band).verdict, CaseVerdict::another_law);
}

// One answer for all requests.
Judgement judgement_of(const Json& answer) {
  return judge_case(verification::case_named("hertz_wall"), [&](const Json&) { return answer; });
}

TEST(Judge, AnAnswerThatDoesNotFollowTheProtocolHasFailed) {
  EXPECT_EQ(judgement_of({{"engine", "x"}}).verdict, CaseVerdict::failed);
  EXPECT_EQ(judgement_of({{"engine", "x"}, {"observables", Json::object()}}).verdict, CaseVerdict::failed);
  EXPECT_EQ(judgement_of(Json::array({1})).verdict, CaseVerdict::failed);
  const Json whole = verification::case_named("hertz_wall");
  Json none{{"engine", "x"}, {"order", 2}, {"observables", Json::object()}};
  for (const Json& seen : whole["observe"]) none["observables"][seen["name"].get<std::string>()] = nullptr;
  EXPECT_EQ(judgement_of(none).verdict, CaseVerdict::failed);
}

// What it says at each resolution, the coarsest first.
Judgement judgement_of_each(const std::string& name, const std::vector<Json>& answers) {
  std::size_t asked = 0;
  return judge_case(verification::case_named(name),
                    [&](const Json&) { return answers[std::min(asked++, answers.size() - 1)]; });
}

TEST(Judge, AClaimThatIsNoOrderHasFailed) {
  for (const Json& order : {Json(-99), Json(0), Json(0.9), Json(21), Json("two"), Json(nullptr)}) {
    Json answer = all_observables("hertz_wall", 1);
    answer["order"] = order;
    const Judgement j = judgement_of(answer);
    EXPECT_EQ(j.verdict, CaseVerdict::failed) << order;
    EXPECT_NE(j.words.find("order"), std::string::npos) << j.words;
  }
  Json other = all_observables("hertz_wall", 1);
  other["order"] = 1;
  const Judgement j = judgement_of_each("hertz_wall", {all_observables("hertz_wall", 1), other});
  EXPECT_EQ(j.verdict, CaseVerdict::failed);
  EXPECT_NE(j.words.find("changes from 2 to 1"), std::string::npos) << j.words;
}
TEST(Judge, WhatCannotOnlyWithShorterStepsHasFailed) {
  const Json cannot{{"engine", "x"}, {"cannot", "too fine"}};
  const Judgement j = judgement_of_each("hertz_wall", {all_observables("hertz_wall", 1), cannot});
  EXPECT_EQ(j.verdict, CaseVerdict::failed);
  EXPECT_NE(j.words.find("too fine"), std::string::npos) << j.words;
}
TEST(Judge, NothingThatMovesIsNotTheSameInAMirror) {
  const Judgement j = judgement_of_each("mirrored_pair", {all_observables("mirrored_pair", 0)});
  EXPECT_EQ(j.verdict, CaseVerdict::failed) << j.words;
}
TEST(Judge, AnObservableThatStandsTwiceHasFailed) {
  const Judgement j =
      judge_case(verification::case_named("hertz_wall"),
                 verification::program_engine(R"(echo '{"engine":"x","order":1,"observables":{"a":1,"a":2}}')", 10));
  EXPECT_EQ(j.verdict, CaseVerdict::failed);
  EXPECT_NE(j.words.find("\"a\" twice"), std::string::npos) << j.words;
}
TEST(Judge, AnInterruptIsNoVerdict) {
  EXPECT_THROW(judge_case(verification::case_named("hertz_wall"),
                          [](const Json&) -> Json { throw Interrupted("interrupted by SIGINT"); }),
               Interrupted);
}
TEST(Judge, AnEngineThatCannotIsNotHeldToIt) {
  const Judgement j = judgement_of({{"engine", "x"}, {"cannot", "no walls"}});
  EXPECT_EQ(j.verdict, CaseVerdict::cannot);
  EXPECT_EQ(j.words, "no walls");
}
TEST(Judge, AProgramThatEndsBadlyHasFailedWithItsLastWords) {
  const Judgement j =
      judge_case(verification::case_named("hertz_wall"), verification::program_engine("echo no luck >&2; exit 3", 10));
  EXPECT_EQ(j.verdict, CaseVerdict::failed);
  EXPECT_NE(j.words.find("code 3: no luck"), std::string::npos) << j.words;
}
TEST(Judge, AProgramThatDoesNotEndIsStopped) {
  const Judgement j =
      judge_case(verification::case_named("hertz_wall"), verification::program_engine("sleep 100", 0.2));
  EXPECT_EQ(j.verdict, CaseVerdict::failed);
  EXPECT_NE(j.words.find("was stopped"), std::string::npos) << j.words;
}
TEST(Judge, AProgramGetsTheRequestOnItsStandardInput) {
  const verification::Engine echo = verification::program_engine("cat", 10);
  const Json request = verification::request_of(verification::case_named("stack"), 250);
  EXPECT_EQ(echo(request), request);
}

TEST(JudgementFiles, JUnitHasFailuresSkipsAndNoLooseAngles) {
  Judgement bad = judgement_of({{"engine", "<x> & \"y\""}, {"observables", Json::object()}});
  const Judgement skipped = judgement_of({{"engine", "x"}, {"cannot", "a < b"}});
  const std::string text = verification::judgements_as_junit({bad, skipped});
  EXPECT_NE(text.find("tests=\"2\" failures=\"1\" skipped=\"1\""), std::string::npos) << text;
  EXPECT_NE(text.find("&lt;x> &amp; &quot;y&quot;"), std::string::npos) << text;
  EXPECT_NE(text.find("a &lt; b"), std::string::npos) << text;
}
TEST(JudgementFiles, WhatWasJudgedBeforeAnInterruptIsMarked) {
  Judgement j = judgement_of({{"engine", "x"}, {"cannot", "y"}});
  j.command = "./mine";
  const Json whole = verification::judgements_as_json({j}),
             part = verification::judgements_as_json({j}, "1 of 57 cases");
  EXPECT_EQ(whole[0]["command"], "./mine");
  EXPECT_FALSE(whole[0].contains("partial"));
  EXPECT_EQ(part[0]["partial"], "1 of 57 cases");
  const std::string text = verification::judgements_as_junit({j}, "1 of 57 cases");
  EXPECT_NE(text.find("errors=\"1\""), std::string::npos) << text;
  EXPECT_NE(text.find("interrupted: 1 of 57 cases"), std::string::npos) << text;
}

}  // namespace
}  // namespace furrow::test
