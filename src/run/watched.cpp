// What each watch over a run has seen, and what it says of it.
#include <algorithm>
#include <array>

#include "run/validity.h"

namespace furrow {

const char* to_string(Verdict verdict) {
  constexpr std::array names{"not watched", "kept", "allowed", "warned", "broken"};
  return names[static_cast<std::size_t>(verdict)];
}

Verdict Watched::verdict() const {
  if (!watched) return Verdict::not_watched;
  if (worst <= warns_above) return Verdict::kept;
  if (allowed && worst <= *allowed) return Verdict::allowed;
  return worst > std::max(ends_above, allowed.value_or(0)) ? Verdict::broken : Verdict::warned;
}

std::optional<double> allowed_by(const Scene& scene, WatchKind kind) {
  if (!scene.allow) return {};
  const Allow& a = *scene.allow;
  const auto any = [](bool is) { return is ? std::optional(infinity) : std::nullopt; };
  switch (kind) {
    case WatchKind::energy_made:
      return a.energy_made;
    case WatchKind::energy_lost:
      return a.energy_lost;
    case WatchKind::overlap:
      return a.overlap;
    case WatchKind::behind_walls:
      return any(a.behind_walls);
    case WatchKind::through_plates:
      return any(a.through_plates);
    case WatchKind::through_lattices:
      return any(a.through_lattices);
    case WatchKind::crossing_lattices:
      return any(a.crossing_lattices.value_or(false));
    case WatchKind::step:
      return a.step;
    default:
      return {};
  }
}

void Watched::history(HistoryVisitor& visit) {
  visit("worst", worst);
  visit("time", time);
  visit("where", where);
  visit("times", times);
}

void RunExtremes::history(HistoryVisitor& visit) {
  visit.list("plates", plate, [&](PlateForce& p) {
    visit("force", p.force);
    visit("fx", p.fx);
    visit("fy", p.fy);
    visit("time", p.time);
  });
  visit("speed", speed);
  visit("speed time", speed_time);
  visit("fastest", fastest);
}

}  // namespace furrow
