// The scenes of validation/scenes in the study of stability: their spectra and the steps that they allow.
#pragma once

#include "report/measurement.h"
#include "verification/studies/scene_stability.h"

namespace furrow::verification {

// The scene's fastest part as an oscillator at a step, to be marked in the atlas.
struct OperatingPoint {
  double zeta = 0, angle = 0;
};

// What is kept of a scene at a moment.
struct StandingScene {
  std::string name;      // "scene 2, spheres"
  double t = 0;          // s
  std::string failed{};  // why there are no numbers
  double own_step = 0;   // s
  int numbers = 0;
  std::complex<double> fastest{};              // 1/s
  Driver driver{};                             // which contact or link, how, its share
  std::vector<std::complex<double>> values{};  // 1/s, upper half
  std::vector<StableStep> steps{};
  double own_growth = 0;    // 1/s, see Standing
  EnergyBalance balance{};  // at its own step, by its own method
  OperatingPoint point{};   // the fastest part at its own step
  bool of_the_paper() const { return name.starts_with("scene "); }
};

// All of them, or in the quick form those without a bed.
void measure_standing_scenes(Measurement& measurement);

std::vector<StandingScene> standing_scenes(const Numbers& numbers);

}  // namespace furrow::verification
