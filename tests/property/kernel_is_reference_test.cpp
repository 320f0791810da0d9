// The kernel gives the bits of the reference, after every step: random scenes with every option of the law, and beds of
// more than one block. RapidCheck shrinks what fails to a small scene. The paper's scenes are compared from end to end
// with FURROW_LONG.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <ostream>
#include <random>

#include "both_solvers.h"
#include "run/prepare.h"
#include "scene/read.h"

namespace furrow {
namespace {

using test::BothSolvers;

double part(int of_thousand) { return 1e-3 * of_thousand; }

// All of them alike from the first scene on: by itself RapidCheck begins with the least.
int up_to(int most) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, most + 1)); }

bool either() { return *rc::gen::arbitrary<bool>(); }

struct Thrown {
  int x, y, radius, vx, vy, spin, hard;
};

[[maybe_unused]] void showValue(const Thrown& t, std::ostream& out) {
  out << "x " << t.x << " y " << t.y << " radius " << t.radius << " vx " << t.vx << " vy " << t.vy << " spin " << t.spin
      << (t.hard != 0 ? " hard" : " soft");
}

std::vector<Thrown> some_discs() {
  const auto any = rc::gen::inRange(0, 1001);
  const auto both = rc::gen::inRange(-1000, 1001);
  return *rc::gen::container<std::vector<Thrown>>(
      rc::gen::map(rc::gen::tuple(any, any, any, both, both, both, rc::gen::inRange(0, 2)),
                   [](const auto& t) { return std::apply([](auto... each) { return Thrown{each...}; }, t); }));
}

std::vector<Material> materials() {
  Material soft, hard;
  soft.name = "soft";
  soft.young = 1e5;
  soft.poisson = 0.25;
  hard.name = "hard";
  hard.young = 4e5;
  hard.shear = 4e5;
  hard.density = 2300;
  return {soft, hard};
}

// What the kernel does not run in vectors: half of the scenes have none of it.
void add_law_options(Scene& s) {
  s.model.law = *rc::gen::element(ForceLaw::hertz_mindlin, ForceLaw::rescaled_mindlin, ForceLaw::linear);
  s.model.after_slip = either() ? AfterSlip::less_viscous : AfterSlip::elastic;
  s.model.rolling = *rc::gen::element(Rolling::none, Rolling::smoothed, Rolling::spring);
  s.contact.normal_stiffness = 100.0 * (1 + up_to(1000));
  s.contact.tangential_stiffness = 50.0 * (1 + up_to(1000));
  if (either()) s.contact.rolling_stiffness = part(1 + up_to(999));
  if (either()) s.contact.rolling_damping = part(up_to(1000));
  if (either()) {
    s.contact.damping_factor = s.contact.restitution = {};
    s.contact.damping = part(up_to(3000));
    if (either()) s.contact.tangential_damping = part(up_to(3000));
  }
  for (ContactPair& pair : s.contact.pair) {
    pair.tangential_stiffness = 40.0 * (1 + up_to(1000));
    if (either()) pair.rolling_stiffness = part(1 + up_to(999));
  }
}

void add_options(Scene& s) {
  s.model.gravity = either() ? 9.81 : 0;
  s.model.disc_mass = either() ? DiscMass::sphere : DiscMass::disc;
  s.model.moment_arm = *rc::gen::element(MomentArm::contact_point, MomentArm::half_overlap, MomentArm::radius);
  s.model.pull = either();
  s.model.tight_plates = either();
  s.model.new_faces = either();
  s.model.slip_damping = either();
  (either() ? s.contact.damping_factor : s.contact.restitution) = part(1 + up_to(999));
  s.contact.friction = either() ? part(up_to(1000)) : 0;
  s.contact.rolling_friction = either() ? part(up_to(1000)) : 0;
  if (either()) {
    s.contact.pair = {{.materials = {"soft", "hard"},
                       .restitution = 0.5,
                       .friction = part(up_to(900)),
                       .rolling_friction = part(up_to(900))}};
  }
  if (either()) add_law_options(s);
  s.output.energy = either();
  s.output.angles = either();
  s.search.skin = either() ? 1e-5 * up_to(1000) : 0;
  s.search.cell_size = either() ? 1e-4 * (1 + up_to(1000)) : 0;
}

