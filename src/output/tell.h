// Between who writes files and who watches them.
#pragma once

#include "output/files.h"

namespace furrow {

// Every FileWatch that lives, one after the other.
void tell(const std::filesystem::path& file, const FileNews& news);

}  // namespace furrow
