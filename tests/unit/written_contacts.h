// The contacts of written_scene as rows of the pictures have them.
#pragma once

#include <algorithm>
#include <map>

#include "written_scene.h"

namespace furrow::test {

// kind, a, b, from x, y to x, y, overlap, push of each contact, in the order of contacts: pairs, walls, plates.
inline std::vector<std::vector<double>> contact_rows(const KnownRun& known, const Moment& m) {
  std::vector<std::vector<double>> rows;
  const auto place = [&](int i) { return Vec2{m.y[known.system.x_of(i)], m.y[known.system.y_of(i)]}; };
  for (const KnownContact& c : contacts_of(known, m)) {
    const Vec2 at = place(c.a);
    double kind = 1, other = 0, length = known.scene.disc[c.a].radius - c.overlap;
    if (c.plate >= 0) kind = 2, other = c.plate;
    if (c.b >= 0) kind = 0, other = c.b, length = std::hypot(place(c.b).x - at.x, place(c.b).y - at.y);
    rows.push_back({kind, 1.0 * c.a, other, at.x, at.y, at.x + length * c.nx, at.y + length * c.ny, c.overlap, c.push});
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

// What VTK should read of them; returns how many there are.
inline std::size_t add_contacts(const std::vector<std::vector<double>>& rows, std::vector<double>& points,
                                std::map<std::string, std::vector<double>>& want) {
  const char* arrays[] = {"kind", "a", "b", "", "", "", "", "overlap [m]", "normal force [N]"};
  for (const std::vector<double>& c : rows) {
    points.insert(points.end(), {c[3], c[4], 0, c[5], c[6], 0});
    for (const int column : {0, 1, 2, 7, 8}) want[arrays[column]].push_back(c[column]);
    for (const char* none : {"tangential force [N]", "spring [m]", "moment [N m]"}) want[none].push_back(0);
  }
  return rows.size();
}

}  // namespace furrow::test
