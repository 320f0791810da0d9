// Reading of files that were written here.
#include <vector>

#include "output/files.h"

namespace furrow {

std::ifstream regular_file(const std::filesystem::path& file) {
  std::ifstream stream;
  std::error_code failed;
  if (std::filesystem::is_regular_file(file, failed)) stream.open(file, std::ios::binary);
  if (!stream.is_open()) stream.setstate(std::ios::failbit);
  return stream;
}

std::string bounded_text(std::istream& stream, const std::string& name) {
  constexpr std::size_t most = std::size_t{1} << 28;
  std::string text;
  for (std::string part(1 << 20, '\0'); stream && text.size() <= most;) {
    stream.read(part.data(), static_cast<std::streamsize>(part.size()));
    text.append(part, 0, static_cast<std::size_t>(stream.gcount()));
  }
  if (text.size() > most) throw FileError(name + ": has more than " + std::to_string(most) + " bytes");
  if (stream.bad()) throw FileError("cannot read all of " + name);
  return text;
}

std::string bounded_text(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) throw FileError(file.string() + ": is a directory");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw FileError("cannot read " + file.string());
  return bounded_text(stream, file.string());
}

FileMark mark_of(const std::filesystem::path& file) {
  std::ifstream stream = regular_file(file);
  if (!stream) throw FileError("cannot read " + file.string());
  FileMark mark;
  Fnv1a hash;
  for (std::vector<char> piece(1U << 16U); stream;) {
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    const auto taken = static_cast<std::size_t>(stream.gcount());
    hash.add(std::string_view(piece.data(), taken));
    mark.bytes += taken;
  }
  if (stream.bad()) throw FileError("cannot read all of " + file.string());
  mark.hash = hash.value();
  return mark;
}

}  // namespace furrow
