#include "output/observables.h"

#ifndef TOML_HEADER_ONLY
#define TOML_HEADER_ONLY 0
#endif
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>

#include "output/files.h"
#include "scene/read.h"

namespace furrow {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double stretch = 50;       // mm, over which local maxima are taken
constexpr double force_free = 0.01;  // of the run's largest force: about the width of a line in the paper's figures

ForceCurve force_curve(const Table& table) {
  ForceCurve curve;
  const auto& plate = table.texts("plate");
  const auto mm = table.numbers("displacement [m]"), fx = table.numbers("Fx [N]"), fy = table.numbers("Fy [N]"),
             f = table.numbers("F [N]");
  for (std::size_t k = 0; k < plate.size(); ++k) {
    if (plate[k] != plate[0]) continue;
    curve.mm.push_back(1e3 * mm[k]);
    curve.fx.push_back(0 - fx[k]);
    curve.fy.push_back(fy[k]);
    curve.f.push_back(f[k]);
  }
  return curve;
}

Parts lattices_of(Scene scene) {
  scene.disc.clear();
  scene.packing.clear();
  scene.plate.clear();
  return make_parts(scene);
}

std::vector<TornLink> torn_links(const Table& events, const Parts& parts) {
  using Ends = std::array<int, 4>;
  std::map<std::pair<std::string, Ends>, int> index;
  for (int k = 0; k < parts.link.count(); ++k) {
    const int a = parts.link.a[k], b = parts.link.b[k];
    const std::string& lattice = parts.lattice[parts.node.lattice[a]].name;
    index[{to_string(parts.link.kind[k]) + " " + lattice,
           {parts.node.row[a], parts.node.column[a], parts.node.row[b], parts.node.column[b]}}] = k;
  }
  const auto mm = events.numbers("displacement [m]");
  const auto &kind = events.texts("kind"), &lattice = events.texts("lattice");
  const auto row_a = events.integers("row a"), column_a = events.integers("column a"), row_b = events.integers("row b"),
             column_b = events.integers("column b");
  std::vector<TornLink> torn;
  for (std::size_t k = 0; k < mm.size(); ++k) {
    const auto found = index.find({kind[k] + " " + lattice[k], {row_a[k], column_a[k], row_b[k], column_b[k]}});
    if (found == index.end()) throw std::runtime_error("events.csv: line " + std::to_string(k + 2) + ": no such link in the scene");
    torn.push_back({1e3 * mm[k], found->second});
  }
  return torn;
}

std::string numbered(const char* kind, int index) {
  const std::string digits = std::to_string(index);
  return std::string(kind) + "_" + std::string(digits.size() < 3 ? 3 - digits.size() : 0, '0') + digits + ".csv";
}

// NaN if a value is NaN, if the window is empty, or if the run ended before the window does.
double extreme(const ForceCurve& curve, const std::vector<double>& values, std::array<double, 2> window,
               const std::function<bool(double, double)>& better) {
  constexpr double slack = 1;  // mm, less than which a run may fall short of the window
  double best = nan;
  if (curve.mm.empty() || curve.mm.back() < window[1] - slack) return nan;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (curve.mm[k] < window[0] || curve.mm[k] > window[1]) continue;
    if (std::isnan(values[k])) return nan;
    if (std::isnan(best) || better(values[k], best)) best = values[k];
  }
  return best;
}

double largest(const ForceCurve& c, const std::vector<double>& values, std::array<double, 2> window) {
  return extreme(c, values, window, std::greater<>());
}

double end_of(const ForceCurve& c) { return c.mm.empty() ? 0 : c.mm.back(); }

// Whether the plate feels nothing, by sample.
std::vector<bool> free_samples(const ForceCurve& c) {
  const double limit = force_free * largest(c, c.f, {0, end_of(c)});
  std::vector<bool> is_free;
  for (const double f : c.f) is_free.push_back(f <= limit);  // nothing is free if the limit is NaN
  return is_free;
}

double first_impact(const ForceCurve& c) {
  const auto is_free = free_samples(c);
  const auto begin = std::find(is_free.begin(), is_free.end(), false);
  const auto end = std::find(begin, is_free.end(), true);
  if (begin == is_free.end()) return nan;
  return largest(c, c.fx, {c.mm[static_cast<std::size_t>(begin - is_free.begin())],
                           end == is_free.end() ? end_of(c) : c.mm[static_cast<std::size_t>(end - is_free.begin())]});
}

