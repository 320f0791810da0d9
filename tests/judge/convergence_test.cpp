// Where a series of values goes: synthetic ones, and those that engines gave.
#include "verification/engines/convergence.h"

#include <gtest/gtest.h>

#include <cmath>

#include "verification/engines/judge.h"

namespace furrow::test {
namespace {

using verification::CaseVerdict;
using verification::Finding;
using verification::Json;

struct Series {
  double expected = 2, floor = 1e-6, claimed = 1;
  std::vector<int> steps;
  std::vector<double> values;
};

Finding judged(const Series& s) {
  const Json seen{{"name", "x"}, {"unit", "m"}, {"floor", s.floor}, {"limit", 9}};
  Finding f{.name = "x", .unit = "m", .values = s.values, .expected = s.expected};
  return verification::judge_converging(f, seen, s.steps, s.claimed);
}

Finding of_function(const std::function<double(double steps)>& value, double expected, double claimed) {
  Series s{.expected = expected, .claimed = claimed, .steps = {250, 630, 1590, 4000, 8000}};
  for (const int n : s.steps) s.values.push_back(value(n));
  return judged(s);
}

// LAMMPS, 29 Sep 2021, gross_slip_40, the velocity along x in m/s: its first change is small by chance.
Series gross_slip(std::size_t count) {
  Series s{.expected = 1.96263304141, .claimed = 1, .steps = {250, 630, 1590, 4000, 8000, 16000}};
  s.values = {1.9626279261269453, 1.9626325652443821, 1.9626645561356946,
              1.962689414123024,  1.962690621482397,  1.962691095463558};
  s.steps.resize(count), s.values.resize(count);
  return s;
}

TEST(Convergence, AFirstChangeThatIsSmallByChanceHidesNoOtherLaw) {
  EXPECT_TRUE(judged(gross_slip(4)).undecided) << "the last changes are 3.2e-5 and 2.5e-5";
  for (const std::size_t count : {5, 6}) {
    const Finding f = judged(gross_slip(count));
    EXPECT_EQ(f.verdict, CaseVerdict::another_law) << count << ": " << f.words;
    EXPECT_NEAR(f.limit, 1.9626914, f.left) << "where it goes by the order that it has";
    EXPECT_LT(f.left, 0.3 * std::fabs(f.limit - 1.96263304141));
    EXPECT_FALSE(f.undecided);
  }
}
// The same of LIGGGHTS 3.8.0 and YADE 2023.02a, at 630, 1000, 4000, 8000 and 16000.
TEST(Convergence, OtherEnginesGoElsewhereTooThoughTheyTurnBack) {
  const std::vector<std::vector<double>> all{
      {1.9626313518242404, 1.9626076002986819, 1.962598444045636, 1.9625995904461946, 1.9626002090057546},
      {1.962631351824211, 1.9626076001921966, 1.9625841616654356, 1.962581726509462, 1.9625825317212267}};
  for (const auto& values : all) {
    const Finding f = judged({1.96263304141, 1e-6, 1, {630, 1000, 4000, 8000, 16000}, values});
    EXPECT_EQ(f.verdict, CaseVerdict::another_law) << f.words;
  }
}
TEST(Convergence, ElsewhereIsSaidWithWhatIsLeft) {
  for (const double order : {1.0, 1.5, 2.0}) {
    const Finding f = of_function([&](double n) { return 2.01 + 5 * std::pow(n, -order); }, 2, order);
    EXPECT_EQ(f.verdict, CaseVerdict::another_law) << order << ": " << f.words;
    EXPECT_NEAR(f.limit, 2.01, f.left) << order;
    EXPECT_NE(f.words.find(" within "), std::string::npos) << f.words;
  }
}
TEST(Convergence, SlowlyToTheExpectedValueIsNoOtherLaw) {
  for (const double order : {0.3, 0.4, 0.5, 0.7}) {
    const Finding f = of_function([&](double n) { return 2 + 5 * std::pow(n, -order); }, 2, 2);
    EXPECT_NE(f.verdict, CaseVerdict::another_law) << order << ": " << f.words;
    EXPECT_NE(f.verdict, CaseVerdict::right) << order << ": " << f.words;
  }
}
TEST(Convergence, WhatGrowsHasFailed) {
  for (const double expected : {0.0, 2.0, 20.0}) {
    for (const auto& value : std::vector<std::function<double(double)>>{
             [](double n) { return std::log(n); }, [](double n) { return std::sqrt(n); }, [](double n) { return n; }}) {
      const Finding f = of_function(value, expected, 1);
      EXPECT_EQ(f.verdict, CaseVerdict::failed) << f.words;
      EXPECT_TRUE(f.undecided);
    }
  }
}
TEST(Convergence, WhatSwingsAboutTheExpectedValueHasFailed) {
  for (const double amplitude : {1e-4, 0.1, 3.0}) {
    const Finding f = of_function([&](double n) { return 2 + amplitude * std::sin(n); }, 2, 1);
    EXPECT_EQ(f.verdict, CaseVerdict::failed) << f.words;
    double sign = 1;
    const Finding g = of_function([&](double) { return 2 + amplitude * (sign = -sign); }, 2, 1);
    EXPECT_EQ(g.verdict, CaseVerdict::failed) << g.words;
  }
}
// Noise whose spread is much more than the floor: the last changes may be small and on one side by chance, in one series of
// twenty. By the last change against the first alone it would be one of three.
TEST(Convergence, NoiseAboutTheExpectedValueIsHardlyEverAnotherLaw) {
  unsigned state = 1;
  const auto noise = [&](double) {
    state = state * 1664525U + 1013904223U;
    return 2 + 1e-3 * (static_cast<double>(state >> 8) / 8388608.0 - 1);
  };
  int elsewhere = 0;
  for (int k = 0; k < 500; ++k) elsewhere += of_function(noise, 2, 1).verdict == CaseVerdict::another_law ? 1 : 0;
  EXPECT_LE(elsewhere, 40) << "of 500";
}
TEST(Convergence, NoiseAboutAnotherValueIsAnotherLaw) {
  const Finding f = of_function([](double n) { return 2.1 + 1e-3 * std::sin(n); }, 2, 1);
  EXPECT_EQ(f.verdict, CaseVerdict::another_law) << f.words;
  EXPECT_NEAR(f.limit, 2.1, f.left);
}
TEST(Convergence, NoiseBelowTheFloorIsRight) {
  EXPECT_EQ(of_function([](double n) { return 2 + 1e-6 * std::sin(n); }, 2, 1).verdict, CaseVerdict::right);
}

// The case asks with 250, 1000 and 4000 steps; what an engine says of more is taken only if the case stays open.
struct Asked {
  Json engine(const Json& request, const std::function<double(int)>& value, int most) {
    const int n = request["steps"];
    steps.push_back(n);
    if (n > most) throw std::runtime_error("too many steps");
    Json answer{{"engine", "x"}, {"order", 1}, {"observables", Json::object()}};
    for (const Json& seen : request["case"]["observe"])
      answer["observables"][seen["name"].get<std::string>()] = value(n);
    return answer;
  }
  std::vector<int> steps;
};

verification::Judgement judgement_of(const std::function<double(int)>& value, int most, std::vector<int>& asked) {
  Asked all;
  const verification::Judgement j = verification::judge_case(
      verification::case_named("hertz_wall"), [&](const Json& request) { return all.engine(request, value, most); });
  asked = all.steps;
  return j;
}

TEST(Convergence, AnOpenCaseIsAskedWithMoreStepsTwice) {
  const int last = verification::case_named("hertz_wall")["steps"].back();
  std::vector<int> asked;
  const auto j = judgement_of([](int n) { return std::log(n); }, 1 << 30, asked);
  EXPECT_EQ(j.verdict, CaseVerdict::failed) << j.words;
  EXPECT_EQ(j.steps, asked);
  ASSERT_GE(asked.size(), 5U);
  EXPECT_EQ(asked[asked.size() - 2], 2 * last);
  EXPECT_EQ(asked.back(), 4 * last);
}
TEST(Convergence, WhatIsDecidedIsNotAskedAgain) {
  std::vector<int> asked;
  const auto j = judgement_of([](int) { return 1.0; }, 1 << 30, asked);
  EXPECT_EQ(j.verdict, CaseVerdict::another_law) << j.words;
  EXPECT_EQ(Json(asked), verification::case_named("hertz_wall")["steps"]);
}
TEST(Convergence, AnEngineThatGivesUpWithMoreStepsIsJudgedByWhatItSaid) {
  const int last = verification::case_named("hertz_wall")["steps"].back();
  std::vector<int> asked;
  const auto j = judgement_of([](int n) { return std::log(n); }, last, asked);
  EXPECT_EQ(j.verdict, CaseVerdict::failed);
  EXPECT_NE(j.words.find("does not converge up to " + std::to_string(last)), std::string::npos) << j.words;
  EXPECT_EQ(asked.back(), 2 * last);
}

}  // namespace
}  // namespace furrow::test
