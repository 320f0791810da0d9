#include "verification/fault_study/faults.h"

#include <toml++/toml.h>

#include <stdexcept>
#include <string_view>

namespace furrow::verification {
namespace {

[[noreturn]] void wrong(const std::string& what) { throw std::runtime_error("faults.toml: " + what); }

std::string text_in(const toml::node& value, const std::string& which) {
  if (!value.is_string()) wrong(which + " must be a text");
  return value.value_or(std::string());
}

// A misspelt key is an error, or what it says would be left out without a word.
Fault fault_of(const toml::table& entry, const std::string& kind, const std::string& which) {
  Fault fault;
  fault.constant = kind == "constant";
  const std::map<std::string_view, std::string*> texts{{"name", &fault.name},           {"says", &fault.says},
                                                       {"file", &fault.change.file},    {"old", &fault.change.old_text},
                                                       {"new", &fault.change.new_text}, {"quick", &fault.quick}};
  const std::map<std::string_view, bool*> flags{{"rebuild", &fault.rebuild}, {"on_all", &fault.on_all}};
  for (const auto& [key, value] : entry) {
    const std::string its = which + ": " + std::string(key.str());
    if (const auto text = texts.find(key.str()); text != texts.end()) {
      *text->second = text_in(value, its);
    } else if (const auto flag = flags.find(key.str()); flag == flags.end()) {
      wrong(its + " is no key of a fault");
    } else if (!value.is_boolean()) {
      wrong(its + " must be true or false");
    } else {
      *flag->second = value.value_or(false);
    }
  }
  for (const char* key : {"name", "says", "file", "old", "new"})
    if (!entry.contains(key)) wrong(which + " has no " + key);
  if (fault.name.empty() || fault.change.old_text.empty()) wrong(which + " has an empty name or an empty old");
  if (!fault.quick.empty() && !(fault.change.file.starts_with("src/") && fault.change.file.ends_with(".cpp")))
    wrong(fault.name + " is in no source of src, and the quick study compiles the file of a fault alone");
  if (fault.constant && fault.change.new_text.find("CHANGE") == std::string::npos)
    wrong(fault.name + " does not say where its CHANGE goes");
  return fault;
}

std::set<std::string> texts_in(const toml::table& table, const char* key, const std::string& which) {
  const toml::array* entries = table.get_as<toml::array>(key);
  if (!entries) wrong(which + "." + key + " must be a list of texts");
  std::set<std::string> all;
  for (const toml::node& entry : *entries) all.insert(text_in(entry, which + "." + key));
  return all;
}

const toml::table& table_in(const toml::table& root, const char* key) {
  const toml::table* table = root.get_as<toml::table>(key);
  if (!table) wrong(std::string("there is no [") + key + "]");
  return *table;
}

void add_all(const toml::node& list, const std::string& kind, std::vector<Fault>& faults) {
  const toml::array* entries = list.as_array();
  if (!entries) wrong(kind + " must be a list of tables");
  for (std::size_t k = 0; k < entries->size(); ++k) {
    const std::string which = kind + " " + std::to_string(k + 1);
    const toml::table* entry = entries->get(k)->as_table();
    if (!entry) wrong(which + " is no table");
    faults.push_back(fault_of(*entry, kind, which));
  }
}

}  // namespace

Faults faults_in(const std::filesystem::path& file) {
  const toml::table root = toml::parse_file(file.string());
  Faults faults;
  for (const auto& [key, value] : root)
    if (key != "fault" && key != "constant" && key != "methods" && key != "costly" && key != "silent")
      wrong("nothing is called " + std::string(key.str()));
  for (const char* kind : {"fault", "constant"})
    if (const toml::node* list = root.get(kind)) add_all(*list, kind, faults.all);
  std::set<std::string> names;
  for (const Fault& fault : faults.all)
    if (!names.insert(fault.name).second) wrong("two faults are called " + fault.name);
  const toml::table &methods = table_in(root, "methods"), &costly = table_in(root, "costly");
  faults.methods_pages = texts_in(methods, "pages", "methods");
  faults.methods_files = texts_in(methods, "files", "methods");
  faults.costly_tests = texts_in(costly, "tests", "costly");
  for (const auto& [test, why] : table_in(root, "silent"))
    faults.silent[std::string(test.str())] = text_in(why, "silent." + std::string(test.str()));
  return faults;
}

}  // namespace furrow::verification
