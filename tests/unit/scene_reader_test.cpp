// The reader refuses what is wrong, says where and what, and the writer writes what the reader reads.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>

#include "scene/read.h"

// What a designated initializer leaves out has the default that scene.h gives it; g++ 12 warns of it all the same.
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"

namespace furrow {
namespace {

using Lines = std::vector<std::string>;
const std::filesystem::path source_dir = FURROW_SOURCE_DIR;

const std::string good = R"(title = "a disc falls"
[time]
end = 1.0
step = 1e-3
[[material]]
name = "soft"
young = 2e5
poisson = 0.3
[[disc]]
position = [0.0, 1.0]
radius = 0.1
material = "soft"
)";

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string content(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Messages without the name of the file, and without "error: ".
Lines errors(const std::string& text) {
  try {
    parse_scene(text, "f");
  } catch (const SceneError& error) {
    Lines lines;
    for (const std::string& message : error.messages()) lines.push_back(changed(message.substr(2), " error: ", " "));
    return lines;
  }
  return {};
}

Lines errors_with(const std::string& from, const std::string& to) { return errors(changed(good, from, to)); }
Lines errors_after(const std::string& more) { return errors(good + more); }  // `more` begins in line 13

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
  EXPECT_EQ(scene.model.lever, Lever::overlap);
  EXPECT_FALSE(scene.settle);
  EXPECT_FALSE(scene.contact.damping_factor);
}

TEST(SceneReader, TakesAnyFieldOfAnEnumAndOfAPair) {
  const Scene scene = parse_scene(good + R"([model]
disc_mass = "sphere"
lever = "radius"
[search]
mode = "brute_force"
[[contact.pair]]
materials = ["soft", "soft"]
friction = 0
)",
                                  "f");
  EXPECT_EQ(scene.model.disc_mass, DiscMass::sphere);
  EXPECT_EQ(scene.model.lever, Lever::radius);
  EXPECT_EQ(scene.search.mode, SearchMode::brute_force);
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
  EXPECT_EQ(errors_after("[search]\nmode = \"cell\""),
            Lines{"14:8: search.mode: must be one of cells, brute_force, not \"cell\"; did you mean \"cells\"?"});
  EXPECT_EQ(errors_after("[search]\nmode = 1"),
            Lines{"14:8: search.mode: must be one of cells, brute_force, not an integer"});
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

TEST(SceneReader, TakesAsciiOnlyOutsideComments) {
  EXPECT_EQ(errors_with("a disc", "a d\xC3\xADsc"), Lines{"1:13: only ASCII is accepted outside comments"});
  EXPECT_EQ(errors_with("radius", "radi\xC3\xBCs"), Lines{"11:5: only ASCII is accepted outside comments"});
  EXPECT_EQ(errors_with("a disc", "a d\\u00EDsc"), Lines{"1:9: title: must hold printable ASCII characters only"});
  EXPECT_EQ(errors_with("a disc falls\"", "a # disc\" # \xC3\xAD \xFF"), Lines{});
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
  EXPECT_EQ(file_error("no/such.toml"), "cannot read scene \"no/such.toml\": No such file or directory");
  const std::string directory = (source_dir / "tests").string();
  EXPECT_EQ(file_error(directory), "cannot read scene \"" + directory + "\": it is a directory");
}

TEST(SceneReader, RefusesEveryBadInputForTheReasonInItsFirstLine) {
  const std::vector<std::pair<std::string, Lines>> expected = {
      {"misspelt_key",
       {"4:2: modle: unknown key; did you mean \"model\"?", "7:1: time.step: missing, but required [s]",
        "9:1: time.setp: unknown key; did you mean \"step\"?",
        "20:1: disc[0].colour: unknown key; known: position, radius, velocity, spin, material"}},
      {"missing_key",
       {"1:1: title: missing, but required", "2:1: time.step: missing, but required [s]",
        "5:1: disc[0].radius: missing, but required [m]", "5:1: disc[0].material: missing, but required"}},
      {"not_ascii", {"2:17: only ASCII is accepted outside comments"}},
      {"not_toml", {"5:7: not TOML: Error while parsing key-value pair: expected value, saw '#'"}},
      {"nothing_moves",
       {"1:1: nothing moves: there is no [[disc]], no [[packing]] and no [[lattice]] with a node that is not fixed"}},
      {"out_of_range",
       {"6:8: time.step: -0.001 is outside 0 < step < inf [s]",
        "11:11: material[0].poisson: 0.7 is outside -1 < poisson <= 0.5",
        "14:13: disc[0].position[0]: nan is outside -inf < position[0] < inf [m]",
        "14:18: disc[0].position[1]: inf is outside -inf < position[1] < inf [m]",
        "15:10: disc[0].radius: 0 is outside 0 < radius < inf [m]"}},
      {"table_or_list",
       {"18:1: wall: must be a list of tables, [[wall]], not a table",
        "23:1: settle: must be one table, [settle], not a list of tables"}},
      {"two_rigid", {"21:1: wall[0]: rigid \"stone\" can meet rigid \"steel\" of disc[0], where nothing would deform"}},
      {"unknown_material",
       {"16:12: disc[0].material: no material is named \"sotf\"; did you mean \"soft\"?",
        "21:12: wall[0].material: no material is named \"granite\"; known: soft"}},
      {"unknown_word", {"5:13: model.disc_mass: must be one of disc, sphere, not \"spere\"; did you mean \"sphere\"?"}},
      {"wrong_type",
       {"5:8: model.pull: must be true or false, not an integer", "9:8: time.step: must be a number [s], not a string",
        "22:9: packing[0].count: must be an integer, not a float",
        "25:14: packing[0].lower_left: must be an array of two numbers [m], not an array of 1",
        "26:21: packing[0].upper_right[1]: must be a number [m], not a string",
        "28:8: packing[0].seed: must be an integer, not a string"}},
  };
  const std::filesystem::path folder = source_dir / "tests/bad_input";
  for (const auto& [stem, lines] : expected) {
    const std::string text = content(folder / (stem + ".toml"));
    EXPECT_TRUE(text.starts_with("# Wrong: ")) << stem;
    EXPECT_EQ(errors(text), lines) << stem;
  }
}

// A lattice of 3 rows and 2 columns under a plate, and a disc on a floor: nothing is wrong with it.
Scene sound_scene() {
  Scene s;
  s.title = "sound";
  s.material = {Material{.name = "soft", .young = 2e5, .poisson = 0.3}, Material{.name = "hard", .rigid = true}};
  s.disc = {Disc{.position = {0, 1}, .radius = 0.1, .material = "soft"}};
  s.wall = {Wall{.name = "floor", .material = "hard"}};
  s.plate = {Plate{.name = "tool", .lower_edge = 1, .material = "hard"}};
  s.lattice = {Lattice{.name = "stem", .rows = 3, .columns = 2, .material = "soft", .fixed_rows = {0}}};
  return s;
}

// What is wrong with the sound scene after a change.
Lines problems(const std::function<void(Scene&)>& change) {
  Scene scene = sound_scene();
  change(scene);
  Lines lines;
  for (const auto& [path, message] : problems_of(scene)) lines.push_back(path + ": " + message);
  return lines;
}

TEST(SceneValidation, FindsNothingWrongWithASoundScene) {
  EXPECT_EQ(problems([](Scene&) {}), Lines{});
}

TEST(SceneValidation, WantsMaterialsNamedOnce) {
  EXPECT_EQ(problems([](Scene& s) { s.material.push_back(s.material[0]); }),
            Lines{"material[2].name: the same as material[0].name"});
  EXPECT_EQ(problems([](Scene& s) { s.material.push_back({.name = "", .rigid = true}); }),
            Lines{"material[2].name: must not be empty"});
}

TEST(SceneValidation, FindsUnknownMaterialsEverywhere) {
  EXPECT_EQ(problems([](Scene& s) {
              s.disc[0].material = s.wall[0].material = "sot";
              s.plate[0].material = s.lattice[0].material = "x";
              s.packing = {Packing{.upper_right = {1, 1}, .material = ""}};
              s.contact.pair = {{.materials = {"soft", "hrad"}}};
            }),
            (Lines{"contact.pair[0].materials[1]: no material is named \"hrad\"; did you mean \"hard\"?",
                   "disc[0].material: no material is named \"sot\"; did you mean \"soft\"?",
                   "packing[0].material: no material is named \"\"; known: soft, hard",
                   "plate[0].material: no material is named \"x\"; known: soft, hard",
                   "wall[0].material: no material is named \"sot\"; did you mean \"soft\"?",
                   "lattice[0].material: no material is named \"x\"; known: soft, hard"}));
}

TEST(SceneValidation, WantsTwoConstantsOfWhatIsElastic) {
  EXPECT_EQ(problems([](Scene& s) { s.material[0].young.reset(); }),
            Lines{"material[0]: young [Pa] is required unless rigid = true"});
  EXPECT_EQ(problems([](Scene& s) { s.material[0].poisson.reset(); }),
            Lines{"material[0]: one of poisson and shear [Pa] is required unless rigid = true"});
  EXPECT_EQ(problems([](Scene& s) { s.material[0].shear = 1e5; }),
            Lines{"material[0].shear: poisson is given too; give one of them"});
}

TEST(SceneValidation, WantsNoConstantsOfWhatIsRigid) {
  EXPECT_EQ(problems([](Scene& s) { s.material[1].young = s.material[1].poisson = s.material[1].shear = 0.1; }),
            (Lines{"material[1].young: a rigid material has no elastic constants",
                   "material[1].poisson: a rigid material has no elastic constants",
                   "material[1].shear: a rigid material has no elastic constants"}));
}

Lines shear_problems(double young, double shear) {
  return problems([&](Scene& s) { s.material[0] = {.name = "soft", .young = young, .shear = shear}; });
}

TEST(SceneValidation, TakesAShearModulusUpToIncompressible) {
  EXPECT_EQ(shear_problems(2e5, 2e5), Lines{});  // the paper's pair, nu = -0.5
  for (const double shear : {0.1, 0.2, 0.7, 1e5 / 3}) EXPECT_EQ(shear_problems(3 * shear, shear), Lines{}) << shear;
  EXPECT_EQ(shear_problems(4, 1), Lines{"material[0].shear: young / (2 shear) - 1 = 1 is outside -1 < poisson <= 0.5"});
  EXPECT_EQ(shear_problems(1e-300, 1e300).size(), 1u);
}

TEST(SceneValidation, WantsDampingGivenInOneWay) {
  EXPECT_EQ(problems([](Scene& s) {
              s.contact.damping_factor = s.contact.restitution = 0.5;
              s.contact.pair = {{.materials = {"soft", "hard"}, .damping_factor = 0.5, .restitution = 0.5}};
            }),
            (Lines{"contact.restitution: damping_factor is given too; give one of them",
                   "contact.pair[0].restitution: damping_factor is given too; give one of them"}));
}

TEST(SceneValidation, WantsEachPairOfMaterialsOnce) {
  EXPECT_EQ(problems([](Scene& s) { s.contact.pair = {{.materials = {"soft"}}}; }),
            Lines{"contact.pair[0].materials: must be two names, not 1"});
  EXPECT_EQ(problems([](Scene& s) {
              s.contact.pair = {{.materials = {"soft", "hard"}}, {.materials = {"hard", "soft"}}};
            }),
            Lines{"contact.pair[1].materials: the same as contact.pair[0].materials"});
}

TEST(SceneValidation, RefusesRigidPartsThatCanMeet) {
  const auto meeting = [](const std::string& path, const std::string& other) {
    return Lines{path + ": rigid \"hard\" can meet rigid \"hard\" of " + other + ", where nothing would deform"};
  };
  const Packing packing{.count = 2, .upper_right = {1, 1}, .material = "hard"};
  EXPECT_EQ(problems([](Scene& s) { s.disc[0].material = "hard"; }), meeting("plate[0]", "disc[0]"));
  EXPECT_EQ(problems([](Scene& s) { s.lattice[0].material = "hard"; }), meeting("lattice[0]", "plate[0]"));
  EXPECT_EQ(problems([](Scene& s) {
              s.lattice[0].material = "hard", s.lattice[0].fixed_columns = {0, 1};
            }),
            meeting("lattice[0]", "plate[0]"));
  EXPECT_EQ(problems([&](Scene& s) { s.packing = {packing}, s.plate = {}, s.wall = {}; }),
            meeting("packing[0]", "packing[0]"));
  EXPECT_EQ(problems([](Scene& s) { s.lattice[0].material = "hard", s.plate = {}; }), meeting("lattice[0]", "wall[0]"));
}

TEST(SceneValidation, TakesRigidPartsThatCannotMeet) {
  EXPECT_EQ(problems([](Scene& s) { s.disc[0].material = "hard", s.wall = {}, s.plate = {}; }), Lines{});
  EXPECT_EQ(problems([](Scene& s) {
              s.lattice[0].material = "hard", s.lattice[0].fixed_rows = {0, 1, 2}, s.plate = {};
            }),
            Lines{});  // neither the wall nor the fixed lattice moves
}

TEST(SceneValidation, WantsWallsWithANormalAndDiscsInFrontOfThem) {
  EXPECT_EQ(problems([](Scene& s) { s.wall[0].normal = {0, 0}; }), Lines{"wall[0].normal: must not be zero"});
  EXPECT_EQ(problems([](Scene& s) { s.disc[0].position.y = -0.01; }),
            Lines{"disc[0].position: the centre is behind wall[0]"});
}

TEST(SceneValidation, RefusesTwoDiscsInOnePlaceButNotAnOverlap) {
  EXPECT_EQ(problems([](Scene& s) { s.disc.push_back(s.disc[0]); }),
            Lines{"disc[1].position: the same as disc[0].position"});
  EXPECT_EQ(problems([](Scene& s) { s.disc.push_back(s.disc[0]), s.disc[1].position.x = 0.01; }), Lines{});
}

TEST(SceneValidation, WantsARectangleThatHoldsADisc) {
  const auto packed = [](const Packing& packing) { return problems([&](Scene& s) { s.packing = {packing}; }); };
  Packing packing{.radius_min = 0.1, .radius_max = 0.1, .upper_right = {0.2, 0.2}, .material = "soft"};
  EXPECT_EQ(packed(packing), Lines{});
  packing.radius_max = 0.11;
  EXPECT_EQ(packed(packing), Lines{"packing[0].upper_right: the rectangle is too small for a disc of radius_max"});
  packing.radius_max = 0.09;
  EXPECT_EQ(packed(packing), Lines{"packing[0].radius_min: above radius_max, 0.09 m"});
  packing.radius_min = 0.01, packing.upper_right.x = 0;
  EXPECT_EQ(packed(packing), Lines{"packing[0].upper_right: must be above lower_left and to the right of it"});
  packing.upper_right.x = 1, packing.seed = ~std::uint64_t{0};
  EXPECT_EQ(packed(packing), Lines{"packing[0].seed: above 2^63 - 1, the largest integer of TOML"});
}

TEST(SceneValidation, WantsTheHeightOfAPlateGivenInOneWay) {
  EXPECT_EQ(problems([](Scene& s) { s.plate[0].lower_edge.reset(); }),
            Lines{"plate[0]: one of lower_edge [m] and working_depth [m] is required"});
  EXPECT_EQ(problems([](Scene& s) { s.settle.emplace(), s.plate[0].working_depth = 0; }),
            Lines{"plate[0].working_depth: lower_edge is given too; give one of them"});
}

TEST(SceneValidation, MeasuresAWorkingDepthFromSettledDiscs) {
  const auto deep = [](Scene& s) { s.plate[0].lower_edge.reset(), s.plate[0].working_depth = 0.1; };
  EXPECT_EQ(problems([&](Scene& s) { deep(s), s.settle.emplace(); }), Lines{});
  EXPECT_EQ(problems([&](Scene& s) { deep(s), s.disc.clear(); }),
            (Lines{"plate[0].working_depth: needs a [[disc]] or [[packing]]; or give lower_edge",
                   "plate[0].working_depth: needs [settle]; or give lower_edge"}));
}

TEST(SceneValidation, SettlesOnlyWhatFalls) {
  EXPECT_EQ(problems([](Scene& s) { s.settle.emplace(), s.model.gravity = 0, s.disc.clear(); }),
            (Lines{"settle: needs model.gravity > 0", "settle: there is no [[disc]] or [[packing]] to settle"}));
}

TEST(SceneValidation, WantsFixedLinesInsideTheLatticeAndOnce) {
  EXPECT_EQ(problems([](Scene& s) {
              s.lattice[0].fixed_rows = {3, -1}, s.lattice[0].fixed_columns = {1, 1};
            }),
            (Lines{"lattice[0].fixed_rows[0]: 3 is outside the lattice, whose last is 2",
                   "lattice[0].fixed_rows[1]: -1 is outside the lattice, whose last is 2",
                   "lattice[0].fixed_columns[1]: the same as lattice[0].fixed_columns[0]"}));
}

TEST(SceneValidation, WantsNodesInsideTheLatticeAndOnce) {
  EXPECT_EQ(problems([](Scene& s) {
              s.lattice[0].node = {{.row = 2, .column = 1}, {.row = 3, .column = 2}, {.row = 2, .column = 1}};
            }),
            (Lines{"lattice[0].node[1].row: 3 is outside the lattice, whose last is 2",
                   "lattice[0].node[1].column: 2 is outside the lattice, whose last is 1",
                   "lattice[0].node[2]: the same as lattice[0].node[0]"}));
}

TEST(SceneValidation, LetsAFixedNodeBeDisplacedButNotMoveOrFeelALoad) {
  EXPECT_EQ(problems([](Scene& s) {
              s.lattice[0].fixed_columns = {1};
              s.lattice[0].node = {{.row = 0, .displacement = {1, 0}, .velocity = {1, 0}, .force = {0, 1}},
                                   {.row = 1, .velocity = {1, 0}, .force = {0, 1}},
                                   {.row = 1, .column = 1, .velocity = {0, 1}}};
            }),
            (Lines{"lattice[0].node[0].velocity: the node is fixed", "lattice[0].node[0].force: the node is fixed",
                   "lattice[0].node[2].velocity: the node is fixed"}));
}

TEST(SceneValidation, WantsSomethingThatMoves) {
  const auto stuck = [](Scene& s) { s.disc.clear(), s.lattice[0].fixed_rows = {2, 1, 0}; };
  EXPECT_EQ(problems([](Scene& s) { s.lattice[0].fixed_rows = {0, 1, 2}; }), Lines{});
  EXPECT_EQ(problems([](Scene& s) { s.disc.clear(); }), Lines{});
  EXPECT_EQ(problems(stuck).size(), 1u);
  EXPECT_EQ(problems([](Scene& s) { s.disc.clear(), s.lattice[0].fixed_columns = {0, 1}; }).size(), 1u);
  EXPECT_EQ(problems([](Scene& s) { s.disc.clear(), s.lattice.clear(); }).size(), 1u);
}

TEST(SceneValidation, WantsTimesInOrder) {
  EXPECT_EQ(problems([](Scene& s) { s.time.step = 2, s.output.interval = 1; }),
            (Lines{"time.step: longer than the whole run, whose end is 1 s",
                   "output.interval: shorter than time.step, 2 s"}));
  EXPECT_EQ(problems([](Scene& s) {
              s.output.frames = {0, 0.5, 0.5, 1, 1.5};
            }),
            (Lines{"output.frames[2]: not later than the frame before it",
                   "output.frames[4]: after the end of the run, 1 s"}));
}

TEST(SceneValidation, WantsPartsNamedOnceOfEachKind) {
  EXPECT_EQ(problems([](Scene& s) {
              s.wall.push_back(s.wall[0]), s.plate.push_back(s.plate[0]), s.lattice.push_back(s.lattice[0]);
            }),
            (Lines{"plate[1].name: the same as plate[0].name", "wall[1].name: the same as wall[0].name",
                   "lattice[1].name: the same as lattice[0].name"}));
  EXPECT_EQ(problems([](Scene& s) {
              s.wall[0].name = "";
              s.wall.push_back(s.wall[0]);
              s.plate[0].name = s.lattice[0].name;
            }),
            Lines{});
}

TEST(SceneWriter, WritesWhatReadsBackAsTheSameText) {
  const std::string text = canonical_text(read_scene(source_dir / "validation/scenes/scenario_3.toml"));
  EXPECT_EQ(canonical_text(parse_scene(text, "f")), text);
}

TEST(SceneWriter, WritesEveryKindOfPart) {
  Scene s = sound_scene();
  s.title = "quote \" and backslash \\";
  s.settle.emplace();
  s.contact.pair = {{.materials = {"soft", "hard"}, .friction = 0.1}};
  s.packing = {Packing{.upper_right = {1, 1}, .material = "soft", .seed = 9'000'000'000'000'000'001}};
  s.lattice[0].node = {{.row = 1, .displacement = {-0.0, 5e-324}}, {.row = 2}};
  s.lattice[0].bending.strength = 1e21;
  s.output.frames = {0.1, 0.2};
  const Scene read = parse_scene(canonical_text(s), "f");
  EXPECT_EQ(canonical_text(read), canonical_text(s));
  EXPECT_EQ(read.title, s.title);
  EXPECT_EQ(read.packing.at(0).seed, s.packing[0].seed);
  EXPECT_TRUE(std::signbit(read.lattice.at(0).node.at(0).displacement.x));
  EXPECT_EQ(read.lattice.at(0).node.at(0).displacement.y, 5e-324);
  EXPECT_EQ(read.lattice.at(0).structural.strength, infinity);
  EXPECT_EQ(read.lattice.at(0).bending.strength, 1e21);
}

TEST(SceneWriter, LeavesOutWhatHasNoValue) {
  const std::string text = canonical_text(parse_scene(good, "f"));
  for (const char* absent : {"shear", "damping_factor", "settle", "wall"})
    EXPECT_EQ(text.find(absent), std::string::npos) << absent;
}

RC_GTEST_PROP(SceneWriter, ReturnsEveryNumberToTheLastBit, ()) {
  Scene s = sound_scene();
  s.disc[0].velocity = {*rc::gen::arbitrary<double>(),
                        std::ldexp(*rc::gen::arbitrary<double>(), *rc::gen::inRange(-1100, 900))};
  RC_PRE(std::isfinite(s.disc[0].velocity.y));
  RC_ASSERT(parse_scene(canonical_text(s), "f").disc.at(0).velocity == s.disc[0].velocity);
}

TEST(SceneHash, IsBlindToHowASceneIsWritten) {
  const std::string other = R"(# the same in other words
disc = [ { material = 'soft', radius = 1_00e-3, position = [ 0, +1 ], spin = 0.0 } ]   # spin by default
title = "a disc falls"
material = [ { poisson = 3e-1, young = 200000, name = "soft" } ]
time.step = 0.001
time.end = 1
)";
  EXPECT_EQ(scene_hash(parse_scene(other, "f")), scene_hash(parse_scene(good, "f")));
}

