#include "program/method_name.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "methods/method.h"
#include "scene/utf8.h"
#include "scene/wording.h"

namespace furrow {

std::string unknown_method(const std::string& name) {
  std::vector<std::string> names;
  for (const MethodInfo& m : method_catalogue()) names.push_back(m.name);
  if (std::find(names.begin(), names.end(), name) != names.end()) return {};
  return "no method is named " + in_quotes(visible(name)) + nearest_or_all(name, names) + "; see furrow methods";
}

void require_method(const std::string& option, const std::string& name) {
  if (const std::string fault = unknown_method(name); !fault.empty())
    throw std::invalid_argument(option + ": " + fault);
}

}  // namespace furrow
