// What an engine may print: an answer that does not follow the protocol has failed, and no other case is lost by it.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "output/child.h"
#include "tests/command_line/program.h"
#include "tests/judge/one_number.h"
#include "verification/engines/judge.h"
#include "verification/engines/judgement_files.h"

namespace furrow::test {
namespace {

using verification::CaseVerdict;
using verification::Json;
using verification::judge_observable;
using verification::Judgement;

Judgement judgement_of(const std::string& command) {
  return verification::judge_case(verification::case_named("hertz_wall"), verification::program_engine(command, 10));
}

void expect_failed(const std::string& command, const std::string& words) {
  const Judgement j = judgement_of(command);
  EXPECT_EQ(j.verdict, CaseVerdict::failed) << command;
  EXPECT_NE(j.words.find(words), std::string::npos) << j.words;
  EXPECT_NO_THROW(verification::judgements_as_json({j}).dump());
}

std::string answering(const Json& answer) { return "cat >/dev/null; echo '" + answer.dump() + "'"; }

TEST(Answers, CannotWithoutAWordIsNoLeaveToAnswerOnce) {
  Json answer = all_observables("hertz_wall", 12345);
  answer["cannot"] = "";
  expect_failed(answering(answer), "has cannot, and no word why");
  answer["cannot"] = "   ";
  expect_failed(answering(answer), "has cannot, and no word why");
}

TEST(Answers, FieldsOfAnotherTypeAreNamed) {
  const Json right = all_observables("hertz_wall", 12345);
  for (const char* field : {"engine", "method", "cannot"}) {
    for (const Json& wrong : {Json(3), Json(true), Json(nullptr), Json::array({"a"}), Json::object()}) {
      Json answer = right;
      answer[field] = wrong;
      expect_failed(answering(answer), "the answer's \"" + std::string(field) + "\" is not a text but " + wrong.dump());
    }
  }
  for (const Json& wrong : {Json(3), Json("x"), Json(nullptr), Json::array({1.0})}) {
    Json answer = right;
    answer["observables"] = wrong;
    expect_failed(answering(answer), "observables are not an object");
  }
}

TEST(Answers, OneValueIsJudgedForEachResolutionOrNotAtAll) {
  const Json seen{{"name", "x"}, {"unit", "m"}, {"value", 2.0}, {"floor", 1e-12}, {"limit", 9}};
  const std::vector<double> h{0.1, 0.01, 0.001};
  for (const std::vector<double>& values : {std::vector<double>{}, {2.0}, {2.0, 2.0}, {2.0, 2.0, 2.0, 2.0}})
    EXPECT_THROW(judge_observable(seen, {10, 100, 1000}, h, values, 1), std::logic_error) << values.size();
}

TEST(Answers, NestedTooDeepHasFailed) {
  const std::string deep = "'[' * 200000 + ']' * 200000", answer = "cat >/dev/null; python3 -c \"print('{";
  expect_failed(answer + "\\\"engine\\\": ' + " + deep + " + '}')\"", "nested deeper");
  expect_failed(answer + "\\\"order\\\": ' + " + deep + " + '}')\"", "nested deeper");
}

TEST(Answers, BytesThatAreNoUtf8AreShownAsSuch) {
  expect_failed(R"(cat >/dev/null; printf '{"engine": "\377"}')", "is no JSON");
  expect_failed(R"(printf 'lost \377 and \303' >&2; exit 3)", "code 3: lost ? and ?");
  expect_failed("python3 -c \"import sys; sys.stderr.buffer.write(b'x' + 'ö'.encode() * 400)\"; exit 3", "öö?");
}

// How many processes run that program with that one argument.
int running(const std::string& program, const std::string& argument) {
  const std::string wanted = program + std::string(1, '\0') + argument + std::string(1, '\0');
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream stream(entry.path() / "cmdline", std::ios::binary);
    count += std::string(std::istreambuf_iterator<char>(stream), {}) == wanted ? 1 : 0;
  }
  return count;
}

TEST(Answers, WhatAnEngineLeavesBehindIsEndedWithIt) {
  {
    const Process other(".", "sleep 531.25");
    EXPECT_TRUE(comes_true([] { return running("sleep", "531.25") == 1; }));
  }
  // What is killed may be seen for a moment longer.
  const auto none_left = [] { return running("sleep", "3127.5") == 0; };
  const std::string left = "setsid sleep 3127.5 >/dev/null 2>&1 & ";
  EXPECT_EQ(verification::program_engine(left + "sleep 0.2; echo '{}'", 120)({}), Json::object());
  EXPECT_TRUE(comes_true(none_left)) << "after an answer";
  EXPECT_THROW(verification::program_engine(left + "sleep 600", 1)({}), std::runtime_error);
  EXPECT_TRUE(comes_true(none_left)) << "after its time";
  const ChildEnd end = run_child({.words = {"sh", "-c", "sleep 3127.5 & echo $!"}});
  EXPECT_TRUE(comes_true(none_left)) << "of the program's own group";
}

TEST(Answers, WhatXmlCannotHoldIsReplaced) {
  Judgement j = judgement_of("exit 3");
  j.words = "a \xef\xbf\xbf b \x01 c";
  EXPECT_NE(verification::judgements_as_junit({j}).find("failed: a ? b ? c"), std::string::npos);
}

TEST(Answers, WithoutEndAreStopped) {
  expect_failed("yes", "has printed more than " + std::to_string(ChildRequest::most_output >> 20) + " MiB");
}

}  // namespace
}  // namespace furrow::test