TEST(SceneHash, SeesEveryValue) {
  const std::uint64_t hash = scene_hash(sound_scene());
  const auto changes_hash = [&](const std::function<void(Scene&)>& change) {
    Scene scene = sound_scene();
    change(scene);
    return scene_hash(scene) != hash;
  };
  EXPECT_FALSE(changes_hash([](Scene&) {}));
  EXPECT_TRUE(changes_hash([](Scene& s) { s.title += ' '; }));
  EXPECT_TRUE(changes_hash([](Scene& s) { s.disc[0].radius = std::nextafter(s.disc[0].radius, 1); }));
  EXPECT_TRUE(changes_hash([](Scene& s) { s.model.lever = Lever::radius; }));
  EXPECT_TRUE(changes_hash([](Scene& s) { s.lattice[0].fixed_rows = {1}; }));
  EXPECT_TRUE(changes_hash([](Scene& s) { s.settle.emplace(); }));
  EXPECT_TRUE(changes_hash([](Scene& s) { s.output.energy = false; }));
}

// The definition written out again, itself held to the published hash of "a".
TEST(SceneHash, IsFnv1aOfTheCanonicalText) {
  const auto fnv1a = [](const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char c : text) hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x100000001b3u;
    return hash;
  };
  EXPECT_EQ(fnv1a("a"), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(scene_hash(sound_scene()), fnv1a(canonical_text(sound_scene())));
}

