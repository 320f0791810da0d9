#include "fault_study/faults.h"

#include <toml++/toml.h>

namespace furrow::verification {
namespace {

std::set<std::string> texts(const toml::node_view<const toml::node> list) {
  std::set<std::string> all;
  if (const toml::array* entries = list.as_array()) {
    for (const toml::node& entry : *entries) all.insert(entry.value_or<std::string>(""));
  }
  return all;
}

Fault fault_of(const toml::table& entry, bool constant) {
  const auto text = [&](const char* key) { return entry[key].value_or<std::string>(""); };
  Fault fault{text("name"), text("says"), {text("file"), text("old"), text("new")}, constant};
  fault.rebuild = entry["rebuild"].value_or(false);
  fault.on_all = entry["on_all"].value_or(false);
  fault.quick = text("quick");
  return fault;
}

}  // namespace

Faults faults_in(const std::filesystem::path& file) {
  const toml::table read = toml::parse_file(file.string());
  Faults faults;
  for (const char* kind : {"fault", "constant"}) {
    const toml::array* list = read[kind].as_array();
    for (std::size_t k = 0; list != nullptr && k < list->size(); ++k)
      faults.all.push_back(fault_of(*list->get(k)->as_table(), std::string(kind) == "constant"));
  }
  const toml::table& table = read;
  faults.methods_pages = texts(table["methods"]["pages"]);
  faults.methods_files = texts(table["methods"]["files"]);
  faults.costly_tests = texts(table["costly"]["tests"]);
  if (const toml::table* silent = table["silent"].as_table()) {
    for (const auto& [test, why] : *silent) faults.silent[std::string(test.str())] = why.value_or<std::string>("");
  }
  return faults;
}

}  // namespace furrow::verification
