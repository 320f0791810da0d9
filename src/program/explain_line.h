// One line of furrow explain: a name and a text.
#pragma once

#include <cstdarg>
#include <cstdio>
#include <string>

namespace furrow {

[[gnu::format(printf, 2, 3)]] inline void line(const std::string& part, const char* pattern, ...) {
  std::printf("  %-22s ", part.c_str());
  std::va_list values;
  va_start(values, pattern);
  std::vprintf(pattern, values);
  va_end(values);
  std::printf("\n");
}

}  // namespace furrow
