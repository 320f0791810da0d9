// The ensemble that an earlier `furrow ensemble` left, taken only if it is whole and this program's.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "validation/studies/members.h"

namespace furrow::validation {

using Groups = std::map<std::string, std::vector<Json>>;  // "scenario_2 disc": its members, by seed

// The members among the numbers of an ensemble. Throws std::out_of_range that names one that is not there.
Groups members_in(const Numbers& numbers);

// What is wrong with the numbers of an ensemble: their form, which there are, what each member says; empty if nothing is.
std::string unusable_ensemble(const Numbers& kept);

// Runs the first member of a group again and compares all its numbers with the kept ones, digit by digit: only this shows
// that the same model made them. Returns the first that differs, empty if none does.
std::string other_member(const std::string& group, const Json& kept_first);

// Those of `groups` in directory/ensemble.json, all if none are named. Throws FileError: no file, not usable, or made
// by another scene or model.
Groups kept_ensemble(const std::filesystem::path& directory, const std::vector<std::string>& groups = {});

}  // namespace furrow::validation
