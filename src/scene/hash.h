// 64-bit FNV-1a of bytes (Fowler, Noll and Vo), and how files write it.
#pragma once

#include <array>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace furrow {

class Fnv1a {
 public:
  Fnv1a& add(unsigned char byte) {
    hash_ = (hash_ ^ byte) * 0x100000001b3;
    return *this;
  }
  Fnv1a& add(std::string_view bytes) {
    for (const char c : bytes) add(static_cast<unsigned char>(c));
    return *this;
  }
  Fnv1a& add_word(std::uint64_t word) {  // its bytes, the lowest first
    for (int byte = 0; byte < 8; ++byte, word >>= 8) add(static_cast<unsigned char>(word & 0xff));
    return *this;
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

// 16 digits.
inline std::string hexadecimal(std::uint64_t value) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016" PRIx64, value);
  return text.data();
}

}  // namespace furrow
