#include "export/deck_run.h"

#include <algorithm>
#include <cmath>

#include "export/export.h"
#include "export/kinds.h"

namespace furrow {
namespace {

std::string named(const char* what, int refine) { return what + ("." + std::to_string(refine)) + ".txt"; }

}  // namespace

std::string forces_file(int refine) { return named("force", refine); }
std::string ends_file(int refine) { return named("end", refine); }
std::string links_file(int refine) { return named("links", refine); }
std::string tears_file(int refine) { return named("torn", refine); }

int refine_of(const std::string& name) {
  const auto digit = std::find_if(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
  int refine = 0;
  for (auto at = digit; at != name.end() && *at >= '0' && *at <= '9' && refine < most_refine; ++at)
    refine = 10 * refine + (*at - '0');
  if (refine == 0) return 0;
  for (const auto file : {forces_file, ends_file, links_file, tears_file}) {
    if (name == file(refine)) return refine;
  }
  return 0;
}

DeckRun deck_run(const Prepared& prepared) {
  const Scene& scene = prepared.scene;
  const Parts& parts = prepared.system.parts();
  DeckRun run;
  run.step = scene.time.step;
  run.every = std::max(1L, std::lround(scene.output.interval / scene.time.step));
  run.steps = std::lround(scene.time.end / scene.time.step);
  run.parts = parts.plate.size() + parts.wall.size();
  run.bodies = parts.disc.count() > 0 ? parts.disc.count() : parts.node.count();
  if (parts.disc.count() > 0) return run;
  const AtomKinds kinds = atom_kinds(parts);
  for (const auto& [link, kind] : kinds.bonds) {
    run.bonds[{parts.link.a[link] + 1, parts.link.b[link] + 1}] = link;
    run.tears = run.tears || can_tear(kinds.bond[static_cast<std::size_t>(kind)]);
  }
  return run;
}

}  // namespace furrow
