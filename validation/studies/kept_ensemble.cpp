#include "validation/studies/kept_ensemble.h"

#include <algorithm>
#include <cmath>

#include "output/files.h"
#include "validation/studies/ensemble.h"

namespace furrow::validation {
namespace {

bool says_a_number(const Json& value) { return value.is_number() && std::isfinite(value.get<double>()); }

bool says_something(const Json& value) {
  if (value.is_array()) return !value.empty() && std::all_of(value.begin(), value.end(), says_a_number);
  return value.is_string() || says_a_number(value);
}

// A member says why it failed, or its mean force and, if it has a bed, the height of that.
std::string unusable_member(const Member& member, const Json& says) {
  if (!says.is_object() || says.empty()) return "says nothing";
  for (const auto& [id, value] : says.items()) {
    if (!says_something(value)) return id + " is neither finite numbers nor words";
  }
  if (says.contains("failed")) return {};
  if (!says.value("mean_force", Json()).is_number()) return "has no mean force";
  if (member.scene != "scenario_1" && !says.value("surface", Json()).is_number()) return "has no surface";
  return {};
}

// The first member that was made of another scene than today's, or asked other things.
std::string of_another_scene(const Numbers& kept, const std::string& group) {
  for (const Member& member : paper_members(false)) {
    if (member.group() == group && kept.find(member.key())->input != member.task().input) return member.key();
  }
  return {};
}

Numbers read(const std::filesystem::path& file, const std::string& make) {
  if (!std::filesystem::exists(file)) throw FileError("no " + file.string() + make);
  try {
    return Numbers::read(file);
  } catch (const FileError& error) {
    throw FileError(error.what() + make);
  }
}

}  // namespace

Groups members_in(const Numbers& numbers) {
  Groups groups;
  for (const Member& member : paper_members(numbers.quick()))
    groups[member.group()].push_back(numbers.at(member.key()));
  return groups;
}

std::string unusable_ensemble(const Numbers& kept) {
  if (kept.study() != "ensemble") return "is not of the study ensemble";
  if (kept.form() != "full") return "is of the quick form, too few members to judge by";
  const std::vector<std::string> wanted = ensemble_keys(false);
  for (const std::string& key : wanted) {
    if (!kept.find(key)) return "has no '" + key + "'";
  }
  for (const Member& member : paper_members(false)) {
    if (const std::string why = unusable_member(member, kept.at(member.key())); !why.empty())
      return "'" + member.key() + "' " + why;
  }
  for (const Result& result : kept.results()) {
    if (std::find(wanted.begin(), wanted.end(), result.key) == wanted.end())
      return "has '" + result.key + "', of which there is none";
  }
  return {};
}

std::string other_member(const std::string& group, const Json& kept_first) {
  const std::vector<Member> all = paper_members(false);
  const Json now =
      std::find_if(all.begin(), all.end(), [&](const Member& m) { return m.group() == group; })->task().run();
  for (const auto& [id, value] : now.items()) {
    if (const Json kept = kept_first.value(id, Json()); kept.dump() != value.dump())
      return id + ": now " + value.dump() + ", kept " + kept.dump();
  }
  return now.size() == kept_first.size() ? "" : "the kept one says more";
}

Groups kept_ensemble(const std::filesystem::path& directory, const std::vector<std::string>& groups) {
  const std::filesystem::path file = directory / "ensemble.json";
  const std::string make = "; make it by: furrow ensemble --out " + directory.string();
  const Numbers kept = read(file, make);
  if (const std::string why = unusable_ensemble(kept); !why.empty()) throw FileError(file.string() + " " + why + make);
  Groups taken;
  for (const auto& [group, list] : members_in(kept)) {
    if (!groups.empty() && std::find(groups.begin(), groups.end(), group) == groups.end()) continue;
    if (const std::string key = of_another_scene(kept, group); !key.empty())
      throw FileError(file.string() + " is of another scene: '" + key + "'" + make);
    if (const std::string why = other_member(group, list.at(0)); !why.empty())
      throw FileError(file.string() + " is of another model: of " + group + ", packing 1, " + why + make);
    taken[group] = list;
  }
  return taken;
}

}  // namespace furrow::validation
