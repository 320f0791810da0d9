// `furrow export`: what it refuses and why, the table of keys, and what stands in the deck.
#include "export.h"

namespace {

using furrow::test::Export;
using furrow::test::text_of;

// Keys by the table in keys.md, with how each went in.
std::map<std::string, std::string> keys_of(const std::string& page) {
  std::map<std::string, std::string> keys;
  const std::regex row("\\n\\| `([a-z_.]+)` \\| ([a-z ]+) \\|");
  for (auto at = std::sregex_iterator(page.begin(), page.end(), row); at != std::sregex_iterator(); ++at)
    keys[(*at)[1]] = (*at)[2];
  return keys;
}

TEST_F(Export, TheTableHasEveryKeyOfScenesAndNoOther) {
  put("scene.toml", discs());
  ASSERT_EQ(furrow("export scene.toml --to lammps --out deck").code, 0) << err();
  std::set<std::string> listed, known;
  for (const auto& [key, how] : keys_of(text("deck/keys.md"))) listed.insert(key);
  for (const auto& key : nlohmann::json::parse(furrow("keys --json").out))
    if (key["type"] != "table") known.insert(key["key"]);
  EXPECT_EQ(listed, known);
  EXPECT_GT(known.size(), 100U);
}

struct Refusal {
  std::string key, scene, options;
  bool possible = true;  // with --allow
};

class Refusals : public Export {
 protected:
  static std::vector<Refusal> all() {
    const std::string no_damper = " --set lattice[0].structural.damping=0.0";
    return {
        {"model.moment_arm", discs(), "--set contact.friction=0.3"},
        {"model.after_slip", impact("slip_damping = true", "restitution = 0.5, friction = 0.3"), ""},
        {"model.law", impact("slip_damping = false, law = \"rescaled_mindlin\"", "restitution = 0.8, friction = 0.3"),
         ""},
        {"model.rolling", impact("slip_damping = false", "rolling_friction = 0.3"), ""},
        {"contact.tangential_damping",
         impact("slip_damping = true", "damping = 0.0, tangential_damping = 3.0, friction = 0.3"),
         "--allow model.after_slip", false},
        {"settle", settled(), "--allow model.moment_arm --allow model.after_slip"},
        {"allow.behind_walls", discs(), "--set allow.behind_walls=true"},
        {"allow.through_plates", discs(), "--set allow.through_plates=true"},
        {"model.tight_plates", discs(), "--set model.tight_plates=true"},
        {"lattice.auxiliary_points", lattice("[[disc]]\nposition = [0.5, 0.5]\nradius = 0.01\nmaterial = \"m\"\n"), "",
         false},
        {"lattice.contact_radius", lattice(plate()), ""},
        {"lattice.structural.damping", lattice(), "--set lattice[0].structural.damping=2.0"},
        {"lattice.shear.damping", lattice(), "--set lattice[0].shear.damping=2.0"},
        {"lattice.bending.damping", lattice(), "--set lattice[0].bending.damping=2.0"},
        {"lattice.link.damping", lattice("[[lattice.link]]\nrows = [3]\ndamping = 2.0\n"), ""},
        {"lattice.tear", lattice(), "--set 'lattice[0].tear=\"magnitude\"'"},
        {"lattice.stem.damping_ratio",
         "title = \"Stem\"\nmodel = { gravity = 0.0 }\ntime = { end = 1e-3, step = 1e-6 }\n"
         "material = [{ name = \"m\", young = 1e7, poisson = 0.3 }]\n[[lattice]]\norigin = [0.0, 0.0]\ncolumns = 3\n"
         "material = \"m\"\nfixed_rows = [0]\nstem = { young = 5e8, poisson = 0.3, diameter = 0.006, length = 0.06, "
         "damping_ratio = 0.02 }\n",
         ""},
    };
  }
};

TEST_F(Refusals, NameTheKeyTheReasonAndTheFlag) {
  for (const Refusal& r : all()) {
    put("scene.toml", r.scene);
    EXPECT_EQ(furrow("export scene.toml --to lammps --out deck " + r.options).code, 2) << r.key;
    const std::string flag = r.possible ? "--allow " + r.key + " exports it so" : "no flag allows it";
    EXPECT_NE(err().find("\n  " + r.key + ": "), std::string::npos) << r.key << ": " << err();
    EXPECT_NE(err().find(flag), std::string::npos) << r.key << ": " << err();
    EXPECT_FALSE(has("deck/in.lammps")) << r.key;
  }
}

TEST_F(Refusals, AreAllowedByTheFlagAndStandInTheTable) {
  for (const Refusal& r : all()) {
    put("scene.toml", r.scene);
    const auto done = furrow("export scene.toml --to lammps --out deck " + r.options + " --allow " + r.key);
    EXPECT_EQ(done.code, r.possible ? 0 : 2) << r.key << ": " << err();
    if (!r.possible) continue;
    const auto keys = keys_of(text("deck/keys.md"));
    EXPECT_EQ(keys.at(r.key), "another law") << r.key;
    EXPECT_NE(done.out.find("another law: " + r.key + ": "), std::string::npos) << "and it is said: " << done.out;
  }
}

// All that the source can refuse is refused here.
TEST_F(Refusals, AreAllTested) {
  const std::string source = text_of(FURROW_SOURCE_DIR "/src/export/deviations.cpp");
  const std::regex refused("(?:add|judge)\\(\"([a-z_.]+)\"");
  std::set<std::string> in_source, tested;
  for (auto at = std::sregex_iterator(source.begin(), source.end(), refused); at != std::sregex_iterator(); ++at)
    in_source.insert((*at)[1]);
  for (const Refusal& r : all()) tested.insert(r.key);
  EXPECT_EQ(tested, in_source);
}

TEST_F(Export, WhereNothingIsLikeThatEveryKeyIsExactOrToTheStep) {
  put("scene.toml", discs());
  ASSERT_EQ(furrow("export scene.toml --to lammps --out deck").code, 0) << err();
  for (const auto& [key, how] : keys_of(text("deck/keys.md")))
    EXPECT_TRUE(how == "exact" || how == "exact to the order of the step" || how == "of furrow alone") << key << how;
}

TEST_F(Export, AKeyThatDoesNotExistCannotBeAllowed) {
  put("scene.toml", discs());
  EXPECT_EQ(furrow("export scene.toml --to lammps --out deck --allow model.moment_arms").code, 2);
  EXPECT_NE(err().find("did you mean \"model.moment_arm\"?"), std::string::npos) << err();
}

TEST_F(Export, AKeyThatDoesNotDeviateIsAllowedForNothingAndSaidSo) {
  put("scene.toml", discs());
  ASSERT_EQ(furrow("export scene.toml --to lammps --out deck --allow model.moment_arm").code, 0) << err();
  EXPECT_NE(err().find("note: --allow model.moment_arm: the scene does not deviate there"), std::string::npos) << err();
  ASSERT_EQ(furrow("export scene.toml --to lammps --out deck --allow model.moment_arm --set contact.friction=0.3").code,
            0);
  EXPECT_EQ(err().find("note: --allow"), std::string::npos) << err();
}

// An overlap of 0 at t = 0 says nothing of the one that they will have.
TEST_F(Export, HowFarTheArmIsOffIsNotKnownBeforeDiscsTouch) {
  put("scene.toml", discs());
  EXPECT_EQ(furrow("export scene.toml --to lammps --out deck --set contact.friction=0.3").code, 2);
  EXPECT_EQ(err().find(" 0 of R"), std::string::npos) << err();
  EXPECT_NE(err().find("not known before they touch"), std::string::npos) << err();
}

TEST_F(Export, WhatWasMeasuredInOtherScenesIsSaidToBe) {
  put("scene.toml", impact("slip_damping = true", "restitution = 0.5, friction = 0.3"));
  EXPECT_EQ(furrow("export scene.toml --to lammps --out deck").code, 2);
  EXPECT_NE(err().find("in this scene is not known before it runs"), std::string::npos) << err();
}

TEST_F(Export, AnEngineThatIsNotKnownIsAnError) {
  put("scene.toml", discs());
  EXPECT_EQ(furrow("export scene.toml --to yade --out deck").code, 2);
  EXPECT_NE(err().find("--to: must be lammps, not \"yade\""), std::string::npos) << err();
  EXPECT_EQ(furrow("export scene.toml --to lammps").code, 2);
  EXPECT_NE(err().find("--out DIR"), std::string::npos) << err();
}

// By material words E* of a wall is too high by 1 + nu in 29 Sep 2021; a pair that is not written is 14,500 times too
// stiff there.
TEST_F(Export, WallsAreNumbersAndEveryPairOfTypesIsWritten) {
  put("scene.toml", discs());
  ASSERT_EQ(furrow("export scene.toml --to lammps --out deck").code, 0) << err();
  const std::string deck = text("deck/in.lammps");
  EXPECT_EQ(deck.find("hertz/material"), std::string::npos);
  for (const char* pair : {"pair_coeff 1 1 ", "pair_coeff 1 2 ", "pair_coeff 2 2 "})
    EXPECT_NE(deck.find(pair), std::string::npos) << pair;
  // 4/3 E* of one material of 2e7 Pa and 0.3 against another of 2e9 Pa and 0.3.
  const double stiffness = 4.0 / 3.0 / (0.91 / 2e7 + 0.91 / 2e9);
  const std::regex mixed("variable law_1_2 string 'hertz ([0-9.e+]+) 0 ");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(deck, found, mixed)) << deck;
  EXPECT_NEAR(std::stod(found[1]), stiffness, 1e-12 * stiffness);
}

