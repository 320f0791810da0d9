#include "report/seal.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "output/files.h"
#include "output/strict_json.h"
#include "scene/hash.h"

namespace furrow {
namespace {

using nlohmann::ordered_json;

std::string seal_of(ordered_json kept) {
  kept.erase("seal");
  return hash_of(kept.dump());
}

}  // namespace

std::string hash_of(const std::string& text) { return hexadecimal(Fnv1a().add(text).value()); }

void seal(ordered_json& kept) { kept["seal"] = seal_of(kept); }

std::string broken_seal(const ordered_json& kept) {
  if (!kept.is_object() || kept.empty()) return "is empty or no result";
  const auto found = kept.find("seal");
  if (found == kept.end() || !found->is_string()) return "bears no seal, so nothing shows that it is whole";
  if (*found != seal_of(kept)) return "contradicts its seal: it was changed or cut after it was written";
  return {};
}

ordered_json read_sealed(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file)) throw FileError(file.string() + ": is a directory");
  std::ifstream stream = regular_file(file);
  if (!stream) throw FileError("cannot read " + file.string());
  ordered_json kept = json_or_discarded(stream);
  if (kept.is_discarded()) throw FileError(file.string() + ": is no JSON, or cut short");
  if (const std::string why = broken_seal(kept); !why.empty()) throw FileError(file.string() + ": " + why);
  return kept;
}

}  // namespace furrow