// The longest stretch without force between two contacts, before the split. NaN, NaN if there is none.
std::array<double, 2> free_flight(const RunRecord& run) {
  const ForceCurve& c = run.force;
  const auto is_free = free_samples(c);
  const double split = split_at(run), last = std::isnan(split) ? end_of(c) : split;
  std::array<double, 2> best{nan, nan};
  double begin = nan;
  bool touched = false;
  for (std::size_t k = 0; k < is_free.size() && c.mm[k] <= last; ++k) {
    if (is_free[k] && touched && std::isnan(begin)) begin = c.mm[k];
    if (is_free[k]) continue;
    if (!std::isnan(begin) && !(c.mm[k] - begin <= best[1] - best[0])) best = {begin, c.mm[k]};
    begin = nan;
    touched = true;
  }
  return best;
}

double force_ratio(const ForceCurve& c, std::array<double, 2> window) {
  if (end_of(c) < window[1] - 1) return nan;
  double fx = 0, fy = 0;
  for (std::size_t k = 0; k < c.mm.size(); ++k) {
    if (c.mm[k] < window[0] || c.mm[k] > window[1]) continue;
    fx += std::abs(c.fx[k]);
    fy += std::abs(c.fy[k]);
  }
  return fy > 0 ? fx / fy : nan;
}

double growth(const ForceCurve& c) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (const Maximum& m : maxima(c, stretch)) {
    const double x = m.mm / 100, y = std::log(m.f);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return n < 2 ? nan : std::exp((n * sxy - sx * sy) / (n * sxx - sx * sx));
}

using Torn = std::vector<char>;  // by link

// Nodes that chains of intact links join to the lowest row (`from_top`: the highest row) of their lattice.
std::vector<char> joined(const Parts& parts, const Torn& torn, bool from_top) {
  std::vector<int> top(parts.lattice.size(), 0);
  for (int k = 0; k < parts.node.count(); ++k) top[parts.node.lattice[k]] = std::max(top[parts.node.lattice[k]], parts.node.row[k]);
  std::vector<char> reached(parts.node.row.size());
  for (int k = 0; k < parts.node.count(); ++k) reached[k] = parts.node.row[k] == (from_top ? top[parts.node.lattice[k]] : 0);
  for (bool grown = true; grown;) {
    grown = false;
    for (int k = 0; k < parts.link.count(); ++k) {
      char &a = reached[parts.link.a[k]], &b = reached[parts.link.b[k]];
      if (torn[k] || a == b) continue;
      a = b = 1;
      grown = true;
    }
  }
  return reached;
}

struct Split {
  double mm = nan;
  std::string pieces;
};

Split split_of(const RunRecord& run) {
  const Parts& parts = run.lattices;
  Torn torn(parts.link.a.size());
  for (const TornLink& t : run.torn) {
    torn[t.link] = 1;
    const auto low = joined(parts, torn, false), high = joined(parts, torn, true);
    bool apart = true;
    for (std::size_t k = 0; k < low.size(); ++k) apart = apart && !(low[k] && high[k]);
    if (!apart) continue;
    const auto count = [](const std::vector<char>& piece) { return std::to_string(std::count(piece.begin(), piece.end(), 1)); };
    return {t.mm, count(low) + " below, " + count(high) + " above, of " + std::to_string(low.size())};
  }
  return {};
}

double fixed_links_torn(const RunRecord& run) {
  int left = 0;
  for (int k = 0; k < run.lattices.link.count(); ++k) left += half_fixed(run.lattices, k);
  for (const TornLink& t : run.torn) {
    left -= half_fixed(run.lattices, t.link);
    if (left == 0) return t.mm;
  }
  return nan;
}

const TornLink* first_structural(const RunRecord& run) {
  for (const TornLink& t : run.torn) {
    if (run.lattices.link.kind[t.link] == LinkClass::structural) return &t;
  }
  return nullptr;
}

std::string place_of(const Parts& parts, int link) {
  const int a = parts.link.a[link], b = parts.link.b[link];
  const auto node = [&](int k) {
    return "row " + std::to_string(parts.node.row[k] + 1) + ", column " + std::to_string(parts.node.column[k] + 1) +
           (parts.node.body[k] < 0 ? " (fixed)" : "");
  };
  return node(a) + " to " + node(b);
}

