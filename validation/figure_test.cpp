// Figures of the page are drawn, of this run and of studies that were kept.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "validation/page/chapters/chapters.h"
#include "validation/page/gnuplot.h"
#include "validation/page/studies.h"

namespace furrow::validation {
namespace {

namespace fs = std::filesystem;

TEST(Figure, OfAnEarlierRunDoesNotPassForANewOne) {
  const fs::path place = fs::temp_directory_path() / ("furrow_figure_" + std::to_string(getpid()));
  fs::create_directories(place);
  const std::string path = std::getenv("PATH");
  for (const std::string body : {"", "echo '<svg'"}) {
    Drawings drawings{{"x.svg", "<svg>old</svg>"}};
    std::ofstream(place / "gnuplot") << "#!/bin/sh\n" << body << "\nexit 0\n";
    fs::permissions(place / "gnuplot", fs::perms::owner_all);
    setenv("PATH", (place.string() + ":" + path).c_str(), 1);
    EXPECT_THROW(draw({}, "plot x", drawings, "x", "x"), std::runtime_error) << body;
    setenv("PATH", path.c_str(), 1);
  }
  fs::remove_all(place);
}

// Scripts of figures change, kept studies stay.
TEST(Figure, OfEachStudyInTheTreeIsDrawn) {
  const Evidence of_the_tree{{}, {}, fs::path(FURROW_SOURCE_DIR) / "reference_data/studies", catalogue()};
  Page page;
  const std::vector<StudyResult> results = study_results(of_the_tree);
  EXPECT_EQ(results.size(), studies_of_the_page().size());
  for (const StudyResult& result : results) EXPECT_NO_THROW(study_section(result, "1", page));
  EXPECT_GT(page.files.size(), 40u) << "drawings and their data";
}

}  // namespace
}  // namespace furrow::validation
