#include "validation/page/film_frames.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace furrow::validation {
namespace {

// Below which the share `covered` of all values lies, or 1 if there are none.
double top_of(std::vector<double> values, double covered) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  if (values.empty()) return 1;
  std::sort(values.begin(), values.end());
  const double top = values[static_cast<std::size_t>(std::lround(covered * static_cast<double>(values.size() - 1)))];
  return top > 0 ? top : 1;
}

std::vector<double> all_of(const RunRecord& run, Table Frame::*table, const char* column) {
  std::vector<double> values;
  for (const Frame& f : run.frames) {
    for (const double v : (f.*table).numbers(column)) values.push_back(std::fabs(v));
  }
  return values;
}

std::vector<double> speeds_of(const Table& discs) {
  const auto vx = discs.numbers("vx [m/s]"), vy = discs.numbers("vy [m/s]");
  std::vector<double> speeds;
  for (std::size_t k = 0; k < vx.size(); ++k) speeds.push_back(std::hypot(vx[k], vy[k]));
  return speeds;
}

template <class Integer>
Integer share(double value, double top, double most) {
  return static_cast<Integer>(std::isfinite(value) ? std::lround(std::clamp(value / top, -1.0, 1.0) * most) : 0);
}

}  // namespace

void FilmBox::include(double x, double y, double reach) {
  if (!std::isfinite(x + y + reach)) return;
  x0 = std::min(x0, x - reach), x1 = std::max(x1, x + reach);
  y0 = std::min(y0, y - reach), y1 = std::max(y1, y + reach);
}

FilmFrames::FilmFrames(const RunRecord& run, const std::filesystem::path& directory) {
  if (run.frames.empty())
    throw std::runtime_error(directory.string() + ": the run has no pictures; run it again with --frames 150");
  find_axis(run, directory);
  find_box(run);
  radii_ = run.frames[0].discs.numbers("radius [m]");
  stress_top_ = top_of(all_of(run, &Frame::discs, "von Mises [Pa]"), 0.99);
  link_top_ = top_of(all_of(run, &Frame::links, "force [N]"), 1);
  std::vector<double> speeds;
  for (const Frame& f : run.frames) {
    const auto some = speeds_of(f.discs);
    speeds.insert(speeds.end(), some.begin(), some.end());
  }
  speed_top_ = top_of(std::move(speeds), 0.99);
  const auto width = run.frames[0].plates.numbers("width [m]"), height = run.frames[0].plates.numbers("height [m]");
  for (std::size_t k = 0; k < width.size(); ++k) plates_.emplace_back(width[k], height[k]);
  std::vector<double> nodes(2 * run.lattices.node.row.size(), box_.x0);
  for (const Frame& frame : run.frames) {
    add_discs(frame);
    add_lattices(run, frame, nodes);
    const auto left = frame.plates.numbers("left [m]"), lower = frame.plates.numbers("lower [m]");
    for (std::size_t k = 0; k < left.size(); ++k) add_place(plate_places_, left[k], lower[k]);
  }
}

// The way and the force of the first driven nodes.
void FilmFrames::find_driven_axis(const RunRecord& run, const std::filesystem::path& directory) {
  const Table drives(directory / "drive_force.csv");
  const auto &lattice = drives.texts("lattice"), &drive = drives.texts("drive");
  const auto t = drives.numbers("t [s]"), way = drives.numbers("displacement [m]"), f = drives.numbers("F [N]");
  std::vector<double> times;
  for (std::size_t k = 0; k < t.size(); ++k) {
    if (lattice[k] != lattice[0] || drive[k] != drive[0]) continue;
    times.push_back(t[k]), force_at_.push_back(1e3 * std::fabs(way[k])), force_.push_back(f[k]);
  }
  if (times.empty()) return;
  const auto way_at = [&](double time) {
    const auto k = static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), time) - times.begin());
    return force_at_[std::min(k, times.size() - 1)];
  };
  for (const double time : Table(directory / "frames/frames.csv").numbers("t [s]")) at_.push_back(way_at(time));
  const auto torn_at = run.torn.empty() ? std::vector<double>{} : Table(directory / "events.csv").numbers("t [s]");
  for (std::size_t k = 0; k < run.torn.size(); ++k) torn_.emplace_back(way_at(torn_at[k]), run.torn[k].link);
}