TEST_F(Export, TheDeckTellsVersionsOfLammpsApart) {
  put("scene.toml", impact("after_slip = \"less_viscous\"", "restitution = 0.5, friction = 0.3"));
  ASSERT_EQ(furrow("export scene.toml --to lammps --out deck").code, 0) << err();
  EXPECT_TRUE(std::regex_search(
      text("deck/in.lammps"),
      std::regex("if \"\\$\\{release\\} >= 20240417\" then \"variable law_wall0_1 string 'hertz [0-9.]+ 0\\.5[0-9]* "
                 ".*damping coeff_restitution limit_damping'\"")))
      << text("deck/in.lammps");
  // More than critical damping: no restitution is that, so later versions must stop and say so.
  put("scene.toml", impact("after_slip = \"less_viscous\"", "damping_factor = 20.0"));
  ASSERT_EQ(furrow("export scene.toml --to lammps --out deck").code, 0) << err();
  EXPECT_NE(text("deck/in.lammps").find("if \"${release} >= 20230328\" then \"print 'This version of LAMMPS cannot"),
            std::string::npos);
  EXPECT_EQ(text("deck/in.lammps").find("coeff_restitution"), std::string::npos);
}

TEST_F(Export, ComparingWhatHasNotRunSaysHowToRunIt) {
  put("scene.toml", discs());
  ASSERT_EQ(furrow("export scene.toml --to lammps --out deck").code, 0) << err();
  EXPECT_EQ(furrow("export --compare deck").code, 4);
  EXPECT_NE(err().find("the engine has left no end.1.txt; run it there: lmp -in in.lammps"), std::string::npos)
      << err();
}

