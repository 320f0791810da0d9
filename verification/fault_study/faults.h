// The faults that the study puts into the source.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "verification/fault_study/workshop.h"

namespace furrow::verification {

struct Fault {
  std::string name, says;
  Change change;  // of a constant with the word CHANGE in new_text
  bool constant = false, rebuild = false;
  bool on_all = false;  // every test is run, whatever notices it
  std::string quick;    // not empty: the page that shows it in the quick study
};

// faults.toml.
struct Faults {
  std::vector<Fault> all;
  std::set<std::string> methods_pages, costly_tests;  // see Turn
  std::set<std::string> methods_files;                // faults in these are faults of the methods
  std::map<std::string, std::string> silent;          // tests that notice nothing: why
};

// Throws toml::parse_error, std::runtime_error that says what is wrong in it.
Faults faults_in(const std::filesystem::path& file);

}  // namespace furrow::verification
