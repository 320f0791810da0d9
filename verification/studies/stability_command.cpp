// How long a step each method may take in a scene where it stands.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "methods/method.h"
#include "program/commands.h"
#include "program/method_name.h"
#include "program/progress.h"
#include "program/signals.h"
#include "program/usage.h"
#include "scene/interrupt.h"
#include "scene/read.h"
#include "scene/wording.h"
#include "verification/commands.h"
#include "verification/studies/scene_stability.h"

namespace furrow::verification {
namespace {

struct StabilityOptions {
  std::string scene;
  std::vector<std::string> methods;  // none: all that step by themselves
  double at = 0;                     // s
};

std::string seconds(double step) {
  if (std::isnan(step)) return "not known";
  if (std::isinf(step)) return "any";
  return rounded(step, 3);
}

const char* verdict(const StableStep& step, double own) {
  if (!(own < step.measured)) return "UNSTABLE";
  return own < step.slow || std::isnan(step.slow) ? "stable" : "grows slowly";
}

std::string energy_words(const EnergyBalance& balance) {
  if (!balance.diverged.empty()) return "diverged: " + balance.diverged;
  if (std::isnan(balance.made())) return "nothing happens in them";
  char text[64];
  std::snprintf(text, sizeof text, "energy %+.2g %%", 100 * balance.made());
  return text;
}

void print_standing(const StabilityOptions& options, const Scene& scene, const Standing& s) {
  std::printf("%s\n%s\n\nat t = %g s %td numbers act\n", options.scene.c_str(), scene.title.c_str(), s.t,
              static_cast<std::ptrdiff_t>(s.linearised.acting.size()));
  if (s.fastest == 0.0) {
    std::printf("nothing acts on anything here: try --at with a later time\n");
    return;
  }
  std::printf("fastest motion   lambda = %.4g %+.4g i 1/s\ndriven by        %s (%s), %.0f %% of its power\n",
              s.fastest.real(), std::fabs(s.fastest.imag()), s.driver.name.c_str(), s.driver.how.c_str(),
              100 * s.driver.share);
}

constexpr const char* own_step = " chooses its own step: it has no largest stable one";

void refuse_if_none_has_a_limit(const std::vector<std::string>& methods) {
  const auto controlled = [](const std::string& method) { return make_method(method)->info().controlled; };
  if (!methods.empty() && std::count_if(methods.begin(), methods.end(), controlled) == std::ssize(methods))
    throw std::invalid_argument(methods.front() + own_step);
}

// One method alone is refused, one of several is skipped.
std::string reason_to_skip(const MethodInfo& info, const System& system, std::size_t wanted) {
  if (info.controlled) return info.name + own_step;
  std::string why = refusal(info, system);
  if (wanted == 1 && !why.empty()) throw std::invalid_argument(why);
  return why;
}

int stability_command(const StabilityOptions& options) {
  for (const std::string& method : options.methods) require_method("--method", method);
  refuse_if_none_has_a_limit(options.methods);
  const Scene scene = requested_scene({.scene = options.scene});
  if (!(options.at >= 0 && options.at <= scene.time.end))
    throw std::invalid_argument("--at: must be from 0 to the end of the run, " + shortest(scene.time.end) + " s");
  Progress progress;
  progress.begin(options.scene, "preparing");
  const Standing s = standing_at(scene, options.at, [&](double done, double total) {
    return progress.show(options.scene, "running", done, total);
  });
  progress.end();
  print_standing(options, scene, s);
  const double own = scene.time.step;
  std::printf("\n%-28s %10s %10s   %s\n", "largest stable step [s]", "predicted", "measured",
              ("the next 200 steps of " + seconds(own) + " s").c_str());
  for (const MethodInfo& info : method_catalogue()) {
    const auto& wanted = options.methods;
    const bool named = std::find(wanted.begin(), wanted.end(), info.name) != wanted.end();
    if ((!named && !wanted.empty()) || (!named && !has_stable_step(s, info))) continue;
    if (const std::string why = named ? reason_to_skip(info, s.system, wanted.size()) : ""; !why.empty()) {
      std::printf("%-28s skipped: %s\n", info.name.c_str(), why.c_str());
      continue;
    }
    throw_if_interrupted();
    progress.begin(options.scene, "measuring " + info.name);
    const StableStep step = stable_step(s, info.name);
    const EnergyBalance balance = run_on(s, info.name, own);
    progress.end();
    std::printf("%-28s %10s %10s   ", info.name.c_str(), seconds(step.slow).c_str(), seconds(step.measured).c_str());
    std::printf("%s; %s\n", verdict(step, own), energy_words(balance).c_str());
    flush_standard_output();
  }
  std::printf(
      "\npredicted  from the amplification factor over the spectrum, growth of more than 1e-5 a step, as furrow "
      "explain\n"
      "           judges by; it takes the whole scene, explain one body with its neighbours held\n"
      "measured   above it small changes grow by more than 1e-3 a step, by the method itself, time held still\n"
      "energy     what the method makes (+) or loses (-) of the energy that the scene has and is given\n");
  return good;
}

}  // namespace

void add_stability_command(CLI::App& app, std::vector<Command>& all) {
  static StabilityOptions standing;
  auto* stability = app.add_subcommand("stability", "how long a step each method may take in a scene where it stands");
  show_examples(stability, {"furrow stability validation/scenes/cantilever.toml --method pece --method rk4",
                            "furrow stability validation/scenes/scenario_1.toml --at 0.4 --method pece"});
  stability->add_option("scene", standing.scene, "scene file (TOML)")->required()->type_name("");
  stability->add_option("--method", standing.methods, "methods (default: all that take a fixed step)")
      ->type_name("NAME");
  stability->add_option("--at", standing.at, "when in the run (default: its start)")
      ->check(moment())
      ->type_name("SECONDS");
  all.push_back({stability, [] { return stability_command(standing); }});
}

}  // namespace furrow::verification
