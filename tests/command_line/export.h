// Scenes for `furrow export`, and the engine that runs them.
#pragma once

#include <regex>
#include <set>

#include "program.h"

namespace furrow::test {

class Export : public Program {
 protected:
  static bool has_lammps() { return std::system("command -v lmp >/dev/null 2>&1") == 0; }

  // Runs the deck in `directory`; the exit code.
  int lammps(const std::string& directory, const std::string& more = "", const std::string& before = "") const {
    return code_of(std::system(("cd '" + (directory_ / directory).string() + "' && OMP_NUM_THREADS=1 " + before +
                                " lmp -in in.lammps -log none " + more + " >engine.log 2>&1 </dev/null")
                                   .c_str()));
  }

  nlohmann::json compared(const std::string& directory) const {
    return nlohmann::json::parse(text(directory + "/compared.json"), nullptr, false);
  }

  // A disc against a wall, oblique, with the law of the engine; what comes after is of TOML.
  static std::string impact(const std::string& model, const std::string& contact,
                            const std::string& normal = "[0.0, 1.0]") {
    return "title = \"Oblique impact\"\nmodel = { gravity = 0.0, moment_arm = \"radius\", " + model +
           " }\ntime = { end = 0.02, step = 4e-6, method = \"verlet\" }\ncontact = { " + contact +
           " }\noutput = { interval = 1e-4 }\nmaterial = [{ name = \"m\", young = 2e7, poisson = 0.3 }]\n"
           "[[disc]]\nposition = [0.0, 0.0126]\nvelocity = [0.05, -0.2]\nspin = 3.0\nradius = 0.01\nmaterial = \"m\"\n"
           "[[wall]]\npoint = [0.0, 0.0]\nnormal = " +
           normal + "\nmaterial = \"m\"\n";
  }

  // Two discs of two materials, a wall, a plate, nothing that LAMMPS does not have.
  static std::string discs() {
    return R"(title = "Two discs"
time = { end = 0.01, step = 1e-5, method = "verlet" }
contact = {}
allow = {}
material = [{ name = "m", young = 2e7, poisson = 0.3 }, { name = "steel", young = 2e9, poisson = 0.3 }]
disc = [{ position = [0.0, 0.0099], radius = 0.01, material = "m" },
        { position = [0.0, 0.03], radius = 0.01, material = "steel" }]
wall = [{ point = [0.0, 0.0], normal = [0.0, 1.0], material = "steel" }]
plate = [{ left_edge = 0.1, lower_edge = 0.0, width = 0.01, height = 0.1, velocity = [-0.1, 0.0], material = "m" }]
)";
  }

  static std::string settled() {
    return R"(title = "A few discs at rest"
time = { end = 0.01, step = 1e-5 }
contact = { restitution = 0.3, friction = 0.3 }
settle = { speed = 0.05, hold = 0.02, step = 5e-5 }
material = [{ name = "m", young = 2e6, poisson = 0.3 }]
wall = [{ point = [0.0, 0.0], normal = [0.6, 0.8], material = "m" }, { point = [0.0, 0.0], normal = [-0.6, 0.8], material = "m" }]
disc = [{ position = [0.002, 0.03], radius = 0.01, material = "m" }, { position = [-0.01, 0.06], radius = 0.01, material = "m" }]
)";
  }

  static std::string lattice(const std::string& more = "") {
    return R"(title = "A stretched lattice"
time = { end = 0.3, step = 2e-4, method = "verlet" }
output = { interval = 2e-3 }
material = [{ name = "m", young = 1e7, poisson = 0.3 }]
[[lattice]]
name = "stem"
origin = [0.0, 0.0]
rows = 6
columns = 3
spacing = 0.01
node_mass = 0.05
material = "m"
fixed_rows = [0]
gravity = true
structural = { stiffness = 1e4, damping = 0.0, strength = 8.0 }
shear = { stiffness = 5e3, damping = 0.0, strength = 8.0 }
bending = { stiffness = 2e3, damping = 0.0, strength = 8.0 }
[[lattice.node]]
row = 3
column = 1
force = [3.0, 2.0]
[[lattice.node]]
row = 2
column = 0
fixed_x = true
[[lattice.drive]]
rows = [5]
velocity = [0.02, 0.05]
ramp = 0.1
[[lattice.link]]
from = [3, 0]
to = [4, 0]
torn = true
)" + more;
  }

  static std::string plate() {
    return "[[plate]]\nleft_edge = 0.1\nlower_edge = 0.0\nwidth = 0.01\nheight = 0.1\nvelocity = [0.0, 0.0]\nmaterial "
           "= \"m\"\n";
  }
};

}  // namespace furrow::test
