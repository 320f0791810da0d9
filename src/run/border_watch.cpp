#include "run/border_watch.h"

#include <algorithm>
#include <cmath>

#include "run/crossing.h"
#include "scene/border.h"

namespace furrow {
namespace {

constexpr double steps_ahead = 64;  // for which pairs are collected

struct Standing {
  int segment;
  Vec2 a, b;
  Box box;
};

double low(const Box& box, bool upright) { return upright ? box.lower : box.left; }

// Two pieces that are further apart than two links, where one has torn, have no border between them.
bool is_wide_open(const System& system, int link, const Standing& one) {
  return link >= 0 && system.torn(link) &&
         std::hypot(one.b.x - one.a.x, one.b.y - one.a.y) > 2 * system.parts().link.rest[link];
}

// Of the segments that discs touch, or did before they tore, sorted along the axis on which they are spread more.
struct StandingBorder {
  std::vector<Standing> segments;
  Box all;
  bool upright = false;
  double widest = 0;  // m, along that axis

  StandingBorder(const System& system, double t, const State& y) {
    const BorderArrays& border = system.parts().border;
    for (const int s : system.border()) {
      if (border.a[s] == border.b[s]) continue;
      Standing one{s, node_place(system, t, y, border.a[s]), node_place(system, t, y, border.b[s]), {}};
      if (is_wide_open(system, border.link[s], one)) continue;
      for (const Vec2 end : {one.a, one.b}) one.box.add(end), all.add(end);
      segments.push_back(one);
    }
    upright = all.upper - all.lower > all.right - all.left;
    for (const Standing& s : segments)
      widest = std::max(widest, upright ? s.box.upper - s.box.lower : s.box.right - s.box.left);
    std::sort(segments.begin(), segments.end(), [this](const Standing& p, const Standing& q) {
      const double one = low(p.box, upright), other = low(q.box, upright);
      return one < other || (one == other && p.segment < q.segment);
    });
  }

  template <class Visit>
  void for_each_near(Vec2 p, double reach, const Visit& visit) const {
    if (!all.holds(p, reach)) return;
    const double place = upright ? p.y : p.x;
    auto s = std::lower_bound(segments.begin(), segments.end(), place - reach - widest,
                              [this](const Standing& one, double bound) { return low(one.box, upright) < bound; });
    for (; s != segments.end() && low(s->box, upright) <= place + reach; ++s) {
      if (!s->box.holds(p, reach)) continue;
      if (nearest_on_segment(p, s->a, s->b, 0).distance2 <= reach * reach) visit(s->segment);
    }
  }
};

}  // namespace

std::string through_torn_border(const System& system, const ContactId& contact) {
  return contact_name(system.parts(), contact) + ", through its torn border";
}

BorderWatch::BorderWatch(const System& system) : system_(system) {
  const Parts& parts = system.parts();
  for (const DrivePart& d : parts.drive) drive_speed_ = std::max(drive_speed_, std::hypot(d.vx, d.vy));
  if (parts.disc.count() > 0) least_reach_ = *std::min_element(parts.disc.radius.begin(), parts.disc.radius.end()) / 8;
}

const std::vector<ContactId>& BorderWatch::crossings(const Step& step, bool border_is_new) {
  crossed_.clear();
  through_torn_.clear();
  if (system_.border().empty() || system_.parts().disc.count() == 0 || !(step.h > 0)) return crossed_;
  constexpr double rounded_up = 1 + 1e-6;
  const double closer = 2 * rounded_up * std::max(std::sqrt(step.motion.moved_squared), drive_speed_ * step.h);
  if (!collected_ || border_is_new || way_ + closer > reach_) {
    reach_ = std::max(steps_ahead * closer, least_reach_);
    way_ = 0;
    collect(step.t - step.h, step.before);
  }
  way_ += closer;
  const std::vector<int>& lattice = system_.parts().border.lattice;
  for (const Pair& pair : near_) {
    const ContactId contact{disc_lattice, pair.disc, lattice[pair.segment]};
    const auto same = [&](const ContactId& c) { return c.a == contact.a && c.b == contact.b; };
    const int link = system_.parts().border.link[pair.segment];
    std::vector<ContactId>& found = link >= 0 && system_.torn(link) ? through_torn_ : crossed_;
    if (std::any_of(found.begin(), found.end(), same)) continue;
    if (crosses_segment(system_, step, path_of_body(system_, step, pair.disc), pair.segment)) found.push_back(contact);
  }
  return crossed_;
}

void BorderWatch::collect(double t, const State& y) {
  collected_ = true;
  near_.clear();
  const StandingBorder border(system_, t, y);
  for (int i = 0; i < system_.parts().disc.count(); ++i)
    border.for_each_near(body_place(system_, y, i), reach_, [&](int segment) { near_.push_back({i, segment}); });
  std::sort(near_.begin(), near_.end());
}

}  // namespace furrow
