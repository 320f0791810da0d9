// What goes into kept results that are no study's, as hashes: a verdict is as old as its fault or its case.
#pragma once

#include <map>
#include <string>

namespace furrow {

using Inputs = std::map<std::string, std::string>;  // name: hash

// Of the text that the fault study puts in the place of another one.
std::string input_of_fault(const std::string& file, const std::string& old_text, const std::string& new_text);

// Of all faults and constants of verification/faults.toml, as this program has it.
Inputs inputs_of_faults();

bool is_case(const std::string& name);
// Of a case of verification/cases: all that it says but for its title. Throws std::out_of_range if there is none.
std::string input_of_case(const std::string& name);

}  // namespace furrow
