#include "output/files.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>

namespace furrow {

std::string number(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

OutputFile::OutputFile(std::filesystem::path file) : file_(std::move(file)), partial_(file_.string() + ".partial") {
  stream_.open(partial_);
  if (!stream_) throw FileError("cannot write " + partial_.string() + ": " + std::strerror(errno));
}

void OutputFile::close() {
  stream_.close();
  if (!stream_) throw FileError("could not write all of " + partial_.string() + ": " + std::strerror(errno));
}

void OutputFile::finish() {
  close();
  std::error_code failed;
  std::filesystem::rename(partial_, file_, failed);
  if (failed) throw FileError("cannot rename " + partial_.string() + ": " + failed.message());
}

}  // namespace furrow
