#include "output/file_list.h"

#include <boost/crc.hpp>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>

#include "output/files.h"
#include "output/strict_json.h"

namespace furrow {
namespace {

namespace fs = std::filesystem;

std::string in_digits(const boost::crc_32_type& crc) {
  char digits[9];
  std::snprintf(digits, sizeof digits, "%08x", static_cast<unsigned>(crc.checksum()));
  return digits;
}

std::string crc_of(std::string_view text) {
  boost::crc_32_type crc;
  crc.process_bytes(text.data(), text.size());
  return in_digits(crc);
}

constexpr std::string_view before_seal = ",\n  \"seal\": \"";

}  // namespace

std::string length_and_crc(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  boost::crc_32_type crc;
  std::uint64_t bytes = 0;
  std::vector<char> piece(1U << 16U);
  while (stream) {
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    crc.process_bytes(piece.data(), static_cast<std::size_t>(stream.gcount()));
    bytes += static_cast<std::uint64_t>(stream.gcount());
  }
  if (stream.bad() || !stream.eof()) throw FileError("cannot read " + file.string());
  return std::to_string(bytes) + " " + in_digits(crc);
}

nlohmann::ordered_json list_of_files(const fs::path& directory, const std::vector<std::string>& names) {
  nlohmann::ordered_json list = nlohmann::ordered_json::object();
  for (const std::string& name : names) {
    if (fs::is_regular_file(directory / name)) list[name] = length_and_crc(directory / name);
  }
  return list;
}

std::string sealed_text(nlohmann::ordered_json run_json) {
  std::string text = run_json.dump(2);
  text.resize(text.size() - 2);  // the end of the line and the brace
  run_json["seal"] = crc_of(text);
  return run_json.dump(2) + "\n";
}

std::string spoilt_file(const fs::path& directory) {
  if (!fs::is_regular_file(directory / "run.json")) return "run.json is missing";
  std::ifstream file(directory / "run.json", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto run_json = json_or_discarded(text);
  if (!run_json.is_object()) return "run.json is no whole JSON";
  const std::size_t end = text.rfind(before_seal);
  if (end == std::string::npos || run_json.value("seal", nlohmann::ordered_json()) != crc_of(text.substr(0, end)))
    return "run.json is not what the run wrote";
  for (const auto& [name, wanted] : run_json.at("files").items()) {
    if (!fs::is_regular_file(directory / name)) return name + " is missing";
    if (length_and_crc(directory / name) != wanted) return name + " is not what the run wrote";
  }
  return {};
}

}  // namespace furrow
