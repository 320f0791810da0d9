#include "page/observables.h"

#ifndef TOML_HEADER_ONLY
#define TOML_HEADER_ONLY 0
#endif
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "output/files.h"
#include "scene/read.h"

namespace furrow {
namespace {

using Window = std::array<double, 2>;  // mm

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<Fact> read_facts(const std::filesystem::path& file) {
  const auto text_of = [](const nlohmann::ordered_json& value) {
    if (value.is_number_float()) return number(value.get<double>());
    return value.is_string() ? value.get<std::string>() : value.dump();
  };
  std::vector<Fact> facts;
  try {
    const auto json = nlohmann::ordered_json::parse(run_text(file));
    if (!json.is_object()) throw std::runtime_error(file.string() + ": is not a JSON object");
    for (const auto& [key, value] : json.items()) {
      facts.push_back({key, {}, value.is_number_float()});
      if (value.is_array()) {
        for (const auto& part : value) facts.back().texts.push_back(text_of(part));
      } else if (!value.is_null()) {
        facts.back().texts.push_back(text_of(value));
      }
    }
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
  return facts;
}

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
  std::map<std::vector<std::string>, int> index;
  for (int k = 0; k < parts.link.count(); ++k) {
    const int a = parts.link.a[k], b = parts.link.b[k], owner = parts.node.lattice[a];
    const std::string& name = parts.lattice[owner].name;
    index[{to_string(parts.link.kind[k]), name.empty() ? std::to_string(owner) : name,
           std::to_string(parts.node.row[a]), std::to_string(parts.node.column[a]), std::to_string(parts.node.row[b]),
           std::to_string(parts.node.column[b])}] = k;
  }
  const auto mm = events.numbers("displacement [m]");
  std::vector<TornLink> torn;
  for (std::size_t k = 0; k < mm.size(); ++k) {
    std::vector<std::string> key;
    for (const char* column : {"kind", "lattice", "row a", "column a", "row b", "column b"})
      key.push_back(events.texts(column)[k]);
    const auto found = index.find(key);
    if (found == index.end())
      throw std::runtime_error(events.file() + ":" + std::to_string(k + 2) + ": no such link in the scene");
    torn.push_back({1e3 * mm[k], found->second});
  }
  return torn;
}

// Samples [first, last) of a window; none if the run ended before the window does.
struct Samples {
  std::size_t first = 0, last = 0;
};

Samples samples_in(const ForceCurve& c, Window w) {
  constexpr double slack = 1;  // mm, by which a run may fall short of the window
  if (!(w[0] <= w[1]) || c.end() < w[1] - slack) return {};
  return {static_cast<std::size_t>(std::lower_bound(c.mm.begin(), c.mm.end(), w[0]) - c.mm.begin()),
          static_cast<std::size_t>(std::upper_bound(c.mm.begin(), c.mm.end(), w[1]) - c.mm.begin())};
}

// Index of the largest value in magnitude (`sign` -1: the smallest); `last` if there is none or one is NaN.
std::size_t extreme(const std::vector<double>& values, Samples s, double sign = 1) {
  std::size_t best = s.last;
  for (std::size_t k = s.first; k < s.last; ++k) {
    if (std::isnan(values[k])) return s.last;
    if (best == s.last || sign * std::abs(values[k]) > sign * std::abs(values[best])) best = k;
  }
  return best;
}

double value_at(const std::vector<double>& values, Samples s, std::size_t k) { return k == s.last ? nan : values[k]; }

double largest(const std::vector<double>& values, Samples s) {
  return std::abs(value_at(values, s, extreme(values, s)));
}

double force_ratio(const ForceCurve& c, Samples s) {
  double fx = 0, fy = 0;
  for (std::size_t k = s.first; k < s.last; ++k) fx += std::abs(c.fx[k]), fy += std::abs(c.fy[k]);
  return fy > 0 ? fx / fy : nan;
}

// Share of the run in percent.
double force_free_share(const ForceCurve& c) {
  return 100 * static_cast<double>(std::count(c.f.begin(), c.f.end(), 0.0)) / static_cast<double>(c.f.size());
}

// Least-squares exponential through the largest forces per 50 mm: its factor per 100 mm.
double growth_of_maxima(const ForceCurve& c) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (const auto& [mm, f] : maxima(c, 50)) {
    const double x = mm / 100, y = std::log(f);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return n < 2 ? nan : std::exp((n * sxy - sx * sy) / (n * sxx - sx * sx));
}

// The first contact ends where nothing touches the plate for 1 mm or more before the second begins. mm; NaN: never.
struct Contacts {
  double first = nan, ended = nan, second = nan;
};

Contacts contacts_of(const ForceCurve& c) {
  Contacts found;
  double since = nan;  // mm, start of the stretch without force that we are in
  for (std::size_t k = 0; k < c.mm.size(); ++k) {
    if (c.f[k] == 0) {
      if (std::isnan(since)) since = c.mm[k];
      continue;
    }
    if (std::isnan(found.first)) {
      found.first = c.mm[k];
    } else if (c.mm[k] - since >= 1) {
      return {found.first, since, c.mm[k]};
    }
    since = nan;
  }
  return found;
}

// How many nodes chains of intact links join to the lowest row and to the highest, or none if they are the same nodes.
struct Pieces {
  int low = 0, high = 0;
};

Pieces pieces_of(const Parts& parts, const std::vector<char>& torn) {
  std::vector<int> top(parts.lattice.size(), 0);
  for (int k = 0; k < parts.node.count(); ++k) {
    int& row = top[parts.node.lattice[k]];
    row = std::max(row, parts.node.row[k]);
  }
  std::vector<int> joined(parts.node.row.size());  // to the lowest row: 1, to the highest: 2
  for (int k = 0; k < parts.node.count(); ++k) {
    joined[k] = (parts.node.row[k] == 0 ? 1 : 0) | (parts.node.row[k] == top[parts.node.lattice[k]] ? 2 : 0);
  }
  for (bool grown = true; grown;) {
    grown = false;
    for (int k = 0; k < parts.link.count(); ++k) {
      int &a = joined[parts.link.a[k]], &b = joined[parts.link.b[k]];
      if (torn[k] || a == b) continue;
      a = b = a | b;
      grown = true;
    }
  }
  if (std::count(joined.begin(), joined.end(), 3) > 0) return {};
  return {static_cast<int>(std::count(joined.begin(), joined.end(), 1)),
          static_cast<int>(std::count(joined.begin(), joined.end(), 2))};
}

// Displacement of the plate from which no chain of links joins the lowest row of a lattice to the highest. mm; NaN:
// never.
struct Split {
  double mm = nan;
  Pieces pieces;
};

Split split_of(const RunRecord& run) {
  std::vector<char> torn(run.lattices.link.a.size());
  for (const TornLink& t : run.torn) {
    torn[t.link] = 1;
    const Pieces pieces = pieces_of(run.lattices, torn);
    if (pieces.low + pieces.high > 0) return {t.mm, pieces};
  }
  return {};
}

double fixed_links_torn(const RunRecord& run) {
  int left = 0;
  for (int k = 0; k < run.lattices.link.count(); ++k) left += half_fixed(run.lattices, k);
  for (const TornLink& t : run.torn) {
    if (half_fixed(run.lattices, t.link) && --left == 0) return t.mm;
  }
  return nan;
}

std::string place_of(const Parts& parts, int link) {
  const auto node = [&](int k) {
    return "row " + std::to_string(parts.node.row[k] + 1) + ", column " + std::to_string(parts.node.column[k] + 1) +
           (parts.node.body[k] < 0 ? " (fixed)" : "");
  };
  return node(parts.link.a[link]) + " to " + node(parts.link.b[link]);
}

bool linked_node_in_plate(const Frame& frame) {
  const auto left = frame.plates.numbers("left [m]"), lower = frame.plates.numbers("lower [m]"),
             width = frame.plates.numbers("width [m]"), height = frame.plates.numbers("height [m]");
  for (const std::string end : {"1", "2"}) {
    const auto x = frame.links.numbers("x" + end + " [m]"), y = frame.links.numbers("y" + end + " [m]");
    for (std::size_t k = 0; k < x.size(); ++k) {
      for (std::size_t p = 0; p < left.size(); ++p) {
        if (x[k] > left[p] && x[k] < left[p] + width[p] && y[k] > lower[p] && y[k] < lower[p] + height[p]) return true;
      }
    }
  }
  return false;
}

Measured plate_meets_lattice(const RunRecord& run) {
  const auto mm = [&](std::size_t frame) { return std::to_string(std::lround(run.frames[frame].mm)); };
  for (std::size_t k = 0; k < run.frames.size(); ++k) {
    if (linked_node_in_plate(run.frames[k])) {
      return {.words = k == 0 ? "at the start" : "between " + mm(k - 1) + " and " + mm(k) + " mm"};
    }
  }
  return {.words = "in no snapshot"};
}

// For what need not happen in a run at all, other than what a run does not say.
Measured if_ever(double mm) { return {mm, std::isnan(mm) ? "not by the end" : ""}; }

Measured lattice_observable(const RunRecord& run, const std::string& name) {
  const ForceCurve& c = run.force;
  const auto structural = [&](const TornLink& t) { return run.lattices.link.kind[t.link] == LinkClass::structural; };
  const auto first = std::find_if(run.torn.begin(), run.torn.end(), structural);
  const bool any = first != run.torn.end();
  if (name == "first_tear") return if_ever(run.torn.empty() ? nan : run.torn[0].mm);
  if (name == "first_structural_tear") return if_ever(any ? first->mm : nan);
  if (name == "first_structural_tear_place") return {.words = any ? place_of(run.lattices, first->link) : "none torn"};
  if (name == "fixed_links_torn") return if_ever(fixed_links_torn(run));
  if (name == "plate_meets_lattice") return plate_meets_lattice(run);

  const Split split = split_of(run);
  if (name == "split") return if_ever(split.mm);
  const Samples after = samples_in(c, {split.mm, c.end()});
  const std::string none = std::isnan(split.mm) ? "no split" : "";
  if (name == "smallest_force_after_split") return {value_at(c.f, after, extreme(c.f, after, -1)), none};
  if (name == "largest_force_after_split") return {largest(c.f, after), none};
  if (name != "pieces") throw std::invalid_argument("there is no observable '" + name + "'");
  if (!none.empty()) return {.words = none};
  return {.words = std::to_string(split.pieces.low) + " below, " + std::to_string(split.pieces.high) + " above, of " +
                   std::to_string(run.lattices.node.count())};
}

}  // namespace

const Fact* RunRecord::fact(std::string_view key) const {
  const auto found = std::find_if(facts.begin(), facts.end(), [&](const Fact& f) { return f.key == key; });
  return found == facts.end() ? nullptr : &*found;
}

bool RunRecord::finished() const {
  const Fact* ended = fact("ended");
  return ended && ended->texts == std::vector<std::string>{"finished"};
}

RunRecord read_run(const std::string& name, const std::filesystem::path& directory) {
  RunRecord run;
  run.name = name;
  const auto scene = directory / "scene.toml", frames = directory / "frames";
  run.facts = read_facts(directory / "run.json");
  run.scene = parse_scene(run_text(scene), scene.string());
  run.lattices = lattices_of(run.scene);
  if (!run.fact("steps")) return run;
  run.force = force_curve(Table(directory / "plate_force.csv"));
  run.energy = Table(directory / "energy.csv");
  run.torn = torn_links(Table(directory / "events.csv"), run.lattices);
  const Table list(frames / "frames.csv");
  const auto displacement = list.numbers("displacement [m]");
  for (std::size_t k = 0; k < list.rows(); ++k) {
    const std::string& index = list.texts("index")[k];
    const std::string ending = "_" + std::string(index.size() < 3 ? 3 - index.size() : 0, '0') + index + ".csv";
    run.frames.push_back({1e3 * displacement[k], Table(frames / ("discs" + ending)), Table(frames / ("links" + ending)),
                          Table(frames / ("plates" + ending))});
  }
  return run;
}

Publication read_publication(std::string_view text) {
  try {
    const toml::table root = toml::parse(text);
    Publication publication{root["title"].value_or(std::string()), {}};
    const toml::array* entries = root["statement"].as_array();
    for (std::size_t k = 0; entries && k < entries->size(); ++k) {
      const toml::node_view entry(*entries->get(k));
      Statement s;
      for (const auto& [key, field] : {std::pair{"id", &s.id},
                                       {"scene", &s.scene},
                                       {"quantity", &s.quantity},
                                       {"value", &s.words},
                                       {"unit", &s.unit},
                                       {"relation", &s.relation},
                                       {"where", &s.where},
                                       {"read", &s.read},
                                       {"observable", &s.observable},
                                       {"ours", &s.ours},
                                       {"mark", &s.mark}}) {
        *field = entry[key].value_or(std::string());
      }
      if (s.words.empty()) s.value = entry["value"].value_or(nan);
      s.label = entry["label"].value_or(number(s.value) + " " + s.unit);
      const auto pair = [&](const char* key) -> std::optional<Window> {
        if (!entry[key].is_array()) return std::nullopt;
        return Window{entry[key][0].value_or(nan), entry[key][1].value_or(nan)};
      };
      s.window = pair("window");
      s.holds = pair("holds");
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

Measured measure(const RunRecord& run, const std::string& name, std::optional<Window> window) {
  const ForceCurve& c = run.force;
  if (c.mm.empty()) return {};
  const Samples s = samples_in(c, window.value_or(Window{0, c.end()}));
  if (name == "largest_force") return {largest(c.f, s)};
  if (name == "largest_force_at") return {value_at(c.mm, s, extreme(c.f, s))};
  if (name == "force_ratio") return {force_ratio(c, s)};
  if (name == "force_free_share") return {force_free_share(c)};
  if (name == "growth_of_maxima") return {growth_of_maxima(c)};
  const Contacts contacts = contacts_of(c);
  const double first_end = std::isnan(contacts.ended) ? c.end() : contacts.ended;
  if (name == "first_impact") return {largest(c.fx, samples_in(c, {contacts.first, first_end}))};
  if (name == "free_flight_begins") return if_ever(contacts.ended);
  if (name == "free_flight_ends") return if_ever(contacts.second);
  const Samples second = samples_in(c, {contacts.second, c.end()});
  const std::string none = std::isnan(contacts.second) ? "no second contact" : "";
  if (name == "second_contact_fx") return {largest(c.fx, second), none};
  if (name == "second_contact_fy") return {largest(c.fy, second), none};
  return lattice_observable(run, name);
}

std::vector<std::array<double, 2>> maxima(const ForceCurve& curve, double length) {
  std::vector<std::array<double, 2>> found;
  for (double from = 0; from + length <= curve.end() + 1; from += length) {
    const Samples s = samples_in(curve, {from, from + length});
    const std::size_t k = extreme(curve.f, s);
    found.push_back({value_at(curve.mm, s, k), value_at(curve.f, s, k)});
  }
  return found;
}

bool half_fixed(const Parts& lattices, int link) {
  return (lattices.node.body[lattices.link.a[link]] < 0) != (lattices.node.body[lattices.link.b[link]] < 0);
}

}  // namespace furrow
