// Faults of lattices as a whole: rows, columns, nodes and links that are not there, and what cannot be a stem.
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "scene/findings.h"
#include "scene/lattice_parts.h"
#include "scene/stem.h"
#include "scene/wording.h"

namespace furrow {
namespace {

bool has(const std::vector<int>& list, int value) { return std::find(list.begin(), list.end(), value) != list.end(); }

class LatticeJudge {
 public:
  LatticeJudge(std::string path, const Lattice& lattice, Findings& found)
      : path_(std::move(path)), lattice_(lattice), found_(found) {}

  void judge() {
    check_lines(".fixed_rows", lattice_.fixed_rows, lattice_.rows);
    check_lines(".fixed_columns", lattice_.fixed_columns, lattice_.columns);
    check_stem();
    for (std::size_t k = 0; k < lattice_.node.size(); ++k) check(path_ + '.' + item("node", k), lattice_.node[k]);
    for (std::size_t k = 0; k < lattice_.link.size(); ++k) check(path_ + '.' + item("link", k), lattice_.link[k]);
    for (std::size_t k = 0; k < lattice_.drive.size(); ++k) check('.' + item("drive", k), k);
  }

 private:
  // Paths that begin with a point are those of the lattice.
  std::string whole(const std::string& path) const { return path.starts_with('.') ? path_ + path : path; }
  void fault(const std::string& path, const std::string& message, std::vector<std::string> others = {}) {
    for (std::string& other : others) other = whole(other);
    found_.error(whole(path), message, others);
  }

  template <class Key>
  void once(std::map<Key, std::string>& said, const Key& key, const std::string& path) {
    const auto [first, fresh] = said.try_emplace(key, path);
    if (!fresh) fault(path, "the same as " + whole(first->second), {first->second});
  }

  void check_index(const std::string& where, int index, int count) {
    if (index < 0 || index >= count)
      fault(where, std::to_string(index) + " is outside the lattice, whose last is " + std::to_string(count - 1),
            {".rows", ".columns"});
  }

  void check_lines(const std::string& list, const std::vector<int>& lines, int count) {
    std::map<int, std::string> said;
    for (std::size_t k = 0; k < lines.size(); ++k) {
      check_index(item(list, k), lines[k], count);
      once(said, lines[k], item(list, k));
    }
  }

  void check(const std::string& where, const NodeSetting& node) {
    check_index(where + ".row", node.row, lattice_.rows);
    check_index(where + ".column", node.column, lattice_.columns);
    once(nodes_, std::pair(node.row, node.column), where);
    const bool fixed = has(lattice_.fixed_rows, node.row) || has(lattice_.fixed_columns, node.column);
    const bool driven = std::any_of(lattice_.drive.begin(), lattice_.drive.end(), [&](const Drive& d) {
      return has(d.rows, node.row) || has(d.columns, node.column);
    });
    const std::vector<std::string> hangs_on{where + ".row", where + ".column", ".fixed_rows", ".fixed_columns"};
    const auto held = [&](Vec2 v) {
      return ((fixed || driven || node.fixed_x) && v.x != 0) || ((fixed || driven || node.fixed_y) && v.y != 0);
    };
    const char* why = driven && !fixed ? "the node is driven" : "the node is fixed";
    if (held(node.velocity)) fault(where + ".velocity", why, hangs_on);
    if (held(node.force)) fault(where + ".force", why, hangs_on);
  }

  void check_stem() {
    if (!lattice_.stem) return;
    const Stem& s = *lattice_.stem;
    if (lattice_.columns < least_stem_columns || lattice_.columns > most_stem_columns)
      return fault(".columns", "a stem has 3, 4 or 5 columns");
    if (s.length < 2 * s.diameter) return fault(".stem.length", "less than two diameters: no rod", {".stem.diameter"});
    if (!has_springs(s, lattice_))
      fault(".stem", "no springs that pull back have its EA and EI: take fewer columns or a longer stem", {".columns"});
  }

  using Number = std::optional<double>;
  void not_both(const std::string& path, const char* a, const Number& given, const char* factor, double by) {
    if (given && by != 1) fault(path + factor, std::string(a + 1) + " is given too; give one of them", {path + a});
  }

  void check(const std::string& where, const LinkSetting& s) {
    not_both(where, ".stiffness", s.stiffness, ".stiffness_factor", s.stiffness_factor);
    not_both(where, ".strength", s.strength, ".strength_factor", s.strength_factor);
    for (const auto& [key, node] : {std::pair{".from", &s.from}, {".to", &s.to}})
      if (node->size() != (s.from.empty() && s.to.empty() ? 0 : 2))
        return fault(where + key, "from and to are a row and a column each", {where + ".from", where + ".to"});
    for (const auto& [key, line, count] :
         {std::tuple{".rows", &s.rows, lattice_.rows}, {".columns", &s.columns, lattice_.columns}})
      check_lines(where + key, *line, count);
    for (const auto& [key, node] : {std::pair{".from", &s.from}, {".to", &s.to}}) {
      if (node->empty()) continue;
      check_index(item(where + key, 0), node->front(), lattice_.rows);
      check_index(item(where + key, 1), node->back(), lattice_.columns);
    }
    if (s.cut_from.has_value() != s.cut_to.has_value())
      fault(where + (s.cut_from ? ".cut_from" : ".cut_to"), "a cut needs cut_from and cut_to");
  }

  void check(const std::string& where, std::size_t number) {
    const Drive& d = lattice_.drive[number];
    if (d.rows.empty() == d.columns.empty()) fault(where, "drives rows or columns: give one of them");
    check_lines(where + ".rows", d.rows, lattice_.rows);
    check_lines(where + ".columns", d.columns, lattice_.columns);
    const auto share = [](const std::vector<int>& a, const std::vector<int>& b) {
      return std::any_of(a.begin(), a.end(), [&](int line) { return has(b, line); });
    };
    const auto meet = [&](const std::vector<int>& rows, const std::vector<int>& columns) {
      return share(rows, d.rows) || share(columns, d.columns) || (!rows.empty() && !d.columns.empty()) ||
             (!columns.empty() && !d.rows.empty());
    };
    if (share(lattice_.fixed_rows, d.rows) || share(lattice_.fixed_columns, d.columns))
      fault(where, "drives nodes that are fixed", {".fixed_rows", ".fixed_columns"});
    for (std::size_t k = 0; k < number; ++k)
      if (meet(lattice_.drive[k].rows, lattice_.drive[k].columns))
        fault(where, "drives nodes that " + whole('.' + item("drive", k)) + " drives");
  }

  std::string path_;
  const Lattice& lattice_;
  Findings& found_;
  std::map<std::pair<int, int>, std::string> nodes_;
};

}  // namespace

void judge_lattices(const Scene& scene, Findings& found) {
  for (std::size_t k = 0; k < scene.lattice.size(); ++k)
    LatticeJudge(item("lattice", k), scene.lattice[k], found).judge();
}

}  // namespace furrow
