// Whatever a scene says, the program ends by itself, says what is wrong in the stated form, and keeps its word: what
// `check` lets pass `run` does not refuse, a run that says "finished" has left numbers only, and its scene.toml is one.
//
// Scenes at random: those of tests/property/scenes with lines dropped, doubled and exchanged, numbers replaced by
// extreme ones, words misspelt, parts moved onto one another. FURROW_LONG=1: many more, from a seed that is printed.
// FURROW_SEED: from that one. FURROW_TRIED: another program than the one that was built here, such as one with
// sanitizers.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <regex>
#include <set>
#include <sstream>

#include "tests/files.h"

namespace furrow::test {
namespace {

namespace fs = std::filesystem;

std::string environment(const char* name, const std::string& otherwise) {
  const char* value = std::getenv(name);
  return value && *value ? value : otherwise;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// Scenes that are right, small and quick, with a part of each kind between them.
std::vector<std::string> seeds() {
  std::set<fs::path> files;
  for (const auto& entry : fs::directory_iterator(FURROW_SOURCE_DIR "/tests/property/scenes"))
    files.insert(entry.path());
  std::vector<std::string> texts;
  for (const fs::path& file : files) texts.push_back(text_of(file));
  return texts;
}

// Changes to the text of a scene.
class Mutator {
 public:
  explicit Mutator(unsigned long seed) : random_(seed) {}

  std::string of(const std::string& text) {
    lines_ = lines_of(text);
    for (std::size_t k = 1 + below(3); k > 0; --k) change();
    std::string changed;
    for (const std::string& line : lines_) changed += line + "\n";
    return changed;
  }
  std::size_t below(std::size_t count) { return random_() % count; }

 private:
  void change() {
    const std::size_t at = below(lines_.size());
    const auto place = lines_.begin() + static_cast<std::ptrdiff_t>(at);
    switch (below(10)) {
      case 0:
        if (lines_.size() > 1) lines_.erase(place);
        break;
      case 1:
        lines_.insert(place, std::string(lines_[at]));
        break;
      case 2:
        std::swap(lines_[at], lines_[below(lines_.size())]);
        break;
      case 3:
        misspell(lines_[at]);
        break;
      case 4:
        move_onto_another();
        break;
      case 5:
        double_table();
        break;
      default:
        replace_number();
    }
  }

  void misspell(std::string& line) {
    if (line.empty()) return;
    const std::size_t k = below(line.size());
    if (below(2) == 0)
      line.erase(k, 1);
    else
      line.insert(k, 1, static_cast<char>(32 + below(95)));
  }

  // A value of one key is given to the same key somewhere else, or to another one of its form.
  void move_onto_another() {
    static const std::regex pair(R"((position|point|origin|lower_left|displacement|upper_right) = (\[[^\]]*\]))");
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < lines_.size(); ++k)
      if (std::regex_search(lines_[k], pair)) places.push_back(k);
    if (places.size() < 2) return;
    std::smatch from, to;
    const std::string source = lines_[places[below(places.size())]];
    std::string& target = lines_[places[below(places.size())]];
    std::regex_search(source, from, pair);
    const std::string kept = target;
    std::regex_search(kept, to, pair);
    target = to[1].str() + " = " + from[2].str();
  }

  // A part is given twice.
  void double_table() {
    std::vector<std::size_t> heads;
    for (std::size_t k = 0; k < lines_.size(); ++k)
      if (lines_[k].rfind("[[", 0) == 0) heads.push_back(k);
    if (heads.empty()) return;
    const std::size_t head = heads[below(heads.size())];
    std::size_t end = head + 1;
    while (end < lines_.size() && lines_[end].rfind('[', 0) != 0) ++end;
    const std::vector<std::string> table(lines_.begin() + static_cast<std::ptrdiff_t>(head),
                                         lines_.begin() + static_cast<std::ptrdiff_t>(end));
    lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(end), table.begin(), table.end());
  }

  void replace_number() {
    static const std::regex number(R"([-+]?[0-9]+(\.[0-9]*)?(e[-+]?[0-9]+)?)");
    std::vector<std::pair<std::size_t, std::smatch>> found;
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      for (std::sregex_iterator m(lines_[k].begin(), lines_[k].end(), number), end; m != end; ++m)
        found.emplace_back(k, *m);
    }
    if (found.empty()) return;
    const auto& [line, match] = found[below(found.size())];
    const auto at = static_cast<std::size_t>(match.position()), length = static_cast<std::size_t>(match.length());
    lines_[line].replace(at, length, other_number(match.str()));
  }

  std::string other_number(const std::string& was) {
    static const std::vector<std::string> extreme{
        "0",     "0.0",   "-0.0",  "-1",     "-1.0",       "1",           "1.0",
        "nan",   "inf",   "-inf",  "1e-300", "1e300",      "1e-160",      "1e160",
        "1e17",  "1e-17", "-1e9",  "1e9",    "1e-9",       "3",           "0.5",
        "2.0",   "100",   "65536", "1e6",    "2147483648", "-2147483649", "9223372036854775807",
        "1e400", "\"1\""};
    if (below(3) > 0) return extreme[below(extreme.size())];
    static const double factors[] = {-1, 0.1, 0.5, 0.99, 1.01, 2, 10};
    std::ostringstream text;
    text << std::strtod(was.c_str(), nullptr) * factors[below(7)];
    return text.str().find_first_of(".en") == std::string::npos && was.find_first_of(".e") != std::string::npos
               ? text.str() + ".0"
               : text.str();
  }

