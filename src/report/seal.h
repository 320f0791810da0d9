// Results that are kept as JSON carry a seal, a hash of all else that they say: one that was cut short, joined from two
// or changed by hand is then distinguished from one that a program has written.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace furrow {

// 64-bit FNV-1a of a text, sixteen hexadecimal digits.
std::string hash_of(const std::string& text);

// Writes the key "seal" over all other keys of an object.
void seal(nlohmann::ordered_json& kept);

// Why it cannot be taken as it was written: "is empty", "bears no seal", "contradicts its seal"; empty if it can.
std::string broken_seal(const nlohmann::ordered_json& kept);

// What the file holds, its seal whole. Throws FileError with the file's name and what is wrong with it.
nlohmann::ordered_json read_sealed(const std::filesystem::path& file);

}  // namespace furrow
