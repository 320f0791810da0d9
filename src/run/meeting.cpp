#include "run/meeting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "run/crossing.h"
#include "run/path.h"
#include "scene/border.h"
#include "scene/wording.h"

namespace furrow {
namespace {

constexpr double rounding = 1e-9, deeper = 0.1;  // of the smaller size

Path operator-(const Path& a, const Path& b) { return {a.from - b.from, a.to - b.to}; }

// m, how deep two parts are in each other: at the start of the step, at its end, and at most on the way. Negative: apart.
struct Depths {
  double start, end, most;
};

// How deep a point is in a moving segment, less `reach`, when this share of the step is over.
double depth_at(const Path& to_a, const Path& to_b, bool torn, double share) {
  const Vec2 a = at(to_a, share), b = at(to_b, share);
  return -std::sqrt((torn ? nearest_end({0, 0}, a, b) : nearest_on_segment({0, 0}, a, b, 0)).distance2);
}

// A disc, or a segment of a border, with what surrounds its way.
struct Swept {
  Box box;
  double low, high;  // of the box, along the axis that is swept
  int index;
};

class Meetings {
 public:
  Meetings(const System& system, const Step& step) : system_(system), parts_(system.parts()), step_(step) {
    for (int n = 0; n < parts_.node.count(); ++n)
      node_.push_back({node_place(system, step.t - step.h, step.before, n), node_place(system, step.t, step.after, n)});
  }

  const Unseen& find() {
    along_links();
    for (int i = 0; i < parts_.disc.count() && none(); ++i) at_what_is_flat({disc_wall, i, -1}, {disc_plate, i, -1});
    for (int n = 0; n < parts_.node.count() && none(); ++n)
      if (parts_.node.body[n] >= 0) at_what_is_flat({node_wall, n, -1}, {node_plate, n, -1});
    if (none() && parts_.disc.count() > 0) between_discs_and_borders();
    return found_;
  }

 private:
  bool none() const { return found_.what.empty(); }
  Path disc(int i) const { return path_of_body(system_, step_, i); }

  void judge(const ContactId& pair, const Depths& d, const char* size, double metres) {
    if (!none()) return;
    Sentence text;
    const double ends = std::max({d.start, d.end, 0.0}), moved = std::fabs(d.end - d.start);
    if (d.start > rounding * metres && moved > metres) {
      text << contact_name(parts_, pair) << " touched, and moved " << moved << " m against each other in one step of "
           << step_.h << " s, more than " << size << ", " << metres << " m: take a shorter step";
    } else if (d.most > ends + deeper * metres) {
      text << contact_name(parts_, pair) << " met within one step of " << step_.h << " s, " << d.most
           << " m deep, and are " << (ends > 0 ? "less" : "not") << " in each other at its ends: take a shorter step";
    }
    found_ = {text.str(), of_disc(pair.kind) ? pair.a : parts_.node.body[pair.a]};
  }

  // Nodes are points: they touch a wall or plate where they are on it.
  void at_what_is_flat(ContactId at_wall, ContactId at_plate) {
    const int i = at_wall.a;
    const bool is_disc = of_disc(at_wall.kind);
    const Path path = is_disc ? disc(i) : node_[i];
    const double reach = is_disc ? parts_.disc.radius[i] : 0;
    const double metres = is_disc ? parts_.disc.radius[i] : parts_.node.spacing[i];
    const char* size = is_disc ? "the disc's radius" : "the lattice's spacing";
    for (at_wall.b = 0; at_wall.b < static_cast<int>(parts_.wall.size()); ++at_wall.b) {
      const WallPart& w = parts_.wall[at_wall.b];
      const auto depth = [&](Vec2 p) { return reach - nearest_on_wall(p, {w.px, w.py}, {w.nx, w.ny}).distance; };
      const double start = depth(path.from), end = depth(path.to);
      judge(at_wall, {start, end, std::max(start, end)}, size, metres);
    }
    for (at_plate.b = 0; at_plate.b < static_cast<int>(parts_.plate.size()); ++at_plate.b) {
      const Path seen = path_from_plate(system_, step_, at_plate.b, path);
      const PlatePart& p = parts_.plate[at_plate.b];
      if (!meets_box(seen, 0.5 * p.width + reach, 0.5 * p.height + reach)) continue;
      judge(at_plate, in_rectangle(seen, 0.5 * p.width, 0.5 * p.height, reach), size, metres);
    }
  }

  // The distance to a convex figure is a convex function along a line: thirds close in on its least.
  static Depths in_rectangle(const Path& path, double half_width, double half_height, double reach) {
    const Rectangle box{-half_width, half_width, -half_height, half_height};
    const auto depth = [&](double share) { return reach - nearest_on_rectangle(at(path, share), box).distance; };
    double low = 0, high = 1;
    for (int k = 0; k < 80; ++k) {
      const double one = low + (high - low) / 3, other = high - (high - low) / 3;
      if (depth(one) < depth(other))
        low = one;
      else
        high = other;
    }
    return {depth(0), depth(1), depth(0.5 * (low + high))};
  }

