// The commands that judge, from outside: `report` on three short scenes, `methods`, `study`.
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <tuple>

#include "methods/method.h"
#include "program.h"
#include "report/seal.h"
#include "tests/owned_file.h"

namespace {

using furrow::test::text_of;

namespace fs = std::filesystem;

class Judging : public furrow::test::Program {
 protected:
  void SetUp() override {
    fs::create_directory(directory_ / "scenes");
    for (const char* number : {"1", "2", "3"}) write_scene(number, "1e-4");
  }

  // The literal scene, with 20 discs and until 50 ms.
  void write_scene(const std::string& number, const std::string& step, const std::string& end = "0.05") const {
    std::string text = text_of(FURROW_SOURCE_DIR "/validation/scenes/literal/scenario_" + number + ".toml");
    for (const auto& [old, now] : {std::pair<std::string, std::string>{"\nend = [^\n]*", "\nend = " + end},
                                   {"\nstep = 1e-4", "\nstep = " + step},
                                   {"\ninterval = 1e-3", "\ninterval = " + (step == "1e-4" ? "1e-3" : step)},
                                   {"count = 230", "count = 20"},
                                   {"working_depth = 0.04", "working_depth = 0.005"},
                                   {"\nframes = \\[[^\\]]*\\]", "\nframes = [0.0]"}})
      text = std::regex_replace(text, std::regex(old), now);
    std::ofstream(directory_ / "scenes" / ("scenario_" + number + ".toml")) << text;
  }

