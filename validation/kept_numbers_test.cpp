// The numbers that a study keeps: which are taken, which are made again, how old they are.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <new>

#include "output/files.h"
#include "report/seal.h"
#include "report/study.h"
#include "validation/page/chapters/chapters.h"

namespace furrow::validation {
namespace {

namespace fs = std::filesystem;

struct Place {
  fs::path path = fs::temp_directory_path() / ("furrow_numbers_" + std::to_string(getpid()));
  Place() { fs::create_directories(path); }
  ~Place() { fs::remove_all(path); }
};

const Sources sources{{"src/physics/contact.h", "1"}, {"validation/studies/s.cpp", "1"}};

Task task(const std::string& key, Json result, int& count) {
  return {key, [result = std::move(result), &count] { return ++count, result; }};
}

Json value_of(Measurement& measurement, const Task& task) { return measurement.run({task}).at(0); }

// Makes {"x": 1} under the key "a", as the study "s".
void make(const fs::path& directory, const Sources& by = sources) {
  int count = 0;
  Measurement first("s", {.directory = directory}, by);
  value_of(first, task("a", {{"x", 1}}, count));
}

TEST(KeptNumbers, AreNotMadeTwice) {
  Place place;
  make(place.path);
  int count = 0;
  Measurement again("s", {.directory = place.path}, sources);
  EXPECT_EQ(value_of(again, task("a", {{"x", 2}}, count)), Json({{"x", 1}}));
  again.numbers().write(place.path / "s.json");
  fs::remove(place.path / "s.runs.jsonl");
  Measurement of_the_whole("s", {.directory = place.path}, sources);
  EXPECT_EQ(value_of(of_the_whole, task("a", {{"x", 2}}, count)), Json({{"x", 1}}));
  EXPECT_EQ(count, 0);
}

TEST(KeptNumbers, OfTheQuickFormDoNotServeTheFullOneNorAnotherStudy) {
  Place place;
  make(place.path);
  int count = 0;
  Measurement quick("s", {.quick = true, .directory = place.path}, sources);
  value_of(quick, task("a", 2, count));
  fs::copy_file(place.path / "s.runs.jsonl", place.path / "t.runs.jsonl");
  Measurement other("t", {.directory = place.path}, sources);
  value_of(other, task("a", 2, count));
  EXPECT_EQ(count, 2);
}

TEST(KeptNumbers, OfOtherSourcesAnotherInputOrAnotherMachineAreMadeAgain) {
  int count = 0;
  for (const char* file : {"src/physics/contact.h", "validation/studies/s.cpp", "src/kernel/loops.cpp"}) {
    Place place;
    make(place.path);
    Sources others = sources;
    others[file] = "2";
    Measurement changed("s", {.directory = place.path}, others);
    EXPECT_EQ(value_of(changed, task("a", 2, count)), 2) << file;
  }
  Place place;
  make(place.path);
  Measurement again("s", {.directory = place.path}, sources);
  Task of_a_scene = task("a", 2, count), timed = task("a", 2, count);
  of_a_scene.input = "1";
  timed.timed = true;
  EXPECT_EQ(value_of(again, of_a_scene), 2);
  EXPECT_EQ(value_of(again, timed), 2);
  EXPECT_EQ(count, 5);
}

TEST(KeptNumbers, TimesAreOfOneMachineAndOneWayToCompile) {
  for (std::string Maker::*part : {&Maker::machine, &Maker::compiler, &Maker::flags}) {
    Place place;
    Maker there = this_maker(sources);
    there.*part = "another";
    Numbers numbers("s", "full");
    numbers.add({.key = "time", .timed = true, .value = 1}, there);
    numbers.add({.key = "number", .value = 1}, there);
    numbers.write(place.path / "s.json");
    Measurement here("s", {.directory = place.path}, sources);
    int count = 0;
    Task time = task("time", 2, count), number = task("number", 2, count);
    time.timed = true;
    EXPECT_EQ(here.run({time, number}), (std::vector<Json>{2, 1}));
  }
}

TEST(KeptNumbers, AFailureIsTriedAgain) {
  Place place;
  int count = 0;
  Measurement first("s", {.directory = place.path}, sources);
  EXPECT_EQ(value_of(first, {"a", []() -> Json { throw std::runtime_error("once"); }}).at("failed"), "once");
  Measurement again("s", {.directory = place.path}, sources);
  EXPECT_EQ(value_of(again, task("a", {{"x", 1}}, count)).at("x"), 1);
}

TEST(KeptNumbers, WantOfMemoryEndsTheStudy) {
  Measurement one("s", {}, sources), two("s", {.jobs = 2}, sources);
  EXPECT_THROW(value_of(one, {"a", []() -> Json { throw std::bad_alloc(); }}), std::bad_alloc);
  EXPECT_THROW(value_of(two, {"a", []() -> Json { throw FileError("full"); }}), FileError);
}

TEST(KeptNumbers, ChangedByHandOrCutAreMadeAgain) {
  Place place;
  make(place.path);
  std::string line;
  std::getline(std::ifstream(place.path / "s.runs.jsonl"), line);
  const std::string by_hand = std::string(line).replace(line.find("\"x\":1"), 5, "\"x\":3");
  int count = 0;
  for (const std::string& spoilt : {by_hand, line.substr(0, 40)}) {
    std::ofstream(place.path / "s.runs.jsonl") << spoilt;
    Measurement again("s", {.directory = place.path}, sources);
    EXPECT_EQ(value_of(again, task("a", 2, count)), 2);
    Measurement third("s", {.directory = place.path}, sources);
    EXPECT_EQ(value_of(third, task("a", 3, count)), 2) << "what follows a line that was cut is taken";
  }
}

TEST(KeptNumbers, TwoOfOneKeyAreRefused) {
  int count = 0;
  Measurement one("s", {}, sources);
  EXPECT_THROW(one.run({task("a", {}, count), task("a", {}, count)}), std::logic_error);
}

TEST(KeptNumbers, AFileOfSomethingElseIsNotReplaced) {
  Place place;
  std::ofstream(place.path / "s.json") << "{\"mine\": 1}";
  EXPECT_THROW(Measurement("s", {.directory = place.path}, sources), FileError);
}

// ---- age ----

TEST(Age, IsOfTheSourcesThatDecide) {
  Numbers numbers("s", "full");
  numbers.add({.key = "a", .value = 1}, this_maker(sources));
  numbers.add({.key = "b", .timed = true, .value = 1}, this_maker(sources));
  EXPECT_EQ(age_of(numbers, sources).old, 0u);
  Sources today = sources;
  today["src/physics/contact.h"] = "2";
  const Age age = age_of(numbers, today);
  EXPECT_EQ(age.old, 2u);
  EXPECT_EQ(age.old_times.size(), 1u);
  EXPECT_EQ(age.changed, std::vector<std::string>{"src/physics/contact.h"});
}

TEST(Age, ProgramOutputAndPageDecideNoNumber) {
  for (const auto& [file, hash] : that_decide(sources_of_this_program(), {})) {
    for (const char* room :
         {"src/program/", "src/output/", "src/report/", "validation/", "benchmarks/", "verification/"})
      EXPECT_FALSE(file.starts_with(room)) << file;
  }
}

// Every file of these rooms is one of the sources that decide.
TEST(Age, TheWholeStatePathDecides) {
  const Sources deciding = that_decide(sources_of_this_program(), {}, true);
  const fs::path top = FURROW_SOURCE_DIR;
  int seen = 0;
  for (const char* room : {"physics", "system", "reference", "kernel", "methods", "run"}) {
    for (const auto& entry : fs::directory_iterator(top / "src" / room)) {
      ++seen;
      EXPECT_TRUE(deciding.contains(fs::relative(entry.path(), top))) << entry.path();
    }
  }
  EXPECT_GT(seen, 50);
}

// A watch ends a run or lets it be (Validity's tests have that it moves no bit), so what it does not end stays as it was.
TEST(Age, AWatchDecidesWhatIsWatchedAlone) {
  const Sources& all = sources_of_this_program();
  const Sources watched = that_decide(all, {}, true), unwatched = that_decide(all, {});
  const std::string watch = "src/run/validity.cpp";
  EXPECT_TRUE(watched.contains(watch));
  EXPECT_FALSE(unwatched.contains(watch));
  EXPECT_TRUE(unwatched.contains("src/run/run.cpp"));
  Sources before = watched;
  before[watch] = "another";
  EXPECT_EQ(changed_since(before, watched), std::vector<std::string>{watch});
  EXPECT_TRUE(changed_since(before, unwatched).empty());
  before["src/run/run.cpp"] = "another";
  EXPECT_EQ(changed_since(before, unwatched), std::vector<std::string>{"src/run/run.cpp"});
  before["src/run/gone.cpp"] = "a source that is there no more";
  EXPECT_EQ(changed_since(before, unwatched).size(), 2u);
}

// A name in the catalogue that fits no file would leave out what it should follow.
TEST(Age, EachOfAStudysOwnSourcesIsThere) {
  int named = 0;
  for (const Study& study : catalogue()) {
    EXPECT_TRUE(study.measure && study.chapter) << study.name;
    for (const std::string& file : study.files) {
      ++named;
      const Sources& all = sources_of_this_program();
      EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.first.starts_with(file); }))
          << study.name << ": " << file;
    }
  }
  EXPECT_GT(named, 20);
}