TEST_F(Export, AnOldOutputIsNotComparedWithANewDeck) {
  put("scene.toml", discs());
  ASSERT_EQ(furrow("export scene.toml --to lammps --out deck").code, 0) << err();
  put("deck/end.1.txt", "1 0 0 0 0\n");
  put("deck/notes.txt");
  ASSERT_EQ(furrow("export scene.toml --to lammps --out deck").code, 0) << err();
  EXPECT_FALSE(has("deck/end.1.txt"));
  EXPECT_TRUE(has("deck/notes.txt")) << "what is somebody else's stays";
}

TEST_F(Export, OnlyWhatTheDeckWritesIsRemoved) {
  put("scene.toml", discs());
  ASSERT_EQ(furrow("export scene.toml --to lammps --out deck").code, 0) << err();
  const char* mine[] = {"force.measured.txt", "end.notes.txt", "links.txt",  "torn.1.old.txt", "force.01.txt",
                        "force.0.txt",        "end.-1.txt",    "end.1.txt~", "my.force.1.txt", "links.1.txt.txt"};
  const char* of_the_deck[] = {"force.1.txt", "force.10.txt", "end.10.txt", "links.1.txt", "torn.250.txt"};
  for (const char* name : mine) put(std::string("deck/") + name);
  for (const char* name : of_the_deck) put(std::string("deck/") + name);
  put("deck/force.mine.txt/notes");
  ASSERT_EQ(furrow("export scene.toml --to lammps --out deck").code, 0) << err();
  for (const char* name : mine) EXPECT_TRUE(has(std::string("deck/") + name)) << name;
  for (const char* name : of_the_deck) EXPECT_FALSE(has(std::string("deck/") + name)) << name;
  EXPECT_TRUE(has("deck/force.mine.txt/notes"));
}

TEST_F(Export, AFailureLeavesTheDeckOfBefore) {
  put("scene.toml", discs());
  ASSERT_EQ(furrow("export scene.toml --to lammps --out deck").code, 0) << err();
  put("deck/end.1.txt", "of before");
  put("deck/force.1.txt/notes");
  const auto before = bits("deck");
  put("scene.toml", impact("slip_damping = false", "restitution = 0.5"));
  EXPECT_EQ(furrow("export scene.toml --to lammps --out deck").code, 4);
  EXPECT_NE(err().find("deck/force.1.txt is in the way"), std::string::npos) << err();
  EXPECT_EQ(bits("deck"), before);
}

TEST_F(Export, AFullDiskLeavesTheDeckOfBefore) {
  put("scene.toml", discs());
  ASSERT_EQ(furrow("export scene.toml --to lammps --out deck").code, 0) << err();
  put("deck/end.1.txt", "of before");
  const auto before = bits("deck");
  put("scene.toml", impact("slip_damping = false", "restitution = 0.5"));
  EXPECT_EQ(furrow("export scene.toml --to lammps --out deck", "ulimit -f 16;").code, 4) << "8 KiB a file: " << out();
  EXPECT_NE(err().find("File too large"), std::string::npos) << err();
  EXPECT_EQ(bits("deck"), before);
}

}  // namespace