bool node_in_plate(const Frame& frame) {
  const auto left = frame.plates.numbers("left [m]"), lower = frame.plates.numbers("lower [m]"),
             width = frame.plates.numbers("width [m]"), height = frame.plates.numbers("height [m]");
  for (const char* end : {"1", "2"}) {
    const auto x = frame.links.numbers("x" + std::string(end) + " [m]"), y = frame.links.numbers("y" + std::string(end) + " [m]");
    for (std::size_t k = 0; k < x.size(); ++k) {
      for (std::size_t p = 0; p < left.size(); ++p) {
        if (x[k] > left[p] && x[k] < left[p] + width[p] && y[k] > lower[p] && y[k] < lower[p] + height[p]) return true;
      }
    }
  }
  return false;
}

Measured plate_meets_lattice(const RunRecord& run) {
  for (std::size_t k = 0; k < run.frames.size(); ++k) {
    if (!node_in_plate(run.frames[k])) continue;
    const auto mm = [&](std::size_t frame) { return std::to_string(std::lround(run.frames[frame].mm)); };
    return {nan, k == 0 ? "at the start" : "between " + mm(k - 1) + " and " + mm(k)};
  }
  return {};
}

using Observable = std::function<Measured(const RunRecord&, std::array<double, 2> window)>;

// Every observable that a statement may name.
const std::map<std::string, Observable, std::less<>>& observables() {
  using Window = std::array<double, 2>;
  const auto after_split = [](const RunRecord& r, bool smallest) {
    const double split = split_at(r);
    if (std::isnan(split)) return nan;
    const Window window{split, end_of(r.force)};
    return smallest ? extreme(r.force, r.force.f, window, std::less<>()) : largest(r.force, r.force.f, window);
  };
  const auto second_contact = [](const RunRecord& r, std::vector<double> values) {
    for (double& v : values) v = std::abs(v);
    return largest(r.force, values, {free_flight(r)[1], end_of(r.force)});
  };
  static const std::map<std::string, Observable, std::less<>> all{
      {"largest_force", [](auto& r, Window w) { return Measured{largest(r.force, r.force.f, w), ""}; }},
      {"largest_force_at",
       [](auto& r, Window w) {
         const auto at = std::find(r.force.f.begin(), r.force.f.end(), largest(r.force, r.force.f, w));
         return Measured{at == r.force.f.end() ? nan : r.force.mm[static_cast<std::size_t>(at - r.force.f.begin())], ""};
       }},
      {"first_impact", [](auto& r, Window) { return Measured{first_impact(r.force), ""}; }},
      {"free_flight_begins", [](auto& r, Window) { return Measured{free_flight(r)[0], ""}; }},
      {"free_flight_ends", [](auto& r, Window) { return Measured{free_flight(r)[1], ""}; }},
      {"second_contact_fx", [=](auto& r, Window) { return Measured{second_contact(r, r.force.fx), ""}; }},
      {"second_contact_fy", [=](auto& r, Window) { return Measured{second_contact(r, r.force.fy), ""}; }},
      {"force_ratio", [](auto& r, Window w) { return Measured{force_ratio(r.force, w), ""}; }},
      {"force_free_share",
       [](auto& r, Window) {
         const auto is_free = free_samples(r.force);
         const auto count = static_cast<double>(std::count(is_free.begin(), is_free.end(), true));
         return Measured{is_free.empty() ? nan : 100 * count / static_cast<double>(is_free.size()), ""};
       }},
      {"growth_of_maxima", [](auto& r, Window) { return Measured{growth(r.force), ""}; }},
      {"first_tear", [](auto& r, Window) { return Measured{r.torn.empty() ? nan : r.torn[0].mm, ""}; }},
      {"first_structural_tear",
       [](auto& r, Window) { return Measured{first_structural(r) ? first_structural(r)->mm : nan, ""}; }},
      {"first_structural_tear_place",
       [](auto& r, Window) {
         return Measured{nan, first_structural(r) ? place_of(r.lattices, first_structural(r)->link) : ""};
       }},
      {"fixed_links_torn", [](auto& r, Window) { return Measured{fixed_links_torn(r), ""}; }},
      {"split", [](auto& r, Window) { return Measured{split_at(r), ""}; }},
      {"pieces", [](auto& r, Window) { return Measured{nan, split_of(r).pieces}; }},
      {"plate_meets_lattice", [](auto& r, Window) { return plate_meets_lattice(r); }},
      {"smallest_force_after_split", [=](auto& r, Window) { return Measured{after_split(r, true), ""}; }},
      {"largest_force_after_split", [=](auto& r, Window) { return Measured{after_split(r, false), ""}; }},
  };
  return all;
}

}  // namespace