// The hashes are of what a compiler reads: a constant changes one, a comment none.
TEST(Age, AConstantMakesNumbersOldAndACommentDoesNot) {
  Place place;
  const auto hashes = [&](const std::string& text) {
    std::ofstream(place.path / "law.h") << text;
    const std::string command = "cmake -DOUTPUT=" + (place.path / "sources.cpp").string() +
                                " -DSOURCE_DIR=" + place.path.string() +
                                " -DFILES=law.h -P " FURROW_SOURCE_DIR "/cmake/write_sources.cmake";
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::ifstream written(place.path / "sources.cpp");
    return std::string(std::istreambuf_iterator<char>(written), {});
  };
  const std::string before = hashes("constexpr double factor = 2;  // one\n");
  EXPECT_EQ(hashes("constexpr  double factor = 2;\n// another\n"), before);
  EXPECT_NE(hashes("constexpr double factor = 3;  // one\n"), before);
}

// ---- a sample made anew ----

double made = 1;  // what the study below makes today

const Study two_numbers{
    .name = "s",
    .measure =
        [](Measurement& m) {
          m.run({{"cheap", [] { return Json(made); }}, {"time", [] { return Json(made); }, "", true}});
        },
    .chapter = [](const Shelf&) { return Report("", ""); }};

TEST(Recomputed, ANumberThatDoesNotComeOutIsNamed) {
  Place place;
  made = 1;
  run_study(two_numbers, {.directory = place.path});
  const Checked good = check_study(two_numbers, place.path, 1, 10);
  EXPECT_EQ(good.compared, 1) << "times are not made anew";
  EXPECT_TRUE(good.wrong.empty());
  made = 2;
  const Checked bad = check_study(two_numbers, place.path, 1, 10);
  EXPECT_EQ(bad.wrong, std::vector<std::string>{"cheap: now 2.0, kept 1.0"});
}

