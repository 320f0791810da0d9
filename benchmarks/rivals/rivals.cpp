#include "benchmarks/rivals/rivals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "export/lammps_law.h"
#include "output/build_info.h"
#include "output/files.h"
#include "physics/damping.h"
#include "scene/read.h"

namespace furrow::benchmarks {
namespace {

namespace fs = std::filesystem;

using Constants = std::vector<std::pair<std::string, std::string>>;

// Overlap at which gran/hertz/history, whose damping grows as sqrt(d) instead of d^(1/4), damps like the others.
constexpr double matched_overlap = 3e-4;  // m, of a disc in the middle of the bed

Constants constants(const Bed& bed, const Task& task) {
  const Scene& scene = bed.prepared.scene;
  const Material& m = scene.material[0];
  const Plate& plate = scene.plate[0];
  const DiscArrays& disc = bed.prepared.system.parts().disc;
  const double beta = damping_factor(*scene.contact.restitution);
  const Elastic elastic{*m.young, *m.poisson, false};
  const ContactLaw law = contact_law(elastic, elastic, beta, scene.contact.friction, 0);
  const double reduced_radius = disc.radius[0] / 2, reduced_mass = disc.mass[0] / 2;
  const double root = std::sqrt(reduced_radius * matched_overlap);
  const double viscosity = law.viscosity * std::sqrt(2 * law.modulus * root * reduced_mass);  // N s/m
  const double gamma = viscosity / (root * reduced_mass);
  Constants all;
  const auto add = [&](const char* name, double value) { all.emplace_back(name, number(value)); };
  add("young", *m.young);
  add("poisson", *m.poisson);
  add("friction", scene.contact.friction);
  add("restitution", *scene.contact.restitution);
  add("tsuji", tsuji_number(tsuji_alpha(law)));
  add("tangential", law.shear_ratio);
  add("kn", 4.0 / 3.0 * law.modulus);
  add("kt", 8 * law.shear_modulus);
  add("gamma", gamma);
  add("gammat", gamma * law.shear_ratio);
  add("betan", std::sqrt(5.0 / 6.0) * beta);  // YADE: Cn = 2 betan sqrt(m* Sn)
  add("gravity", scene.model.gravity);
  add("radius", disc.radius[0]);
  add("mass", disc.mass[0]);
  add("width", scene.wall.back().point.x);
  add("x0", plate.left_edge);
  add("x1", plate.left_edge + plate.width);
  add("y0", *plate.lower_edge);
  add("y1", *plate.lower_edge + plate.height);
  add("step", scene.time.step);
  add("speed", task.speed);
  all.emplace_back("steps", std::to_string(task.steps));
  all.emplace_back("look", task.look ? "1" : "0");
  all.emplace_back("bed", (bed.directory / "bed.data").string());
  all.emplace_back("plate", (bed.directory / "plate.stl").string());
  return all;
}

MeasuredCommand deck(std::vector<std::string> words, const Bed& bed, const Task& task) {
  for (const auto& [name, value] : constants(bed, task)) words.insert(words.end(), {"-var", name, value});
  return {std::move(words), task.directory, {"OMP_NUM_THREADS=1"}, task.directory / "errors.txt"};
}

MeasuredCommand lammps(const Bed& bed, const Task& task, const std::string& law) {
  return deck({"lmp", "-in", bed.decks / "lammps.in", "-log", "none", "-screen", "out.txt", "-var", "law", law}, bed,
              task);
}

MeasuredCommand liggghts(const Bed& bed, const Task& task) {
  return deck({"liggghts", "-in", bed.decks / "liggghts.in", "-log", "none", "-screen", "out.txt", "-var", "stress",
               task.look ? "/stress" : ""},
              bed, task);
}

MeasuredCommand yade(const Bed& bed, const Task& task) {
  std::vector<std::string> words{"yade", "-n", "-x", "-j1", bed.decks / "yade.py"};
  for (const auto& [name, value] : constants(bed, task)) {
    if (name != "plate") words.push_back(name + "=" + value);
  }
  return {std::move(words), task.directory, {"OMP_NUM_THREADS=1"}, task.directory / "errors.txt"};
}

MeasuredCommand furrow_with(const Bed& bed, const Task& task, const std::string& method,
                            const std::vector<std::string>& environment = {}) {
  Scene scene = read_scene(bed.directory / "scene.toml");
  scene.plate[0].velocity.x = task.speed;
  scene.time.method = method;
  scene.time.end = static_cast<double>(task.steps) * scene.time.step;
  if (!task.look) scene.output.interval = scene.time.end;
  OutputFile file = OutputFile::replacing(task.directory / "scene.toml");
  file << canonical_text(scene);
  file.finish();
  return {{bed.furrow, "run", task.directory / "scene.toml", "--out", task.directory / "run"},
          task.directory,
          environment,
          task.directory / "errors.txt"};
}

void write_plate(const fs::path& file, const Plate& plate) {
  const double x[] = {plate.left_edge, plate.left_edge + plate.width};
  const double y[] = {*plate.lower_edge, *plate.lower_edge + plate.height};
  const double z[] = {-0.02, 0.02};  // m: the discs are far from both
  // Corner k: bits of k choose x, y and z. Two triangles a face, seen from outside.
  constexpr std::array<std::array<int, 4>, 6> faces{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  constexpr std::array<std::array<int, 3>, 6> normals{
      {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};
  OutputFile out = OutputFile::replacing(file);
  out << "solid tool\n";
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (const int third : {2, 3}) {
      out << "facet normal " << normals[f][0] << " " << normals[f][1] << " " << normals[f][2] << "\nouter loop\n";
      for (const int corner : {faces[f][0], faces[f][third - 1], faces[f][third]})
        out << "vertex " << x[corner & 1] << " " << y[corner >> 1 & 1] << " " << z[corner >> 2] << "\n";
      out << "endloop\nendfacet\n";
    }
  }
  out << "endsolid tool\n";
  out.finish();
}

// For LAMMPS and LIGGGHTS: id, type, diameter, density, x, y, z. The density gives the sphere the mass of the disc.
void write_bed(const fs::path& file, const Scene& scene, const DiscArrays& disc) {
  OutputFile out = OutputFile::replacing(file);
  out << "settled bed\n\n" << disc.count() << " atoms\n1 atom types\n";
  out << "-0.1 " << scene.wall.back().point.x + 0.1 << " xlo xhi\n-0.1 1.5 ylo yhi\n-0.05 0.05 zlo zhi\n\nAtoms\n\n";
  for (int i = 0; i < disc.count(); ++i) {
    const double r = disc.radius[i];
    out << i + 1 << " 1 " << 2 * r << " " << disc.mass[i] / (4.0 / 3.0 * pi * r * r * r) << " "
        << scene.disc[i].position.x << " " << scene.disc[i].position.y << " 0\n";
  }
  out.finish();
}

}  // namespace

void write_scene(const Bed& bed, const Scene& scene) {
  OutputFile file = OutputFile::replacing(bed.directory / "scene.toml");
  file << canonical_text(scene);
  file.finish();
}

Bed make_bed(const fs::path& decks, const fs::path& directory, const fs::path& furrow) {
  fs::create_directories(directory);
  Bed bed{prepare(read_scene(decks / "scene.toml")), directory, decks, furrow};
  Scene& scene = bed.prepared.scene;
  for (std::size_t i = 0; i < scene.disc.size(); ++i) {
    const int disc = static_cast<int>(i);
    scene.disc[i].position = {bed.prepared.y[bed.prepared.system.x_of(disc)],
                              bed.prepared.y[bed.prepared.system.y_of(disc)]};
  }
  scene.settle.reset();
  write_scene(bed, scene);
  write_bodies(bed);
  return bed;
}

void write_bodies(const Bed& bed) {
  write_bed(bed.directory / "bed.data", bed.prepared.scene, bed.prepared.system.parts().disc);
  write_plate(bed.directory / "plate.stl", bed.prepared.scene.plate[0]);
}

Rival converged() {
  return {"furrow, rk4", "", "", 1, 4, [](const Bed& bed, const Task& task) { return furrow_with(bed, task, "rk4"); }};
}

std::string version_of(const std::string& package) {
  if (package.empty()) return std::string(build_info().commit);
  return run_measured({.words = {"dpkg-query", "-W", "-f=${Version}", package}}).output;
}

// How a program was compiled: of a package what Debian's flags are, if it does not say itself.
std::string build_of(const std::string& package) {
  if (package.empty()) return std::string(build_info().compiler) + " " + std::string(build_info().flags);
  if (package == "lammps") {
    const std::string help = run_measured({.words = {"lmp", "-h"}}).output;
    const auto at = help.find("Compiler: ");
    if (at != std::string::npos)
      return help.substr(at + 10, help.find('\n', at) - at - 10) + ", Debian's flags: x86-64";
  }
  return "Debian's flags: -O2, x86-64";
}

std::vector<Rival> rivals() {
  const auto lammps_with = [](const std::string& law) {
    return [=](const Bed& bed, const Task& task) { return lammps(bed, task, law); };
  };
  const auto own = [](const std::string& method) {
    return [=](const Bed& bed, const Task& task) { return furrow_with(bed, task, method); };
  };
  constexpr long all = 45'000;
  return {
      {"furrow, symplectic Euler", "", "Hertz, Tsuji damping, Mindlin; I = m R^2/2", all, 1, own("symplectic_euler")},
      {"furrow, PECE", "", "the same", all, 2, own("pece")},
      {"furrow, no wide vectors", "", "the first again, with the registers of the rivals' builds", all, 1,
       [](const Bed& bed, const Task& task) {
         return furrow_with(bed, task, "symplectic_euler", {"FURROW_VECTORS=none"});
       }},
      // By the judge: gross_slip_40, spinning_impact and oblique_pair; before contacts slide the law is the same.
      {"LAMMPS, granular", "lammps", "the same law up to slip", all, 1, lammps_with("granular")},
      {"LAMMPS, gran/hertz/history", "lammps", "another law: damping as sqrt(d) instead of d^(1/4)", all, 1,
       lammps_with("hertz")},
      {"LIGGGHTS, hertz", "liggghts", "the same law without friction; I = 2/5 m R^2", all, 1, liggghts},
      {"YADE, Hertz-Mindlin", "yade", "another law on walls and plate: R* = R/2", 9'000, 1, yade},
  };
}

std::vector<std::vector<double>> rows_of(const std::filesystem::path& file, std::size_t columns) {
  std::ifstream stream(file);
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(stream, line);) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line);
    std::vector<double> row;
    for (std::string word; words >> word;) {
      char* end = nullptr;
      const double value = std::strtod(word.c_str(), &end);
      if (*end == '\0') row.push_back(value);
    }
    if (row.size() == columns) rows.push_back(row);
  }
  return rows;
}

}  // namespace furrow::benchmarks
