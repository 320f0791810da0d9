// A deck of `furrow export` with an engine's output that is furrow's own run.
#pragma once

#include "export.h"

namespace furrow::test {

using Rows = std::vector<std::vector<std::string>>;

inline Rows cells_of(const std::string& csv) {
  Rows rows;
  std::istringstream lines(csv);
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

inline std::string without_line(const std::string& text, std::size_t from, std::size_t count) {
  std::istringstream lines(text);
  std::string left, line;
  for (std::size_t k = 1; std::getline(lines, line); ++k)
    if (k < from || k >= from + count) left += line + "\n";
  return left;
}

inline std::string with_line(const std::string& text, std::size_t number, const std::string& other) {
  std::istringstream lines(text);
  std::string changed, line;
  for (std::size_t k = 1; std::getline(lines, line); ++k) changed += (k == number ? other : line) + "\n";
  return changed;
}

constexpr const char* box = "ITEM: BOX BOUNDS mm mm pp\n-1 1\n-1 1\n-1 1\n";

class Comparing : public Export {
 protected:
  void export_and_run(const std::string& scene, const std::string& options = "") {
    put("scene.toml", scene);
    ASSERT_EQ(furrow("export scene.toml --to lammps --out deck " + options).code, 0) << err();
    ASSERT_EQ(furrow("run deck/scene.toml --out own").code, 0) << err();
  }

  std::string title() const {
    const auto json = nlohmann::json::parse(text("deck/export.json"));
    return "# furrow export, scene " + json["scene_hash"].get<std::string>() + "\n";
  }

  static std::string dump_of(int step, const std::string& entries, std::size_t count) {
    return "ITEM: TIMESTEP\n" + std::to_string(step) + "\nITEM: NUMBER OF " + entries + "\n" + std::to_string(count) +
           "\n" + box;
  }

  void put_end(int steps) const {
    const Rows bodies = cells_of(text("own/state.csv"));
    std::string end = dump_of(steps, "ATOMS", bodies.size()) + "ITEM: ATOMS id x y vx vy\n";
    for (std::size_t k = 0; k < bodies.size(); ++k)
      end += std::to_string(k + 1) + " " + bodies[k][2] + " " + bodies[k][3] + " " + bodies[k][4] + " " + bodies[k][5] +
             "\n";
    put("deck/end.1.txt", end);
  }

  // discs(): a plate that touches nothing, and a wall; a row each 100 steps.
  void good_discs(const std::string& options = "") {
    export_and_run(discs(), options);
    const Rows plate = cells_of(text("own/plate_force.csv")), wall = cells_of(text("own/wall_force.csv"));
    std::string force = title() + "# step plate0_Fx plate0_Fy wall0_Fx wall0_Fy\n";
    for (std::size_t k = 0; k < wall.size(); ++k)
      force +=
          std::to_string(100 * k) + " " + plate[k][3] + " " + plate[k][4] + " " + wall[k][2] + " " + wall[k][3] + "\n";
    put("deck/force.1.txt", force);
    put_end(1000);
    ASSERT_EQ(furrow("export --compare deck").code, 0) << out() << err();
  }

  void expect_refused(const std::string& file, const std::string& spoilt, const std::string& why) const {
    const std::string good = text("deck/" + file);
    put("deck/" + file, spoilt);
    EXPECT_EQ(furrow("export --compare deck").code, 4) << why << ": " << out();
    EXPECT_NE(err().find("deck/" + file + ": "), std::string::npos) << why << ": " << err();
    EXPECT_NE(err().find(why), std::string::npos) << why << ": " << err();
    EXPECT_FALSE(has("deck/compared.json")) << why << ": a result of before stands";
    put("deck/" + file, good);
  }
};

}  // namespace furrow::test
