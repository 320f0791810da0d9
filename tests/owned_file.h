// A file in a directory of furrow's that a test changes in the program's name.
#pragma once

#include <nlohmann/json.hpp>

#include "output/file_list.h"
#include "tests/files.h"

namespace furrow::test {

// Lets the marker beside the file know it as it is now: as if the program had written it so.
inline void make_its_own(const std::filesystem::path& file) {
  const std::filesystem::path marker = file.parent_path() / ".furrow.json";
  auto json = nlohmann::ordered_json::parse(text_of(marker));
  json.at("files").at(file.filename().string()) = length_and_crc(file);
  std::ofstream(marker) << json.dump(2) << "\n";
}

}  // namespace furrow::test
