// The pictures of a run as whole numbers, body by body, frame after frame.
#pragma once

#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

#include "validation/page/run_record.h"

namespace furrow::validation {

// What is to be seen, and the unit of its places: its longer side is 65,000 of them, which a pixel is not.
struct FilmBox {
  double x0 = infinity, y0 = infinity, x1 = -infinity, y1 = -infinity;  // m
  double unit() const { return std::max(x1 - x0, y1 - y0) / 65000; }    // m
  void include(double x, double y, double reach);
};

class FilmFrames {
 public:
  FilmFrames(const RunRecord& run, const std::filesystem::path& directory);

  // Along the axis of the film: mm of the first plate's way if it moves, or of the first driven nodes (by_way), else ms.
  bool by_way() const { return by_way_; }
  bool driven() const { return driven_; }  // nodes of a lattice, and no plate
  const std::vector<double>& at() const { return at_; }
  const std::vector<double>& force_at() const { return force_at_; }
  const std::vector<double>& force() const { return force_; }                // N, on the plate or the driven nodes
  const std::vector<std::pair<double, int>>& torn() const { return torn_; }  // where, which link

  const FilmBox& box() const { return box_; }
  const std::vector<double>& radii() const { return radii_; }                       // m
  const std::vector<std::pair<double, double>>& plates() const { return plates_; }  // width, height, m
  double stress_top() const { return stress_top_; }                                 // Pa
  double speed_top() const { return speed_top_; }                                   // m/s
  double link_top() const { return link_top_; }                                     // N

  // From the lower left corner, less 32768.
  const std::vector<std::int16_t>& disc_places() const { return disc_places_; }
  const std::vector<std::int16_t>& node_places() const { return node_places_; }
  const std::vector<std::int16_t>& plate_places() const { return plate_places_; }
  // Of 255, or of 127, stands for the top.
  const std::vector<std::uint8_t>& stresses() const { return stresses_; }
  const std::vector<std::uint8_t>& speeds() const { return speeds_; }
  const std::vector<std::int8_t>& link_forces() const { return link_forces_; }

 private:
  void find_axis(const RunRecord& run, const std::filesystem::path& directory);
  void find_driven_axis(const RunRecord& run, const std::filesystem::path& directory);
  void find_box(const RunRecord& run);
  void add_discs(const Frame& frame);
  void add_lattices(const RunRecord& run, const Frame& frame, std::vector<double>& nodes);
  void add_place(std::vector<std::int16_t>& places, double x, double y) const;

  bool by_way_ = false, driven_ = false;
  std::vector<double> at_, force_at_, force_, radii_;
  std::vector<std::pair<double, int>> torn_;
  std::vector<std::pair<double, double>> plates_;
  FilmBox box_;
  double stress_top_ = 1, speed_top_ = 1, link_top_ = 1;
  std::vector<std::int16_t> disc_places_, node_places_, plate_places_;
  std::vector<std::uint8_t> stresses_, speeds_;
  std::vector<std::int8_t> link_forces_;
};

}  // namespace furrow::validation
