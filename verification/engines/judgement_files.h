// Judgements as a table, as JSON and as JUnit.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "verification/engines/judge.h"

namespace furrow::verification {

// How both files begin, by which they are known again.
inline constexpr std::string_view judgements_begin_json = "[\n {\n  \"case\": ";
inline constexpr std::string_view judgements_begin_junit =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"furrow judge\"";

std::string table_row(const Judgement& j);
std::string count_line(const std::vector<Judgement>& all);
// `partial` says how much was judged if not all was, as "3 of 57 cases": in JSON a key of each judgement, in JUnit an error.
Json judgements_as_json(const std::vector<Judgement>& all, const std::string& partial = "");
std::string judgements_as_junit(const std::vector<Judgement>& all, const std::string& partial = "");

}  // namespace furrow::verification
