#include "verification/engines/oracles.h"

#include <cstdio>
#include <regex>
#include <sstream>

#include "scene/wording.h"
#include "verification/engines/oracle_parts.h"

namespace furrow::verification {

Expected expected_of(const Json& whole) {
  const std::string oracle = whole["oracle"];
  for (const auto* table : {&contact_oracles(), &assembly_oracles(), &spring_oracles(), &bed_oracles()}) {
    if (const auto found = table->find(oracle); found != table->end()) return found->second(whole);
  }
  throw std::invalid_argument("case " + whole["name"].get<std::string>() + ": there is no oracle " + oracle);
}

std::string with_values(const std::string& text, const Expected& expected) {
  std::istringstream lines(text);
  std::string all, line, name;
  const std::regex naming("name = \"(.*)\""), valuing("value = .*"), spanning("interval = .*");
  std::smatch found;
  while (std::getline(lines, line)) {
    if (std::regex_match(line, found, naming)) name = found[1];
    if (std::regex_match(line, valuing)) {
      char value[40];
      std::snprintf(value, sizeof value, "value = %.12g", expected.at(name));
      line = value;
      if (line.find_first_of(".en", 8) == std::string::npos) line += ".0";
    }
    if (std::regex_match(line, spanning) && expected.contains(low_of(name)))
      line =
          "interval = [" + rounded(expected.at(low_of(name)), 6) + ", " + rounded(expected.at(high_of(name)), 6) + "]";
    all += line + "\n";
  }
  return all;
}

}  // namespace furrow::verification
