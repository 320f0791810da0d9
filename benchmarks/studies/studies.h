// The studies of this folder, one function each; see their files.
#pragma once

#include "report/study.h"

namespace furrow::benchmarks {

Json work_precision(const Settings& settings);
Json need(const Settings& settings);
Json speed(const Settings& settings);

}  // namespace furrow::benchmarks
