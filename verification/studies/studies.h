// The studies of this folder, one function each; see their files.
#pragma once

#include "report/study.h"

namespace furrow::verification {

Json order(const Settings& settings);
Json published(const Settings& settings);
Json stability(const Settings& settings);

}  // namespace furrow::verification