void add_walls(Scene& s) {
  const std::vector<Wall> box{
      {"", {0, 0}, {0, 1}, "hard"}, {"", {0, 0}, {1, 0.1}, "soft"}, {"", {0.2, 0}, {-1, 0}, "hard"}};
  for (const Wall& w : box) {
    if (either()) s.wall.push_back(w);
  }
}

void add_plates(Scene& s) {
  for (int k = up_to(2); k > 0; --k) {
    Plate p;
    p.name = "plate " + std::to_string(k);
    p.left_edge = 0.2 * part(up_to(1000));
    p.lower_edge = 0.2 * part(up_to(1000));
    p.width = either() ? 0.01 : 0.001;  // so thin that discs are pressed through
    p.height = 0.06;
    p.velocity = {part(up_to(1000)), part(up_to(200))};
    if (either()) p.velocity = {part(up_to(1000)), 0}, p.lower_edge = 0;  // on the floor, if there is one
    p.ramp = either() ? 1e-4 * up_to(60) : 0;
    p.material = "hard";
    s.plate.push_back(p);
    if (either()) continue;
    Plate flush = p;  // beside or on top of it
    flush.name += " flush";
    (either() ? flush.left_edge : *flush.lower_edge) += either() ? p.width : p.height;
    s.plate.push_back(flush);
  }
}

// Rollers, notches, weak regions, driven rows, and soft stems in the place of what the keys say.
void add_lattice_options(Lattice& l) {
  for (NodeSetting& n : l.node) n.fixed_x = either(), n.fixed_y = either();
  if (either()) l.link.push_back({.rows = {0, 1}, .stiffness_factor = 0.5, .strength_factor = 0.1});
  if (either()) l.link.push_back({.cut_from = Vec2{-0.01, 0.031}, .cut_to = Vec2{0.025, 0.031}, .torn = true});
  if (either()) l.drive = {{.rows = {l.rows - 1}, .velocity = {0.5, 0.1 * up_to(3)}, .ramp = either() ? 2e-3 : 0}};
  if (!either()) return;
  l.columns = 3;
  l.stem = Stem{1e4, 0.3, 0.04, 0.08 + part(up_to(20)), 50.0 * up_to(9), part(up_to(9))};  // five rows or six
  for (NodeSetting& n : l.node) n.row = std::min(n.row, 4);
}

void add_lattices(Scene& s) {
  for (int k = up_to(2); k > 0; --k) {
    Lattice l;
    l.name = "lattice " + std::to_string(k);
    l.origin = {0.05 + 0.09 * k, 0.02};
    l.rows = 1 + up_to(5);
    l.columns = 1 + up_to(5);
    l.spacing = 0.02;
    l.node_mass = 0.2;
    l.material = either() ? "soft" : "hard";
    l.gravity = either();
    if (either()) l.fixed_rows = {0};
    l.damper = either() ? Damper::full : Damper::axial;
    l.tear = either() ? TearRule::magnitude : TearRule::tension;
    l.auxiliary_points = either() ? 9 : 0;
    // Weak ones tear where they start, several links of a node at once.
    const double strength = either() ? 0.5 + 0.2 * up_to(30) : infinity;
    if (up_to(3) > 0) l.structural = {2000, 1, strength};
    if (either()) l.shear = {2000, 0, strength};
    if (either()) l.bending = {500, 1, strength};
    const Vec2 off{1e-3 * (up_to(8) - 4), 1e-3 * (up_to(8) - 4)};
    if (either()) l.node = {{l.rows - 1, 0, off, {0.1 * up_to(9), 0}, {1.0 * up_to(5), 0}}};
    if (either()) add_lattice_options(l);
    s.lattice.push_back(l);
  }
}

Scene some_scene() {
  Scene s;
  s.material = materials();
  add_options(s);
  add_walls(s);
  add_plates(s);
  add_lattices(s);
  for (const Thrown& t : some_discs()) {
    s.disc.push_back({{0.2 * part(t.x), 0.2 * part(t.y)},
                      0.005 + 0.015 * part(t.radius),
                      {part(t.vx), part(t.vy)},
                      0.01 * t.spin,
                      t.hard != 0 ? "hard" : "soft"});
  }
  RC_PRE(!s.disc.empty() || !s.lattice.empty());
  return s;
}