// A number that is kept as a time would never be made again.
TEST(Recomputed, NothingComparedIsNotGood) {
  Place place;
  made = 1;
  for (const double cpu : {0.0, 100.0}) {
    Numbers numbers("s", "full");
    numbers.add({.key = "cheap", .timed = cpu == 0, .cpu = cpu, .value = 1.0}, this_maker(sources));
    numbers.add({.key = "time", .timed = true, .value = 1.0}, this_maker(sources));
    numbers.write(place.path / "s.json");
    const Checked checked = check_study(two_numbers, place.path, 1, 10);
    EXPECT_EQ(checked.compared, 0);
    ASSERT_FALSE(checked.wrong.empty());
    EXPECT_EQ(checked.wrong.back(), "no number was compared");
  }
}

TEST(Recomputed, TheFileOfAnotherStudyIsRefused) {
  Place place;
  Numbers numbers("t", "full");
  numbers.add({.key = "cheap", .value = 1.0}, this_maker(sources));
  numbers.write(place.path / "s.json");
  EXPECT_THROW(check_study(two_numbers, place.path, 1, 10), FileError);
}

TEST(Recomputed, AResultTooFewOrTooManyIsNamed) {
  Place place;
  made = 1;
  Numbers numbers("s", "full");
  numbers.add({.key = "cheap", .value = 1.0}, this_maker(sources));
  numbers.add({.key = "older", .value = 1.0}, this_maker(sources));
  numbers.write(place.path / "s.json");
  EXPECT_EQ(check_study(two_numbers, place.path, 1, 10).wrong,
            (std::vector<std::string>{"time: is not kept", "older: is kept, and no result of the study"}));
}

}  // namespace
}  // namespace furrow::validation
