#include "output/frames.h"

#include <cmath>
#include <functional>

#include "output/files.h"
#include "system/observe.h"

namespace furrow {
namespace {

std::string numbered(const std::string& name, std::size_t index, const std::string& ending) {
  std::string digits = std::to_string(index);
  digits.insert(0, digits.size() < 3 ? 3 - digits.size() : 0, '0');
  return name + "_" + digits + ending;
}

// VTK's PolyData in text form: points, cells of one kind, data at points and cells.
class PolyData {
 public:
  PolyData(const std::filesystem::path& file, std::size_t points, const char* cells, std::size_t cell_count)
      : file_(file), cells_(cells) {
    file_ << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" "
             "byte_order=\"LittleEndian\">\n<PolyData>\n"
          << "<Piece NumberOfPoints=\"" << std::to_string(points) << "\" NumberOf" << cells << "=\""
          << std::to_string(cell_count) << "\">\n";
  }

  void array(const std::string& name, int components, const std::string& type,
             const std::function<void(OutputFile&)>& values) {
    file_ << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\"" << components
          << "\" format=\"ascii\">\n";
    values(file_);
    file_ << "</DataArray>\n";
  }

  void section(const std::string& name, const std::function<void()>& content) {
    file_ << "<" << name << ">\n";
    content();
    file_ << "</" << name << ">\n";
  }

  void finish() {
    file_ << "</Piece>\n</PolyData>\n</VTKFile>\n";
    file_.finish();
  }

  // Cell k has the points k n ... k n + n - 1.
  void cells_of(std::size_t count, std::size_t n) {
    section(cells_, [&] {
      array("connectivity", 1, "Int64", [&](OutputFile& f) {
        for (std::size_t k = 0; k < count * n; ++k) f << std::to_string(k) << "\n";
      });
      array("offsets", 1, "Int64", [&](OutputFile& f) {
        for (std::size_t k = 1; k <= count; ++k) f << std::to_string(k * n) << "\n";
      });
    });
  }

