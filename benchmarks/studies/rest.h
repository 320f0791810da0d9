// What an active set could win: discs at rest, whose contacts need not be evaluated.
#pragma once

#include "studies/study.h"

namespace furrow::studies {

void add_rest(Report& report, const Settings& settings);

}  // namespace furrow::studies
