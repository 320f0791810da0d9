// The control of steps, number by number: the filter that chooses them, the norm that judges them, and how often rkc
// renews its estimate of the spectrum.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "methods/controlled.h"
#include "oscillator.h"

namespace furrow {
namespace {

using namespace test;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Every trial of pece_adaptive on an oscillator, by the formulas of its header and of the filter's.
struct WrittenOut {
  double w, zeta;             // rad/s, -
  double relative, absolute;  // tolerances
  double proposal;            // s
  double x = 1, v = 0;
  double h_before = 0;                // s, of the method's history
  double filter_h = 0, filter_e = 0;  // of the filter's
  bool filter_started = false;
  long rejected = 0;

  double step(double most) {
    const double ax = v, av = -w * w * x - 2 * zeta * w * v;
    double h = std::fmin(proposal, most);
    bool cut = proposal > most;
    for (;;) {
      const double r = h_before > 0 ? h / h_before : 0;
      const double px = x + h * ((1 + r / 2) * ax - r / 2 * before_x);
      const double pv = v + h * ((1 + r / 2) * av - r / 2 * before_v);
      const double bx = pv, bv = -w * w * px - 2 * zeta * w * pv;
      const double cx = x + h / 2 * (ax + bx), cv = v + h / 2 * (av + bv);
      const double milne = h_before > 0 ? r / (3 * (1 + r)) : 0.5;
      const double e =
          std::fmax(milne * std::fabs(cx - px) / (absolute + relative * (std::fabs(x) + h * std::fabs(ax))),
                    milne * std::fabs(cv - pv) / (absolute + relative * (std::fabs(v) + h * std::fabs(av))));
      if (e <= 1) {
        const double judged = std::fmax(e, 1e-6);
        if (!filter_started) {
          filter_h = h;
          filter_e = judged;
        }
        filter_started = true;
        double factor =
            std::pow(0.5 / judged, 0.125) * std::pow(0.5 / filter_e, 0.125) * std::pow(h / filter_h, -0.375);
        factor = std::fmin(std::fmax(factor, 0.2), 2);
        proposal = cut ? std::fmax(proposal, h * factor) : h * factor;
        filter_h = h;
        filter_e = judged;
        before_x = ax;
        before_v = av;
        h_before = h;
        x = cx;
        v = cv;
        return h;
      }
      ++rejected;
      cut = false;
      filter_started = false;
      h *= std::fmax(std::pow(0.5 / e, 0.375), 0.1);
      proposal = h;
    }
  }
  double before_x = 0, before_v = 0;
};

void expect_as_written(const Tolerances& tolerances, double w, double zeta, const std::vector<double>& most) {
  const Oscillator system(w, zeta);
  const auto method = make_method("pece_adaptive", tolerances);
  WrittenOut want{w, zeta, tolerances.relative, tolerances.absolute, tolerances.first_step};
  State y{1, 0};
  double t = 0;
  for (std::size_t k = 0; k < most.size(); ++k) {
    const double h = method->step(system, t, y, most[k]);
    // An error of 1e-6 is a difference of numbers of 1, known to 1e-10 of itself; so are the steps, and the states by
    // them.
    EXPECT_NEAR(h, want.step(most[k]), 1e-9 * h) << "step " << k;
    EXPECT_NEAR(y[0], want.x, 1e-9) << "step " << k;
    EXPECT_NEAR(y[1], want.v, 1e-9 * w) << "step " << k;
    t += h;
  }
  EXPECT_EQ(method->rejections(), want.rejected);
}

TEST(StepControl, StepsAreThoseOfTheFilterWrittenOut) {
  expect_as_written({.relative = 1e-5, .absolute = 1e-7, .first_step = 1e-4}, 3, 0.05, std::vector<double>(120, 10));
  expect_as_written({.relative = 1e-3, .absolute = 1e-3, .first_step = 1e-5}, 10, 0, std::vector<double>(80, 10));
}

TEST(StepControl, AFirstStepFarTooLongIsShortenedAsWritten) {
  expect_as_written({.relative = 1e-6, .absolute = 1e-9, .first_step = 1}, 20, 0.1, std::vector<double>(60, 10));
}

// Cut by a stop every fifth time, to half and to a thousandth: the longer step that was proposed is kept.
TEST(StepControl, AStepCutByAStopIsJudgedAsWritten) {
  std::vector<double> most(100, 10);
  for (std::size_t k = 4; k < most.size(); k += 5) most[k] = k % 2 == 0 ? 1e-3 : 1e-5;
  expect_as_written({.relative = 1e-5, .absolute = 1e-7, .first_step = 1e-3}, 3, 0.05, most);
}

// Does nothing, and says of its error what it is asked to; the last number is not controlled.
class SaysItsError final : public ControlledMethod {
 public:
  explicit SaysItsError(const Tolerances& tolerances) : ControlledMethod({"says", "", 2, 0, true}, tolerances) {}
  State says, to;
  std::vector<double> tried;

