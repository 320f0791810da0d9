// The energy ledger closes with every option of the model: what is left over is the error of the method and shrinks at its
// order.
//
//   order observed between h and h/2: log2(residual(h)/residual(h/2)) -> 2 for pece, 4 for rk4
//
// In the stretch that is run nothing touches for the first time, lets go, slips or tears: there no method keeps its order.
// So the rule after slip and tight plates change no number here, but the way through the code.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "run/observe.h"
#include "scenes.h"

namespace furrow {
namespace {

using namespace test;

struct Option {
  const char* name;
  std::function<void(Scene&)> choose;
};

void PrintTo(const Option& option, std::ostream* out) { *out << option.name; }

// A wall, two discs and a plate in a row, all pressed together; they move, turn and rub without slipping.
Scene pressed_row() {
  constexpr double radius = 0.1, overlap = 0.002;  // m
  Scene scene = empty_scene();
  scene.contact.damping_factor = 0.1;
  scene.contact.friction = 50;
  scene.contact.rolling_friction = 0.2;
  scene.model.rolling_smoothing = 1;
  scene.wall = {wall({0, 0}, {1, 0})};
  scene.disc = {disc({radius - overlap, 0}, radius, {-0.003, 0.01}, 0.05),
                disc({3 * radius - 2 * overlap, 0.001}, radius, {0.002, -0.008}, -0.1)};
  scene.plate = {plate({4 * radius - 3 * overlap, -1}, 1, 2, {-0.01, 0.004})};
  return scene;
}

// A disc pressed onto the right side of a lattice whose lowest row is fixed and that swings.
Scene pressed_lattice() {
  Scene scene = pressed_row();
  scene.disc.resize(1);
  scene.plate.clear();
  scene.wall.clear();
  Lattice lattice{.rows = 5, .columns = 3, .spacing = 0.1, .node_mass = 5, .material = "soft"};
  lattice.fixed_rows = {0};
  lattice.structural = link_kind(2e4, 20);
  lattice.shear = lattice.bending = link_kind(1e4, 20);
  lattice.auxiliary_points = 0;
  lattice.node = {{.row = 4, .column = 1, .velocity = {0.02, -0.01}}};
  scene.lattice = {lattice};
  scene.disc[0].position = {0.298, 0.24};
  return scene;
}

const std::vector<Option>& of_contacts() {
  const auto damped_by = [](auto set) {
    return [set](Scene& s) {
      s.contact.damping_factor.reset();
      set(s.contact);
    };
  };
  static const std::vector<Option> all{
      {"Hertz-Mindlin", [](Scene&) {}},
      {"rescaled Mindlin", [](Scene& s) { s.model.law = ForceLaw::rescaled_mindlin; }},
      {"linear",
       [](Scene& s) {
         s.model.law = ForceLaw::linear;
         s.contact.normal_stiffness = 2e4;
         s.contact.tangential_stiffness = 1e4;
       }},
      {"restitution", damped_by([](auto& contact) { contact.restitution = 0.7; })},
      {"Tsuji's alpha", damped_by([](auto& contact) { contact.tsuji_alpha = 0.3; })},
      {"a dashpot", damped_by([](auto& contact) { contact.damping = 40; })},
      {"a dashpot, another along the tangent",
       damped_by([](auto& contact) { contact.damping = 40, contact.tangential_damping = 15; })},
      {"no damping along the tangent", [](Scene& s) { s.model.slip_damping = false; }},
      {"less viscous after slip", [](Scene& s) { s.model.after_slip = AfterSlip::less_viscous; }},
      {"arm to half the overlap", [](Scene& s) { s.model.moment_arm = MomentArm::half_overlap; }},
      {"arm of the radius", [](Scene& s) { s.model.moment_arm = MomentArm::radius; }},
      {"no rolling friction", [](Scene& s) { s.model.rolling = Rolling::none; }},
      {"a rolling spring", [](Scene& s) { s.model.rolling = Rolling::spring; }},
      {"tight plates", [](Scene& s) { s.model.tight_plates = true; }},
      {"a plate on its ramp", [](Scene& s) { s.plate[0].ramp = 1; }},
  };
  return all;
}

const std::vector<Option>& of_lattices() {
  static const std::vector<Option> all{
      {"as it is", [](Scene&) {}},
      {"dampers on the whole velocity", [](Scene& s) { s.lattice[0].damper = Damper::full; }},
      {"new faces", [](Scene& s) { s.model.new_faces = true; }},
      {"weight", [](Scene& s) { s.model.gravity = 9.81, s.lattice[0].gravity = true; }},
      {"a driven row",
       [](Scene& s) {
         s.lattice[0].drive = {{.rows = {3}, .velocity = {0.01, 0.005}}};
       }},
      {"a driven row on its ramp",
       [](Scene& s) {
         s.lattice[0].drive = {{.rows = {3}, .velocity = {0.01, 0.005}, .ramp = 1}};
       }},
      {"rollers",
       [](Scene& s) {
         for (int column = 0; column < 3; ++column)
           s.lattice[0].node.push_back({.row = 1, .column = column, .fixed_x = true});
       }},
      {"a stem",
       [](Scene& s) {
         Lattice& l = s.lattice[0];
         l.structural = l.shear = l.bending = {};
         l.stem = Stem{.young = 1e6, .diameter = 0.2, .length = 0.4, .damping_ratio = 0.02};
       }},
      {"links of their own",
       [](Scene& s) {
         s.lattice[0].link = {{.rows = {1, 2}, .stiffness_factor = 0.5}, {.columns = {0}, .damping = 5.0}};
       }},
      {"a notch",
       [](Scene& s) {
         s.lattice[0].link = {{.from = {1, 0}, .to = {2, 0}, .torn = true}};
       }},
      {"a load",
       [](Scene& s) {
         s.lattice[0].node[0].force = {3, 1};
       }},
  };
  return all;
}

struct Left {
  double residual, turned_over;  // J
  bool smooth = true;
};

Left left_over(const Scene& scene, const std::string& method, double step) {
  constexpr double end = 0x1p-4;  // s
  System system(scene);
  State y = system.initial_state();
  const Energies start = observe(system, 0, y).energy;
  Left left{};
  run(system, *make_method(method), y, {.start = 0, .end = end, .step = step, .stop = {}},
      [&](double, const State&, const JumpReport& jump) {
        left.smooth = left.smooth && jump.torn.empty();
        return true;
      });
  const Energies now = observe(system, end, y).energy;
  left.residual = now.residual(start);
  left.turned_over = start.live() + now.lost() + std::fabs(now.plate_work);
  return left;
}

void closes(const Scene& scene) {
  for (const auto& [method, order, coarse] : {std::tuple{"pece", 2.0, 0x1p-13}, {"rk4", 4.0, 0x1p-11}}) {
    const Left at[2] = {left_over(scene, method, coarse), left_over(scene, method, coarse / 2)};
    EXPECT_TRUE(at[0].smooth && at[1].smooth);
    EXPECT_GT(at[0].turned_over, 1e-4) << "something happens";
    EXPECT_NEAR(std::log2(at[0].residual / at[1].residual), order, 0.3)
        << method << ": the next term of the series: omega h of the lattice is at most 0.1; residuals "
        << at[0].residual << ", " << at[1].residual;
  }
}

class LedgerOfContacts : public testing::TestWithParam<Option> {};
INSTANTIATE_TEST_SUITE_P(Options, LedgerOfContacts, testing::ValuesIn(of_contacts()));
TEST_P(LedgerOfContacts, ClosesAtTheOrderOfTheMethod) {
  Scene scene = pressed_row();
  GetParam().choose(scene);
  closes(scene);
}

class LedgerOfLattices : public testing::TestWithParam<Option> {};
INSTANTIATE_TEST_SUITE_P(Options, LedgerOfLattices, testing::ValuesIn(of_lattices()));
TEST_P(LedgerOfLattices, ClosesAtTheOrderOfTheMethod) {
  Scene scene = pressed_lattice();
  GetParam().choose(scene);
  closes(scene);
}

}  // namespace
}  // namespace furrow
