// The gate of instruction counts cannot pass on nothing.
#include "benchmarks/tracking/gate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace furrow::benchmarks {
namespace {

Json sound() {
  return {{"rhs", {{"answer", "0123456789abcdef"}, {"instructions", 1000}}},
          {"step", {{"answer", "fedcba9876543210"}, {"instructions", 2000}}}};
}

int both(const Json& accepted, const Json& results) {
  return std::max(check_answers(accepted, results), check_counts(accepted, results));
}

TEST(Gate, PassesWhatIsTheSame) { EXPECT_EQ(both(sound(), sound()), good); }

TEST(Gate, EveryWayToSpoilEitherSideFails) {
  struct Way {
    const char* name;
    std::function<void(Json&)> spoil;
  };
  const std::vector<Way> ways{{"null", [](Json& j) { j = nullptr; }},
                              {"empty", [](Json& j) { j = Json::object(); }},
                              {"a kernel less", [](Json& j) { j.erase("step"); }},
                              {"a kernel more", [](Json& j) { j["third"] = j["step"]; }},
                              {"another answer", [](Json& j) { j["step"]["answer"] = "0"; }},
                              {"answer is empty", [](Json& j) { j["step"]["answer"] = ""; }},
                              {"answer is null", [](Json& j) { j["step"]["answer"] = nullptr; }},
                              {"count is NaN", [](Json& j) { j["step"]["instructions"] = std::nan(""); }},
                              {"count is zero", [](Json& j) { j["step"]["instructions"] = 0; }},
                              {"count is text", [](Json& j) { j["step"]["instructions"] = "2000"; }},
                              {"no count", [](Json& j) { j["step"].erase("instructions"); }}};
  for (const Way& way : ways) {
    Json spoilt = sound();
    way.spoil(spoilt);
    EXPECT_EQ(both(spoilt, sound()), failed) << way.name << " accepted";
    EXPECT_EQ(both(sound(), spoilt), failed) << way.name << " now";
    const std::string name = way.name;
    if (name.find("kernel") != std::string::npos || name == "another answer")
      continue;  // the same on both sides is good
    EXPECT_EQ(both(spoilt, spoilt), failed) << name << " on both sides";
  }
}

TEST(Gate, MoreThanTwoPerCentFails) {
  Json now = sound();
  now["rhs"]["instructions"] = 1021;
  EXPECT_EQ(both(sound(), now), failed);
  now["rhs"]["instructions"] = 1019;
  EXPECT_EQ(both(sound(), now), good);
}

}  // namespace
}  // namespace furrow::benchmarks
