#include "output/frames.h"

#include <iterator>

#include "run/observe.h"
#include "scene/wording.h"
#include "system/place.h"

namespace furrow {
namespace {

// All parts of one kind, a row each: written as CSV, and as VTK's PolyData in text form with a cell for each row.
struct Table {
  struct Array {
    const char* name;
    std::vector<std::size_t> columns;  // one, or x and y of one or more vectors in the plane
    const char* type = "Float64";
  };

  std::vector<std::string> headings;
  std::string cells;  // Verts, Lines or Polys
  Array points;       // corners of a cell
  std::vector<Array> data{};
  std::vector<std::vector<std::string>> rows{};  // what stands beyond the headings is for VTK only

  std::vector<std::string>& add(auto... numbers) { return rows.emplace_back(std::vector{number(numbers)...}); }

  // Adds what the two files hold to `written`.
  void write(const std::string& name, std::vector<FileMark>& written) const {
    OutputFile csv(name + ".csv", joined(headings, ","));
    for (const auto& row : rows) csv << joined({row.begin(), row.begin() + std::ssize(headings)}, ",") << "\n";
    written.push_back(csv.mark());
    csv.finish();

    const std::size_t corners = points.columns.size() / 2, count = corners * rows.size();
    std::string connectivity, offsets, fields;
    for (std::size_t k = 0; k < count; ++k) connectivity += std::to_string(k) + "\n";
    for (std::size_t k = 1; k <= rows.size(); ++k) offsets += std::to_string(k * corners) + "\n";
    for (const Array& array : data) fields += in_vtk(array);
    OutputFile vtk(name + ".vtp");
    vtk << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        << "<PolyData>\n<Piece NumberOfPoints=\"" + std::to_string(count) + "\" NumberOf" + cells + "=\""
        << std::to_string(rows.size()) + "\">\n"
        << element("Points", in_vtk(points))
        << (data.empty() ? "" : element(corners == 1 ? "PointData" : "CellData", fields))
        << element(cells, in_vtk("connectivity", "Int64", 1, connectivity) + in_vtk("offsets", "Int64", 1, offsets))
        << "</Piece>\n</PolyData>\n</VTKFile>\n";
    written.push_back(vtk.mark());
    vtk.finish();
  }

  static std::string element(const std::string& name, const std::string& content) {
    return "<" + name + ">\n" + content + "</" + name + ">\n";
  }

  static std::string in_vtk(const std::string& name, const std::string& type, int components,
                            const std::string& lines) {
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" + std::to_string(components) +
           "\" format=\"ascii\">\n" + lines + "</DataArray>\n";
  }

