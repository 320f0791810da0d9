// What the work-precision study rests on: references that closed forms bear out, and counts that repeat to the digit.
//
//   spring  x(t) = x0 e^(-zeta w t) (cos(wd t) + zeta w/wd sin(wd t)),  w = 10 rad/s,  zeta = 0.05
//           wd = w sqrt(1 - zeta^2)
//   impact  leaves as fast as it came, t_c after the touch at t_0:
//           y(t) = R + v (t - t_0 - t_c)
//           t_c = (4 sqrt(pi)/5) Gamma(2/5)/Gamma(9/10) d_max/v
//           d_max = (5 m v^2/(4 K))^(2/5)
//           K = 4/3 E* sqrt(R)
//
// Sources: the damped oscillator; Hertz 1882. The scenes are those of the study, benchmarks/studies/cases.cpp.
#include <algorithm>
#include <cmath>

#include "benchmarks/studies/reference.h"
#include "verification/check.h"

namespace furrow::verification {
namespace {

using benchmarks::Error;
using benchmarks::Outcome;

CaseInfo info_of(const std::string& name) {
  const std::vector<CaseInfo>& all = cases();
  return *std::find_if(all.begin(), all.end(), [&](const CaseInfo& c) { return c.name == name; });
}

Outcome outcome(const std::string& name, const std::string& method, double step, double tolerance = 0) {
  return benchmarks::run_case(make_case(info_of(name)), {.method = method, .step = step, .tolerance = tolerance});
}

double count(const std::string& name, const std::string& method, double step, double tolerance = 0) {
  return static_cast<double>(outcome(name, method, step, tolerance).evaluations);
}

benchmarks::Reference reference(const std::string& name) {
  const CaseInfo info = info_of(name);
  return benchmarks::make_reference(info, make_case(info));
}

TEST(WorkPrecision, ReferencesAreClosedForms) {
  requirement("precision.references");
  const double wd = 10 * std::sqrt(1 - 0.05 * 0.05), t = 2;
  const double swing = 0.01 * std::exp(-0.5 * t) * (std::cos(wd * t) + 0.5 / wd * std::sin(wd * t));
  expect(
      "mass on the spring after 2 s [m]", reference("single_spring").outcome.place.at(0), 0.1 + swing,
      absolute(1e-14, "rk4 errs by x0 t w (w h)^4/120 = 2e-15 m; round-off of 20000 steps as a random walk 1e-15 m"));
  // E = G = 2e5 Pa: nu = -0.5. A disc of 1000 kg/m^3, 1 m deep.
  const double radius = 0.01, speed = 0.1, touch = 0.0137, pi = 3.14159265358979323846;
  const double stiffness = 4.0 / 3.0 * 2e5 / (1 - 0.25) * std::sqrt(radius);
  const double depth = std::pow(5 * 1000 * pi * radius * radius * speed * speed / (4 * stiffness), 0.4);
  // A rigid wall adds nothing to 1/E* = (1 - nu^2)/E.
  const double lasts = 0.8 * std::sqrt(pi) * std::tgamma(0.4) / std::tgamma(0.9) * depth / speed;
  const benchmarks::Reference hertz = reference("hertz_impact");
  expect("disc after its bounce [m]", hertz.outcome.place.at(1), radius + speed * (0.1 - touch - lasts),
         absolute(
             1e-13,
             "rk4 errs by order 5/2: measured 1e-6 at a step of 1.25e-3 s, 1e-14 m at 1e-6 s; round-off of 1e5 steps"));
}

TEST(WorkPrecision, UnrelatedReferencesAgreeTenTimesBetterThanThePapersError) {
  requirement("precision.references");
  for (const std::string name : {"single_spring", "hertz_impact", "damped_hertz_impact", "cantilever"}) {
    const benchmarks::Reference known = reference(name);
    const double papers = error_of(outcome(name, "pece", 1e-4), known.outcome).place;
    expect(name + ": apart, of the paper's error", known.disagreement.place / papers, 0,
           absolute(0.1, "an error is distinguished from the reference's own only if it is ten times larger"));
  }
}

TEST(WorkPrecision, CountsRepeatToTheDigit) {
  requirement("precision.counts");
  const auto steps = exact("steps times evaluations a step");
  expect("scenario_1, pece at 1e-4 s", count("scenario_1", "pece", 1e-4), 2 * 12000, steps);
  expect("scenario_1, rk4 at 1e-3 s", count("scenario_1", "rk4", 1e-3), 4 * 1200, steps);
  expect("single_spring, verlet at 1e-3 s", count("single_spring", "verlet", 1e-3), 2000 + 1,
         exact("one a step, and the first"));
  const auto once =
      exact("counted once; steps are chosen with + - * / sqrt alone, so that every machine chooses the same");
  expect("hertz_impact, pece_adaptive at 1e-6", count("hertz_impact", "pece_adaptive", 0.01, 1e-6), 477, once);
  expect("scenario_1, pece_adaptive at 1e-3", count("scenario_1", "pece_adaptive", 0.02, 1e-3), 1204, once);
  expect("scenario_1, verlet at 1e-3 s", count("scenario_1", "verlet", 1e-3), 1592, once);
}

TEST(WorkPrecision, PapersAccuracyCostsAThird) {
  requirement("precision.cheaper");
  const struct {
    const char* name;
    double step;
  } finds[] = {{"single_spring", 5e-3}, {"cantilever", 8e-4}};
  for (const auto& [name, step] : finds) {
    const CaseInfo info = info_of(name);
    const Outcome known = reference(name).outcome;
    const Outcome papers = outcome(name, "pece", 1e-4);
    const Outcome other = outcome(name, "rk4", step);
    const double error = error_of(other, known).place / error_of(papers, known).place;
    expect_true(std::string(name) + ": rk4 is as accurate as the paper's setting", error <= 1,
                "else it is not comparable");
    expect_true(std::string(name) + ": and costs at most a third", 3 * other.evaluations <= papers.evaluations,
                "the claim");
  }
}

}  // namespace
}  // namespace furrow::verification
