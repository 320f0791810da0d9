// Counts and bytes of a scene, known before any work begins, each against a stated limit.
#include <string>
#include <vector>

#include "scene/findings.h"
#include "scene/wording.h"

namespace furrow {
namespace {

constexpr double most_steps = 1e10;         // a day and more for the smallest scene
constexpr double most_rows = 1e8;           // of one file
constexpr double most_bytes = 16e9;         // of memory
constexpr double most_frame_bytes = 1e12;   // on disk
constexpr double bytes_of_a_body = 1000;    // with its contacts, links and what a method keeps of it
constexpr double bytes_of_a_picture = 350;  // of one disc, node or link, in both forms
constexpr double links_of_a_node = 6;
constexpr std::size_t most_materials = 1000;  // each pair of them has a contact law

using Paths = std::vector<std::string>;

void judge_count(Findings& found, const std::string& path, const std::string& what, double count, double most,
                 const std::string& unit, const Paths& others) {
  if (!(count <= most))
    found.refuse(path, what + " = " + rounded(count, 3) + ' ' + unit + "; at most " + shortest(most), others);
}

double discs_of(const Scene& scene) {
  auto discs = static_cast<double>(scene.disc.size());
  for (const Packing& p : scene.packing) discs += p.count;
  return discs;
}

void judge_times(const Scene& scene, Findings& found) {
  const Timing& time = scene.time;
  judge_count(found, "time.step", "time.end / time.step", time.end / time.step, most_steps, "steps", {"time.end"});
  judge_count(found, "output.interval", "time.end / output.interval", time.end / scene.output.interval, most_rows,
              "rows", {"time.end"});
  if (!scene.settle) return;
  const double step = scene.settle->step.value_or(time.step);
  judge_count(found, "settle.limit", "settle.limit over the step of settling", scene.settle->limit / step, most_steps,
              "steps", {"settle.step", "time.step"});
  if (step > scene.settle->limit)
    found.error("settle.limit", "shorter than the step of settling, " + shortest(step) + " s",
                {"settle.step", "time.step"});
  if (scene.settle->hold > scene.settle->limit)
    found.error("settle.hold", "longer than settle.limit, " + shortest(scene.settle->limit) + " s", {"settle.limit"});
}

}  // namespace

void judge_sizes(const Scene& scene, Findings& found) {
  judge_times(scene, found);
  double bodies = discs_of(scene), nodes = 0;
  for (std::size_t i = 0; i < scene.lattice.size(); ++i) {
    const Lattice& l = scene.lattice[i];
    const double here = static_cast<double>(l.rows) * l.columns;
    judge_count(found, item("lattice", i), "rows times columns", here, most_bytes / bytes_of_a_body,
                "nodes of " + shortest(bytes_of_a_body) + " bytes", {});
    nodes += here;
  }
  bodies += nodes;
  judge_count(found, "", "memory for " + shortest(bodies) + " discs and nodes", bodies * bytes_of_a_body, most_bytes,
              "bytes", {});
  const double pictured = bodies + links_of_a_node * nodes;
  judge_count(found, "output.frames", std::to_string(scene.output.frames.size()) + " pictures",
              static_cast<double>(scene.output.frames.size()) * pictured * bytes_of_a_picture, most_frame_bytes,
              "bytes", {"packing", "lattice", "disc"});
  judge_count(found, "material", "materials", static_cast<double>(scene.material.size()),
              static_cast<double>(most_materials), "of them", {});
}

}  // namespace furrow
