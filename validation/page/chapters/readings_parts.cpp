#include "validation/page/chapters/readings_parts.h"

#include <algorithm>
#include <cmath>

#include "output/files.h"
#include "scene/read.h"
#include "scene/wording.h"
#include "validation/page/chapters/in_words.h"
#include "validation/page/chapters/readings_rows.h"
#include "validation/studies/observed_run.h"

namespace furrow::validation {
namespace {

using Packings = std::map<std::string, std::vector<Json>>;

// Mean over the packings; scene 1 has one, which stands beside each of the others.
double mean_misfit(const Packings& said, const std::vector<std::string>& scenes) {
  std::size_t packings = 1;
  for (const auto& [scene, runs] : said) packings = std::max(packings, runs.size());
  double sum = 0;
  for (std::size_t p = 0; p < packings; ++p) {
    std::map<std::string, Json> one;
    for (const auto& [scene, runs] : said) one[scene] = runs[std::min(p, runs.size() - 1)];
    sum += misfit_of(one, scenes);
  }
  return sum / static_cast<double>(packings);
}

const Finalist& best_of(const ReadingsFound& found, int valid_runs) {
  const Finalist* best = nullptr;
  double least = infinity;
  for (const Finalist& f : found.finalists) {
    const double worse_step = std::max(mean_misfit(f.said, found.scenes), mean_misfit(f.finer, found.scenes));
    if (f.valid_runs() >= valid_runs && worse_step < least) best = &f, least = worse_step;
  }
  return *best;
}

bool among(const std::vector<std::string>& scenes, const std::string& scene) {
  return std::find(scenes.begin(), scenes.end(), scene) != scenes.end();
}

}  // namespace

Judgement judge(const Finalist& finalist, const ReadingsFound& found) {
  Judgement judged;
  for (const Statement& row : the_rows())
    judged.rows[row.id] =
        row_verdict(row, runs_of(row, finalist, found, AtStep::papers), runs_of(row, finalist, found, AtStep::finer));
  for (const Statement& row : the_paper().statements)
    judged.older_reproduced += judged.rows[row.id] == "reproduced" ? 1 : 0;
  for (const Sentence& sentence : the_sentences()) {
    judged.sentences.push_back(sentence_verdict(sentence, judged.rows));
    judged.by_rows.push_back(rows_verdict(sentence, judged.rows));
  }
  judged.misfit = mean_misfit(finalist.said, found.scenes);
  judged.finer_misfit = mean_misfit(finalist.finer, found.scenes);
  return judged;
}

const Finalist& best_finalist(const ReadingsFound& found) { return best_of(found, 0); }

const Finalist& best_valid_finalist(const ReadingsFound& found) {
  return best_of(found, found.finalists.front().valid_runs());
}

int watched_runs(const ReadingsFound& found) {
  std::size_t count = 0;
  for (const auto& [scene, runs] : found.finalists.front().watched) count += runs.size();
  return static_cast<int>(count);
}

bool is_of_the_scene_files(const Interpretation& reading, const std::vector<std::string>& scenes,
                           const std::string& in) {
  const auto bare = [](Scene scene) {
    scene.title.clear();
    scene.allow.reset();
    scene.output = {};
    return canonical_text(scene);
  };
  return std::all_of(scenes.begin(), scenes.end(), [&](const std::string& name) {
    return bare(scene_of(name, reading, paper_step, 1)) == bare(scene_named(in + name));
  });
}

std::string name_of(const Interpretation& reading) {
  const std::string words = words_of(reading);
  return words.empty() ? "literal" : words;
}

std::string name_beside(const Interpretation& reading, const Interpretation& winner) {
  if (reading == winner) return "the winner";
  std::vector<std::string> differing;
  std::ptrdiff_t choices = 0;
  for (std::size_t k = 0; k < reading.size(); ++k) {
    const Choice& choice = the_readings().choices[k];
    choices += reading[k] != 0 ? 1 : 0;
    if (reading[k] == winner[k]) continue;
    const std::string& name = choice.alternatives[static_cast<std::size_t>(reading[k])].name;
    differing.push_back(choice.id + " " + (reading[k] == 0 ? "literal" : name));
  }
  return std::ssize(differing) < choices ? "the winner, but " + joined(differing) : name_of(reading);
}

const std::vector<std::string>& counted_verdicts() {
  static const std::vector<std::string> all{
      "reproduced",  "reproduced in kind", "only at this step", "not reproduced", "contradicted by the paper itself",
      "not testable"};
  return all;
}

int count_of(const std::vector<std::string>& verdicts, const std::string& verdict) {
  return static_cast<int>(std::count(verdicts.begin(), verdicts.end(), verdict));
}

int testable() {
  return static_cast<int>(
      std::count_if(the_sentences().begin(), the_sentences().end(), [](const Sentence& s) { return !s.rows.empty(); }));
}

int rows_near(const ReadPoint& point, const std::vector<std::string>& scenes) {
  int near = 0;
  for (const Statement& row : the_rows())
    near += among(scenes, row.scene) && row_misfit(row, point.said.at(row.scene)) < 0.5 ? 1 : 0;
  return near;
}

std::string wanted_of(const Statement& row) {
  if (!row.words.empty()) return row.words;
  return row.relation + (row.relation.empty() ? "" : " ") + number(row.value) +
         (row.unit.empty() ? "" : " " + row.unit);
}

std::string said_in(const Json& said, const std::string& id) {
  if (!said.contains(id)) return said.contains("failed") ? "does not run" : "–";
  return said[id].is_string() ? said[id].get<std::string>() : three_digits(said[id]);
}

std::string said_of(const Finalist& finalist, const ReadingsFound& found, const std::string& id) {
  const Statement& row = row_named(id);
  const Sample sample = sample_of(id, runs_of(row, finalist, found, AtStep::papers));
  if (is_yes_or_no(row)) return count_of_yes(sample) + " " + what_runs_do(row);
  if (sample.numbers.empty()) return sample.words.empty() ? "–" : sample.words.front();
  return three_digits(sample.quantile(0.5)) + (row.unit.empty() ? "" : " " + row.unit);
}

}  // namespace furrow::validation
