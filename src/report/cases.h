// The scenes on which methods are compared, each ready to be run again and again from the same start.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "run/prepare.h"

namespace furrow {

// Every step divides the interval between samples, so that all methods are looked at at the same times.
struct Span {
  double start = 0;     // s
  double interval = 0;  // s
  int samples = 0;      // after the start
  double end() const { return start + interval * samples; }
};

struct Case {
  System system;
  State y;  // at the start
  Span span;
};

// What is known of a case before it is made.
struct CaseInfo {
  std::string name, title;
  Span span{};
  double coarsest = 0, finest = 0;  // s, of the steps tried with fixed-step methods
  int phases = 3;                   // runs with neighbouring steps, whose errors are averaged
  bool by_force = false;            // judged by the force on the plate, else by the positions at the end
  double reference_step = 0;        // s, of rk4
  Locate reference_locate = Locate::tears;
  double other_step = 0;  // s, of the other reference, the longest one if it is controlled
  std::string other = "odeint_dopri5";
  std::vector<Locate> locate{Locate::none};  // every method is tried with each
  double nudge_end = 0;                      // s, how long the scene is watched for its predictability
  bool big = false;                          // seconds a run: left out of the quick form
  std::function<Scene()> scene;
};

const std::vector<CaseInfo>& cases();

// Without the energy ledger, which not every method is right to be charged for. A bed settles, which takes seconds; a
// span that starts later begins where the paper's method, with half the paper's step, has brought the scene.
Case make_case(const CaseInfo& info);

// The scene file of that name in validation/scenes.
Scene scene_file(const std::string& name);

// Makes a case when first asked for it, once, whoever asks.
class LazyCase {
 public:
  explicit LazyCase(CaseInfo info) : info_(std::move(info)) {}
  const Case& get() {
    std::call_once(once_, [this] { case_ = std::make_unique<Case>(make_case(info_)); });
    return *case_;
  }

 private:
  CaseInfo info_;
  std::once_flag once_;
  std::unique_ptr<Case> case_;
};

}  // namespace furrow
