// `furrow export --compare`: what it refuses, what it judges. The engine's files are those of furrow's own run, spoilt.
#include "comparing.h"

namespace {

using furrow::test::cells_of;
using furrow::test::Comparing;
using furrow::test::Rows;
using furrow::test::with_line;
using furrow::test::without_line;

TEST_F(Comparing, SaysWhatWasCompared) {
  good_discs();
  EXPECT_NE(out().find("plate 0: no force in either"), std::string::npos) << out();
  EXPECT_NE(out().find("10 rows"), std::string::npos) << out();
  EXPECT_EQ(compared("deck")["end"]["bodies"], 2);
}

TEST_F(Comparing, RefusesForcesThatAreNotWhole) {
  good_discs();
  const std::string force = text("deck/force.1.txt");
  const std::string again = "run the engine again: lmp -in in.lammps";
  expect_refused("force.1.txt", "", "ends after 0 of 11 rows; " + again);
  expect_refused("force.1.txt", "hello\n", "is of another deck");
  expect_refused("force.1.txt", without_line(force, 1, 1), "is of another deck");
  expect_refused("force.1.txt", without_line(force, 6, 100), "ends after 3 of 11 rows");
  expect_refused("force.1.txt", without_line(force, 7, 1), "line 7 is of step 500, not 400");
  expect_refused("force.1.txt", with_line(force, 7, "400 0 0 nan nan"), "line 7 has a number that is not finite");
  expect_refused("force.1.txt", with_line(force, 7, "400 0 0 1 1e999"), "line 7 is not a row of numbers");
  expect_refused("force.1.txt", with_line(force, 7, "400 0 0 1 2x"), "line 7 is not a row of numbers");
  expect_refused("force.1.txt", with_line(force, 7, "400 0 0 1"), "line 7 has 4 numbers, not 5");
  expect_refused("force.1.txt", with_line(force, 7, ""), "line 7 has 0 numbers, not 5");
  expect_refused("force.1.txt", force + "1100 0 0 0 0\n", "line 14 is more than the run has");
  furrow::test::fs::remove(directory_ / "deck/force.1.txt");
  EXPECT_EQ(furrow("export --compare deck").code, 4) << out();
  EXPECT_NE(err().find("deck/force.1.txt: is missing"), std::string::npos) << err();
}

// A run at another step that did not come to its end.
TEST_F(Comparing, RefusesAStepThatHasNoEnd) {
  good_discs();
  put("deck/force.10.txt", text("deck/force.1.txt"));
  EXPECT_EQ(furrow("export --compare deck").code, 4) << out();
  EXPECT_NE(err().find("deck/end.10.txt: is missing; run the engine again: lmp -in in.lammps -var refine 10"),
            std::string::npos)
      << err();
}

TEST_F(Comparing, RefusesAnEndThatHasNotEveryBodyOnce) {
  good_discs();
  const std::string end = text("deck/end.1.txt");
  expect_refused("end.1.txt", "", "ends too early");
  expect_refused("end.1.txt", without_line(end, 11, 1), "ends too early, after line 10");
  for (const std::string id : {"0", "-1", "3", "9999", "99999999", "1e300", "1.5"})
    expect_refused("end.1.txt", with_line(end, 10, id + " 0 0 0 0"), "line 10 has body");
  expect_refused("end.1.txt", with_line(end, 11, "1 0 0 0 0"), "line 11 has body 1 again");
  expect_refused("end.1.txt", with_line(end, 11, "2 nan 0 0 0"), "line 11 has a number that is not finite");
  expect_refused("end.1.txt", with_line(end, 2, "999"), "has 999 as step, not 1000");
  expect_refused("end.1.txt", with_line(end, 4, "3"), "has 3 bodies, not 2");
  expect_refused("end.1.txt", end + "3 0 0 0 0\n", "is more than the run has");
  expect_refused("end.1.txt", end.substr(0, end.size() - 1), "does not end: the file was cut");
}

TEST_F(Comparing, RefusesADeckThatIsNotAsItWasWritten) {
  good_discs();
  for (const char* file : {"in.lammps", "data.lammps", "scene.toml", "keys.md"})
    expect_refused(file, text(std::string("deck/") + file) + "# more\n", "is not as furrow export wrote it");
  expect_refused("scene.toml", impact("slip_damping = false", "restitution = 0.5"), "is not as furrow export wrote it");
  furrow::test::fs::remove(directory_ / "deck/keys.md");
  EXPECT_EQ(furrow("export --compare deck").code, 4) << out();
  EXPECT_NE(err().find("deck/keys.md: cannot be read"), std::string::npos) << err();
}

TEST_F(Comparing, NamesTheFieldOfExportJsonThatIsWrong) {
  good_discs();
  for (const std::string text : {"", "null", "[]", "5", "{"})
    expect_refused("export.json", text, "is not what furrow export writes");
  expect_refused("export.json", "{}", "\"to\" is missing");
  const auto good = nlohmann::ordered_json::parse(text("deck/export.json"));
  for (const auto& [name, value] : good.items()) {
    auto spoilt = good;
    spoilt.erase(name);
    expect_refused("export.json", spoilt.dump(), "\"" + name + "\" is missing");
    spoilt = good;
    spoilt[name] = 5;
    expect_refused("export.json", spoilt.dump(), "\"" + name + "\" is not a ");
  }
  auto spoilt = good;
  spoilt["deviations"] = {5};
  expect_refused("export.json", spoilt.dump(), "\"deviations[0].key\" is missing");
  spoilt["deviations"] = {{{"key", "settle"}, {"how", "another law"}, {"text", "a verdict less"}}};
  expect_refused("export.json", spoilt.dump(), "is not as furrow export wrote it");
}

TEST_F(Comparing, TheEarlyTimeHoldsARow) {
  good_discs();
  for (const char* early : {"0", "1e-9", "9e-4"}) {
    EXPECT_EQ(furrow(std::string("export --compare deck --early ") + early).code, 2) << early << out();
    EXPECT_NE(err().find("--early"), std::string::npos) << err();
  }
  EXPECT_EQ(furrow("export --compare deck --early 1e-3").code, 0) << out() << err();
}

TEST_F(Comparing, ForcesOfOneOfTheTwoOnlyAreAnError) {
  good_discs();
  const std::string force = text("deck/force.1.txt");
  put("deck/force.1.txt", with_line(force, 7, "400 1 0 0 0"));
  EXPECT_EQ(furrow("export --compare deck").code, 1) << out();
  EXPECT_NE(out().find("plate 0: no force in furrow, to 1 N in the engine"), std::string::npos) << out();
  std::string none = title() + "# step\n";
  for (int k = 0; k <= 10; ++k) none += std::to_string(100 * k) + " 0 0 0 0\n";
  put("deck/force.1.txt", none);
  EXPECT_EQ(furrow("export --compare deck").code, 1) << out();
}

struct Torn {
  int step;
  std::pair<int, int> link;  // two bodies, from 1
};

// lattice(): three columns, a row each 10 steps, 600 steps.
class ComparingLinks : public Comparing {
 protected:
  void SetUp() override {
    export_and_run(lattice(), "--until 0.12");
    for (const auto& row : cells_of(text("own/events.csv"))) {
      const auto node = [&](std::size_t c) { return 3 * std::stoi(row[c]) + std::stoi(row[c + 1]) + 1; };
      torn_.push_back({static_cast<int>(std::stod(row[0]) / 2e-4 + 0.5), std::minmax({node(4), node(6)})});
    }
    ASSERT_GE(torn_.size(), 3U);
    std::istringstream words(text("deck/data.lammps").substr(text("deck/data.lammps").find("Bonds") + 5));
    for (int number, type, a, b; words >> number >> type >> a >> b;) bonds_.insert(std::minmax({a, b}));
    put_end(600);
  }

