#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
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

// A row of the matrix of engines that are wrong on purpose by quick cases: each verdict's sign, as scripts/judge prints it.
std::string row_of(const WrongEngine& wrong, const std::vector<std::string>& quick) {
  constexpr char signs[] = {'+', '.', 'o', 'X', '!'};
  std::string row;
  for (const std::string& name : quick)
    row += signs[static_cast<int>(judge_case(case_named(name), wrong.answer).verdict)];
  return row;
}

// Wrong engines by the cases that find one each: none has an empty row. Prints the matrix, and writes it to the
// file that FURROW_MATRIX names.
TEST(Engines, TheMatrixOfWrongOnesByQuickCasesHasNoEmptyRow) {
  if (std::getenv("FURROW_LONG") == nullptr) GTEST_SKIP() << "takes six minutes: FURROW_LONG=1 runs it, as every night";
  std::vector<std::string> quick;
  for (const WrongEngine& wrong : wrong_engines()) {
    if (std::find(quick.begin(), quick.end(), wrong.found_by) == quick.end()) quick.push_back(wrong.found_by);
  }
  std::sort(quick.begin(), quick.end());
  std::string text;
  for (std::size_t k = 0; k < quick.size(); ++k) text += std::string(36 + k, ' ') + quick[k] + "\n";
  for (const WrongEngine& wrong : wrong_engines()) {
    const std::string row = row_of(wrong, quick);
    EXPECT_NE(row.find_first_of("oX!"), std::string::npos) << wrong.name << ": no case tells it from the right one";
    text += wrong.name + std::string(36 - std::min<std::size_t>(wrong.name.size(), 35), ' ') + row + "\n";
  }
  text += "\n+ right   o of lower order   X another law   ! failed   . cannot\n";
  std::printf("%s", text.c_str());
  if (const char* file = std::getenv("FURROW_MATRIX")) std::ofstream(file) << text;
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
