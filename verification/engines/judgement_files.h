// Judgements as a table, as JSON and as JUnit.
#pragma once

#include <string>
#include <vector>

#include "verification/engines/judge.h"

namespace furrow::verification {

std::string table_row(const Judgement& j);
std::string count_line(const std::vector<Judgement>& all);
Json judgements_as_json(const std::vector<Judgement>& all);
std::string judgements_as_junit(const std::vector<Judgement>& all);

}  // namespace furrow::verification
