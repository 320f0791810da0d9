#include "verification/studies/atlas.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <numbers>

#include "methods/method.h"
#include "verification/studies/amplification.h"
#include "verification/studies/blow_up.h"
#include "verification/studies/kept_numbers.h"

namespace furrow::verification {
namespace {

constexpr const char* groups_key = "amplifications";
constexpr const char* rim_key = "rim of pece";
std::string key_of(const std::string& method) { return "atlas " + method; }
std::string theory_key(const std::string& method) { return "theory " + method; }

bool is_conservative(const std::string& method) { return make_method(method)->info().conservative; }

// A method that takes no force that depends on velocity has no damping.
std::vector<double> ratios_for(bool conservative, const std::vector<double>& zetas) {
  std::vector<double> some;
  std::copy_if(zetas.begin(), zetas.end(), std::back_inserter(some),
               [&](double zeta) { return zeta == 0 || !conservative; });
  return some;
}

Json measured(const std::string& method, const std::vector<double>& zetas) {
  Json rows = Json::array();
  for (const AtlasLimit& l : limits_of(method, zetas))
    rows.push_back({l.zeta, kept(l.theory, 6), kept(l.spring, 6), kept(l.contact, 6)});
  return rows;
}

// Names of methods by amplification.
Json groups() {
  Json all = Json::array();
  for (const AtlasEntry& e : atlas_by_theory()) all.push_back(e.methods);
  return all;
}

// Finely, critical damping among it; up from the undamped edge.
Json theory_of(const std::string& method) {
  const bool by_eigenvalue = acts_by_eigenvalue(method);
  Json boundary = Json::array();
  const auto add = [&](double zeta) {
    const double limit = largest_stable_angle(method, zeta == undamped_at ? 0 : zeta);
    boundary.push_back({kept(zeta, 5), kept(limit, 6)});
  };
  for (double zeta = undamped_at; zeta < 0.9; zeta *= 1.15) add(zeta);
  for (double zeta = 0.9; zeta < 1.15; zeta += 0.02) add(zeta);
  for (double zeta = 1.15; zeta < 31; zeta *= 1.1) add(zeta);
  return {{"by_eigenvalue", by_eigenvalue},
          {"real_axis", by_eigenvalue ? kept(largest_stable_radius(method, -1), 6) : Json()},
          {"boundary", boundary}};
}

Json rim() {
  constexpr int directions = 120;
  Json radii = Json::array();
  for (int k = 0; k <= directions; ++k)
    radii.push_back(
        kept(largest_stable_radius("pece", std::polar(1.0, std::numbers::pi * (0.5 + 0.5 * k / directions))), 6));
  return radii;
}

// Of a method that failed as a whole nothing is known but the theory.
void add_limits(AtlasEntry& entry, const std::vector<double>& zetas, const Json& rows) {
  for (std::size_t k = 0; k < zetas.size(); ++k) {
    AtlasLimit limit{zetas[k], entry.limit_at(zetas[k]), NAN, NAN};
    if (rows.is_array()) {
      limit.theory = number(rows.at(k)[1]);
      limit.spring = number(rows.at(k)[2]);
      limit.contact = number(rows.at(k)[3]);
    }
    entry.limits.push_back(limit);
  }
}

}  // namespace

double AtlasEntry::limit_at(double zeta) const {
  if (boundary.empty()) return NAN;
  const auto beyond =
      std::find_if(boundary.begin(), boundary.end(), [&](const auto& point) { return point[0] >= zeta; });
  if (beyond == boundary.begin()) return boundary.front()[1];
  if (beyond == boundary.end()) return boundary.back()[1];
  const auto& [z0, h0] = *(beyond - 1);
  const auto& [z1, h1] = *beyond;
  return h0 + (zeta - z0) / (z1 - z0) * (h1 - h0);
}

std::vector<AtlasLimit> limits_of(const std::string& method, const std::vector<double>& zetas) {
  std::vector<AtlasLimit> limits;
  for (const double zeta : ratios_for(is_conservative(method), zetas)) {
    const double theory = largest_stable_angle(method, zeta);
    limits.push_back({zeta, theory, measured_stable_angle(method, spring_oscillation(zeta), theory),
                      measured_stable_angle(method, contact_oscillation(zeta), theory)});
  }
  return limits;
}

std::vector<AtlasEntry> atlas_by_theory() {
  std::vector<AtlasEntry> atlas;
  for (const MethodInfo& info : method_catalogue()) {
    if (info.controlled) continue;
    const auto same = std::find_if(atlas.begin(), atlas.end(), [&](const AtlasEntry& e) {
      return same_amplification(e.methods.front(), info.name);
    });
    if (same != atlas.end()) {
      same->methods.push_back(info.name);
      continue;
    }
    AtlasEntry entry{.methods = {info.name}, .by_eigenvalue = acts_by_eigenvalue(info.name)};
    entry.conservative = info.conservative;
    if (entry.by_eigenvalue) entry.real_axis = largest_stable_radius(info.name, -1);
    atlas.push_back(entry);
  }
  return atlas;
}

void measure_atlas(Measurement& measurement, const std::vector<double>& zetas) {
  const std::vector<Json> known = measurement.run({{groups_key, groups}, {rim_key, rim}});
  std::vector<Task> tasks;
  for (const Json& group : known.at(0)) {
    const std::string first = group.at(0);
    tasks.push_back({theory_key(first), [first] { return theory_of(first); }});
    for (const std::string method : group)
      tasks.push_back({key_of(method), [method, &zetas] { return measured(method, zetas); }});
  }
  measurement.run(tasks);
}

std::vector<AtlasEntry> atlas_of(const Numbers& numbers, const std::vector<double>& zetas) {
  std::vector<AtlasEntry> atlas;
  for (const Json& group : numbers.at(groups_key)) {
    AtlasEntry e{.methods = group.get<std::vector<std::string>>()};
    e.conservative = is_conservative(e.methods.front());
    const Json& theory = numbers.at(theory_key(e.methods.front()));
    e.by_eigenvalue = theory.value("by_eigenvalue", true);
    e.real_axis = number(theory.value("real_axis", Json()));
    for (const Json& point : theory.value("boundary", Json::array()))
      e.boundary.push_back({point[0], number(point[1])});
    for (const std::string& method : e.methods)
      add_limits(e, ratios_for(e.conservative, zetas), numbers.at(key_of(method)));
    atlas.push_back(std::move(e));
  }
  return atlas;
}

std::vector<double> rim_of_pece(const Numbers& numbers) { return numbers.at(rim_key).get<std::vector<double>>(); }

std::vector<std::string> methods_outside(const std::vector<AtlasEntry>& atlas) {
  std::vector<std::string> outside;
  for (const MethodInfo& info : method_catalogue()) {
    const bool inside = std::any_of(atlas.begin(), atlas.end(), [&](const AtlasEntry& e) {
      return std::find(e.methods.begin(), e.methods.end(), info.name) != e.methods.end();
    });
    if (!inside) outside.push_back(info.name);
  }
  return outside;
}

}  // namespace furrow::verification