  void along_links() {
    const LinkArrays& link = parts_.link;
    for (int k = 0; k < link.count() && none(); ++k) {
      const int a = link.a[k], b = link.b[k];
      const double moved = length(node_[a] - node_[b]), spacing = parts_.node.spacing[a];
      if (system_.torn(k) || !(moved > spacing)) continue;
      Sentence text;
      text << parts_.node_name(a) << " and " << parts_.node_name(b) << " moved " << moved
           << " m against each other in one step of " << step_.h << " s, more than the lattice's spacing, " << spacing
           << " m: take a shorter step";
      found_ = {text.str(), std::max(parts_.node.body[a], parts_.node.body[b])};
    }
  }

  // Pairs whose boxes meet, as seen from the mean motion, along the axis on which the boxes are shorter.
  void between_discs_and_borders() {
    std::vector<Swept> discs, segments;
    const Vec2 drift = mean_motion();
    const auto surround = [&](Box& box, const Path& path, double margin) {
      for (const Vec2 p : {path.from, path.to - drift}) {
        box.add({p.x - margin, p.y - margin});
        box.add({p.x + margin, p.y + margin});
      }
    };
    for (int i = 0; i < parts_.disc.count(); ++i) {
      discs.push_back({{}, 0, 0, i});
      surround(discs.back().box, disc(i), parts_.disc.radius[i]);
    }
    for (const int segment : system_.border()) {
      segments.push_back({{}, 0, 0, segment});
      for (const int n : {parts_.border.a[segment], parts_.border.b[segment]})
        surround(segments.back().box, node_[n], 0);
    }
    sweep(discs, segments);
    for (std::size_t i = 0; i < discs.size() && none(); ++i) {
      for (std::size_t k = i + 1; k < discs.size() && discs[k].low <= discs[i].high && none(); ++k)
        if (discs[i].box.meets(discs[k].box))
          two_discs(std::min(discs[i].index, discs[k].index), std::max(discs[i].index, discs[k].index));
    }
    double widest = 0;
    for (const Swept& s : segments) widest = std::max(widest, s.high - s.low);
    for (const Swept& d : discs) {
      auto s = std::lower_bound(segments.begin(), segments.end(), d.low - widest,
                                [](const Swept& one, double low) { return one.low < low; });
      for (; s != segments.end() && s->low <= d.high && none(); ++s)
        if (d.box.meets(s->box)) disc_and_border(d.index, s->index);
    }
  }

  // Sorts both along the axis on which boxes are short beside the whole.
  static void sweep(std::vector<Swept>& discs, std::vector<Swept>& segments) {
    Box all;
    double wide = 0, high = 0;
    for (const auto* some : {&discs, &segments}) {
      for (const Swept& s : *some) {
        all.add({s.box.left, s.box.lower});
        all.add({s.box.right, s.box.upper});
        wide += s.box.right - s.box.left;
        high += s.box.upper - s.box.lower;
      }
    }
    const bool upright = high * (all.right - all.left) < wide * (all.upper - all.lower);
    for (auto* some : {&discs, &segments}) {
      for (Swept& s : *some) {
        s.low = upright ? s.box.lower : s.box.left;
        s.high = upright ? s.box.upper : s.box.right;
      }
      std::stable_sort(some->begin(), some->end(), [](const Swept& p, const Swept& q) { return p.low < q.low; });
    }
  }

  Vec2 mean_motion() const {
    Vec2 mean;
    const int bodies = parts_.bodies();
    for (int i = 0; i < bodies; ++i) {
      const Path path = path_of_body(system_, step_, i);
      mean.x += (path.to.x - path.from.x) / bodies;
      mean.y += (path.to.y - path.from.y) / bodies;
    }
    return mean;
  }

  void two_discs(int a, int b) {
    const Path way = disc(a) - disc(b);
    const double reach = parts_.disc.radius[a] + parts_.disc.radius[b];
    const auto depth = [&](Vec2 p) { return reach - std::hypot(p.x, p.y); };
    judge({disc_disc, a, b}, {depth(way.from), depth(way.to), depth(at(way, nearest_share(way)))}, "the smaller radius",
          std::min(parts_.disc.radius[a], parts_.disc.radius[b]));
  }

  // It is nearest to the segment at an end of the step, where it passes an end of the segment, or where it crosses it.
  void disc_and_border(int d, int segment) {
    const int link = parts_.border.link[segment];
    const bool torn = link >= 0 && system_.torn(link);
    const Path to_a = node_[parts_.border.a[segment]] - disc(d), to_b = node_[parts_.border.b[segment]] - disc(d);
    const double radius = parts_.disc.radius[d];
    Depths depths{depth_at(to_a, to_b, torn, 0), depth_at(to_a, to_b, torn, 1), -infinity};
    const auto passes = crossing_shares(to_a, to_b);
    for (const double share : {0.0, 1.0, nearest_share(to_a), nearest_share(to_b), passes[0], passes[1]})
      if (share >= 0 && share <= 1) depths.most = std::max(depths.most, depth_at(to_a, to_b, torn, share));
    for (double* depth : {&depths.start, &depths.end, &depths.most}) *depth += radius;
    judge({disc_lattice, d, parts_.border.lattice[segment]}, depths, "the disc's radius", radius);
  }

  const System& system_;
  const Parts& parts_;
  const Step& step_;
  std::vector<Path> node_;
  Unseen found_;
};

}  // namespace

Unseen unseen_meeting(const System& system, const Step& step) { return Meetings(system, step).find(); }

}  // namespace furrow
