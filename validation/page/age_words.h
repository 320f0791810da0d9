// The age of kept numbers in words and as a sign.
#pragma once

#include "report/age.h"

namespace furrow::validation {

// "12 results, made 2026-01-31 by commit 63b8b18 on AMD EPYC. All are of today's solver.", or how many are not and why.
std::string words_of(const Numbers& numbers, const Age& age);

// Why some are old: "3 of them were made before these sources changed: src/run/run.cpp."; empty if none are.
std::string why_old(const Age& age);

// "today's solver", or how many numbers are older, HTML. old_read: of those that it reads elsewhere.
std::string age_chip(const Age& age, std::size_t old_read = 0);

// The first of them, "and 3 more".
std::string listed(const std::vector<std::string>& all, std::size_t most);

}  // namespace furrow::validation
