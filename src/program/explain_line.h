// One line of furrow explain: a name and a text.
#pragma once

#include <unistd.h>

#include <array>
#include <cstdarg>
#include <cstdio>
#include <string>

#include "program/run_summary.h"

namespace furrow {

[[gnu::format(printf, 2, 3)]] inline void line(const std::string& part, const char* pattern, ...) {
  constexpr std::size_t first = 25, most = 100;
  const std::size_t columns = isatty(STDOUT_FILENO) != 0 ? most : std::string::npos;  // what programs read is one line
  std::array<char, 2000> text{};
  std::va_list values;
  va_start(values, pattern);
  std::vsnprintf(text.data(), text.size(), pattern, values);
  va_end(values);
  std::printf("  %-22s %s\n", part.c_str(),
              wrapped(std::string(first, ' ') + text.data(), columns, first).substr(first).c_str());
}

}  // namespace furrow
