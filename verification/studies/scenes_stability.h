// The scenes of validation/scenes in the study of stability: their spectra and the steps that they allow.
#pragma once

#include "verification/studies/atlas.h"
#include "verification/studies/scene_stability.h"

namespace furrow::verification {

// What is kept of a scene at a moment.
struct StandingScene {
  std::string name;     // "scene 2, spheres"
  double t = 0;         // s
  double own_step = 0;  // s
  int numbers = 0;
  std::complex<double> fastest{};            // 1/s
  std::string driver;                        // which contact or link, how, its share
  std::vector<std::complex<double>> values;  // 1/s, upper half
  std::vector<StableStep> steps;
  double own_growth = 0;   // 1/s, see Standing
  EnergyBalance balance;   // at its own step, by its own method
  OperatingPoint point{};  // the fastest part at its own step
};

// All of them, or in the quick form those without a bed.
std::vector<StandingScene> standing_scenes(const Settings& settings);

void report_scenes(Report& report, const std::vector<StandingScene>& scenes);

}  // namespace furrow::verification