RunRecord read_run(const std::string& name, const std::filesystem::path& directory) {
  RunRecord run;
  run.name = name;
  const auto facts = directory / "run.json";
  try {
    run.facts = nlohmann::json::parse(run_file(facts));
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(facts.string() + ": " + error.what());
  }
  if (!run.facts.is_object()) throw std::runtime_error(facts.string() + ": is not a JSON object");
  const auto scene = directory / "scene.toml";
  run.scene = parse_scene(run_file(scene), scene.string());
  run.lattices = lattices_of(run.scene);
  run.force = force_curve(Table(directory / "plate_force.csv"));
  run.energy = Table(directory / "energy.csv");
  try {
    run.torn = torn_links(Table(directory / "events.csv"), run.lattices);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(directory.string() + ": " + error.what());
  }
  const auto frames = directory / "frames";
  const Table list(frames / "frames.csv");
  const auto index = list.integers("index");
  const auto displacement = list.numbers("displacement [m]");
  for (std::size_t k = 0; k < index.size(); ++k) {
    run.frames.push_back({1e3 * displacement[k], Table(frames / numbered("discs", index[k])),
                          Table(frames / numbered("links", index[k])), Table(frames / numbered("plates", index[k]))});
  }
  return run;
}

Publication read_publication(std::string_view text) {
  try {
    const toml::table root = toml::parse(text);
    Publication publication{root["title"].value_or(std::string()), {}};
    const toml::array* entries = root["statement"].as_array();
    for (std::size_t k = 0; entries && k < entries->size(); ++k) {
      const toml::table& entry = *entries->get(k)->as_table();
      const auto words = [&](const char* key) { return entry[key].value_or(std::string()); };
      Statement s{words("id"), words("scene"), words("quantity"), words("unit"), words("relation"), words("where"),
                  words("read"), words("observable"), words("ours"), words("mark"), {}, {}, {}, {}};
      s.words = words("value");
      s.value = entry["value"].is_string() ? nan : entry["value"].value_or(nan);
      s.label = entry["label"].value_or(number(s.value) + " " + s.unit);
      if (const toml::array* w = entry["window"].as_array()) s.window = {w->at(0).value_or(nan), w->at(1).value_or(nan)};
      if (s.id.empty() || (s.words.empty() && std::isnan(s.value))) {
        throw std::runtime_error("paper.toml: statement " + std::to_string(k + 1) + " has no id or no value");
      }
      publication.statements.push_back(std::move(s));
    }
    return publication;
  } catch (const toml::parse_error& error) {
    throw std::runtime_error("paper.toml: " + std::string(error.description()));
  }
}

Measured measure(const RunRecord& run, const Statement& statement) {
  const auto found = observables().find(statement.observable);
  if (found == observables().end()) throw std::invalid_argument("there is no observable '" + statement.observable + "'");
  return found->second(run, statement.window.value_or(std::array{0.0, end_of(run.force)}));
}

std::vector<Maximum> maxima(const ForceCurve& curve, double length) {
  std::vector<Maximum> found;
  for (double from = 0; from + length <= end_of(curve) + 1; from += length) {
    const double top = largest(curve, curve.f, {from, from + length});
    const auto at = std::find(curve.f.begin(), curve.f.end(), top);
    found.push_back({at == curve.f.end() ? nan : curve.mm[static_cast<std::size_t>(at - curve.f.begin())], top});
  }
  return found;
}

double split_at(const RunRecord& run) { return split_of(run).mm; }

bool half_fixed(const Parts& lattices, int link) {
  return (lattices.node.body[lattices.link.a[link]] < 0) != (lattices.node.body[lattices.link.b[link]] < 0);
}

}  // namespace furrow
