// Which build of furrow this is: written beside every result, so that a number can be traced to what made it.
#pragma once

#include <string_view>

namespace furrow {

struct BuildInfo {
  std::string_view version;
  std::string_view commit;    // as git describes it, "-dirty" if the tree had changes; "unknown" outside a repository
  std::string_view compiler;  // name and version
  std::string_view flags;     // that the library's sources were compiled with
  std::string_view build_type;
  std::string_view sources;  // hash of the solver's sources: what decides the bits of a run and of its files
  std::string_view system;   // operating system and processor
};

const BuildInfo& build_info();

}  // namespace furrow
