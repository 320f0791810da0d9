// The file of a study's numbers: what is written is read back, and what furrow does not write is refused.
#include <gtest/gtest.h>

#include "output/files.h"
#include "report/numbers.h"

namespace furrow::validation {
namespace {

const Sources sources{{"src/physics/contact.h", "1"}};

TEST(NumbersFile, SharesNames) {
  const std::vector<Json> values{{{"force", 1}, {"why", nullptr}},
                                 {{"force", 2}, {"why", "late"}},
                                 {{"why", "other order"}, {"force", 3}},
                                 {{"failed", "once"}},
                                 Json::array({1, 2}),
                                 7};
  Numbers numbers("s", "full");
  for (std::size_t k = 0; k < values.size(); ++k)
    numbers.add({.key = std::to_string(k), .value = values[k]}, this_maker(sources));
  Json kept = Json::parse(numbers.line());
  EXPECT_EQ(kept.at("names"), Json::parse(R"([["force", "why"]])"));
  EXPECT_EQ(kept.at("results").at(1).at("value"), Json::parse(R"([2, "late"])"));
  const Numbers again = Numbers::of(kept, "s.json");
  for (std::size_t k = 0; k < values.size(); ++k) EXPECT_EQ(again.at(std::to_string(k)).dump(), values[k].dump());
  for (const char* spoilt : {R"([["force"]])", R"([["force", "force"]])", "[]", R"({"force": 1})"}) {
    kept["names"] = Json::parse(spoilt);
    EXPECT_THROW(Numbers::of(kept, "s.json"), FileError) << spoilt;
  }
}

TEST(NumbersFile, HasWholePlacesAndTextsThatCanBeShown) {
  Numbers numbers("s", "full");
  for (const char* key : {"a", "b"}) numbers.add({.key = key, .value = {{"x", 1}}}, this_maker(sources));
  const Json right = Json::parse(numbers.line());
  ASSERT_NO_THROW(Numbers::of(right, "s.json"));
  for (const char* field : {"/results/0/names", "/results/0/maker", "/schema"}) {
    for (const Json& wrong : {Json(0.7), Json(-1), Json(9), Json("0"), Json(true), Json(nullptr)}) {
      Json spoilt = right;
      spoilt[Json::json_pointer(field)] = wrong;
      EXPECT_THROW(Numbers::of(spoilt, "s.json"), FileError) << field << " " << wrong;
    }
  }
  for (const char* field : {"commit", "when", "compiler", "flags", "machine"}) {
    Json spoilt = right;
    spoilt["makers"][0][field] = "a\033[2Jb";
    EXPECT_THROW(Numbers::of(spoilt, "s.json"), FileError) << field;
  }
}

}  // namespace
}  // namespace furrow::validation
