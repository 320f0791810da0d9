// Names of methods, as a command line or a scene gives them.
#pragma once

#include <string>

namespace furrow {

// What is wrong with the name; empty if there is such a method.
std::string unknown_method(const std::string& name);

// Throws std::invalid_argument that names the option if there is no such method.
void require_method(const std::string& option, const std::string& name);

}  // namespace furrow
