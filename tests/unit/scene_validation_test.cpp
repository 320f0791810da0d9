// What is wrong with a scene as a whole is found, and reported with its place.
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>

#include "tests/unit/scene_text.h"

namespace furrow {
namespace {

// What is wrong with the sound scene after a change.
Lines problems(const std::function<void(Scene&)>& change) {
  Scene scene = sound_scene();
  change(scene);
  Lines lines;
  for (const auto& [path, message] : problems_of(scene)) lines.push_back(path + ": " + message);
  return lines;
}

TEST(SceneValidation, FindsNothingWrongWithASoundScene) {
  EXPECT_EQ(problems([](Scene&) {}), Lines{});
}

TEST(SceneValidation, WantsMaterialsNamedOnce) {
  EXPECT_EQ(problems([](Scene& s) { s.material.push_back(s.material[0]); }),
            Lines{"material[2].name: the same as material[0].name"});
  EXPECT_EQ(problems([](Scene& s) { s.material.push_back({.name = "", .rigid = true}); }),
            Lines{"material[2].name: must not be empty"});
}

TEST(SceneValidation, FindsUnknownMaterialsEverywhere) {
  EXPECT_EQ(problems([](Scene& s) {
              s.disc[0].material = s.wall[0].material = "sot";
              s.plate[0].material = s.lattice[0].material = "x";
              s.packing = {Packing{.upper_right = {1, 1}, .material = ""}};
              s.contact.pair = {{.materials = {"soft", "hrad"}}};
            }),
            (Lines{"contact.pair[0].materials[1]: no material is named \"hrad\"; did you mean \"hard\"?",
                   "disc[0].material: no material is named \"sot\"; did you mean \"soft\"?",
                   "packing[0].material: no material is named \"\"; known: soft, hard",
                   "plate[0].material: no material is named \"x\"; known: soft, hard",
                   "wall[0].material: no material is named \"sot\"; did you mean \"soft\"?",
                   "lattice[0].material: no material is named \"x\"; known: soft, hard"}));
}

TEST(SceneValidation, WantsTwoConstantsOfWhatIsElastic) {
  EXPECT_EQ(problems([](Scene& s) { s.material[0].young.reset(); }),
            Lines{"material[0]: young [Pa] is required unless rigid = true"});
  EXPECT_EQ(problems([](Scene& s) { s.material[0].poisson.reset(); }),
            Lines{"material[0]: one of poisson and shear [Pa] is required unless rigid = true"});
  EXPECT_EQ(problems([](Scene& s) { s.material[0].shear = 1e5; }),
            Lines{"material[0].shear: poisson is given too; give one of them"});
}

TEST(SceneValidation, WantsNoConstantsOfWhatIsRigid) {
  EXPECT_EQ(problems([](Scene& s) { s.material[1].young = s.material[1].poisson = s.material[1].shear = 0.1; }),
            (Lines{"material[1].young: a rigid material has no elastic constants",
                   "material[1].poisson: a rigid material has no elastic constants",
                   "material[1].shear: a rigid material has no elastic constants"}));
}

Lines shear_problems(double young, double shear) {
  return problems([&](Scene& s) { s.material[0] = {.name = "soft", .young = young, .shear = shear}; });
}

TEST(SceneValidation, TakesAShearModulusUpToIncompressible) {
  EXPECT_EQ(shear_problems(2e5, 2e5), Lines{});  // the paper's pair, nu = -0.5
  for (const double shear : {0.1, 0.2, 0.7, 1e5 / 3}) EXPECT_EQ(shear_problems(3 * shear, shear), Lines{}) << shear;
  EXPECT_EQ(shear_problems(4, 1), Lines{"material[0].shear: young / (2 shear) - 1 = 1 is outside -1 < poisson <= 0.5"});
  EXPECT_EQ(shear_problems(1e-300, 1e300).size(), 1u);
}

TEST(SceneValidation, WantsDampingGivenInOneWay) {
  EXPECT_EQ(problems([](Scene& s) {
              s.contact.damping_factor = s.contact.restitution = 0.5;
              s.contact.pair = {{.materials = {"soft", "hard"}, .damping_factor = 0.5, .restitution = 0.5}};
            }),
            (Lines{"contact.restitution: damping_factor is given too; give one of them",
                   "contact.pair[0].restitution: damping_factor is given too; give one of them"}));
  EXPECT_EQ(problems([](Scene& s) {
              s.contact.tsuji_alpha = s.contact.restitution = 0.5;
              s.contact.pair = {{.materials = {"soft", "hard"}, .damping_factor = 0.5, .tsuji_alpha = 0.5}};
            }),
            (Lines{"contact.tsuji_alpha: restitution is given too; give one of them",
                   "contact.pair[0].tsuji_alpha: damping_factor is given too; give one of them"}));
}

TEST(SceneValidation, WantsWhatTheLinearLawNeedsAndNothingOfHertzs) {
  EXPECT_EQ(problems([](Scene& s) {
              s.model.law = ForceLaw::linear;
              s.contact.friction = 0.5;
            }),
            (Lines{"contact: normal_stiffness [N/m] is required: model.law is linear",
                   "contact: tangential_stiffness [N/m] is required: model.law is linear"}));
  EXPECT_EQ(problems([](Scene& s) {
              s.model.law = ForceLaw::linear;
              s.contact.normal_stiffness = 1e4;
              s.contact.tsuji_alpha = 0.5;
            }),
            Lines{"contact.tsuji_alpha: is of Hertz's law; model.law is linear"});
  EXPECT_EQ(problems([](Scene& s) { s.contact.tangential_damping = 3; }),
            Lines{"contact.tangential_damping: needs damping [N s/m]"});
}

TEST(SceneValidation, WantsEachPairOfMaterialsOnce) {
  EXPECT_EQ(problems([](Scene& s) { s.contact.pair = {{.materials = {"soft"}}}; }),
            Lines{"contact.pair[0].materials: must be two names, not 1"});
  EXPECT_EQ(problems([](Scene& s) {
              s.contact.pair = {{.materials = {"soft", "hard"}}, {.materials = {"hard", "soft"}}};
            }),
            Lines{"contact.pair[1].materials: the same as contact.pair[0].materials"});
}

TEST(SceneValidation, RefusesRigidPartsThatCanMeet) {
  const auto meeting = [](const std::string& path, const std::string& other) {
    return Lines{path + ": rigid \"hard\" can meet rigid \"hard\" of " + other + ", where nothing would deform"};
  };
  const Packing packing{.count = 2, .upper_right = {1, 1}, .material = "hard"};
  EXPECT_EQ(problems([](Scene& s) { s.disc[0].material = "hard"; }), meeting("plate[0]", "disc[0]"));
  EXPECT_EQ(problems([](Scene& s) { s.lattice[0].material = "hard"; }), meeting("lattice[0]", "plate[0]"));
  EXPECT_EQ(problems([](Scene& s) {
              s.lattice[0].material = "hard", s.lattice[0].fixed_columns = {0, 1};
            }),
            meeting("lattice[0]", "plate[0]"));
  EXPECT_EQ(problems([&](Scene& s) { s.packing = {packing}, s.plate = {}, s.wall = {}; }),
            meeting("packing[0]", "packing[0]"));
  EXPECT_EQ(problems([](Scene& s) { s.lattice[0].material = "hard", s.plate = {}; }), meeting("lattice[0]", "wall[0]"));
}

TEST(SceneValidation, TakesRigidPartsThatCannotMeet) {
  EXPECT_EQ(problems([](Scene& s) { s.disc[0].material = "hard", s.wall = {}, s.plate = {}; }), Lines{});
  EXPECT_EQ(problems([](Scene& s) {
              s.lattice[0].material = "hard", s.lattice[0].fixed_rows = {0, 1, 2}, s.plate = {};
            }),
            Lines{});  // neither the wall nor the fixed lattice moves
}

TEST(SceneValidation, WantsWallsWithANormalAndDiscsInFrontOfThem) {
  EXPECT_EQ(problems([](Scene& s) { s.wall[0].normal = {0, 0}; }), Lines{"wall[0].normal: must not be zero"});
  EXPECT_EQ(problems([](Scene& s) { s.disc[0].position.y = -0.01; }),
            Lines{"disc[0].position: the centre is behind wall[0]"});
}

TEST(SceneValidation, RefusesTwoDiscsInOnePlaceButNotASmallOverlap) {
  EXPECT_EQ(problems([](Scene& s) { s.disc.push_back(s.disc[0]); }),
            Lines{"disc[1].position: the same as disc[0].position"});
  EXPECT_EQ(problems([](Scene& s) { s.disc.push_back(s.disc[0]), s.disc[1].position.x = 0.11; }), Lines{});
}

TEST(SceneValidation, WantsARectangleThatHoldsADisc) {
  const auto packed = [](const Packing& packing) { return problems([&](Scene& s) { s.packing = {packing}; }); };
  Packing packing{.radius_min = 0.1, .radius_max = 0.1, .upper_right = {0.2, 0.2}, .material = "soft"};
  EXPECT_EQ(packed(packing), Lines{});
  packing.radius_max = 0.11;
  EXPECT_EQ(packed(packing), Lines{"packing[0].upper_right: the rectangle is too small for a disc of radius_max"});
  packing.radius_max = 0.09;
  EXPECT_EQ(packed(packing), Lines{"packing[0].radius_min: above radius_max, 0.09 m"});
  packing.radius_min = 0.01, packing.upper_right.x = 0;
  EXPECT_EQ(packed(packing), Lines{"packing[0].upper_right: must be above lower_left and to the right of it"});
  packing.upper_right.x = 1, packing.seed = ~std::uint64_t{0};
  EXPECT_EQ(packed(packing), Lines{"packing[0].seed: above 2^63 - 1, the largest integer of TOML"});
}

TEST(SceneValidation, WantsTheHeightOfAPlateGivenInOneWay) {
  EXPECT_EQ(problems([](Scene& s) { s.plate[0].lower_edge.reset(); }),
            Lines{"plate[0]: one of lower_edge [m] and working_depth [m] is required"});
  EXPECT_EQ(problems([](Scene& s) { s.settle.emplace(), s.plate[0].working_depth = 0; }),
            Lines{"plate[0].working_depth: lower_edge is given too; give one of them"});
}

TEST(SceneValidation, MeasuresAWorkingDepthFromSettledDiscs) {
  const auto deep = [](Scene& s) { s.plate[0].lower_edge.reset(), s.plate[0].working_depth = 0.1; };
  EXPECT_EQ(problems([&](Scene& s) { deep(s), s.settle.emplace(); }), Lines{});
  EXPECT_EQ(problems([&](Scene& s) { deep(s), s.disc.clear(); }),
            (Lines{"plate[0].working_depth: needs a [[disc]] or [[packing]]; or give lower_edge",
                   "plate[0].working_depth: needs [settle]; or give lower_edge"}));
}

TEST(SceneValidation, SettlesOnlyWhatFalls) {
  EXPECT_EQ(problems([](Scene& s) { s.settle.emplace(), s.model.gravity = 0, s.disc.clear(); }),
            (Lines{"settle: needs model.gravity > 0", "settle: there is no [[disc]] or [[packing]] to settle"}));
}

TEST(SceneValidation, WantsFixedLinesInsideTheLatticeAndOnce) {
  EXPECT_EQ(problems([](Scene& s) {
              s.lattice[0].fixed_rows = {3}, s.lattice[0].fixed_columns = {1, 1};
            }),
            (Lines{"lattice[0].fixed_rows[0]: 3 is outside the lattice, whose last is 2",
                   "lattice[0].fixed_columns[1]: the same as lattice[0].fixed_columns[0]"}));
}

TEST(SceneValidation, WantsNodesInsideTheLatticeAndOnce) {
  EXPECT_EQ(problems([](Scene& s) {
              s.lattice[0].node = {{.row = 2, .column = 1}, {.row = 3, .column = 2}, {.row = 2, .column = 1}};
            }),
            (Lines{"lattice[0].node[1].row: 3 is outside the lattice, whose last is 2",
                   "lattice[0].node[1].column: 2 is outside the lattice, whose last is 1",
                   "lattice[0].node[2]: the same as lattice[0].node[0]"}));
}

TEST(SceneValidation, LetsAFixedNodeBeDisplacedButNotMoveOrFeelALoad) {
  EXPECT_EQ(problems([](Scene& s) {
              s.lattice[0].fixed_columns = {1};
              s.lattice[0].node = {{.row = 0, .displacement = {1, 0}, .velocity = {1, 0}, .force = {0, 1}},
                                   {.row = 1, .velocity = {1, 0}, .force = {0, 1}},
                                   {.row = 1, .column = 1, .velocity = {0, 1}}};
            }),
            (Lines{"lattice[0].node[0].velocity: the node is fixed", "lattice[0].node[0].force: the node is fixed",
                   "lattice[0].node[2].velocity: the node is fixed"}));
}

TEST(SceneValidation, WantsSomethingThatMoves) {
  const auto stuck = [](Scene& s) { s.disc.clear(), s.lattice[0].fixed_rows = {2, 1, 0}; };
  EXPECT_EQ(problems([](Scene& s) { s.lattice[0].fixed_rows = {0, 1, 2}; }), Lines{});
  EXPECT_EQ(problems([](Scene& s) { s.disc.clear(); }), Lines{});
  EXPECT_EQ(problems(stuck).size(), 1u);
  EXPECT_EQ(problems([](Scene& s) { s.disc.clear(), s.lattice[0].fixed_columns = {0, 1}; }).size(), 1u);
  EXPECT_EQ(problems([](Scene& s) { s.disc.clear(), s.lattice.clear(); }).size(), 1u);
}

TEST(SceneValidation, WantsTimesInOrder) {
  EXPECT_EQ(problems([](Scene& s) { s.time.step = 2, s.output.interval = 1; }),
            (Lines{"time.step: longer than the whole run, whose end is 1 s",
                   "output.interval: shorter than time.step, 2 s"}));
  EXPECT_EQ(problems([](Scene& s) {
              s.output.frames = {0, 0.5, 0.5, 1, 1.5};
            }),
            (Lines{"output.frames[2]: not later than the frame before it",
                   "output.frames[4]: after the end of the run, 1 s"}));
}

TEST(SceneValidation, WantsPartsNamedOnceOfEachKind) {
  EXPECT_EQ(problems([](Scene& s) {
              s.wall.push_back(s.wall[0]), s.plate.push_back(s.plate[0]), s.lattice.push_back(s.lattice[0]);
            }),
            (Lines{"plate[1].name: the same as plate[0].name", "wall[1].name: the same as wall[0].name",
                   "lattice[1].name: the same as lattice[0].name"}));
  EXPECT_EQ(problems([](Scene& s) {
              s.wall[0].name = "";
              s.wall.push_back(s.wall[0]);
              s.wall[1].normal = {1, 0}, s.wall[1].point = {-1, 0};
              s.plate[0].name = s.lattice[0].name;
            }),
            Lines{});
}

}  // namespace
}  // namespace furrow