RC_GTEST_PROP(KernelIsReference, AfterEveryStepOfRandomScenes, ()) {
  const Scene scene = some_scene();
  BothSolvers both(scene);
  const auto method = *rc::gen::element<std::string>("pece", "rk4", "symplectic_euler", "ab2");
  const std::string found = both.run(method, 1e-4, 40);
  RC_CLASSIFY(both.contacts() > 0, "something touched");
  if (!found.empty()) RC_LOG() << canonical_text(scene);
  RC_LOG() << found << '\n';
  RC_ASSERT(found.empty());
}

// What the property rests on: it sees a difference of the last bit.
TEST(KernelIsReference, ADifferenceOfTheLastBitIsSeen) {
  Scene scene;
  scene.material = materials();
  scene.contact.friction = 0.5;
  scene.disc = {{{0, 0}, 0.01, {}, 0, "soft"}, {{0.019, 0}, 0.01, {}, 0, "soft"}};
  const System system(scene);
  const State y = system.initial_state();
  for (std::size_t k = 0; k < y.size(); ++k) {
    State other = y;
    other[k] = std::nextafter(other[k], 1e300);
    EXPECT_NE(test::difference(system, y, system, other), "") << test::name_of_number(system, static_cast<int>(k));
  }
  EXPECT_EQ(test::difference(system, y, system, y), "");
}

// Numbered at random, so that pairs reach across blocks all over the bed.
Scene bed_over_blocks(int threads) {
  constexpr int count = 4096 + 700, a_row = 70;
  std::mt19937_64 random(7);
  std::vector<int> place(count);
  for (int k = 0; k < count; ++k) place[k] = k;
  for (int k = count - 1; k > 0; --k) std::swap(place[k], place[random() % static_cast<std::uint64_t>(k + 1)]);
  Scene s;
  s.material = materials();
  s.contact = {.damping_factor = 2.0, .friction = 0.4, .rolling_friction = 0.2};
  s.search.threads = threads;
  s.wall = {{"", {0, 0}, {0, 1}, "hard"}};
  for (const int k : place) {
    const double jitter = 1e-6 * static_cast<double>(random() % 1000);
    s.disc.push_back({{0.019 * (k % a_row) + jitter, 0.009 + 0.019 * (k / a_row) - jitter},
                      0.0095 + jitter,
                      {1e-3 * static_cast<double>(random() % 100), -0.1},
                      static_cast<double>(random() % 7),
                      k % 3 == 0 ? "hard" : "soft"});
  }
  return s;
}

TEST(KernelIsReference, InBedsOfMoreThanOneBlockOnAnyNumberOfThreads) {
  for (const int threads : {1, 2, 3, 4}) {
    BothSolvers both(bed_over_blocks(threads));
    EXPECT_EQ(both.kernel().threads(), threads);
    EXPECT_EQ(both.run("pece", 1e-4, threads == 1 ? 3 : 1), "") << threads << " threads";
    EXPECT_GT(both.contacts(), 2 * 9000);  // at two moments at least
  }
}

// The beds of the paper's scenes as they lie, and the plate's first way through them; with FURROW_LONG all of it.
class PapersScenes : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, PapersScenes, testing::Values("scenario_1", "scenario_2", "scenario_3"));

TEST_P(PapersScenes, AreTheSameBitsFromTheReference) {
  const Scene scene = read_scene(std::string(FURROW_SOURCE_DIR) + "/validation/scenes/" + GetParam() + ".toml");
  const Prepared p = prepare(scene);
  BothSolvers both(p.scene);
  both.start_from(p.y, p.system.discrete_state());
  const bool whole = std::getenv("FURROW_LONG") != nullptr;
  const long steps = whole ? std::lround(scene.time.end / scene.time.step) : 300;
  EXPECT_EQ(both.run(scene.time.method, scene.time.step, steps), "");
}

}  // namespace
}  // namespace furrow
