// A run as a player shows it (player.js): its pictures, its force curve, its torn links, in few bytes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "validation/page/run_record.h"

namespace furrow::validation {

// The bytes of the film, before they are packed. stills: displacements (mm) or times (ms) to be marked. Throws
// std::runtime_error if the run has no pictures.
std::string film_of(const RunRecord& run, const std::filesystem::path& directory, const std::vector<double>& stills);

struct Film {
  std::string id, label;  // of the element that holds it; what a reader chooses it by
  std::string data;
};

// The element that a script turns into a player; the first film is shown, the others can be put beside it.
std::string player_element(const std::vector<Film>& films);
std::string film_elements(const std::vector<Film>& films);

// A page of its own that plays one run.
std::string view_page(const RunRecord& run, const std::filesystem::path& directory);

}  // namespace furrow::validation
