#include "validation/studies/golden_compare.h"

#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <sstream>

#include "output/files.h"
#include "report/seal.h"

namespace furrow::validation {
namespace {

constexpr double slack = 1e-9;  // s: times are sums of steps
constexpr std::size_t energies = 11;

// ---- what a golden must be ----

bool is_finite(const Json& value) { return value.is_number() && std::isfinite(value.get<double>()); }

// A row of these kinds: 'n' a finite number, 's' a text.
bool is_row(const Json& row, std::string_view kinds) {
  if (!row.is_array() || row.size() != kinds.size()) return false;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    if (kinds[k] == 'n' ? !is_finite(row[k]) : !row[k].is_string()) return false;
  }
  return true;
}

bool is_checkpoint(const Json& row) {
  if (!row.is_object() || !row.contains("t") || !is_finite(row["t"])) return false;
  if (!row.contains("hash") || !row["hash"].is_string() || row["hash"].get<std::string>().size() != 16) return false;
  if (!row.contains("energies") || !row["energies"].is_object() || row["energies"].size() != energies) return false;
  for (const auto& [name, value] : row["energies"].items()) {
    if (!is_finite(value)) return false;
  }
  return true;
}

double time_of(const Json& row) { return row.is_object() ? row.at("t").get<double>() : row.at(0).get<double>(); }

// Of rows with a time: that it goes from `from` on and never back, and not beyond the end.
bool in_order(const Json& rows, double end) {
  double before = 0;
  for (const Json& row : rows) {
    if (time_of(row) < before || time_of(row) > end + slack) return false;
    before = time_of(row);
  }
  return true;
}

struct Kind {
  const char *key, *what, *row;
};
constexpr std::array kinds{Kind{"force", "force curve", "nnn"}, Kind{"tears", "tears", "nsn"},
                           Kind{"positions", "positions at the end", "nn"}};

std::string malformed_rows(const Json& golden) {
  for (const auto& [key, what, kind] : kinds) {
    if (!golden.contains(key) || !golden[key].is_array()) return std::string("no ") + what;
    for (std::size_t k = 0; k < golden[key].size(); ++k) {
      if (!is_row(golden[key][k], kind))
        return std::string(what) + ": row " + std::to_string(k) + " is not of finite numbers and texts as it must be";
    }
  }
  return {};
}

std::string malformed_checkpoints(const Json& golden) {
  if (!golden.contains("checkpoints") || !golden["checkpoints"].is_array()) return "no checkpoints";
  const Json& points = golden["checkpoints"];
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!is_checkpoint(points[k]))
      return "checkpoint " + std::to_string(k) + " is not a time, a hash of 16 digits and " + std::to_string(energies) +
             " finite energies";
  }
  if (points.size() < 3) return "only " + std::to_string(points.size()) + " checkpoints, at least 3 are kept";
  if (time_of(points[0]) != 0 || std::fabs(time_of(points[1]) - first_checkpoint) > slack)
    return "the first checkpoints are not at 0 and " + number(first_checkpoint) + " s";
  return {};
}

// ---- differences ----

struct Difference {
  double time;
  std::string text;
};

bool same_bits(const Json& a, const Json& b) {
  if (a.is_number() && b.is_number())
    return std::bit_cast<std::uint64_t>(a.get<double>()) == std::bit_cast<std::uint64_t>(b.get<double>());
  return a == b;
}

std::string at_time(double t) { return "at t = " + number(t) + " s, "; }

// The earliest difference of those that were seen.
class First {
 public:
  void see(double time, const std::string& text) {
    if (!found_ || time < found_->time) found_ = {time, text};
  }
  void see(double time, const std::string& place, const Json& ours, const Json& golden) {
    if (!same_bits(ours, golden))
      see(time, at_time(time) + place + ": ours " + ours.dump() + ", golden " + golden.dump());
  }
  std::string text() const { return found_ ? found_->text : ""; }

 private:
  std::optional<Difference> found_;
};

