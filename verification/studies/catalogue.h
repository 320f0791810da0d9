// The studies, one function each; see their files.
#pragma once

#include "studies/study.h"

namespace furrow::studies {

Json work_precision(const Settings& settings);

}  // namespace furrow::studies