 private:
  OutputFile file_;
  std::string cells_;
};

void write_discs(const std::filesystem::path& directory, std::size_t index, const System& system, double t,
                 const State& y) {
  const std::vector<Stress> stress = disc_stresses(system, t, y);
  const std::vector<double>& radius = system.parts().disc.radius;
  const int count = system.parts().disc.count();
  const auto spin = [&](int i) { return system.has_friction() ? y[system.spin_of(i)] : 0; };
  OutputFile csv(directory / numbered("discs", index, ".csv"));
  csv << "x [m],y [m],radius [m],vx [m/s],vy [m/s],spin [rad/s],von Mises [Pa]\n";
  for (int i = 0; i < count; ++i) {
    csv.row(y[system.x_of(i)], y[system.y_of(i)], radius[i], y[system.vx_of(i)], y[system.vy_of(i)], spin(i),
            von_mises(stress[i]));
  }
  csv.finish();
  PolyData vtk(directory / numbered("discs", index, ".vtp"), radius.size(), "Verts", radius.size());
  const auto scalar = [&](const std::string& name, const std::function<double(int)>& value) {
    vtk.array(name, 1, "Float64", [&](OutputFile& f) {
      for (int i = 0; i < count; ++i) f << value(i) << "\n";
    });
  };
  vtk.section("Points", [&] {
    vtk.array("points", 3, "Float64", [&](OutputFile& f) {
      for (int i = 0; i < count; ++i) f << y[system.x_of(i)] << " " << y[system.y_of(i)] << " 0\n";
    });
  });
  vtk.section("PointData", [&] {
    scalar("radius [m]", [&](int i) { return radius[i]; });
    scalar("spin [rad/s]", spin);
    scalar("von Mises [Pa]", [&](int i) { return von_mises(stress[i]); });
    vtk.array("velocity [m/s]", 3, "Float64", [&](OutputFile& f) {
      for (int i = 0; i < count; ++i) f << y[system.vx_of(i)] << " " << y[system.vy_of(i)] << " 0\n";
    });
  });
  vtk.cells_of(radius.size(), 1);
  vtk.finish();
}

void write_links(const std::filesystem::path& directory, std::size_t index, const System& system, const State& y) {
  const LinkArrays& link = system.parts().link;
  const System::Nodes nodes = system.nodes(y);
  const std::vector<double> force = link_forces(system, y);
  std::vector<int> intact;
  for (int k = 0; k < link.count(); ++k) {
    if (!system.torn(k)) intact.push_back(k);
  }
  OutputFile csv(directory / numbered("links", index, ".csv"));
  csv << "x1 [m],y1 [m],x2 [m],y2 [m],force [N],kind\n";
  for (const int k : intact) {
    csv.row(nodes.x[link.a[k]], nodes.y[link.a[k]], nodes.x[link.b[k]], nodes.y[link.b[k]], force[k],
            to_string(link.kind[k]));
  }
  csv.finish();
  PolyData vtk(directory / numbered("links", index, ".vtp"), 2 * intact.size(), "Lines", intact.size());
  vtk.section("Points", [&] {
    vtk.array("points", 3, "Float64", [&](OutputFile& f) {
      for (const int k : intact) {
        for (const int n : {link.a[k], link.b[k]}) f << nodes.x[n] << " " << nodes.y[n] << " 0\n";
      }
    });
  });
  vtk.section("CellData", [&] {
    vtk.array("force [N]", 1, "Float64", [&](OutputFile& f) {
      for (const int k : intact) f << force[k] << "\n";
    });
    vtk.array("kind", 1, "Int32", [&](OutputFile& f) {
      for (const int k : intact) f << static_cast<int>(link.kind[k]) << "\n";
    });
  });
  vtk.cells_of(intact.size(), 2);
  vtk.finish();
}

void write_plates(const std::filesystem::path& directory, std::size_t index, const System& system, double t) {
  const std::vector<PlatePart>& plates = system.parts().plate;
  OutputFile csv(directory / numbered("plates", index, ".csv"));
  PolyData vtk(directory / numbered("plates", index, ".vtp"), 4 * plates.size(), "Polys", plates.size());
  csv << "left [m],lower [m],width [m],height [m],vx [m/s],vy [m/s]\n";
  vtk.section("Points", [&] {
    vtk.array("points", 3, "Float64", [&](OutputFile& f) {
      for (int k = 0; k < static_cast<int>(plates.size()); ++k) {
        const PlatePart& p = plates[k];
        const System::PlateAt at = system.plate_at(k, t);
        csv.row(at.left, at.lower, p.width, p.height, at.vx, at.vy);
        f << at.left << " " << at.lower << " 0\n" << at.left + p.width << " " << at.lower << " 0\n";
        f << at.left + p.width << " " << at.lower + p.height << " 0\n"
          << at.left << " " << at.lower + p.height << " 0\n";
      }
    });
  });
  csv.finish();
  vtk.cells_of(plates.size(), 4);
  vtk.finish();
}

}  // namespace

void Frames::add(const System& system, double t, double displacement, const State& y) {
  const std::filesystem::path directory = directory_ / "frames";
  write_discs(directory, frames_.size(), system, t, y);
  write_links(directory, frames_.size(), system, y);
  write_plates(directory, frames_.size(), system, t);
  frames_.push_back({t, displacement});
}

void Frames::finish() const {
  OutputFile csv(directory_ / "frames" / "frames.csv");
  OutputFile pvd(directory_ / "run.pvd");
  csv << "index,t [s],displacement [m]\n";
  pvd << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (std::size_t k = 0; k < frames_.size(); ++k) {
    csv.row(static_cast<int>(k), frames_[k].t, frames_[k].displacement);
    int part = 0;
    for (const char* name : {"discs", "links", "plates"}) {
      pvd << "<DataSet timestep=\"" << frames_[k].t << "\" part=\"" << part++ << "\" name=\"" << name
          << "\" file=\"frames/" << numbered(name, k, ".vtp") << "\"/>\n";
    }
  }
  pvd << "</Collection>\n</VTKFile>\n";
  csv.finish();
  pvd.finish();
}

}  // namespace furrow