void compare_checkpoints(const Json& ours, const Json& golden, First& first) {
  first.see(time_of(golden), "time of the checkpoint", ours.at("t"), golden.at("t"));
  first.see(time_of(golden), "state hash", ours.at("hash"), golden.at("hash"));
  for (const auto& [name, value] : golden.at("energies").items())
    first.see(time_of(golden), "energy " + name, ours.at("energies").value(name, Json()), value);
}

constexpr std::array force_columns{"time", "Fx [N]", "Fy [N]"};
constexpr std::array tear_columns{"time", "link", "force [N]"};

void compare_row(const std::string& key, std::size_t k, const Json& ours, const Json& golden, First& first) {
  if (key == "checkpoints") return compare_checkpoints(ours, golden, first);
  for (std::size_t c = 0; c < golden.size(); ++c) {
    const std::string column = key == "force" ? force_columns[c] : tear_columns[c];
    first.see(std::min(time_of(ours), time_of(golden)), key + ", row " + std::to_string(k) + ", " + column, ours.at(c),
              golden.at(c));
  }
}

// Rows with a time, of the golden those up to `end`. Returns how many were compared.
std::size_t compare_timed(const std::string& key, const Json& ours, const Json& golden, double end, First& first) {
  std::size_t theirs = 0;
  while (theirs < golden.size() && time_of(golden[theirs]) <= end + slack) ++theirs;
  const std::size_t both = std::min(theirs, ours.size());
  for (std::size_t k = 0; k < both; ++k) compare_row(key, k, ours[k], golden[k], first);
  if (ours.size() != theirs) {
    const double t = time_of(both < ours.size() ? ours[both] : golden[both]);
    first.see(t, at_time(t) + key + ", row " + std::to_string(both) + " is only in " +
                     (both < ours.size() ? "ours" : "the golden"));
  }
  return both;
}

std::size_t compare_positions(const Json& ours, const Json& golden, double end, First& first) {
  if (ours.size() != golden.size())
    first.see(end, std::to_string(ours.size()) + " positions, golden " + std::to_string(golden.size()));
  const std::size_t both = std::min(ours.size(), golden.size());
  for (std::size_t body = 0; body < both; ++body) {
    for (const std::size_t axis : {0, 1})
      first.see(end, "position of body " + std::to_string(body) + (axis == 0 ? ", x [m]" : ", y [m]"),
                ours[body].at(axis), golden[body].at(axis));
  }
  return both;
}

std::string first_other_line(const std::string& ours, const std::string& golden) {
  std::istringstream a(ours), b(golden);
  std::string mine, theirs;
  bool more_of_a = true, more_of_b = true;
  do {
    more_of_a = static_cast<bool>(std::getline(a, mine));
    more_of_b = static_cast<bool>(std::getline(b, theirs));
  } while (more_of_a && more_of_b && mine == theirs);
  return "ours \"" + (more_of_a ? mine : "") + "\", golden \"" + (more_of_b ? theirs : "") + "\"";
}

// The whole of two lists of numbers, in units of a tolerance of 1e-6 of the largest of their kind: what a reader would
// see in a figure is some thousand of them, round-off some millionth.
std::string most_moved(const Json& ours, const Json& golden, std::size_t column) {
  double scale = 0, most = 0;
  for (std::size_t k = 0; k < std::min(ours.size(), golden.size()); ++k) {
    const double mine = ours[k].at(column), theirs = golden[k].at(column);
    scale = std::max(scale, std::fabs(theirs));
    most = std::max(most, std::fabs(mine - theirs));
  }
  return scale > 0 ? number(std::round(most / (1e-6 * scale))) : most > 0 ? "more than it was" : "0";
}

std::string moved(const Json& now, const Json& golden) {
  return "; moved: Fx by " + most_moved(now["force"], golden["force"], 1) + ", Fy by " +
         most_moved(now["force"], golden["force"], 2) + ", x by " +
         most_moved(now["positions"], golden["positions"], 0) + ", y by " +
         most_moved(now["positions"], golden["positions"], 1) + " tolerances; tears " +
         std::to_string(now["tears"].size()) + ", golden " + std::to_string(golden["tears"].size());
}

