// What the numbers of a study depend on: every file of the project that its own files include, and the sources of the
// headers among them, but for those that decide no number.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include "validation/page/chapters/chapters.h"

namespace furrow::validation {
namespace {

namespace fs = std::filesystem;

// A scene goes into a number by the hash of its canonical text, the number's input: how that text is read, checked and
// put together decides no number beside it.
constexpr std::array text_of_scenes{
    "src/scene/findings.", "src/scene/hash.",    "src/scene/key.",       "src/scene/labels.",    "src/scene/range.",
    "src/scene/read.",     "src/scene/schema",   "src/scene/set_key.",   "src/scene/toml_text.", "src/scene/toml_value",
    "src/scene/utf8.",     "src/scene/wording.", "src/scene/interrupt.", "src/report/embedded.", "src/report/study."};
// Keeping, sealing and looking up what was measured; the clock and the name of the machine; judging in words.
constexpr std::array keeping{"src/output/build_info.", "src/output/files.",       "src/output/kept_result.",
                             "src/output/machine.",    "src/output/strict_json.", "src/report/measurement.",
                             "src/report/age.",        "src/report/numbers.",     "src/report/seal.",
                             "src/report/sources.",    "verification/check."};

// What may end a run and changes no number of it decides only what is watched.
bool looks_on(const std::string& file) {
  static const Sources& all = sources_of_this_program();
  static const Sources watched = that_decide(all, {}, true), unwatched = that_decide(all, {});
  return watched.contains(file) && !unwatched.contains(file);
}

bool decides_no_number(const std::string& file) {
  const auto begins = [&](const char* with) { return file.starts_with(with); };
  return std::any_of(text_of_scenes.begin(), text_of_scenes.end(), begins) ||
         std::any_of(keeping.begin(), keeping.end(), begins);
}

const fs::path root = FURROW_SOURCE_DIR;

std::vector<std::string> included_by(const std::string& file) {
  static const std::regex line(R"re(^\s*#include "([^"]+)")re");
  std::ifstream stream(root / file);
  std::vector<std::string> files;
  std::smatch found;
  for (std::string text; std::getline(stream, text);) {
    if (!std::regex_search(text, found, line)) continue;
    const std::string name = found[1];
    for (const std::string& path : {name, "src/" + name}) {
      if (fs::exists(root / path)) files.push_back(path);
    }
  }
  const fs::path source = fs::path(file).replace_extension(".cpp");
  if (file.ends_with(".h") && fs::exists(root / source)) files.push_back(source.string());
  return files;
}

// All files that a number can come from, each with the one that led to it.
std::map<std::string, std::string> reached_from(std::vector<std::string> files) {
  std::map<std::string, std::string> from;
  for (const std::string& file : files) from[file] = "its own";
  while (!files.empty()) {
    const std::string file = files.back();
    files.pop_back();
    for (const std::string& next : included_by(file)) {
      if (!decides_no_number(next) && from.emplace(next, file).second) files.push_back(next);
    }
  }
  return from;
}

std::vector<std::string> own_files(const Study& study) {
  std::vector<std::string> files;
  for (const auto& [file, hash] : sources_of_this_program()) {
    if (std::any_of(study.files.begin(), study.files.end(),
                    [&, f = file](const std::string& own) { return f.starts_with(own); }))
      files.push_back(file);
  }
  return files;
}

TEST(SourcesOfAStudy, AreAllFilesThatItIncludes) {
  for (const Study& study : catalogue()) {
    const Sources hashed = study.sources();
    const auto reached = reached_from(own_files(study));
    for (const auto& [file, from] : reached)
      EXPECT_TRUE(hashed.contains(file) || (!study.watched && looks_on(file)))
          << study.name << " depends on " << file << " by " << from;
    if (!study.files.empty()) {
      EXPECT_GT(reached.size(), 50u) << study.name;
    }
  }
}

// What of verification judges, and what of it each of the kinds of kept verdicts begins with.
std::vector<std::string> begins_with(const std::string& what) {
  const std::string engines = "verification/engines/";
  if (what == "judged_furrow") return {engines + "furrow_engine.cpp", engines + "judge.cpp"};
  if (what == "judged_others") return {engines + "judge.cpp"};
  const bool independent = what == "judged_independent";
  std::vector<std::string> files{independent ? engines + "judge.cpp" : "tests/studies/work_precision_counts.cpp"};
  for (const auto& entry : fs::directory_iterator(root / (independent ? "verification/engines" : "verification"))) {
    const std::string name = entry.path().filename();
    if (entry.path().extension() == ".cpp" && (!independent || name.starts_with("independent")))
      files.push_back(fs::relative(entry.path(), root));
  }
  return files;
}

// How a program is started and how the files of a run are written decides no verdict; the text of a case goes into it
// by its hash.
bool decides_no_verdict(const std::string& file) {
  return file.starts_with("src/output/") && !file.starts_with("src/output/schedule.");
}

TEST(SourcesOfVerdicts, AreAllFilesThatTheirJudgesInclude) {
  for (const char* what : {"faults", "judged_furrow", "judged_independent", "judged_others"}) {
    const Sources hashed = that_decide(what);
    const auto reached = reached_from(begins_with(what));
    for (const auto& [file, from] : reached) {
      if (decides_no_verdict(file) || decides_no_number(file) || looks_on(file)) continue;
      EXPECT_TRUE(hashed.contains(file)) << what << " depend on " << file << " by " << from;
    }
    for (const auto& [file, hash] : hashed) {
      const bool of_solver = that_decide("times").contains(file), by_hand = file.find("/fault_study/") != file.npos ||
                                                                            file.find("/adapters/") != file.npos ||
                                                                            file.find("/program_engine.") != file.npos;
      EXPECT_TRUE(of_solver || by_hand || decides_no_number(file) || reached.contains(file))
          << what << " do not depend on " << file;
    }
    EXPECT_EQ(hashed.contains("src/physics/contact.h"),
              std::string(what) == "faults" || std::string(what) == "judged_furrow");
  }
}

// What makes a lattice decides numbers of all its scenes, what reads its text does not.
TEST(SourcesOfAStudy, HoldWhatMakesAScene) {
  for (const Study& study : catalogue()) {
    if (study.name == "speed") continue;
    const Sources hashed = study.sources();
    for (const char* file : {"src/scene/lattice_parts.cpp", "src/scene/stem.cpp", "src/scene/packing.cpp"})
      EXPECT_TRUE(hashed.contains(file)) << study.name << ": " << file;
    EXPECT_FALSE(hashed.contains("src/scene/read.cpp")) << study.name;
  }
}

// A list of what is left out that names nothing would hide nothing, and one that names a law would hide it.
TEST(SourcesOfAStudy, LeaveOutNothingThatIsNotThere) {
  for (const auto* list : {&text_of_scenes[0], &keeping[0]}) {
    const std::size_t count = list == &keeping[0] ? keeping.size() : text_of_scenes.size();
    for (std::size_t k = 0; k < count; ++k) {
      const fs::path named = root / list[k];
      const auto fits = [&](const fs::directory_entry& one) {
        return one.path().filename().string().starts_with(named.filename().string());
      };
      EXPECT_TRUE(std::any_of(fs::directory_iterator(named.parent_path()), {}, fits)) << list[k];
    }
  }
}

}  // namespace
}  // namespace furrow::validation