  std::string links(const std::vector<Torn>& torn) const {
    std::string all;
    for (int step = 0; step <= 600; step += 10) {
      std::set<std::pair<int, int>> whole = bonds_;
      for (const Torn& one : torn)
        if (one.step <= step) whole.erase(one.link);
      all += dump_of(step, "ENTRIES", whole.size()) + "ITEM: ENTRIES index c_links[1] c_links[2]\n";
      int number = 0;
      for (const auto& [a, b] : whole)
        all += std::to_string(++number) + " " + std::to_string(a) + " " + std::to_string(b) + "\n";
    }
    return all;
  }

  int compared_with(const std::vector<Torn>& torn) const {
    std::string counts = title();
    for (int step = 0; step <= 600; ++step)
      counts += std::to_string(step) + " " +
                std::to_string(std::count_if(torn.begin(), torn.end(), [&](const Torn& t) { return t.step <= step; })) +
                "\n";
    put("deck/torn.1.txt", counts);
    put("deck/links.1.txt", links(torn));
    return furrow("export --compare deck --early 0.12").code;
  }

  std::pair<int, int> whole_link() const {
    for (const auto& bond : bonds_)
      if (std::none_of(torn_.begin(), torn_.end(), [&](const Torn& t) { return t.link == bond; })) return bond;
    return {};
  }

