#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/judge/wrong_engines.h"
#include "verification/engines/furrow_engine.h"

namespace furrow::test {
namespace {

using verification::case_named;
using verification::case_names;
using verification::CaseVerdict;
using verification::judge_case;
using verification::Judgement;
using verification::to_string;

std::map<std::string, Judgement> judge_all(const Engine& engine) {
  std::map<std::string, Judgement> all;
  for (const std::string& name : case_names()) all[name] = judge_case(case_named(name), engine);
  return all;
}

TEST(Engines, TheIndependentOneIsRightInEveryCase) {
  for (const auto& [name, j] : judge_all(independent))
    EXPECT_EQ(to_string(j.verdict), "right") << name << ": " << j.words;
}

TEST(Engines, FurrowIsRightInEveryCase) {
  for (const char* method : {"verlet", "pece", "rk4"}) {
    for (const auto& [name, j] : judge_all([&](const Json& r) { return verification::furrow_answer(r, method); })) {
      EXPECT_EQ(to_string(j.verdict), "right") << method << ", " << name << ": " << j.words;
    }
  }
}

TEST(Engines, EachThatIsWrongOnPurposeIsFoundByACase) {
  for (const WrongEngine& wrong : wrong_engines()) {
    const Judgement j = judge_case(case_named(wrong.found_by), wrong.answer);
    EXPECT_GT(j.verdict, CaseVerdict::cannot) << wrong.name << " in " << wrong.found_by << ": " << j.words;
  }
}

TEST(Engines, TheExampleOfTheProtocolIsRightWhereItClaimsToBe) {
  const Engine example =
      verification::program_engine("python3 " FURROW_SOURCE_DIR "/verification/engines/example.py", 30);
  int own = 0, others = 0;
  for (const std::string& name : case_names()) {
    const Json whole = case_named(name);
    const bool can = whole["needs"] == Json{"hertz", "wall"};
    if (!can && ++others > 5) continue;  // one process a case, which says that it cannot
    const Judgement j = judge_case(whole, example);
    own += can ? 1 : 0;
    EXPECT_EQ(to_string(j.verdict), can ? "right" : "cannot") << name << ": " << j.words;
  }
  EXPECT_GE(own, 5);
}

}  // namespace
}  // namespace furrow::test
