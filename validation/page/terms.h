// Words of the glossary and names of methods, as links to where they are explained.
#pragma once

#include <string>

namespace furrow::validation {

// "method_pece", of its row in the table of methods.
std::string id_of_method(const std::string& name);

// The HTML of a section with each term linked where it is first used. Headings, drawings and links stay as they are.
std::string with_terms(const std::string& section);

}  // namespace furrow::validation
