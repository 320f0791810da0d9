// export.json: what stands in a deck, by hashes, so that nothing else is compared in its place.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "export/export.h"

namespace furrow {

struct DeckRecord {
  std::string to, furrow, scene_hash;  // engine, commit, of scene.toml
  nlohmann::ordered_json deviations;   // a list; empty: the deck is exact
};

// Names and texts of the files of a deck; scene.toml is one of them.
using DeckFiles = std::vector<std::pair<std::string, std::string>>;

std::string deck_record(const DeckFiles& files, const std::vector<KeyRow>& deviations);

// Throws FileError that names the file, and the field, unless export.json and every file it lists are as they were
// written.
DeckRecord read_deck_record(const std::filesystem::path& directory);

}  // namespace furrow
