#include "validation/studies/kept_ensemble.h"

#include <algorithm>
#include <cmath>

#include "output/files.h"
#include "report/seal.h"

namespace furrow::validation {
namespace {

std::map<std::string, std::vector<Member>> members_by_group() {
  std::map<std::string, std::vector<Member>> groups;
  for (const Member& m : paper_members(false)) groups[m.group()].push_back(m);
  return groups;
}

bool says_a_number_or_words(const Json& value) {
  return value.is_string() || (value.is_number() && std::isfinite(value.get<double>()));
}

// A member says why it failed, or its mean force and, if it has a bed, the height of that.
std::string unusable_member(const Json& member, const std::string& group) {
  if (!member.is_object() || member.empty()) return "says nothing";
  for (const auto& [id, value] : member.items()) {
    if (!says_a_number_or_words(value)) return id + " is neither a finite number nor words";
  }
  if (member.contains("failed")) return {};
  if (!member.value("mean_force", Json()).is_number()) return "has no mean force";
  if (!group.starts_with("scenario_1") && !member.value("surface", Json()).is_number()) return "has no surface";
  return {};
}

std::string unusable_group(const Json& list, const std::string& group, std::size_t wanted) {
  if (!list.is_array() || list.size() != wanted)
    return std::to_string(list.is_array() ? list.size() : 0) + " of " + std::to_string(wanted) + " members of " + group;
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (const std::string why = unusable_member(list[k], group); !why.empty())
      return "member " + std::to_string(k + 1) + " of " + group + " " + why;
  }
  return {};
}

Json members_of(const Json& kept) {
  const Json data = kept.value("data", Json());
  const Json members = data.is_object() ? data.value("members", Json()) : Json();
  return members.is_object() ? members : Json::object();
}

}  // namespace

std::string unusable_ensemble(const Json& kept) {
  if (const std::string why = broken_seal(kept); !why.empty()) return why;
  if (kept.value("study", Json()) != "ensemble") return "is not of the study ensemble";
  if (kept.value("form", Json()) != "full") return "is of the quick form, too few members to judge by";
  const Json members = members_of(kept);
  const auto wanted = members_by_group();
  for (const auto& [group, list] : wanted) {
    if (const std::string why = unusable_group(members.value(group, Json()), group, list.size()); !why.empty())
      return "has " + why;
  }
  for (const auto& [group, list] : members.items()) {
    if (!wanted.contains(group)) return "has a group " + group + ", of which there is none";
  }
  return {};
}

std::string other_member(const std::string& group, const Json& kept_first) {
  const Member first = members_by_group().at(group).at(0);
  const Json now = observed(paper_scene(first.scene, first.reading, first.seed), first.scene);
  for (const auto& [id, value] : now.items()) {
    if (const Json kept = kept_first.value(id, Json()); kept.dump() != value.dump())
      return id + ": now " + value.dump() + ", kept " + kept.dump();
  }
  return now.size() == kept_first.size() ? "" : "the kept one says more";
}

Groups kept_ensemble(const std::filesystem::path& directory, const std::vector<std::string>& groups) {
  const std::filesystem::path file = directory / "ensemble.json";
  const std::string make = "; make it by: furrow ensemble --out " + directory.string();
  if (!std::filesystem::exists(file)) throw FileError("no " + file.string() + make);
  const Json kept = read_sealed(file);
  if (const std::string why = unusable_ensemble(kept); !why.empty()) throw FileError(file.string() + " " + why + make);
  Groups taken;
  const Json members = members_of(kept);
  for (const auto& [group, list] : members.items()) {
    if (!groups.empty() && std::find(groups.begin(), groups.end(), group) == groups.end()) continue;
    if (const std::string why = other_member(group, list.at(0)); !why.empty())
      throw FileError(file.string() + " is of another scene or model: of " + group + ", packing 1, " + why + make);
    taken[group] = std::vector<Json>(list.begin(), list.end());
  }
  return taken;
}

}  // namespace furrow::validation
