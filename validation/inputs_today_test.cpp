// What goes into a result counts as its sources do: another scene, or another row asked of it, makes it old, by its name.
#include <gtest/gtest.h>

#include "report/study.h"
#include "validation/page/age_words.h"
#include "validation/page/chapters/chapters.h"

namespace furrow::validation {
namespace {

std::string input = "1";  // of "a" today

// A study that goes by what it has: without "a" it would ask for "c".
const Study going_on{.name = "s",
                     .measure =
                         [](Measurement& m) {
                           const auto one = [] { return Json(1); };
                           const Json first = m.run({{"a", one, input}, {"b", one, "1"}})[0];
                           if (first == 1) m.run({{"after a", one}});
                         },
                     .chapter = [](const Shelf&) { return Report("", ""); }};

Numbers kept() {
  Numbers numbers("s", "full");
  for (const char* key : {"a", "b", "after a"})
    numbers.add({.key = key, .input = key == std::string("after a") ? "" : "1", .value = 1},
                this_maker(going_on.sources()));
  return numbers;
}

TEST(InputsToday, ThatChangedMakeTheirResultsOldAndNoOther) {
  input = "1";
  EXPECT_EQ(age_today(going_on, kept()).age.old, 0u);
  input = "2";
  const AgeToday today = age_today(going_on, kept());
  EXPECT_EQ(today.age.old, 1u);
  EXPECT_EQ(today.age.inputs, std::vector<std::string>{"a"});
  EXPECT_EQ(today.not_kept, std::vector<std::string>{});
  EXPECT_EQ(why_old(today.age), "1 of them were made before the input of these changed: a.");
}

TEST(InputsToday, AreComparedWithoutARun) {
  int runs = 0;
  InputsToday today("s", kept(), going_on.sources());
  EXPECT_EQ(today.run({{"a", [&] { return Json(++runs); }, "1"}}), std::vector<Json>{1});
  EXPECT_EQ(runs, 0);
}

TEST(InputsToday, WhatIsNotKeptIsNamed) {
  input = "1";
  Numbers fewer("s", "full");
  fewer.add({.key = "a", .input = "1", .value = 1}, this_maker(going_on.sources()));
  EXPECT_EQ(age_today(going_on, fewer).not_kept, (std::vector<std::string>{"b", "after a"}));
}

TEST(InputsToday, AResultThatIsTakenOverIsItsOwn) {
  InputsToday today("s", kept(), going_on.sources());
  today.take({.key = "after a", .value = 1}, this_maker({}));
  EXPECT_EQ(today.inputs().at("after a"), "");
  today.take({.key = "after a", .value = 2}, this_maker({}));
  EXPECT_NE(today.inputs().at("after a"), "");
}

// Each kept study but that of times, which reads files beside the program, is asked for today's inputs.
TEST(InputsToday, OfEachKeptStudyCanBeAskedFor) {
  for (const Study& study : catalogue()) {
    if (study.files.empty()) continue;
    const Numbers numbers = Numbers::read(FURROW_SOURCE_DIR "/reference_data/studies/" + study.name + ".json");
    EXPECT_NO_THROW(age_today(study, numbers)) << study.name;
  }
}

}  // namespace
}  // namespace furrow::validation
