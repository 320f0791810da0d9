// What run.json says of the files of a run: how long each of the others is and its CRC-32, and a seal on its own text. So a
// reader knows them whole and as they were written.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace furrow {

// "120 cbf43926": the bytes of a file and its CRC-32. Throws FileError if it cannot be read.
std::string length_and_crc(const std::filesystem::path& file);

// Of those that are there: {"NAME": "120 cbf43926", ...}. Throws FileError if one cannot be read.
nlohmann::ordered_json list_of_files(const std::filesystem::path& directory, const std::vector<std::string>& names);

// The text of run.json. Its last key is "seal": the CRC-32 of all that stands before the comma in front of it.
std::string sealed_text(nlohmann::ordered_json run_json);

// The first file of the run in `directory` that is not as it was written, and what is wrong with it; empty if all are.
std::string spoilt_file(const std::filesystem::path& directory);

}  // namespace furrow
