// A method of one's own: it enters the catalogue, and every run can name it.
#include <cmath>

#include "examples.h"
#include "run/run.h"
#include "scene/read.h"

// Heun's method: y + h (f(t, y) + f(t + h, y + h f)) / 2, of order 2.
class Heun final : public furrow::Method {
 public:
  Heun() : Method({.name = "heun", .title = "Heun's method", .order = 2, .evaluations = 2}) {}

  double step(const furrow::OdeSystem& system, double t, furrow::State& y, double h) override {
    first_.resize(y.size());
    second_.resize(y.size());
    evaluate_start(system, t, y, first_);
    furrow::State ahead = y;
    for (std::size_t i = 0; i < y.size(); ++i) ahead[i] += h * first_[i];
    evaluate(system, t + h, ahead, second_);
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += h / 2 * (first_[i] + second_[i]);
    return h;
  }

 private:
  furrow::State first_, second_;
};

double fall_by_an_own_method(double h) {
  const auto make = [](const furrow::Tolerances&) -> std::unique_ptr<furrow::Method> {
    return std::make_unique<Heun>();
  };
  static const bool registered = (furrow::register_method({Heun().info(), make}), true);
  furrow::Scene scene;
  scene.material = {{.name = "soft", .young = 2e5, .poisson = 0.3}};
  scene.disc = {{.position = {0, 0}, .radius = 0.01, .material = "soft"}};
  furrow::System system(scene);
  furrow::State y = system.initial_state();
  const auto method = furrow::make_method(registered ? "heun" : "");
  const auto end = furrow::run(system, *method, y, {.end = 1, .step = h}, [](auto&&...) { return true; });
  return end.ending == furrow::Ending::finished ? y[system.y_of(0)] : NAN;
}
