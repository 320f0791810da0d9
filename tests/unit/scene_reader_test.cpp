// The reader takes what is right and refuses what is wrong, saying where and what.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/scene_text.h"

namespace furrow {
namespace {

std::string file_error(const std::filesystem::path& file) {
  try {
    read_scene(file);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

TEST(SceneReader, FillsTheFieldsOfTheThirdScene) {
  const Scene scene = read_scene(source_dir / "validation/scenes/scenario_3.toml");
  EXPECT_EQ(scene.time.end, 4.5);
  EXPECT_EQ(scene.contact.damping_factor, 20.0);
  EXPECT_EQ(scene.contact.restitution, std::nullopt);
  ASSERT_EQ(scene.wall.size(), 3u);
  EXPECT_EQ(scene.wall[2].point, (Vec2{0.6, 0}));
  ASSERT_EQ(scene.packing.size(), 1u);
  EXPECT_EQ(scene.packing[0].count, 230);
  EXPECT_EQ(scene.settle.value().limit, 20.0);
  EXPECT_EQ(scene.plate.at(0).working_depth, 0.04);
  EXPECT_EQ(scene.plate.at(0).lower_edge, std::nullopt);
  EXPECT_EQ(scene.lattice.at(0).fixed_rows, (std::vector<int>{0, 1}));
  EXPECT_EQ(scene.lattice.at(0).shear.strength, 40.0);
  EXPECT_EQ(scene.output.frames.size(), 6u);
}

TEST(SceneReader, KeepsDefaultsOfWhatIsLeftOut) {
  const Scene scene = parse_scene(good, "f");
  EXPECT_EQ(scene.model.gravity, 9.81);
  EXPECT_EQ(scene.model.moment_arm, MomentArm::contact_point);
  EXPECT_FALSE(scene.settle);
  EXPECT_FALSE(scene.contact.damping_factor);
}

TEST(SceneReader, TakesAnyFieldOfAnEnumAndOfAPair) {
  const Scene scene = parse_scene(good + R"([model]
disc_mass = "sphere"
moment_arm = "radius"
[search]
threads = 2
[[contact.pair]]
materials = ["soft", "soft"]
friction = 0
)",
                                  "f");
  EXPECT_EQ(scene.model.disc_mass, DiscMass::sphere);
  EXPECT_EQ(scene.model.moment_arm, MomentArm::radius);
  EXPECT_EQ(scene.search.threads, 2);
  EXPECT_EQ(scene.contact.pair.at(0).friction, 0.0);
  EXPECT_EQ(scene.contact.pair.at(0).rolling_friction, std::nullopt);
}

TEST(SceneReader, NamesTheNearestKnownKey) {
  EXPECT_EQ(errors_after("[model]\ngrvity = 1"), Lines{"14:1: model.grvity: unknown key; did you mean \"gravity\"?"});
  EXPECT_EQ(errors_after("[[dics]]"), Lines{"13:3: dics: unknown key; did you mean \"disc\"?"});
}

TEST(SceneReader, ListsKnownKeysWhenNoneIsNear) {
  EXPECT_EQ(errors_after("mass = 1"),
            Lines{"13:1: disc[0].mass: unknown key; known: position, radius, velocity, spin, material"});
}

TEST(SceneReader, SaysWhichTypeIsExpectedAndWhichStands) {
  EXPECT_EQ(errors_with("1e-3", "\"1e-3\""), Lines{"4:8: time.step: must be a number [s], not a string"});
  EXPECT_EQ(errors_with("1e-3", "[1e-3]"), Lines{"4:8: time.step: must be a number [s], not an array of 1"});
  EXPECT_EQ(errors_with("1e-3", "2020-01-01"), Lines{"4:8: time.step: must be a number [s], not a date or time"});
  EXPECT_EQ(errors_with("\"a disc falls\"", "1"), Lines{"1:9: title: must be a string, not an integer"});
  EXPECT_EQ(errors_after("[output]\nenergy = 1"), Lines{"14:10: output.energy: must be true or false, not an integer"});
  EXPECT_EQ(errors_after("[output]\nframes = 1.0"), Lines{"14:10: output.frames: must be an array [s], not a float"});
  EXPECT_EQ(errors_after("[output]\nframes = [0.0, true]"),
            Lines{"14:16: output.frames[1]: must be a number [s], not a boolean"});
}

TEST(SceneReader, TakesAnIntegerForANumberButNotAFloatForAnInteger) {
  EXPECT_EQ(parse_scene(changed(good, "end = 1.0", "end = 1"), "f").time.end, 1.0);
  EXPECT_EQ(errors_after("[[packing]]\ncount = 2.0\nradius_min = 1\nradius_max = 1\nlower_left = [0, 0]\n"
                         "upper_right = [9, 9]\nmaterial = \"soft\""),
            Lines{"14:9: packing[0].count: must be an integer, not a float"});
}

TEST(SceneReader, SaysTheAcceptedRangeWithItsUnit) {
  EXPECT_EQ(errors_with("1e-3", "-1e-3"), Lines{"4:8: time.step: -0.001 is outside 0 < step < inf [s]"});
  EXPECT_EQ(errors_with("0.3", "0.51"), Lines{"8:11: material[0].poisson: 0.51 is outside -1 < poisson <= 0.5"});
}

TEST(SceneReader, RefusesNumbersThatAreNotFinite) {
  EXPECT_EQ(errors_with("1e-3", "inf"), Lines{"4:8: time.step: inf is outside 0 < step < inf [s]"});
  EXPECT_EQ(errors_with("[0.0, 1.0]", "[0.0, nan]"),
            Lines{"10:18: disc[0].position[1]: nan is outside -inf < position[1] < inf [m]"});
}

const std::string lattice = R"([[lattice]]
origin = [0, 0]
rows = 2
columns = 2
spacing = 0.1
node_mass = 1
material = "soft"
)";

TEST(SceneReader, TakesAnInfiniteStrength) {
  const std::string link = "structural = {stiffness = 1, damping = 0, strength = ";
  EXPECT_EQ(parse_scene(good + lattice + link + "inf}", "f").lattice.at(0).structural.strength, infinity);
  EXPECT_EQ(errors_after(lattice + link + "nan}"),
            Lines{"20:54: lattice[0].structural.strength: nan is outside 0 < strength <= inf [N]"});
}

TEST(SceneReader, RefusesIntegersThatDoNotFit) {
  EXPECT_EQ(errors_after(lattice + "fixed_rows = [3000000000]"),
            Lines{"20:15: lattice[0].fixed_rows[0]: 3e+09 is outside 0 <= fixed_rows[0] <= 2147483647"});
  EXPECT_EQ(errors_with("end = 1.0", "end = 9223372036854775808").size(), 1u);
}

TEST(SceneReader, TakesExactlyTwoNumbersForAVector) {
  EXPECT_EQ(errors_with("[0.0, 1.0]", "[1.0]"),
            Lines{"10:12: disc[0].position: must be an array of two numbers [m], not an array of 1"});
  EXPECT_EQ(errors_with("[0.0, 1.0]", "[0.0, 1.0, 2.0]"),
            Lines{"10:12: disc[0].position: must be an array of two numbers [m], not an array of 3"});
  EXPECT_EQ(errors_with("[0.0, 1.0]", "1.0"),
            Lines{"10:12: disc[0].position: must be an array of two numbers [m], not a float"});
}

TEST(SceneReader, PlacesAMissingKeyAtTheHeaderOfItsTable) {
  EXPECT_EQ(errors_with("step = 1e-3", ""), Lines{"2:1: time.step: missing, but required [s]"});
  EXPECT_EQ(errors_with("radius = 0.1\n", ""), Lines{"9:1: disc[0].radius: missing, but required [m]"});
}

TEST(SceneReader, ListsTheWordsOfAnEnum) {
  EXPECT_EQ(errors_after("[model]\nmoment_arm = \"contact_pont\""),
            Lines{"14:14: model.moment_arm: must be one of contact_point, half_overlap, radius, not \"contact_pont\"; "
                  "did you mean "
                  "\"contact_point\"?"});
  EXPECT_EQ(errors_after("[model]\nmoment_arm = 1"),
            Lines{"14:14: model.moment_arm: must be one of contact_point, half_overlap, radius, not an integer"});
}

TEST(SceneReader, SaysWhetherATableIsOneOrOneOfAList) {
  EXPECT_EQ(errors_after("[wall]"), Lines{"13:1: wall: must be a list of tables, [[wall]], not a table"});
  EXPECT_EQ(errors_after("[[model]]"), Lines{"13:1: model: must be one table, [model], not a list of tables"});
  EXPECT_EQ(errors_after("[contact.pair]"),
            Lines{"13:1: contact.pair: must be a list of tables, [[contact.pair]], not a table"});
  EXPECT_EQ(errors_after(lattice + "[lattice.node]"),
            Lines{"20:1: lattice[0].node: must be a list of tables, [[lattice.node]], not a table"});
}

TEST(SceneReader, HintsAtDoubleBracketsWhereATableIsRepeated) {
  EXPECT_EQ(errors_after("[wall]\n[wall]"),
            Lines{"14:1: not TOML: Error while parsing table header: cannot redefine existing table 'wall'; tables of "
                  "a list are headed [[...]]"});
}

TEST(SceneReader, ReportsSyntaxErrorsInTheSameForm) {
  EXPECT_EQ(errors_with("1e-3", ""),
            Lines{"4:8: not TOML: Error while parsing key-value pair: expected value, saw '\\n'"});
  EXPECT_EQ(errors_with("step = 1e-3", "end = 2.0"),
            Lines{"4:7: not TOML: Error while parsing key-value pair: cannot redefine existing floating-point 'end'"});
}

TEST(SceneReader, TakesLettersOfAnyTongueInStringsAndComments) {
  const auto title = [](const std::string& quoted) {
    return parse_scene(changed(good, "\"a disc falls\"", quoted), "f").title;
  };
  const std::string umlaut = "\xC3\xBC", euro = "\xE2\x82\xAC", moon = "\xF0\x9F\x8C\x99";  // two, three and four bytes
  EXPECT_EQ(title('"' + umlaut + "ber " + euro + moon + '"'), umlaut + "ber " + euro + moon);
  EXPECT_EQ(title("'" + moon + "? ?" + umlaut + "'"), moon + "? ?" + umlaut);
  EXPECT_EQ(title("\"\"\"" + umlaut + "\"\"\""), umlaut);
  EXPECT_EQ(title("\"\\u00fc \\U0001F319 " + umlaut + "\""), umlaut + ' ' + moon + ' ' + umlaut);
  EXPECT_EQ(title("\"plain\"  # " + euro + " \xFF"), "plain");
  const std::string named =
      changed(changed(good, "\"soft\"", '"' + umlaut + '"'), "material = \"soft\"", "material = '" + umlaut + "'");
  EXPECT_EQ(parse_scene(named, "f").material.at(0).name, umlaut);
}

TEST(SceneReader, CountsLettersNotBytesInItsPlaces) {
  EXPECT_EQ(errors_after("\"\xC3\xBC\" = 1"), Lines{"13:1: disc[0].?: unknown key; known: position, radius, velocity, "
                                                    "spin, material"});
  EXPECT_EQ(errors_after("[model]\ndisc_mass = \"\xC3\xBC\xC3\xBC\" # \xC3\xBC\n[search]\nskin = \"\xC3\xBC\""),
            (Lines{"14:13: model.disc_mass: must be one of disc, sphere, not \"\xC3\xBC\xC3\xBC\"",
                   "16:8: search.skin: must be a number [m], not a string"}));
  EXPECT_EQ(
      errors_with("title = \"a disc falls\"\n[time]\nend = 1.0",
                  "title = '\xC3\xBC\xC3\xBC'\ntime = { step = 1e-4, title = '\xE2\x82\xAC', end = true }\n[search]"),
      (Lines{"2:23: time.title: unknown key; known: end, step, method, relative_tolerance, absolute_tolerance, "
             "max_step, locate, solver",
             "2:42: time.end: must be a number [s], not a boolean",
             "4:1: search.step: unknown key; known: skin, cell_size, threads"}));
}

TEST(SceneReader, RefusesBytesThatAreNotUtf8WithTheirPlace) {
  for (const char* bytes : {"\xFF", "\xC3", "\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\x80"}) {
    const Lines wrong = errors_with("a disc", std::string("a d") + bytes + "sc");
    EXPECT_EQ(wrong, Lines{"1:13: not UTF-8"}) << bytes;
  }
  EXPECT_EQ(errors_with("radius", "radi\xC3\xBCs"), Lines{"11:5: only ASCII is accepted outside strings and comments"});
}

TEST(SceneReader, RefusesControlCharactersInTexts) {
  for (const char* text : {"\\t", "\t", "\\u0007", "\\u007F", "\\u0085", "\xC2\x85", "\xE2\x80\xAE", "\xEF\xBB\xBF",
                           "\t\xC3\xBC", "\\t\xC3\xBC", "\\u2028"})
    EXPECT_EQ(errors_with("a disc", std::string("a d") + text), Lines{"1:9: title: must hold no control characters"})
        << text;
}

// Each title ends before the comment, whatever quotes and backslashes are in it.
TEST(SceneReader, TellsCommentsFromStrings) {
  for (const std::string title :
       {R"("\" # \\")", R"('\')", R"("""a"" " # """")", R"('''b'' # ''''')", R"("")", R"('')"})
    EXPECT_EQ(errors_with("\"a disc falls\"", title + " # \xC3\xA9 ' \""), Lines{}) << title;
  EXPECT_EQ(errors_with("falls\"", "falls\n# \xC3\xA9"),
            Lines{"1:22: not TOML: Error while parsing string: unescaped control characters other than TAB (U+0009) "
                  "are explicitly prohibited"});
}

TEST(SceneReader, TakesWindowsLineEndsAndAByteOrderMark) {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : good) text += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(scene_hash(parse_scene(text, "f")), scene_hash(parse_scene(good, "f")));
  EXPECT_EQ(errors(changed(text, "1e-3", "0")), Lines{"4:8: time.step: 0 is outside 0 < step < inf [s]"});
}

TEST(SceneReader, SaysWhatAnEmptyFileLacks) {
  EXPECT_EQ(errors(""), (Lines{"1:1: title: missing, but required", "1:1: time: missing, but required"}));
}

TEST(SceneReader, SurvivesDeepNesting) {
  const auto repeated = [](const std::string& part, int times) {
    std::string text;
    while (times-- > 0) text += part;
    return text;
  };
  EXPECT_EQ(errors("a" + repeated(".a", 100'000) + " = 1"), Lines{"1:34: a key of too many parts"});
  EXPECT_EQ(errors("[a" + repeated(".a", 100'000) + "]").size(), 1u);
  EXPECT_EQ(errors("a = " + repeated("[", 100'000)).size(), 1u);
  EXPECT_EQ(errors("a = " + repeated("{a.a.a.a.a.a.a.a.a.a = ", 100'000)).size(), 1u);
}

TEST(SceneReader, TellsAllFaultsAtOnceInTheOrderOfTheFile) {
  const std::string text = changed(changed(changed(good, "1.0", "true"), "name", "nmae"), "radius = 0.1", "radius = 0");
  EXPECT_EQ(errors(text + "[modle]"),
            (Lines{"3:7: time.end: must be a number [s], not a boolean", "5:1: material[0].name: missing, but required",
                   "6:1: material[0].nmae: unknown key; did you mean \"name\"?",
                   "11:10: disc[0].radius: 0 is outside 0 < radius < inf [m]",
                   "13:2: modle: unknown key; did you mean \"model\"?"}));
}

TEST(SceneReader, PlacesFaultsOfTheWholeAtTheirKeyOrItsTable) {
  EXPECT_EQ(errors_with("material = \"soft\"", "material = \"sft\""),
            Lines{"12:12: disc[0].material: no material is named \"sft\"; did you mean \"soft\"?"});
  EXPECT_EQ(errors_with("young = 2e5", ""), Lines{"5:1: material[0]: young [Pa] is required unless rigid = true"});
}

TEST(SceneReader, NamesTheFileInEachMessage) {
  try {
    parse_scene("title = 1\ntime = 2", "some/where.toml");
    FAIL();
  } catch (const SceneError& error) {
    EXPECT_STREQ(error.what(),
                 "some/where.toml:1:9: error: title: must be a string, not an integer\n"
                 "some/where.toml:2:8: error: time: must be one table, [time], not an integer");
  }
}

TEST(SceneReader, SaysWhyAFileCannotBeRead) {
  const std::string here = std::filesystem::current_path();
  EXPECT_EQ(
      file_error("no/such.toml"),
      "cannot read scene \"no/such.toml\": No such file or directory; there is no directory \"no\", seen from \"" +
          here + "\"");
  const std::string directory = (source_dir / "tests").string();
  EXPECT_EQ(file_error(directory), "cannot read scene \"" + directory + "\": it is a directory");
}

}  // namespace
}  // namespace furrow