  std::vector<Torn> torn_;
  std::set<std::pair<int, int>> bonds_;
};

TEST_F(ComparingLinks, ThatTearAlikePass) {
  EXPECT_EQ(compared_with(torn_), 0) << out() << err();
  EXPECT_EQ(compared("deck")["links"]["both"], torn_.size());
}

TEST_F(ComparingLinks, ThatTearInOneOnlyFail) {
  std::vector<Torn> more = torn_;
  more.insert(more.begin(), {50, whole_link()});
  EXPECT_EQ(compared_with(more), 1) << "the engine tears one that furrow keeps: " << out();
  EXPECT_EQ(compared_with({}), 1) << "furrow tears what the engine keeps: " << out();
}

TEST_F(ComparingLinks, OthersInTheSameStepsFail) {
  std::vector<Torn> others = torn_;
  others[0].link = whole_link();
  EXPECT_EQ(compared_with(others), 1) << out();
  EXPECT_EQ(compared("deck")["links"]["engine"], compared("deck")["links"]["furrow"]) << "as many";
}

TEST_F(ComparingLinks, LaterThanTheEarlyTimeAreNoVerdict) {
  std::vector<Torn> more = torn_;
  more.insert(more.begin(), {500, whole_link()});
  EXPECT_EQ(compared_with(more), 1) << out();
  EXPECT_EQ(furrow("export --compare deck --early 0.08").code, 1) << "nothing is left to compare: " << out();
  EXPECT_NE(out().find("Nothing was compared"), std::string::npos) << out();
  EXPECT_TRUE(compared("deck")["links"]["good"].is_null());
}

TEST_F(ComparingLinks, MustBeWhole) {
  ASSERT_EQ(compared_with(torn_), 0) << out() << err();
  const std::string links = text("deck/links.1.txt"), counts = text("deck/torn.1.txt");
  expect_refused("links.1.txt", "", "ends too early");
  expect_refused("links.1.txt", with_line(links, 10, "1 1 18"), "line 10 has a link that the scene has not");
  expect_refused("links.1.txt", with_line(links, 10, "1 1 99"), "line 10 has body 99");
  expect_refused("links.1.txt", with_line(links, 10, "1 1 nan"), "line 10 has a number that is not finite");
  expect_refused("links.1.txt", with_line(links, 2, "10"), "line 2 has 10 as step, not 0");
  expect_refused("torn.1.txt", "", "ends after 0 of 601 rows");
  expect_refused("torn.1.txt", with_line(counts, 302, "300 nan"), "line 302 has a number that is not finite");
  expect_refused("torn.1.txt", with_line(counts, 302, "300 1000"), "has 1000 torn links at step 300");
  expect_refused("torn.1.txt", without_line(counts, 302, 1), "line 302 is of step 301, not 300");
}

}  // namespace