// Whatever is done to a good file, it is a scene or it is refused with at least one message; nothing else is thrown.
RC_GTEST_PROP(SceneReader, SurvivesAnyMutation, ()) {
  static const std::string whole = content(source_dir / "validation/scenes/scenario_3.toml");
  std::string text = whole;
  const int changes = *rc::gen::inRange(1, 6);
  for (int i = 0; i < changes; ++i) {
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size() + 1);
    const auto length = std::min(*rc::gen::inRange<std::size_t>(0, 40), text.size() - at);
    const auto from = *rc::gen::inRange<std::size_t>(0, whole.size() - 40);
    const std::vector<std::string> inserts = {"",
                                              whole.substr(from, 20),
                                              *rc::gen::string<std::string>(),
                                              "\"",
                                              "'''",
                                              "[",
                                              "]]",
                                              "{",
                                              "=",
                                              "\n",
                                              "#",
                                              ".",
                                              "-",
                                              "nan",
                                              "1e999",
                                              "\xC3",
                                              std::string(1, '\0')};
    text.replace(at, length, *rc::gen::elementOf(inserts));
  }
  try {
    const std::string canonical = canonical_text(parse_scene(text, "f"));
    RC_ASSERT(canonical_text(parse_scene(canonical, "f")) == canonical);
  } catch (const SceneError& error) {
    RC_ASSERT(!error.messages().empty());
    for (const std::string& message : error.messages()) RC_ASSERT(message.find(" error: ") != std::string::npos);
  }
}

}  // namespace
}  // namespace furrow