  void write_checks(bool good) const {
    const nlohmann::ordered_json check{{"test", "A.B"},       {"name", "a number"},  {"requirement", "x.y"},
                                       {"want", 1},           {"got", good ? 1 : 2}, {"error", good ? 0 : 1},
                                       {"tolerance", 0.5},    {"kind", "absolute"},  {"of_limit", good ? 0 : 2},
                                       {"reason", "because"}, {"sentence", "it is"}, {"file", "here"},
                                       {"good", good}};
    nlohmann::ordered_json all{{"tests", 1}, {"missing", nlohmann::ordered_json::array()}, {"checks", {check}}};
    furrow::seal(all);
    std::ofstream(directory_ / "checks.json") << all;
  }
};

void write_as_its_own(const fs::path& file, const std::string& text) {
  std::ofstream(file) << text;
  furrow::test::make_its_own(file);
}

TEST_F(Judging, AReportIsGoodOnlyIfItsChecksAre) {
  write_checks(true);
  ASSERT_EQ(furrow("report --scenes scenes --out page --checks checks.json").code, 0) << err();
  EXPECT_EQ(out(), "page/index.html\n");
  EXPECT_TRUE(fs::exists(directory_ / "page/index.html"));
  write_checks(false);
  EXPECT_EQ(furrow("report --scenes scenes --out page --reuse --checks checks.json").code, 1) << err();
  EXPECT_EQ(out(), "page/index.html\n");
}

TEST_F(Judging, AReportReusesWhatFinishedAndNothingElse) {
  ASSERT_EQ(furrow("report --scenes scenes --out page").code, 0) << err();
  const auto run = [&](int number) {
    return directory_ / "page" / ("scenario_" + std::to_string(number)) / "run.json";
  };
  const auto written = [&](int number) { return fs::last_write_time(run(number)); };
  const auto first = written(1), second = written(2), third = written(3);
  auto json = nlohmann::json::parse(text_of(run(2)));
  json["ended"] = "interrupted";
  write_as_its_own(run(2), json.dump(2));
  fs::last_write_time(run(2), second);
  ASSERT_EQ(furrow("report --scenes scenes --out page --reuse").code, 0) << err();
  EXPECT_EQ(written(1), first);
  EXPECT_EQ(written(3), third);
  EXPECT_NE(written(2), second);
  EXPECT_EQ(nlohmann::json::parse(text_of(run(2)))["ended"], "finished");
  ASSERT_EQ(furrow("report --scenes scenes --out page").code, 0) << err();
  EXPECT_NE(written(1), first);
}

TEST_F(Judging, AReportReusesNoRunOfAnotherSceneOrProgram) {
  ASSERT_EQ(furrow("report --scenes scenes --out page").code, 0) << err();
  const fs::path file = directory_ / "page/scenario_2/run.json";
  const std::string sound = text_of(file);
  for (const char* key : {"scene_hash", "method", "step", "sources", "compiler", "flags"}) {
    auto json = nlohmann::json::parse(sound);
    json[key] = "another";
    write_as_its_own(file, json.dump(2));
    ASSERT_EQ(furrow("report --scenes scenes --out page --reuse").code, 0) << err();
    EXPECT_NE(err().find("page/scenario_2: run again: " + std::string(key) + " is \"another\""), std::string::npos)
        << err();
    EXPECT_EQ(nlohmann::json::parse(text_of(file))[key], nlohmann::json::parse(sound)[key]);
  }
}

// As a copy that was broken off leaves them: after a whole line, within one, without a picture. Who did that is not known, so
// the file stays until it is moved away.
TEST_F(Judging, AReportReusesNoRunWhoseFilesAreNotWhole) {
  ASSERT_EQ(furrow("report --scenes scenes --out page").code, 0) << err();
  const auto half = [](const std::string& text) { return text.substr(0, text.find('\n', text.size() / 2) + 1); };
  const auto in_a_line = [](const std::string& text) { return text.substr(0, text.size() - 2); };
  const auto without_last = [](const std::string& text) {
    return text.substr(0, text.rfind('\n', text.size() - 2) + 1);
  };
  const auto longer = [](const std::string& text) {
    return std::regex_replace(text, std::regex("end = 0.05"), "end = 0.06");
  };
  const auto another_number = [](std::string text) {
    const std::size_t digit = text.rfind("0.");
    return digit == std::string::npos ? text + "1" : text.replace(digit, 1, "9");
  };
  using Spoil = std::function<std::string(const std::string&)>;
  for (const auto& [file, spoil, why] :
       {std::tuple<std::string, Spoil, const char*>{"plate_force.csv", half, "plate_force.csv is not"},
        {"energy.csv", half, "energy.csv is not"},
        {"energy.csv", in_a_line, "energy.csv is not"},
        {"events.csv", another_number, "events.csv is not"},
        {"frames/frames.csv", without_last, "frames.csv is not"},
        {"scene.toml", longer, "scene.toml is not"},
        {"run.json", another_number, "run.json is not"}}) {
    const fs::path place = directory_ / "page/scenario_2" / file;
    const std::string sound = text_of(place);
    std::ofstream(place) << spoil(sound);
    ASSERT_NE(text_of(place), sound) << file;
    const std::string spoilt = text_of(place);
    EXPECT_EQ(furrow("report --scenes scenes --out page --reuse").code, 4) << err();
    EXPECT_NE(err().find("page/scenario_2: run again: "), std::string::npos) << err();
    EXPECT_NE(err().find(why), std::string::npos) << err();
    EXPECT_NE(err().find("page/scenario_2/" + file + " is in the way"), std::string::npos) << err();
    EXPECT_EQ(text_of(place), spoilt) << file;
    fs::remove(place);
    EXPECT_EQ(furrow("report --scenes scenes --out page --reuse").code, 0) << err();
    EXPECT_TRUE(file == "run.json" || text_of(place) == sound) << file << " is not there again";
  }
}

TEST_F(Judging, AReportNamesWhatIsMissingAndEndsWithOne) {
  fs::create_directory(directory_ / "studies");
  EXPECT_EQ(furrow("report --scenes scenes --out page --studies studies --faults faults.json").code, 1);
  const std::string page = text_of(directory_ / "page/index.html");
  for (const char* file : {"faults.json", "studies/order.json", "studies/ensemble.json"}) {
    EXPECT_NE(err().find("missing on the page: cannot read " + std::string(file)), std::string::npos) << err();
    EXPECT_NE(page.find("cannot read " + std::string(file)), std::string::npos) << file;
  }
}

// Of the players' scenes none is there but the three; the runs of these are made.
TEST_F(Judging, AReportNamesTheScenesThatItsPlayersLack) {
  EXPECT_EQ(furrow("report --scenes scenes --out page --players").code, 1) << err();
  const std::string page = text_of(directory_ / "page/index.html");
  for (const char* name :
       {"best_reading/scenario_1", "best_reading/scenario_2", "best_reading/scenario_3", "deformable_tool"}) {
    const std::string lacks = "cannot read scenes/" + std::string(name) + ".toml, whose run the players show";
    EXPECT_NE(err().find("furrow: missing on the page: " + lacks), std::string::npos) << err();
    EXPECT_NE(page.find(lacks), std::string::npos) << name;
  }
  EXPECT_TRUE(has("page/scenario_1_finer/run.json"));
}

TEST_F(Judging, AReportSaysWhatItWasNotGivenAndWhatMakesIt) {
  write_checks(true);
  EXPECT_EQ(furrow("report --scenes scenes --out page --checks checks.json").code, 0) << err();
  const std::string page = text_of(directory_ / "page/index.html");
  EXPECT_NE(page.find("not given by --mutants; made by: scripts/mutants"), std::string::npos);
  EXPECT_NE(page.find("<a href=\"#missing\">4 parts are missing</a>"), std::string::npos);
  EXPECT_EQ(page.find("not given by --checks"), std::string::npos);
}

TEST_F(Judging, AReportOfARunThatDivergedExitsThreeAndSaysWhich) {
  write_scene("1", "0.4", "1.2");
  write_checks(false);
  EXPECT_EQ(furrow("report --scenes scenes --out page --checks checks.json").code, 3) << err();
  EXPECT_NE(err().find("scenario_1 diverged"), std::string::npos) << err();
  EXPECT_TRUE(fs::exists(directory_ / "page/index.html"));
}

TEST_F(Judging, AReportWithoutAScenesFileBeginsNothing) {
  fs::remove(directory_ / "scenes/scenario_1.toml");
  EXPECT_EQ(furrow("report --scenes scenes --out page").code, 4) << err();
  EXPECT_FALSE(fs::exists(directory_ / "page"));
}

// Name, order, evaluations and kind of step of each are those of the catalogue, one a line, own ones first.
TEST_F(Judging, MethodsAreATableOfTheCatalogue) {
  ASSERT_EQ(furrow("methods").code, 0);
  std::istringstream lines(out());
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line.substr(0, 4), "name");
  const std::size_t order_end = line.find("order") + 5;
  bool own = true;
  for (const furrow::MethodInfo& m : furrow::method_catalogue()) {
    if (own && m.family != "own") {
      std::getline(lines, line);
      EXPECT_EQ(line, "");
      std::getline(lines, line);
      EXPECT_EQ(line, "Boost.Odeint");
      own = false;
    }
    std::getline(lines, line);
    std::istringstream words(line);
    std::string name, order, evaluations, step;
    words >> name >> order >> evaluations;
    if (m.dense_jacobian) {
      std::string plus, n;
      words >> plus >> n;
      EXPECT_EQ(plus + n, "+n");
    }
    words >> step;
    EXPECT_EQ(name, m.name);
    EXPECT_EQ(order, std::to_string(m.order));
    EXPECT_EQ(line[order_end - 1], order.back()) << "stands under its heading";
    EXPECT_EQ(evaluations, m.evaluations > 0 ? std::to_string(m.evaluations) : "varies") << m.name;
    EXPECT_EQ(step, m.controlled ? "controlled" : "fixed") << m.name;
    EXPECT_NE(line.find(m.title), std::string::npos) << m.name;
    EXPECT_EQ(line.find("no forces that depend on velocity") != std::string::npos, m.conservative) << m.name;
    EXPECT_EQ(line.find("at most 200") != std::string::npos, m.dense_jacobian) << m.name;
  }
  EXPECT_FALSE(std::getline(lines, line)) << line;
}

