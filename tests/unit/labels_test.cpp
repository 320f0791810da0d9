#include "scene/labels.h"

#include <gtest/gtest.h>

#include "scene/scene.h"

namespace furrow {
namespace {

std::vector<std::string> labels_of(const std::vector<std::string>& names) {
  std::vector<Plate> plates(names.size());
  for (std::size_t k = 0; k < names.size(); ++k) plates[k].name = names[k];
  return labels(plates);
}

TEST(Labels, AreTheNamesOrTheIndicesOfThoseThatHaveNone) {
  EXPECT_EQ(labels_of({"tool", "", "press"}), (std::vector<std::string>{"tool", "1", "press"}));
  EXPECT_TRUE(labels_of({}).empty());
}

TEST(Labels, ANameLikeAnIndexIsNotTakenForOne) {
  EXPECT_EQ(labels_of({"1", "", ""}), (std::vector<std::string>{"1", "#1", "2"}));
  EXPECT_EQ(labels_of({"", "#0", "0"}), (std::vector<std::string>{"##0", "#0", "0"}));
}

}  // namespace
}  // namespace furrow