 protected:
  void prepare(const OdeSystem& system, double t, const State& y) override { system.rhs(t, y, now_); }
  void attempt(const OdeSystem& /*system*/, double /*t*/, const State& y, double h) override {
    tried.push_back(h);
    next_ = to.empty() ? y : to;
    error_ = says;
  }
  void accept(double /*h*/) override {}
};

bool accepts(const State& error, const State& to = {}) {
  const Beside system([](double) { return 5.0; });
  SaysItsError method({.relative = 1e-2, .absolute = 1e-1, .first_step = 0.5});
  method.says = error;
  method.to = to;
  State y{2, 1, 0};
  try {
    method.step(system, 0, y, 1);
  } catch (const Divergence&) {
    EXPECT_EQ(y, (State{2, 1, 0}));
    EXPECT_EQ(method.rejections(), 60);
    EXPECT_EQ(method.tried.size(), 60u);
    return false;
  }
  return method.tried.size() == 1;
}

// Of y = (2, 1) with rates (1, -2) and h = 1/2 the scales are 0.1 + 0.01 (2 + 0.5 * 1) and 0.1 + 0.01 (1 + 0.5 * 2).
TEST(StepControl, ErrorIsTheGreatestAgainstItsOwnScale) {
  EXPECT_TRUE(accepts({0.125 * 0.9999, 0, 0}));
  EXPECT_FALSE(accepts({0.125 * 1.0001, 0, 0}));
  EXPECT_TRUE(accepts({0, -0.12 * 0.9999, 0}));
  EXPECT_FALSE(accepts({0, -0.12 * 1.0001, 0}));
  EXPECT_TRUE(accepts({0, 0, 1e9}));  // beside the control
}

TEST(StepControl, ANaNInTheErrorAloneIsAnError) {
  EXPECT_FALSE(accepts({nan, 0, 0}));
  EXPECT_FALSE(accepts({0, nan, 0}));
  EXPECT_FALSE(accepts({nan, 0.01, 0}));
  EXPECT_FALSE(accepts({std::numeric_limits<double>::infinity(), 0, 0}));
  EXPECT_TRUE(accepts({0, 0, nan}));
}

TEST(StepControl, ANumberThatIsNotFiniteIsAnErrorInTheLedgerToo) {
  EXPECT_TRUE(accepts({0, 0, 0}, {2, 1, 7}));
  EXPECT_FALSE(accepts({0, 0, 0}, {2, 1, nan}));
  EXPECT_FALSE(accepts({0, 0, 0}, {2, -std::numeric_limits<double>::infinity(), 0}));
}

TEST(StepControl, ATryThatCannotBeJudgedIsATenthNext) {
  const Beside system([](double) { return 0.0; });
  SaysItsError method({.relative = 1e-2, .absolute = 1e-1, .first_step = 0.5});
  method.says = {nan, 0, 0};
  State y{2, 1, 0};
  EXPECT_THROW(method.step(system, 0, y, 1), Divergence);
  for (std::size_t k = 1; k < method.tried.size(); ++k)
    EXPECT_NEAR(method.tried[k], method.tried[k - 1] / 10, 1e-9 * method.tried[k]);
}

TEST(StepControl, AStepGrowsByTwoAtMost) {
  const Beside system([](double) { return 0.0; });
  SaysItsError method({.relative = 1e-2, .absolute = 1e-1, .first_step = 1e-3});
  method.says = {0, 0, 0};
  State y{2, 1, 0};
  for (int k = 0; k < 8; ++k) EXPECT_NEAR(method.step(system, 0, y, 1), std::ldexp(1e-3, k), 1e-15) << k;
  method.restart();
  EXPECT_EQ(method.step(system, 0, y, 1), 1e-3);
}

// z' = -rate z beside a position that rests.
struct FastDecay final : OdeSystem {
  explicit FastDecay(double of) : rate(of) {}
  std::size_t size() const override { return 3; }
  std::size_t positions() const override { return 1; }
  void rhs(double /*t*/, const State& y, State& dydt) const override { dydt = {y[1], 0, -rate * y[2]}; }
  double rate;  // 1/s
};

// A step of s stages takes s evaluations; estimates come with the 1st, 26th, 51st, ... accepted one.
TEST(RungeKuttaChebyshev, RenewsItsEstimateEveryTwentyFiveSteps) {
  const FastDecay system(400);
  const auto method = make_method("rkc", {.relative = 1e30, .absolute = 1e30, .first_step = 0.1});
  State y{0, 0, 1};
  const int stages = 1 + static_cast<int>(std::sqrt(1 + 1.54 * 0.1 * 1.2 * 400));
  for (int n = 0; n < 80; ++n) {
    const long before = method->evaluations();
    method->step(system, 0.1 * n, y, 0.1);
    const long taken = method->evaluations() - before - (n == 0 ? 1 : 0);  // the first knows no rate
    if (n % 25 == 0) {
      EXPECT_GT(taken, stages) << n;
      EXPECT_LE(taken, stages + 4) << n;  // one eigenvalue: the power iteration agrees with itself at once
    } else {
      EXPECT_EQ(taken, stages) << n;
    }
  }
  method->restart();
  const long before = method->evaluations();
  method->step(system, 8, y, 0.1);
  EXPECT_GT(method->evaluations() - before, stages + 1);
}

// A thousand stages reach 1.54 h rho of 10^6, with the margin of 1.2 on rho; beyond that the step is tried shorter.
TEST(RungeKuttaChebyshev, TriesATenthWhereAThousandStagesDoNotReach) {
  const auto step_of = [](double rate) {
    State y{0, 0, 1};
    return make_method("rkc", {.relative = 1e30, .absolute = 1e30, .first_step = 1})->step(FastDecay(rate), 0, y, 1);
  };
  EXPECT_EQ(step_of(0.99 * 999 * 999 / (1.54 * 1.2)), 1);
  EXPECT_EQ(step_of(1.01 * 1000 * 1000 / (1.54 * 1.2)), 0.1);
  EXPECT_NEAR(step_of(1.01 * 1e7 / (1.54 * 1.2)), 0.01, 1e-15);
}

// Sixty tries on, the step is shorter than six decimals show.
TEST(StepControl, WhoGivesUpSaysHowShortTheLastStepWas) {
  struct NotANumber final : OdeSystem {
    std::size_t size() const override { return 2; }
    std::size_t positions() const override { return 1; }
    void rhs(double /*t*/, const State& /*y*/, State& dydt) const override { dydt = {0, nan}; }
  };
  for (const MethodInfo& info : method_catalogue()) {
    if (!info.controlled) continue;
    State y{1, 0};
    try {
      make_method(info.name)->step(NotANumber(), 0, y, 0.1);
      ADD_FAILURE() << info.name << " takes a step";
    } catch (const Divergence& end) {
      const std::string text = end.what();
      const std::size_t at = text.find("the last was ");
      ASSERT_NE(at, std::string::npos) << text;
      const double last = std::stod(text.substr(at + 13));
      EXPECT_GT(last, 0) << text;
      EXPECT_LT(last, 1e-20) << text;
    }
  }
}

}  // namespace
}  // namespace furrow
