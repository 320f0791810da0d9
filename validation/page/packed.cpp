#include "validation/page/packed.h"

#include <zlib.h>

#include <stdexcept>

namespace furrow::validation {
namespace {

std::string base64(const std::string& bytes) {
  static constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    unsigned three = 0;
    for (std::size_t j = k; j < k + 3; ++j)
      three = three << 8 | (j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0U);
    for (std::size_t j = 0; j < 4; ++j) text += k + j > bytes.size() ? '=' : digits[three >> (18 - 6 * j) & 63];
  }
  return text;
}

}  // namespace

std::string packed(std::string_view data) {
  std::string bytes(compressBound(data.size()), '\0');
  uLongf size = bytes.size();
  const int code = compress2(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(data.data()),
                             data.size(), Z_BEST_COMPRESSION);
  if (code != Z_OK) throw std::runtime_error("zlib cannot compress a part of the page");
  bytes.resize(size);
  return base64(bytes);
}

std::string packed_element(const std::string& id, std::string_view data) {
  return "<script type=\"text/plain\" id=\"" + id + "\">" + packed(data) + "</script>\n";
}

}  // namespace furrow::validation
