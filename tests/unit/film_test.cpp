// What a player gets of a run says what the run's files say.
#include "validation/page/film.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "run_directory.h"
#include "validation/page/packed.h"

namespace furrow::validation {
namespace {

using test::RunDirectory;

// Header and numbers again, read as the script does: each frame but the first adds to the one before.
struct Reader {
  std::string bytes;
  std::size_t at = 0;
  nlohmann::json header;

  explicit Reader(std::string film) : bytes(std::move(film)) {
    const auto size = take<std::uint32_t>(1)[0];
    header = nlohmann::json::parse(bytes.substr(at, size));
    at += size;
  }
  template <class Integer>
  std::vector<Integer> take(std::size_t count) {
    std::vector<Integer> values(count);
    std::memcpy(values.data(), bytes.data() + at, count * sizeof(Integer));
    at += count * sizeof(Integer);
    return values;
  }
  template <class Integer>
  std::vector<Integer> frames(std::size_t width) {
    auto values = take<Integer>(width * header["mm"].size());
    for (std::size_t k = width; k < values.size(); ++k) values[k] = static_cast<Integer>(values[k] + values[k - width]);
    return values;
  }
};

void write_discs(const RunDirectory& run) {
  run.write("frames/discs_000.csv", RunDirectory::discs_heading + "0.05,0.03,0.01,0.3,0.4,0,1000\n");
  run.write("frames/discs_001.csv", RunDirectory::discs_heading + "0.06,0.02,0.01,0,0.25,0,500\n");
}

TEST(Film, PlacesAreThoseOfTheFilesToWithinItsUnit) {
  RunDirectory run;
  write_discs(run);
  run.force({{-3, 4}, {-30, 40}, {0, 0}});
  Reader film(film_of(read_run("scenario_1", run.path()), run.path(), {50}));
  EXPECT_EQ(film.header["axis"], "mm");
  EXPECT_EQ(film.header["mm"], nlohmann::json::parse("[0.0, 50.0]"));
  EXPECT_EQ(film.header["stills"], nlohmann::json::parse("[50.0]"));
  const double unit = film.header["unit"], x0 = film.header["box"][0], y0 = film.header["box"][1];
  const auto discs = film.frames<std::int16_t>(2);
  for (const auto& [k, want] :
       {std::pair<std::size_t, double>{0, 0.05 - x0}, {1, 0.03 - y0}, {2, 0.06 - x0}, {3, 0.02 - y0}})
    EXPECT_NEAR(unit * (discs[k] + 32768), want, unit) << k;
  EXPECT_LT(unit, 1e-5) << "of a scene of centimetres";
  EXPECT_EQ(film.frames<std::uint8_t>(1), (std::vector<std::uint8_t>{255, 128})) << "stress, of the largest";
  EXPECT_EQ(film.frames<std::uint8_t>(1), (std::vector<std::uint8_t>{255, 128})) << "speed, of the largest";
  const auto nodes = film.frames<std::int16_t>(6);
  EXPECT_NEAR(unit * (nodes[5] + 32768), 0.02 - y0, unit) << "the upper node of the upper link";
  const std::size_t links = film.header["links"].size();
  const auto forces = film.frames<std::int8_t>(links);
  EXPECT_EQ(forces[0], 127) << "tension";
  EXPECT_EQ(forces[1], -127) << "pressure";
  film.frames<std::int16_t>(2);  // the plate
  const std::size_t bins = film.header["curve"]["count"];
  const auto low = film.take<std::int16_t>(bins), high = film.take<std::int16_t>(bins);
  EXPECT_NEAR(film.header["curve"]["peak"], 50, 1e-12);
  EXPECT_EQ(*std::max_element(high.begin(), high.end()), 32000) << "no peak of the curve is lost";
  EXPECT_EQ(film.at, film.bytes.size());
}

TEST(Film, ARunWithoutPicturesIsAnErrorThatSaysWhatToDo) {
  RunDirectory run;
  run.write("frames/frames.csv", "index,t [s],displacement [m]\n");
  try {
    film_of(read_run("scenario_1", run.path()), run.path(), {});
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("run it again with --frames"), std::string::npos) << error.what();
  }
}

TEST(Film, AViewIsOnePageThatNeedsNoOtherFile) {
  RunDirectory run;
  write_discs(run);
  run.force({{-3, 4}, {-30, 40}});
  const std::string page = view_page(read_run("scenario_1", run.path()), run.path());
  EXPECT_NE(page.find("<title>Three nodes</title>"), std::string::npos);
  EXPECT_EQ(page.find("{{"), std::string::npos);
  EXPECT_EQ(page.find(" src="), std::string::npos);
  EXPECT_EQ(page.find("http"), std::string::npos);
}

// RFC 4648, section 10, of what zlib makes of nothing and more: a header of 78 DA at the strongest.
TEST(Film, WhatIsPackedIsDeflatedAndInBase64) {
  EXPECT_EQ(packed("").substr(0, 3), "eNo");
  const std::string much(100000, 'a');
  EXPECT_LT(packed(much).size(), 400u);
  EXPECT_EQ(packed(much).size() % 4, 0u);
}

}  // namespace
}  // namespace furrow::validation
