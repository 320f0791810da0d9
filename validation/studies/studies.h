// The studies of this folder, one function each; see their files.
#pragma once

#include "report/study.h"

namespace furrow::validation {

Json geometry(const Settings& settings);
Json ensemble(const Settings& settings);
Json statements(const Settings& settings);

}  // namespace furrow::validation