struct Counts {
  std::size_t checkpoints = 0, force = 0, tears = 0, positions = 0;
};

std::string what_was(const Counts& n, const Json& golden, Extent extent) {
  const auto count = [](std::size_t k, const char* what) { return std::to_string(k) + " " + what; };
  std::string text = "the same bits: " + std::to_string(n.checkpoints) + " of " +
                     count(golden["checkpoints"].size(), "checkpoints, each with ") + count(energies, "energies, ") +
                     count(n.force, "force rows, ") + count(n.tears, "tears");
  return text + (extent == Extent::whole ? ", " + count(n.positions, "positions")
                                         : "; up to t = " + number(first_checkpoint) + " s, the rest was not run");
}

}  // namespace

std::string malformed_golden(const Json& golden) {
  if (!golden.is_object() || golden.value("golden", Json()) != golden_format)
    return "no golden of format " + std::to_string(golden_format);
  for (const char* key : {"scene", "reading", "scene_text", "ended"}) {
    if (!golden.contains(key) || !golden[key].is_string()) return std::string("does not say its ") + key;
  }
  if (!golden.contains("end") || !is_finite(golden["end"])) return "does not say its end";
  for (const std::string& why : {malformed_checkpoints(golden), malformed_rows(golden)}) {
    if (!why.empty()) return why;
  }
  const double end = golden["end"], last = time_of(golden["checkpoints"].back());
  if (golden["ended"] == "finished" && std::fabs(last - end) > slack)
    return "the last checkpoint is at " + number(last) + " s, not at the end, " + number(end) + " s";
  for (const char* key : {"checkpoints", "force", "tears"}) {
    if (!in_order(golden[key], last)) return std::string(key) + ": times out of order, or beyond the end";
  }
  const auto rows = static_cast<std::size_t>(last / golden_row_every + 1e-6) + 1;
  if (golden["force"].size() != rows)
    return std::to_string(golden["force"].size()) + " force rows, " + std::to_string(rows) + " make up the run";
  if (golden["positions"].empty()) return "no positions";
  return broken_seal(golden);
}

Comparison compare_golden(const Json& now, const Json& golden, Extent extent) {
  if (now.contains("failed")) return {false, "did not run: " + now["failed"].get<std::string>()};
  if (const std::string why = malformed_golden(golden); !why.empty())
    return {false, "the golden cannot be used: " + why};
  for (const char* key : {"scene", "reading", "end"}) {
    if (now.at(key) != golden[key])
      return {false, std::string("the golden is of another ") + key + ": ours " + now[key].dump() + ", golden " +
                         golden[key].dump()};
  }
  if (now.at("scene_text") != golden["scene_text"])
    return {false, "the golden is of another scene or other settings: " +
                       first_other_line(now["scene_text"], golden["scene_text"])};
  First first;
  const bool whole = extent == Extent::whole;
  const double last = time_of(now.at("checkpoints").back());
  const double end = whole ? HUGE_VAL : last;
  Counts n;
  n.checkpoints = compare_timed("checkpoints", now["checkpoints"], golden["checkpoints"], end, first);
  n.force = compare_timed("force", now.at("force"), golden["force"], end, first);
  n.tears = compare_timed("tears", now.at("tears"), golden["tears"], end, first);
  if (whole) n.positions = compare_positions(now.at("positions"), golden["positions"], last, first);
  if (whole && now.at("ended") != golden["ended"])
    first.see(last,
              at_time(last) + "ended otherwise: ours " + now["ended"].dump() + ", golden " + golden["ended"].dump());
  if (n.checkpoints < 2) first.see(0, "too few checkpoints to compare: " + std::to_string(n.checkpoints));
  if (!first.text().empty()) return {false, "differs " + first.text() + (whole ? moved(now, golden) : "")};
  return {true, what_was(n, golden, extent)};
}

}  // namespace furrow::validation
