// A body that runs into a wall, head-on, d its overlap and d(0) = 0, d'(0) = v at the touch:
//
//   linear  d'' = -2 zeta w d' - w^2 d,  of which  d = v/wd e^(-zeta w t) sin wd t, free again at wd t = pi
//   Hertz   d'' = -K/m d^(3/2) - g d^(1/4) d',  closed form in damped_hertz.h, for any damping
//
// The force after the touch starts like t (linear), like a jump (with dashpot), like t^(3/2) (Hertz) and like t^(1/4)
// (Hertz with damping). The solver knows Hertz contacts only: the linear ones are systems of this file.
#include <cmath>
#include <numbers>

#include "run/system.h"
#include "verification/studies/order_hertz.h"
#include "verification/studies/order_problems.h"

namespace furrow::verification {
namespace {

constexpr long double pi = std::numbers::pi_v<long double>;
constexpr long double flight = 0.25L;  // of a contact's duration, before the touch: room for the start of any method

// ---- linear ----

class LinearContact final : public OdeSystem {
 public:
  explicit LinearContact(double zeta) : viscosity_(2 * zeta) {}
  std::size_t size() const override { return 2; }
  std::size_t positions() const override { return 1; }
  std::string velocity_dependence() const override { return viscosity_ > 0 ? "the dashpot" : ""; }
  void rhs(double /*t*/, const State& y, State& dydt) const override {  // in units of 1/w
    dydt[0] = y[1];
    dydt[1] = y[0] < 0 ? -y[0] - viscosity_ * y[1] : 0;
  }

 private:
  double viscosity_;
};

Problem linear_contact(double zeta, const std::string& name, const std::string& title, const std::string& event) {
  const long double ratio = zeta;
  const long double turn = std::sqrt(1 - ratio * ratio);
  const long double contact = pi / turn;
  const long double touch = flight * contact;
  Problem p{name, title, event, zeta > 0 ? 1.0 : 2.0};
  p.from_rest = p.rebounds = zeta == 0;
  p.unit = static_cast<double>(contact);
  p.duration = 1.65 * p.unit;
  p.touch = static_cast<double>(touch);
  p.least_steps = zeta == 0 ? 160 : 80;  // with fewer the h^3 of an Adams method of order 3 hides the h^2 of the kink
  p.system = [zeta] { return std::make_unique<LinearContact>(zeta); };
  p.state = [=](long double t) -> State {
    const long double s = t - touch;
    if (s <= 0) return {static_cast<double>(-s), -1};
    const long double e = std::exp(-ratio * std::fmin(s, contact));
    if (s >= contact) return {static_cast<double>(e * (s - contact)), static_cast<double>(e)};
    const long double sine = std::sin(turn * s) / turn;
    return {static_cast<double>(-e * sine), static_cast<double>(-e * (std::cos(turn * s) - ratio * sine))};
  };
  return p;
}

// ---- Hertz ----

constexpr double radius = 0.01;   // m
constexpr double density = 1000;  // kg/m^3
constexpr double young = 2e5;     // Pa
constexpr double poisson = 0.3;   // -
constexpr double closing = 0.1;   // m/s

// The disc's centre is at height 0 when it touches.
Scene impact_scene(double beta, bool pull) {
  Scene scene;
  scene.model.gravity = 0;
  scene.model.pull = pull;
  scene.output.energy = false;
  scene.contact.damping_factor = beta;
  scene.material.push_back({.name = "any", .density = density, .young = young, .poisson = poisson});
  scene.disc.push_back({.position = {0, 0}, .radius = radius, .material = "any"});
  scene.wall.push_back({.point = {0, -radius}, .material = "any"});
  return scene;
}

// until: of the contact's duration, from the touch.
Problem hertz(double beta, bool pull, double until, Problem p) {
  p.least_steps = beta > 0 ? 400 : 80;
  const long double mass = density * pi * radius * radius;
  const long double modulus = young / (2 * (1 - static_cast<long double>(poisson) * poisson));
  const long double stiffness = 4 * modulus * std::sqrt(static_cast<long double>(radius)) / 3;
  const long double length = std::pow(mass * closing * closing / stiffness, 0.4L);
  const long double time = length / closing;
  const auto path = std::make_shared<HertzPath>(beta, pull);
  const long double contact = path->contact() * time;
  p.from_rest = beta == 0;
  p.rebounds = beta == 0 && until > 1;
  p.unit = static_cast<double>(contact);
  p.duration = static_cast<double>((flight + until) * contact);
  p.touch = static_cast<double>(flight * contact);
  p.length = static_cast<double>(length);
  p.speed = closing;
  p.system = [=] { return std::make_unique<System>(impact_scene(beta, pull)); };
  p.state = [=](long double t) -> State {
    const auto [overlap, approach] = path->at((t - flight * contact) / time);
    return {0, static_cast<double>(-overlap * length), 0, static_cast<double>(-approach * closing)};
  };
  return p;
}

}  // namespace

std::vector<Problem> contact_problems() {
  return {
      linear_contact(0, "linear_contact", "linear contact", "slope of the force jumps at touch and release"),
      linear_contact(0.1, "dashpot_contact", "contact with dashpot", "force jumps at touch and release"),
      hertz(0, true, 0.65, {"hertz_inside", "Hertz in contact", "force starts as t^(3/2) at touch", 2.5}),
      hertz(0, true, 1.4, {"hertz", "Hertz after rebound", "force starts and ends as t^(3/2)", 2.5}),
      hertz(0.1, true, 0.65,
            {"damped_hertz_inside", "damped Hertz in contact", "force starts as t^(1/4) at touch", 1.25}),
      hertz(0.1, false, 1.4,
            {"damped_hertz", "damped Hertz after rebound", "force starts as t^(1/4), its slope jumps where it ends",
             1.25}),
  };
}

}  // namespace furrow::verification