  std::mt19937_64 random_;
  std::vector<std::string> lines_;
};

struct Outcome {
  int code = -1;
  std::string out, err;
};

enum ExitCode { good = 0, failed_check = 1, bad_input = 2, diverged = 3, io_failed = 4, interrupted = 130 };

class MutatedScenes : public testing::Test {
 protected:
  void SetUp() override {
    const auto limit = static_cast<long>(4e6);  // kB: a scene that asks for more must be refused, not killed
    limits_ = sanitizers() ? "" : "ulimit -v " + std::to_string(limit) + " && ";
    knows_stability_ = furrow("stability --help").code == good;  // the solver alone has no such command
  }

  static bool sanitizers() { return !environment("FURROW_TRIED", "").empty(); }

  // Interrupted after so many seconds; what then does not end within a minute hangs (137).
  Outcome furrow(const std::string& arguments, int seconds = 1) const {
    const std::string program = environment("FURROW_TRIED", FURROW_PROGRAM);
    const std::string command = "cd '" + directory_.string() + "' && " + limits_ +
                                "timeout --preserve-status -s INT -k 60 " + std::to_string(seconds) + " '" + program +
                                "' " + arguments + " >out.txt 2>err.txt </dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status), text_of(directory_ / "out.txt"),
            text_of(directory_ / "err.txt")};
  }

  // Ends as stated, and says why.
  Outcome expect_stated(const std::string& arguments, std::vector<int> codes) {
    const Outcome o = furrow(arguments);
    codes.push_back(interrupted);
    EXPECT_TRUE(std::find(codes.begin(), codes.end(), o.code) != codes.end())
        << arguments << ": exit code " << o.code << "\n"
        << o.err;
    EXPECT_EQ(o.err.find("Sanitizer"), std::string::npos) << arguments << "\n" << o.err;
    EXPECT_EQ(o.err.find("runtime error"), std::string::npos) << arguments << "\n" << o.err;
    if (o.code == bad_input || o.code == diverged || o.code == io_failed) {
      static const std::regex error(R"((^|\n)(s\.toml:[0-9]+:[0-9]+: error: .|furrow: error: .))");
      EXPECT_TRUE(std::regex_search(o.err, error)) << arguments << " says: " << o.err;
    }
    return o;
  }

  // The scene, of which a strength may be infinite, stands in two files as text.
  static bool is_scene(const fs::path& file) {
    return file.filename() == "scene.toml" || file.filename() == "checkpoint";
  }

  // What a finished run has left.
  void expect_numbers() {
    static const std::regex no_number(R"((^|[,\s>])[-+]?(nan|inf)([,\s<]|$))", std::regex::icase);
    for (const auto& entry : fs::recursive_directory_iterator(directory_ / "o")) {
      if (!entry.is_regular_file() || is_scene(entry.path())) continue;
      std::smatch found;
      const std::string text = text_of(entry.path());
      EXPECT_FALSE(std::regex_search(text, found, no_number)) << entry.path().filename() << ": " << found.str();
      EXPECT_EQ(entry.path().string().find(".partial"), std::string::npos) << entry.path();
    }
    fs::copy_file(directory_ / "o/scene.toml", directory_ / "s.toml", fs::copy_options::overwrite_existing);
    expect_stated("check s.toml", {good});
  }

  void try_scene(const std::string& text, bool whole) {
    std::ofstream(directory_ / "s.toml") << text;
    const Outcome check = expect_stated("check s.toml", {good, bad_input});
    const std::vector<int> word = check.code == good ? std::vector<int>{good, diverged} : std::vector<int>{bad_input};
    expect_stated("explain s.toml", word);
    fs::remove_all(directory_ / "o");
    const Outcome run = expect_stated("run s.toml --out o", word);
    if (whole && knows_stability_) expect_stated("stability s.toml --method pece --method rk4", word);
    if (run.code == good) expect_numbers();
  }

  const OwnDirectory own_;
  const fs::path directory_ = own_.path();
  std::string limits_;
  bool knows_stability_ = false;
};

TEST_F(MutatedScenes, TheSeedsAreGood) {
  for (const std::string& seed : seeds()) {
    std::ofstream(directory_ / "s.toml") << seed;
    EXPECT_EQ(furrow("check s.toml", 300).code, good) << seed << text_of(directory_ / "err.txt");
    fs::remove_all(directory_ / "o");
    EXPECT_EQ(furrow("run s.toml --out o", 300).code, good) << seed << text_of(directory_ / "err.txt");
    expect_numbers();
  }
}

TEST_F(MutatedScenes, EndAsStated) {
  const bool many = !environment("FURROW_LONG", "").empty();
  const unsigned long first =
      std::stoul(environment("FURROW_SEED", many ? std::to_string(std::random_device()()) : "1"));
  const unsigned long count = std::stoul(environment("FURROW_SCENES", many ? "3000" : "100"));
  std::printf("FURROW_SEED=%lu\n", first);
  int failures = 0;
  for (unsigned long k = first; k < first + count && failures < 5; ++k) {
    Mutator mutator(k);
    const std::string text = mutator.of(seeds()[k % seeds().size()]);
    const int before = testing::UnitTest::GetInstance()->current_test_info()->result()->total_part_count();
    try_scene(text, k % 4 < 2 || many);
    if (testing::UnitTest::GetInstance()->current_test_info()->result()->total_part_count() == before) continue;
    ++failures;
    ADD_FAILURE() << "FURROW_SEED=" << k << " FURROW_SCENES=1, the scene:\n" << text;
  }
}

}  // namespace
}  // namespace furrow::test
