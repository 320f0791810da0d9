// More discs than fit in one block are stored by place (system/place.h). In a deck, in its scene and beside an engine's end
// a disc has the number that the scene gives it, whatever its size and wherever it lies.
#include "comparing.h"

namespace {

using furrow::test::cells_of;
using furrow::test::Comparing;
using furrow::test::Rows;

constexpr int wide = 70, high = 61;  // above 4096, none touches another

double radius_of(int k) { return 0.006 + 1e-6 * k; }

// Row by row from the right and from above, so unlike any curve through the places, every disc of its own size.
std::string many() {
  std::ostringstream scene;
  scene.precision(17);
  scene << "title = \"Many discs\"\ntime = { end = 1e-4, step = 1e-5, method = \"verlet\" }\noutput = { interval = "
           "1e-5 }\n"
           "contact = {}\nmodel = { gravity = 0.0 }\nmaterial = [{ name = \"m\", young = 2e7, poisson = 0.3 }, { name "
           "= \"n\", young = 1e7, poisson = 0.3 }]\n"
           "wall = [{ point = [0.0, -1.0], normal = [0.0, 1.0], material = \"m\" }]\n";
  for (int k = 0; k < wide * high; ++k)
    scene << "[[disc]]\nposition = [" << 0.025 * (wide - k % wide) << ", " << 0.025 * (high - k / wide)
          << "]\nvelocity = [" << 1e-3 * (k % 7) << ", 0.0]\nradius = " << radius_of(k) << "\nmaterial = \""
          << (k == 0 ? "m" : "n") << "\"\n";
  return scene.str();
}

TEST_F(Comparing, ManyDiscsKeepTheirNumbers) {
  export_and_run(many());
  ASSERT_EQ(furrow("run scene.toml --out straight").code, 0) << err();
  const Rows straight = cells_of(text("straight/state.csv")), exported = cells_of(text("own/state.csv"));
  ASSERT_EQ(straight.size(), static_cast<std::size_t>(wide * high));
  EXPECT_EQ(exported, straight) << "the scene of the deck is another";

  std::istringstream data(text("deck/data.lammps"));
  std::string line;
  std::map<int, std::array<double, 3>> atoms;  // diameter, place
  while (std::getline(data, line) && line.rfind("Atoms", 0) != 0) {
  }
  std::getline(data, line);
  while (std::getline(data, line) && !line.empty()) {
    std::istringstream cells(line);
    int id = 0, type = 0;
    double diameter = 0, density = 0, x = 0, y = 0;
    ASSERT_TRUE(cells >> id >> type >> diameter >> density >> x >> y) << line;
    atoms[id] = {diameter, x, y};
    EXPECT_EQ(type, id == 1 ? 1 : 2) << "kinds are numbered as the scene lists them";
  }
  ASSERT_EQ(atoms.size(), straight.size());
  for (int k = 0; k < wide * high; ++k) {
    const auto& [diameter, x, y] = atoms.at(k + 1);
    ASSERT_DOUBLE_EQ(diameter, 2 * radius_of(k)) << k;
    ASSERT_NEAR(x, 0.025 * (wide - k % wide), 1e-12) << k;
    ASSERT_NEAR(y, 0.025 * (high - k / wide), 1e-12) << k;
  }

  std::string force = title() + "# step wall0_Fx wall0_Fy\n";
  for (int step = 0; step <= 10; ++step) force += std::to_string(step) + " 0 0\n";
  put("deck/force.1.txt", force);
  put_end(10);
  EXPECT_EQ(furrow("export --compare deck").code, 1) << "no force was there to be compared";
  EXPECT_LT(compared("deck")["end"]["greatest_distance"].get<double>(), 1e-12) << out();
}

TEST_F(Comparing, ExplainNamesTheFirstDiscsOfTheScene) {
  put("scene.toml", many());
  ASSERT_EQ(furrow("explain scene.toml").code, 0) << err();
  EXPECT_NE(out().find("disc of 0.006 m"), std::string::npos) << out();
}

}  // namespace
