// Decks that LAMMPS runs, and what the comparison says of them.
#include "export.h"

namespace {

using furrow::test::Export;

class Lammps : public Export {
 protected:
  void SetUp() override {
    if (!has_lammps()) GTEST_SKIP() << "lmp is not installed";
  }

  // Exported, run at two steps, compared; the exit code of the comparison.
  int exported_and_compared(const std::string& scene, const std::string& options = "", double early = 1) {
    put("scene.toml", scene);
    const int exported = furrow("export scene.toml --to lammps --out deck " + options).code;
    EXPECT_EQ(exported, 0) << err();
    for (const char* refine : {"1", "10"})
      EXPECT_EQ(lammps("deck", std::string("-var refine ") + refine), 0) << text("deck/engine.log");
    return furrow("export --compare deck --early " + std::to_string(early)).code;
  }
};

struct Law {
  const char *name, *model, *contact, *normal = "[0.0, 1.0]";
};

// The contact begins to count when a step has gone into it: order 1, whatever the method, or more where it begins softly.
TEST_F(Lammps, HasTheseLawsToTheOrderOfTheStep) {
  const Law laws[] = {
      {"elastic, slides", "slip_damping = false", "friction = 0.1"},
      {"damped, never pulls", "slip_damping = false", "restitution = 0.5"},
      {"damped, pulls", "slip_damping = false, pull = true", "restitution = 0.5"},
      {"damped tangent, the engine's rule after slip", "after_slip = \"less_viscous\"",
       "restitution = 0.5, friction = 0.4"},
      {"beyond critical damping", "after_slip = \"less_viscous\"", "damping_factor = 20.0, friction = 0.4"},
      {"Tsuji's alpha", "slip_damping = false", "tsuji_alpha = 0.7, friction = 0.1"},
      {"dashpots", "after_slip = \"less_viscous\"", "damping = 20.0, tangential_damping = 7.0, friction = 0.4"},
      {"rescaled", "slip_damping = false, law = \"rescaled_mindlin\"", "friction = 0.3"},
      {"linear", "after_slip = \"less_viscous\", law = \"linear\"",
       "restitution = 0.5, friction = 0.4, normal_stiffness = 1e5, tangential_stiffness = 3e4"},
      {"leaning wall", "slip_damping = false", "restitution = 0.5, friction = 0.3", "[0.6, 0.8]"},
  };
  for (const Law& law : laws) {
    EXPECT_EQ(exported_and_compared(impact(law.model, law.contact, law.normal)), 0) << law.name << ": " << out();
    const auto early = compared("deck")["early"]["parts"];
    ASSERT_EQ(early.size(), 1U) << law.name;
    EXPECT_GT(early[0]["greatest"], 1.0) << law.name << ": it hit the wall";
    EXPECT_GT(early[0]["order"].get<double>(), 0.9) << law.name;
    EXPECT_LT(early[0]["steps"][1]["error"], 2e-3) << law.name;
  }
}

TEST_F(Lammps, AnotherStiffnessIsNoticed) {
  put("scene.toml", impact("slip_damping = false", "restitution = 0.5"));
  ASSERT_EQ(furrow("export scene.toml --to lammps --out deck").code, 0) << err();
  const std::string written = text("deck/in.lammps");
  const std::string other = std::regex_replace(written, std::regex("'hertz 14652014"), "'hertz 14800000");
  ASSERT_NE(other, written);
  put("deck/in.lammps", other);
  for (const char* refine : {"1", "10"}) ASSERT_EQ(lammps("deck", std::string("-var refine ") + refine), 0);
  EXPECT_EQ(furrow("export --compare deck --early 1").code, 4) << out();
  EXPECT_NE(err().find("deck/in.lammps: is not as furrow export wrote it"), std::string::npos) << err();
  put("deck/in.lammps", written);
  EXPECT_EQ(furrow("export --compare deck --early 1").code, 1) << out();
}

// Its error is one whatever the step, so that the finer run alone would make an order of it.
TEST_F(Lammps, ACoarseRunWithoutForcesIsNoAgreement) {
  ASSERT_EQ(exported_and_compared(impact("slip_damping = false", "restitution = 0.5")), 0) << out();
  const std::string forces = text("deck/force.1.txt");
  put("deck/force.1.txt",
      std::regex_replace(forces, std::regex(R"((\n[-+.e0-9]+)( [-+.e0-9]+ [-+.e0-9]+)+)"), "$1 0 0"));
  EXPECT_NE(text("deck/force.1.txt"), forces);
  EXPECT_EQ(furrow("export --compare deck --early 1").code, 1) << out() << err();
}

// After the first tears an undamped lattice is chaotic.
TEST_F(Lammps, TearsItsFirstLinksInTheSameSteps) {
  EXPECT_EQ(exported_and_compared(lattice(), "--until 0.12", 0.12), 0) << out();
  const auto links = compared("deck")["links"];
  EXPECT_GE(links["early"], 3);
  EXPECT_LE(links["steps_apart"], 3.0);
  EXPECT_EQ(links["furrow"], links["both"]) << out();
}

TEST_F(Lammps, KeepsAnUntornLatticeToRoundOff) {
  put("scene.toml", lattice());
  ASSERT_EQ(furrow("export scene.toml --to lammps --out deck --until 0.05").code, 0) << err();
  ASSERT_EQ(lammps("deck"), 0) << text("deck/engine.log");
  ASSERT_EQ(furrow("export --compare deck").code, 0) << out();
  EXPECT_EQ(compared("deck")["links"]["engine"], 0);
  // Verlet's step is the same there: a few hundred of them, of positions of 0.05 m.
  EXPECT_LT(compared("deck")["end"]["greatest_distance"], 1e-13);
  EXPECT_EQ(compared("deck")["end"]["good"], true) << out();
}

// Of a lattice whose links are all torn from the start there is no bond; its nodes fall.
TEST_F(Lammps, TakesALatticeWithoutALinkThatHolds) {
  put("scene.toml", lattice("[[lattice.link]]\ntorn = true\n"));
  ASSERT_EQ(furrow("export scene.toml --to lammps --out deck --until 0.05").code, 0) << err();
  ASSERT_EQ(lammps("deck"), 0) << text("deck/engine.log");
  EXPECT_EQ(furrow("export --compare deck").code, 0) << out() << err();
  EXPECT_EQ(compared("deck")["end"]["good"], true) << "all fall as fast";
}

// What a stiffer bond, or a node that has left its place, would make of it is no agreement.
TEST_F(Lammps, AnUntornLatticeThatGoesElsewhereIsNoAgreement) {
  put("scene.toml", lattice());
  ASSERT_EQ(furrow("export scene.toml --to lammps --out deck --until 0.05").code, 0) << err();
  const std::string deck = text("deck/in.lammps");
  put("deck/in.lammps", std::regex_replace(deck, std::regex("(bond_coeff 1) [0-9.e+]+"), "$1 777"));
  ASSERT_NE(text("deck/in.lammps"), deck);
  ASSERT_EQ(lammps("deck"), 0) << text("deck/engine.log");
  put("deck/in.lammps", deck);
  EXPECT_EQ(furrow("export --compare deck").code, 1) << out() << err();
}

// Discs on a floor, struck by a plate, without friction: the force on both, on two processes too.
TEST_F(Lammps, DrawsAPlateThroughASettledBedOnTwoProcesses) {
  if (std::system("command -v mpirun >/dev/null 2>&1") != 0) GTEST_SKIP() << "mpirun is not installed";
  put("scene.toml", furrow::test::text_of(FURROW_SOURCE_DIR "/benchmarks/rivals/scene.toml"));
  const std::string options =
      "--set contact.friction=0 --set packing[0].count=60 --set wall[2].point=[0.2,0.0] --set plate[0].left_edge=0.03 "
      "--set "
      "packing[0].upper_right=[0.2,0.4] --until 0.05 --set output.interval=1e-3";
  ASSERT_EQ(furrow("export scene.toml --to lammps --out deck " + options).code, 0) << err();
  const std::string two = "mpirun --allow-run-as-root --oversubscribe -np 2";
  for (const char* refine : {"1", "10"})
    ASSERT_EQ(lammps("deck", std::string("-var refine ") + refine, two), 0) << text("deck/engine.log");
  EXPECT_EQ(furrow("export --compare deck").code, 0) << out();
  const auto plate = compared("deck")["early"]["parts"][0];
  EXPECT_EQ(plate["part"], "plate tool");
  EXPECT_NEAR(plate["order"].get<double>(), 1, 0.2);
  EXPECT_LT(plate["steps"][1]["error"], 1e-3) << "at 1e-5 s";
}

TEST_F(Lammps, WhatIsAllowedIsNoVerdict) {
  put("scene.toml", lattice(plate()));
  ASSERT_EQ(furrow("export scene.toml --to lammps --out deck --until 0.12 --allow lattice.contact_radius").code, 0)
      << err();
  ASSERT_EQ(lammps("deck"), 0) << text("deck/engine.log");
  EXPECT_EQ(furrow("export --compare deck --early 0.12").code, 0) << out();
  EXPECT_NE(out().find("none of this is a verdict"), std::string::npos) << out();
}

}  // namespace