void FilmFrames::find_axis(const RunRecord& run, const std::filesystem::path& directory) {
  driven_ = run.scene.plate.empty() && std::filesystem::exists(directory / "drive_force.csv");
  by_way_ = driven_;
  if (driven_) return find_driven_axis(run, directory);
  by_way_ = !run.scene.plate.empty() && plate_speed(run) > 0;
  const auto times = Table(directory / "frames/frames.csv").numbers("t [s]");
  for (std::size_t k = 0; k < run.frames.size(); ++k) at_.push_back(by_way_ ? run.frames[k].mm : 1e3 * times[k]);
  force_at_ = run.force.mm, force_ = run.force.f;
  if (!by_way_ && !run.scene.plate.empty()) {
    const Table force(directory / "plate_force.csv");
    const auto& plate = force.texts("plate");
    const auto t = force.numbers("t [s]");
    force_at_.clear();
    for (std::size_t k = 0; k < t.size(); ++k) {
      if (plate[k] == plate[0]) force_at_.push_back(1e3 * t[k]);
    }
  }
  const auto torn_at = run.torn.empty() ? std::vector<double>{} : Table(directory / "events.csv").numbers("t [s]");
  for (std::size_t k = 0; k < run.torn.size(); ++k)
    torn_.emplace_back(by_way_ ? run.torn[k].mm : 1e3 * torn_at[k], run.torn[k].link);
}

// All that is in some frame, and a margin, so that nothing is cut; of plates their lower half alone if they are tall.
void FilmFrames::find_box(const RunRecord& run) {
  for (const Frame& f : run.frames) {
    const auto x = f.discs.numbers("x [m]"), y = f.discs.numbers("y [m]"), r = f.discs.numbers("radius [m]");
    for (std::size_t k = 0; k < x.size(); ++k) box_.include(x[k], y[k], r[k]);
    for (const std::string end : {"1", "2"}) {
      const auto lx = f.links.numbers("x" + end + " [m]"), ly = f.links.numbers("y" + end + " [m]");
      for (std::size_t k = 0; k < lx.size(); ++k) box_.include(lx[k], ly[k], 0);
    }
    const auto left = f.plates.numbers("left [m]"), lower = f.plates.numbers("lower [m]"),
               width = f.plates.numbers("width [m]");
    for (std::size_t k = 0; k < left.size(); ++k)
      box_.include(left[k], lower[k], 0), box_.include(left[k] + width[k], lower[k], 0);
  }
  if (!(box_.x1 > box_.x0)) box_.x0 -= 0.5, box_.x1 = box_.x0 + 1;
  if (!(box_.y1 > box_.y0)) box_.y0 -= 0.5, box_.y1 = box_.y0 + 1;
  const double width = box_.x1 - box_.x0, height = box_.y1 - box_.y0;
  box_.x0 -= 0.02 * width, box_.x1 += 0.02 * width;
  box_.y0 -= 0.04 * height, box_.y1 += 0.1 * height;
}

void FilmFrames::add_place(std::vector<std::int16_t>& places, double x, double y) const {
  for (const double off : {x - box_.x0, y - box_.y0})
    places.push_back(static_cast<std::int16_t>(std::lround(std::clamp(off / box_.unit(), 0.0, 65535.0)) - 32768));
}

void FilmFrames::add_discs(const Frame& frame) {
  const auto x = frame.discs.numbers("x [m]"), y = frame.discs.numbers("y [m]"),
             stress = frame.discs.numbers("von Mises [Pa]");
  const std::vector<double> speed = speeds_of(frame.discs);
  for (std::size_t k = 0; k < radii_.size(); ++k) {
    add_place(disc_places_, x.at(k), y.at(k));
    stresses_.push_back(share<std::uint8_t>(stress.at(k), stress_top_, 255));
    speeds_.push_back(share<std::uint8_t>(speed.at(k), speed_top_, 255));
  }
}

// The rows are the intact links in their order. A node whose links are all torn is no longer seen and stays where it was.
void FilmFrames::add_lattices(const RunRecord& run, const Frame& frame, std::vector<double>& nodes) {
  const Parts& parts = run.lattices;
  const auto x1 = frame.links.numbers("x1 [m]"), y1 = frame.links.numbers("y1 [m]"), x2 = frame.links.numbers("x2 [m]"),
             y2 = frame.links.numbers("y2 [m]"), force = frame.links.numbers("force [N]");
  const std::size_t all = parts.link.a.size(), torn = all - std::min(all, x1.size());
  std::vector<char> gone(all);
  for (std::size_t k = 0; k < std::min(torn, run.torn.size()); ++k) gone[run.torn[k].link] = 1;
  std::size_t row = 0;
  for (std::size_t k = 0; k < all; ++k) {
    if (gone[k] != 0 || row >= x1.size()) {
      link_forces_.push_back(0);
      continue;
    }
    const auto a = static_cast<std::size_t>(parts.link.a[k]), b = static_cast<std::size_t>(parts.link.b[k]);
    nodes[2 * a] = x1[row], nodes[2 * a + 1] = y1[row];
    nodes[2 * b] = x2[row], nodes[2 * b + 1] = y2[row];
    link_forces_.push_back(share<std::int8_t>(force[row++], link_top_, 127));
  }
  for (std::size_t k = 0; k < nodes.size(); k += 2) add_place(node_places_, nodes[k], nodes[k + 1]);
}

}  // namespace furrow::validation
