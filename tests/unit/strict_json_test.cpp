#include "output/strict_json.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

namespace furrow::test {
namespace {

std::string fault_of(const std::string& text) {
  try {
    strict_json(text);
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
  return "none";
}

std::string nested(int depth, const std::string& begin, const std::string& end) {
  std::string text;
  for (int k = 0; k < depth; ++k) text += begin;
  text += "1";
  for (int k = 0; k < depth; ++k) text += end;
  return text;
}

TEST(StrictJson, AKeyThatStandsTwiceIsNamed) {
  EXPECT_EQ(fault_of(R"({"a": 1, "b": {"a": 2}})"), "none");
  EXPECT_EQ(fault_of(R"([{"a": 1}, {"a": 1}])"), "none");
  EXPECT_EQ(fault_of(R"({"a": 1, "b": 2, "a": 3})"), "has \"a\" twice");
  EXPECT_EQ(fault_of(R"([{"a": {"b": 1, "b": 1}}])"), "has \"b\" twice");
}

TEST(StrictJson, WhatIsNestedTooDeepIsRefusedBeforeItEndsTheProgram) {
  EXPECT_EQ(fault_of(nested(100, "[", "]")), "none");
  EXPECT_EQ(fault_of(nested(102, "[", "]")), "is nested deeper than 100");
  EXPECT_EQ(fault_of(nested(300000, "[", "]")), "is nested deeper than 100");
  EXPECT_EQ(fault_of(nested(300000, "{\"a\":", "}")), "is nested deeper than 100");
  EXPECT_EQ(fault_of(nested(300000, "[", "")), "is nested deeper than 100");
}

TEST(StrictJson, WhatIsNoJsonIsRefusedWithItsPlace) {
  for (const char* text : {"", "{", "{\"a\"}", "{} {}", "[1,]", "nan", "{\"a\": \"\xff\"}", "\xef\xbb\xbf{"})
    EXPECT_EQ(fault_of(text).substr(0, 17), "is no JSON: byte ") << text;
}

TEST(StrictJson, NumbersThatAreTooLargeAreRefused) {
  EXPECT_EQ(fault_of("[1e308, -1e308, 1e-400, 123456789012345678901234567890]"), "none");
  EXPECT_EQ(fault_of("[1e999]"), "has a number that is too large");
  EXPECT_TRUE(json_or_discarded("{\"a\": -1e999}").is_discarded());
}

TEST(StrictJson, WithoutAReasonItIsDiscarded) {
  EXPECT_EQ(json_or_discarded("[1]").dump(), "[1]");
  EXPECT_TRUE(json_or_discarded(R"({"a": 1, "a": 1})").is_discarded());
  std::istringstream good("{\"b\": 1,\n \"a\": 2}"), bad("{");
  EXPECT_EQ(json_or_discarded(good).dump(), R"({"b":1,"a":2})");
  EXPECT_TRUE(json_or_discarded(bad).is_discarded());
}

}  // namespace
}  // namespace furrow::test
