// The studies, one function each; see their files.
#pragma once

#include "studies/study.h"

namespace furrow::studies {

Json order(const Settings& settings);
Json stability(const Settings& settings);
Json work_precision(const Settings& settings);
Json need(const Settings& settings);
Json geometry(const Settings& settings);
Json convergence(const Settings& settings);
Json ensemble(const Settings& settings);
Json statements(const Settings& settings);
Json outlook(const Settings& settings);
Json speed(const Settings& settings);

}  // namespace furrow::studies
