#include "run/meeting.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "run/crossing.h"
#include "run/path.h"
#include "scene/border.h"
#include "scene/wording.h"

namespace furrow {
namespace {

Path operator-(const Path& a, const Path& b) { return {a.from - b.from, a.to - b.to}; }

// m, from the origin.
double nearest(Vec2 a, Vec2 b) { return std::sqrt(nearest_on_segment({0, 0}, a, b, 0, false).distance2); }
double nearest(const Path& path) { return nearest(path.from, path.to); }

// A disc's centre, or a segment of a border, with what surrounds its way.
struct Moving {
  Box box;
  int disc, segment;  // -1: it is not one
};

class Meetings {
 public:
  Meetings(const System& system, const Step& step) : system_(system), parts_(system.parts()), step_(step) {
    for (int n = 0; n < parts_.node.count(); ++n)
      node_.push_back({node_place(system, step.t - step.h, step.before, n), node_place(system, step.t, step.after, n)});
  }

  const Unseen& find() {
    at_what_is_flat();
    if (found_.what.empty()) along_links();
    if (found_.what.empty()) between_discs_and_borders();
    return found_;
  }

 private:
  Path disc(int i) const { return path_of_body(system_, step_, i); }

  void say(const std::string& one, const std::string& other, double moved, const char* size, double metres, int body) {
    Sentence text;
    text << one << " and " << other << " moved " << moved << " m against each other in one step of " << step_.h
         << " s, more than " << size << ", " << metres << " m";
    found_ = {text.str(), body};
  }

  void at_what_is_flat() {
    for (int i = 0; i < parts_.disc.count(); ++i)
      at_what_is_flat(disc(i), parts_.disc.radius[i], "the disc's radius", parts_.disc.radius[i], i);
    for (int n = 0; n < parts_.node.count(); ++n)
      if (const int body = parts_.node.body[n]; body >= 0)
        at_what_is_flat(node_[n], parts_.node.contact_radius[n], "the node's spacing", parts_.node.spacing[n], body);
  }

  void at_what_is_flat(const Path& path, double reach, const char* size, double metres, int body) {
    const double moved = length(path);
    if (!(moved > metres) || !found_.what.empty()) return;
    for (std::size_t w = 0; w < parts_.wall.size(); ++w) {
      const WallPart& wall = parts_.wall[w];
      const auto gap = [&](Vec2 at) { return nearest_on_wall(at, {wall.px, wall.py}, {wall.nx, wall.ny}).distance; };
      if (std::min(gap(path.from), gap(path.to)) <= reach)
        return say(parts_.body_name(body), "wall " + std::to_string(w), moved, size, metres, body);
    }
    for (int p = 0; p < static_cast<int>(parts_.plate.size()); ++p) {
      const Path seen = path_from_plate(system_, step_, p, path);
      const PlatePart& plate = parts_.plate[p];
      if (length(seen) > metres && meets_box(seen, 0.5 * plate.width + reach, 0.5 * plate.height + reach))
        return say(parts_.body_name(body), "plate " + std::to_string(p), length(seen), size, metres, body);
    }
  }

  void along_links() {
    const LinkArrays& link = parts_.link;
    for (int k = 0; k < link.count() && found_.what.empty(); ++k) {
      const int a = link.a[k], b = link.b[k];
      if (system_.torn(k)) continue;
      const Path way = node_[a] - node_[b];
      if (length(way) > parts_.node.spacing[a])
        say(parts_.node_name(a), parts_.node_name(b), length(way), "the lattice's spacing", parts_.node.spacing[a],
            std::max(parts_.node.body[a], parts_.node.body[b]));
    }
  }

  // Pairs whose boxes meet, from left to right, as seen from the mean motion.
  void between_discs_and_borders() {
    if (parts_.disc.count() == 0) return;
    const std::vector<Moving> all = moving();
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t k = i + 1; k < all.size() && all[k].box.left <= all[i].box.right; ++k) {
        if (!all[i].box.meets(all[k].box)) continue;
        if (all[i].disc >= 0 && all[k].disc >= 0) {
          discs(std::min(all[i].disc, all[k].disc), std::max(all[i].disc, all[k].disc));
        } else if (all[i].disc >= 0 || all[k].disc >= 0) {
          disc_and_border(std::max(all[i].disc, all[k].disc), std::max(all[i].segment, all[k].segment));
        }
        if (!found_.what.empty()) return;
      }
    }
  }

  std::vector<Moving> moving() const {
    const Vec2 drift = mean_motion();
    std::vector<Moving> all;
    const auto surround = [&](Box& box, const Path& path, double margin) {
      for (const Vec2 at : {path.from, path.to - drift}) {
        box.add({at.x - margin, at.y - margin});
        box.add({at.x + margin, at.y + margin});
      }
    };
    for (int i = 0; i < parts_.disc.count(); ++i) {
      all.push_back({{}, i, -1});
      surround(all.back().box, disc(i), parts_.disc.radius[i]);
    }
    for (const int segment : system_.border()) {
      all.push_back({{}, -1, segment});
      for (const int n : {parts_.border.a[segment], parts_.border.b[segment]}) surround(all.back().box, node_[n], 0);
    }
    std::stable_sort(all.begin(), all.end(), [](const Moving& p, const Moving& q) { return p.box.left < q.box.left; });
    return all;
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

  void discs(int a, int b) {
    const Path way = disc(a) - disc(b);
    const double smaller = std::min(parts_.disc.radius[a], parts_.disc.radius[b]);
    if (length(way) > smaller && nearest(way) <= parts_.disc.radius[a] + parts_.disc.radius[b])
      say(parts_.body_name(a), parts_.body_name(b), length(way), "the smaller radius", smaller, a);
  }

  void disc_and_border(int d, int segment) {
    const int a = parts_.border.a[segment], b = parts_.border.b[segment], link = parts_.border.link[segment];
    const Path to_a = node_[a] - disc(d), to_b = node_[b] - disc(d);
    const double moved = std::max(length(to_a), length(to_b)), radius = parts_.disc.radius[d];
    if (!(moved > radius)) return;
    double way = std::min(nearest(to_a), nearest(to_b));
    if (link < 0 || !system_.torn(link))
      way = std::min({way, nearest(to_a.from, to_b.from), nearest(to_a.to, to_b.to)});
    if (way > radius && !crosses_segment(system_, step_, disc(d), segment)) return;
    say(parts_.body_name(d), "the border of lattice " + lattice_name(system_, parts_.border.lattice[segment]), moved,
        "the disc's radius", radius, d);
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
