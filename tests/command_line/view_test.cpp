// `furrow view`: one page that plays a run, or a word on why not.
#include <gtest/gtest.h>

#include "program.h"

namespace {

namespace fs = std::filesystem;
using furrow::test::text_of;

class View : public furrow::test::Program {};

TEST_F(View, PlaysARunWithThePicturesThatWereAskedFor) {
  ASSERT_EQ(furrow("run " + scene("scenario_1") + " --until 0.05 --frames 21 --out here").code, 0) << err();
  ASSERT_EQ(furrow("view here").code, 0) << err();
  EXPECT_EQ(out(), "here/view.html\n");
  const std::string page = text_of(directory_ / "here/view.html");
  EXPECT_NE(page.find("21 pictures"), std::string::npos);
  EXPECT_NE(page.find("id=\"film\""), std::string::npos);
  ASSERT_EQ(furrow("run " + scene("scenario_1") + " --until 0.05 --out here").code, 0)
      << "the page is no obstacle, " << err();
}

TEST_F(View, OfNoRunIsAnErrorOfInput) {
  EXPECT_EQ(furrow("view nowhere").code, 4);
  EXPECT_NE(err().find("nowhere: no such directory"), std::string::npos) << err();
}

TEST_F(View, OfARunWithoutPicturesSaysHowToGetSome) {
  ASSERT_EQ(furrow("run " + scene("scenario_1") + " --until 0.01 --set output.frames=[] --out here").code, 0) << err();
  EXPECT_NE(furrow("view here").code, 0);
  EXPECT_NE(err().find("run it again with --frames 150"), std::string::npos) << err();
  EXPECT_FALSE(fs::exists(directory_ / "here/view.html"));
}

TEST_F(View, FramesAreAWholeNumberFromTwo) {
  for (const char* bad : {"1", "many", "2.5", "-3", "100000"}) {
    EXPECT_EQ(furrow("run " + scene("scenario_1") + " --until 0.01 --out here --frames " + bad).code, 2) << bad;
    EXPECT_NE(err().find("--frames: must be a whole number from 2 to 10000"), std::string::npos) << err();
  }
}

}  // namespace