  std::string in_vtk(const Array& array) const {
    const auto& c = array.columns;
    std::string lines;
    for (const auto& row : rows) {
      if (c.size() == 1) lines += row[c[0]] + "\n";
      for (std::size_t k = 1; k < c.size(); k += 2) lines += row[c[k - 1]] + " " + row[c[k]] + " 0\n";
    }
    return in_vtk(array.name, array.type, c.size() == 1 ? 1 : 3, lines);
  }
};

// "discs_007"
std::string name_of(const std::string& kind, std::size_t frame) {
  const std::string digits = std::to_string(frame);
  return kind + '_' + std::string(digits.size() < 3 ? 3 - digits.size() : 0, '0') + digits;
}

// In the order in which they are written.
std::vector<std::string> pictures_of(std::size_t frames) {
  std::vector<std::string> all;
  for (std::size_t k = 0; k < frames; ++k) {
    for (const char* kind : {"discs", "links", "plates", "contacts"}) {
      for (const char* ending : {".csv", ".vtp"}) all.push_back("frames/" + name_of(kind, k) + ending);
    }
  }
  return all;
}

Table discs_of(const System& system, double t, const State& y) {
  Table table{{"x [m]", "y [m]", "radius [m]", "vx [m/s]", "vy [m/s]", "spin [rad/s]", "von Mises [Pa]"},
              "Verts",
              {"points", {0, 1}},
              {{"radius [m]", {2}}, {"spin [rad/s]", {5}}, {"von Mises [Pa]", {6}}, {"velocity [m/s]", {3, 4}}}};
  const Layout& at = system.layout();
  if (at.angles > 0) {
    table.headings.emplace_back("angle [rad]");
    table.data.push_back({"angle [rad]", {7}});
  }
  const std::vector<Stress> stress = disc_stresses(system, t, y);
  for (const int i : places_in(system.parts().disc.number)) {
    auto& row = table.add(y[system.x_of(i)], y[system.y_of(i)], system.parts().disc.radius[i], y[system.vx_of(i)],
                          y[system.vy_of(i)], system.spin(y, i), von_mises(stress[i]));
    if (at.angles > 0) row.push_back(number(y[at.angle_of(i)]));
  }
  return table;
}

// The line of a contact: between the centres of two discs, else from the disc or node to the contact point. Force
// chains are lines of a width that goes with their normal force.
Table contacts_of(const System& system, double t, const State& y) {
  Table table{{"kind", "a", "b", "x1 [m]", "y1 [m]", "x2 [m]", "y2 [m]", "overlap [m]", "normal force [N]",
               "tangential force [N]", "slip [m/s]", "spring [m]", "moment [N m]"},
              "Lines",
              {"points", {3, 4, 5, 6}},
              {{"overlap [m]", {7}},
               {"normal force [N]", {8}},
               {"tangential force [N]", {9}},
               {"slip [m/s]", {10}},
               {"spring [m]", {11}},
               {"moment [N m]", {12}},
               {"kind", {13}, "Int32"},
               {"a", {1}, "Int32"},
               {"b", {2}, "Int32"}}};
  const Parts& parts = system.parts();
  const NodeMotion node = system.nodes(t, y);
  const auto number_of = [&](int part, bool disc) { return std::to_string(disc ? parts.disc.number[part] : part); };
  system.for_each_contact(t, y, [&](const Contact& c) {
    const bool disc = of_disc(c.id.kind), pair = c.id.kind == disc_disc;
    const double x = disc ? y[system.x_of(c.id.a)] : node.x[c.id.a];
    const double x2 = pair ? y[system.x_of(c.id.b)] : 0, y2 = pair ? y[system.y_of(c.id.b)] : 0;
    const double height = disc ? y[system.y_of(c.id.a)] : node.y[c.id.a];
    const double length = (disc ? parts.disc.radius[c.id.a] : 0) - c.touch.overlap;
    auto& row = table.rows.emplace_back(std::vector<std::string>{
        contact_kind_names[c.id.kind], number_of(c.id.a, disc), number_of(c.id.b, pair), number(x), number(height),
        number(pair ? x2 : x + length * c.nx), number(pair ? y2 : height + length * c.ny), number(c.touch.overlap),
        number(c.force.normal), number(c.force.tangential), number(c.touch.slip), number(c.touch.spring),
        number(c.force.moment)});
    row.push_back(std::to_string(static_cast<int>(c.id.kind)));
  });
  return table;
}

Table links_of(const System& system, double t, const State& y) {
  Table table{{"x1 [m]", "y1 [m]", "x2 [m]", "y2 [m]", "force [N]", "kind"},
              "Lines",
              {"points", {0, 1, 2, 3}},
              {{"force [N]", {4}}, {"kind", {6}, "Int32"}}};
  const LinkArrays& link = system.parts().link;
  const NodeMotion node = system.nodes(t, y);
  const std::vector<double> force = link_forces(system, t, y);
  for (int k = 0; k < link.count(); ++k) {
    if (system.torn(k)) continue;
    const int a = link.a[k], b = link.b[k];
    auto& row = table.add(node.x[a], node.y[a], node.x[b], node.y[b], force[k]);
    row.insert(row.end(), {to_string(link.kind[k]), std::to_string(static_cast<int>(link.kind[k]))});
  }
  return table;
}

Table plates_of(const System& system, double t) {
  Table table{{"left [m]", "lower [m]", "width [m]", "height [m]", "vx [m/s]", "vy [m/s]"},
              "Polys",
              {"points", {0, 1, 6, 1, 6, 7, 0, 7}}};
  for (int k = 0; k < std::ssize(system.parts().plate); ++k) {
    const PlatePart& p = system.parts().plate[k];
    const auto [left, lower, vx, vy] = system.plate_at(k, t);
    table.add(left, lower, p.width, p.height, vx, vy, left + p.width, lower + p.height);
  }
  return table;
}

}  // namespace

void Frames::Memory::history(HistoryVisitor& visit) {
  visit("frames", count);
  list.history(visit, "frames.csv");
  pvd.history(visit, "run.pvd");
  visit.list("pictures", pictures, [&](FileMark& one) { one.history(visit, "a picture"); });
}

void Frames::Memory::require(const std::filesystem::path& directory) const {
  OutputFile::require(directory / "run.pvd", pvd);
  OutputFile::require(directory / "frames/frames.csv", list);
  const std::vector<std::string> names = pictures_of(count);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::filesystem::path file = directory / names[k];
    if (!std::filesystem::exists(file)) throw FileError("cannot go on with the run: there is no " + file.string());
    OutputFile::require_whole(file, pictures.at(k));
  }
}

Frames::Frames(const std::filesystem::path& directory, const Memory* kept)
    : directory_(directory / "frames"),
      list_(OutputFile::begun(directory_ / "frames.csv", "index,t [s],displacement [m]", kept ? &kept->list : nullptr)),
      pvd_(OutputFile::begun(directory / "run.pvd",
                             "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>",
                             kept ? &kept->pvd : nullptr)),
      count_(kept ? kept->count : 0),
      pictures_(kept ? kept->pictures : std::vector<FileMark>{}) {}

void Frames::add(const System& system, double t, double displacement, const State& y) {
  int part = 0;
  const auto write = [&](const std::string& kind, const Table& table) {
    const std::string name = name_of(kind, count_);
    table.write((directory_ / name).string(), pictures_);
    pvd_ << "<DataSet timestep=\"" << t << "\" part=\"" << part++ << "\" name=\"" << kind << "\" file=\"frames/" << name
         << ".vtp\"/>\n";
  };
  write("discs", discs_of(system, t, y));
  write("links", links_of(system, t, y));
  write("plates", plates_of(system, t));
  write("contacts", contacts_of(system, t, y));
  list_.row(static_cast<int>(count_++), t, displacement);
  list_.flush();
  pvd_.flush();
}

void Frames::close(bool complete) {
  pvd_ << "</Collection>\n</VTKFile>\n";
  for (OutputFile* file : {&list_, &pvd_}) complete ? file->finish() : file->close();
}

std::vector<std::string> Frames::files(std::size_t frames) {
  std::vector<std::string> all = pictures_of(frames);
  all.insert(all.begin(), {"run.pvd", "frames/frames.csv"});
  return all;
}

}  // namespace furrow
