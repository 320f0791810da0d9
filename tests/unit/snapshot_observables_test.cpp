// Snapshots made by hand: few discs and links, numbers that can be added up by hand.
#include "validation/page/snapshot_observables.h"

#include <gtest/gtest.h>

#include <cmath>

namespace furrow {
using namespace validation;
namespace {

struct DiscRow {
  double x, y, stress;
};

Frame frame(const std::vector<DiscRow>& discs, const std::vector<std::array<double, 4>>& links = {},
            double plate_left = 0.3) {
  std::vector<std::vector<double>> disc(4), link(4);
  for (const DiscRow& d : discs) {
    disc[0].push_back(d.x), disc[1].push_back(d.y), disc[2].push_back(0.01), disc[3].push_back(d.stress);
  }
  for (const auto& l : links) {
    for (std::size_t k = 0; k < 4; ++k) link[k].push_back(l[k]);
  }
  return {.discs = Table({"x [m]", "y [m]", "radius [m]", "von Mises [Pa]"}, disc),
          .links = Table({"x1 [m]", "y1 [m]", "x2 [m]", "y2 [m]"}, link),
          .plates = Table({"left [m]", "lower [m]", "width [m]", "height [m]"}, {{plate_left}, {0.05}, {0.01}, {0.1}})};
}

RunRecord run_with(const Frame& first, const Frame& last) {
  RunRecord run;
  run.frames = {first, last};
  return run;
}

double seen(const RunRecord& run, const std::string& name) { return measure_snapshots(run, name).value().value; }

const Frame first = frame({{0.01, 0.01, 300}, {0.05, 0.01, 100}, {0.3, 0.01, 100}, {0.59, 0.01, 100}, {0.3, 0.09, 50}});
const Frame last = frame({{0.01, 0.01, 100}, {0.05, 0.01, 100}, {0.1, 0.03, 100}, {0.59, 0.01, 300}, {0.5, 0.13, 50}});

TEST(SnapshotObservables, HighestDiscRises) { EXPECT_NEAR(seen(run_with(first, last), "pile_up"), 40, 1e-9); }

TEST(SnapshotObservables, OutlineBehindThePlateIsMeasuredFromItsLowerEdge) {
  // Columns about 0, 0.04 or 0.06 and 0.1 m have their tops at 0.02, 0.02 and 0.04 m; the edge is at 0.05 m.
  EXPECT_NEAR(seen(run_with(first, last), "depth_left_behind"), 1e3 * (0.08 / 3 - 0.05), 1e-9);
}

TEST(SnapshotObservables, StressesAreMeansOverTheirRegion) {
  const RunRecord run = run_with(first, last);
  EXPECT_NEAR(seen(run, "right_wall_stress"), 3, 1e-12);
  EXPECT_NEAR(seen(run, "corner_stress"), 200.0 / 150, 1e-12);
  EXPECT_NEAR(seen(run, "corner_relief"), 0.5, 1e-12);
}

TEST(SnapshotObservables, LatticeIsFollowedByTheEndsOfItsLinks) {
  const std::vector<DiscRow> discs{{0.32, 0.01, 100}, {0.5, 0.01, 900}};
  const RunRecord run =
      run_with(frame(discs, {{0.3, 0, 0.3, 0.01}, {0.3, 0.01, 0.31, 0.02}}),
               frame({{0.32, 0.01, 150}, {0.5, 0.01, 10}}, {{0.3, 0, 0.3, 0.01}, {0.3, 0.01, 0.4, 0.02}}));
  EXPECT_NEAR(seen(run, "stress_at_lattice"), 1.5, 1e-12);
  EXPECT_NEAR(seen(run, "upper_part_moved"), 90, 1e-9);
  EXPECT_NEAR(seen(run, "lower_part_moved"), 0, 1e-9);
}

TEST(SnapshotObservables, RunThatStoppedEarlyDoesNotSay) {
  RunRecord run = run_with(first, last);
  run.scene.output.frames = {0, 1, 2};
  EXPECT_TRUE(std::isnan(seen(run, "pile_up")));
  EXPECT_FALSE(measure_snapshots(run, "no_such_thing").has_value());
}

}  // namespace
}  // namespace furrow
