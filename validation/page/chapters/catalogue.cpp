#include "benchmarks/studies/need.h"
#include "benchmarks/studies/speed.h"
#include "benchmarks/studies/work_precision.h"
#include "validation/page/chapters/chapters.h"
#include "validation/studies/convergence.h"
#include "validation/studies/ensemble.h"
#include "validation/studies/geometry.h"
#include "validation/studies/outlook.h"
#include "validation/studies/reading_search.h"
#include "validation/studies/statements.h"
#include "verification/studies/order.h"
#include "verification/studies/published.h"
#include "verification/studies/responses.h"
#include "verification/studies/stability.h"

namespace furrow::validation {
namespace {

// What defines the numbers that the paper reports.
const std::vector<std::string> observing{"validation/page/observables.",
                                         "validation/page/sentence_observables.",
                                         "validation/page/snapshot_observables.",
                                         "validation/page/run_record.",
                                         "validation/page/table.",
                                         "validation/studies/observed_run.",
                                         "src/output/first_touch.",
                                         "src/output/schedule."};

std::vector<std::string> and_observing(std::vector<std::string> own) {
  own.insert(own.end(), observing.begin(), observing.end());
  return own;
}

// Of whole runs of the paper's scenes, one for each packing.
std::vector<std::string> and_members(const std::string& own) {
  return and_observing({own, "validation/studies/beds.", "validation/studies/members."});
}

// The search goes where the verdicts on what it has send it.
std::vector<std::string> of_readings() {
  std::vector<std::string> files = and_members("validation/studies/reading");
  for (const char* other : {"validation/studies/once.", "validation/studies/sentences.", "validation/studies/verdict.",
                            "validation/calibration/key_path.", "validation/calibration/varied_key."})
    files.emplace_back(other);
  return files;
}

std::vector<std::string> of_verification(const std::vector<std::string>& own, const std::vector<std::string>& others) {
  std::vector<std::string> files{"verification/studies/kept_numbers."};
  for (const std::string& file : own) files.push_back("verification/studies/" + file);
  files.insert(files.end(), others.begin(), others.end());
  return files;
}

}  // namespace

const std::vector<Study>& catalogue() {
  static const std::vector<Study> all{
      {.name = "order",
       .what = "observed order of each method on each kind of force",
       .files = of_verification({"order.", "order_contacts.", "order_cure.", "order_friction.", "order_hertz.",
                                 "order_observed.", "order_predicted.", "order_problems.", "order_reference.",
                                 "order_springs.", "order_trends.", "published_schemes."},
                                {"verification/damped_hertz."}),
       .measure = verification::measure_order,
       .chapter = order},
      {.name = "responses",
       .what = "one contact, one spring, one bent lattice beside closed forms; published impacts",
       .files =
           of_verification({"algebra.", "responses."},
                           {"verification/oblique_", "verification/bare_lattice.", "verification/cantilever_scenes.",
                            "verification/damped_hertz.", "verification/hertz_law.", "verification/own_lattice.",
                            "verification/round_body.", "verification/running."}),
       .measure = verification::measure_responses,
       .chapter = responses},
      {.name = "published",
       .what = "every method on published problems that have nothing to do with contacts",
       .files = of_verification(
           {"published", "order_observed.", "order_predicted.", "order_problems.", "order_reference."}, {}),
       .measure = verification::measure_published,
       .chapter = published},
      {.name = "stability",
       .what = "where methods fail: stable steps by theory, and the solver's own blow-up",
       .files = of_verification(
           {"stability.", "scene_stability.", "scenes_stability.", "atlas.", "blow_up.", "growth.", "amplification."},
           {"src/report/cases.", "src/report/linearise."}),
       .measure = verification::measure_stability,
       .chapter = stability},
      {.name = "work_precision",
       .what = "error against evaluations and CPU time, every method on every scene",
       .files = {"benchmarks/studies/work_precision", "benchmarks/studies/reference.",
                 "benchmarks/studies/measured_run.", "src/output/schedule.", "src/report/cases.",
                 "src/report/linearise."},
       .measure = benchmarks::measure_work_precision,
       .chapter = work_precision},
      {.name = "need",
       .what = "terms of the model that a scene could do without",
       .files = {"benchmarks/studies/need", "benchmarks/studies/measured_run.", "src/output/schedule.",
                 "src/report/cases.", "src/scene/strip."},
       .measure = benchmarks::measure_need,
       .chapter = need},
      {.name = "geometry",
       .what = "which lattice and plate come closest to the paper's first scene",
       .files = and_observing({"validation/studies/geometry."}),
       .measure = measure_geometry,
       .chapter = geometry},
      {.name = "convergence",
       .what = "which of the paper's numbers do not depend on the time step",
       .files = and_observing({"validation/studies/convergence.", "validation/studies/beds."}),
       .measure = measure_convergence,
       .chapter = convergence,
       .watched = true},
      {.name = "ensemble",
       .what = "the paper's numbers over many packings of the bed",
       .files = and_members("validation/studies/ensemble."),
       .measure = measure_ensemble,
       .chapter = ensemble},
      {.name = "statements",
       .what = "the paper, sentence by sentence; gaps and misprints tried both ways",
       .files = and_members("validation/studies/statements."),
       .reads = {"ensemble", "convergence", "readings"},
       .measure = measure_statements,
       .chapter = statements},
      {.name = "readings",
       .what = "every reading of what the paper leaves open, and every sentence judged",
       .files = of_readings(),
       .measure = measure_readings,
       .chapter = readings_of_the_paper,
       .watched = true},
      {.name = "outlook",
       .what = "what the paper leaves to later: speed, sizes, stiffness, damping, friction, a tool that bends",
       .files = and_members("validation/studies/outlook"),
       .measure = measure_outlook,
       .chapter = outlook},
      {.name = "speed",
       .what = "what scripts/rivals and scripts/track have measured, put together for the page",
       .measure = benchmarks::measure_speed,
       .chapter = speed,
       .made_by = "scripts/rivals, track, scale and beyond"},
  };
  return all;
}

}  // namespace furrow::validation