TEST_F(Judging, StudiesAreListedAndAnUnknownOneIsRefused) {
  ASSERT_EQ(furrow("study").code, 0);
  for (const char* name : {"order", "published", "stability", "work_precision", "need", "speed", "geometry",
                           "convergence", "ensemble", "statements", "outlook"})
    EXPECT_NE(("\n" + out()).find(std::string("\n") + name + " "), std::string::npos) << name;
  EXPECT_EQ(furrow("study ordre").code, 2);
  EXPECT_NE(err().find("no study is named \"ordre\"; did you mean \"order\"?"), std::string::npos) << err();
}

// Its runs are kept until it ends; of the scene file's own setting, the first of them, all numbers are made the paper's.
TEST_F(Judging, AStudyWhoseClaimDoesNotHoldExitsOneAndSaysWhich) {
  const fs::path kept = directory_ / "geometry.runs.jsonl";
  furrow::test::Process study(directory_, started("study geometry --quick --jobs 1 --out ."));
  ASSERT_TRUE(furrow::test::comes_true([&] { return furrow::test::lines_of(kept) >= 2 || study.has_ended(); }));
  study.send(SIGINT);
  ASSERT_EQ(study.code(), 130) << err();
  std::istringstream lines(text_of(kept));
  std::string first;
  std::getline(lines, first);
  auto run = nlohmann::ordered_json::parse(first);
  run.at("results").at(0).at("value").at(0) = {238, 40, 47, 50, 150, 54, 116};
  furrow::seal(run);
  std::ofstream(kept) << run.dump() << "\n";
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(furrow("study geometry --quick --out .").code, 1) << "those that are kept are taken, " << err();
    EXPECT_NE(err().find("furrow: does not hold: No setting tried meets all of the paper's numbers"), std::string::npos)
        << err();
    EXPECT_EQ(out(), "./geometry.json\n");
  }
  fs::remove(directory_ / "geometry.json");
  EXPECT_EQ(furrow("study geometry --quick --out .").code, 0) << err();
}

}  // namespace
