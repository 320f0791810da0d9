#include "report/inputs.h"

#include <toml++/toml.h>

#include "report/embedded.h"
#include "report/seal.h"
#include "scene/wording.h"

namespace furrow {

std::string input_of_fault(const std::string& file, const std::string& old_text, const std::string& new_text) {
  return hash_of(file + "\n" + old_text + "\n" + new_text);
}

Inputs inputs_of_faults() {
  Inputs inputs;
  const toml::table listed = toml::parse(embedded("verification/faults.toml"));
  for (const char* kind : {"fault", "constant"}) {
    for (const toml::node& entry : *listed[kind].as_array()) {
      const auto text = [&](const char* key) { return entry.as_table()->at(key).value_or(std::string()); };
      inputs[text("name")] = input_of_fault(text("file"), text("old"), text("new"));
    }
  }
  return inputs;
}

namespace {

std::string file_of_case(const std::string& name) { return "verification/cases/" + name + ".toml"; }

}  // namespace

bool is_case(const std::string& name) { return !embedded_files(file_of_case(name)).empty(); }

std::string input_of_case(const std::string& name) {
  toml::table whole = toml::parse(embedded(file_of_case(name)));
  whole.erase("title");
  Sentence text;
  text << toml::json_formatter{whole};
  return hash_of(text.str());
}

}  // namespace furrow
