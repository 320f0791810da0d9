#include "export/tears_apart.h"

#include <algorithm>

#include "scene/wording.h"

namespace furrow {
namespace {

constexpr double round_off = 1e-6;  // of a step

StepSpan moment(double step) { return {step, step}; }

double gap(StepSpan a, StepSpan b) { return std::max({0.0, a.after - b.by, b.after - a.by}); }

class Apart {
 public:
  Apart(const DeckRun& run, const std::vector<Tear>& own, const EngineOutput& engine, double early)
      : run_(run), engine_(engine), early_(early / run.step + round_off) {
    for (const Tear& tear : own) {
      own_.push_back(tear.time / run.step);
      own_links_.emplace(tear.link, moment(own_.back()));
    }
  }

  TearsApart found() {
    count();
    for (const auto& [link, theirs] : engine_.links) compare(link, theirs);
    return out_;
  }

 private:
  StepSpan never() const { return {static_cast<double>(run_.steps), infinity}; }
  StepSpan nth(const std::vector<double>& steps, std::size_t n) const {
    return n < steps.size() ? moment(steps[n]) : never();
  }
  int early_of(const std::vector<double>& steps) const {
    return static_cast<int>(std::count_if(steps.begin(), steps.end(), [&](double step) { return step <= early_; }));
  }

  // The n-th tear here and there.
  void count() {
    out_.furrow_early = early_of(own_);
    out_.engine_early = early_of(engine_.tears);
    const auto most = static_cast<std::size_t>(std::max(out_.furrow_early, out_.engine_early));
    for (std::size_t n = 0; n < most; ++n) out_.steps = std::max(out_.steps, gap(nth(own_, n), nth(engine_.tears, n)));
  }

  void compare(int link, StepSpan theirs) {
    const auto found = own_links_.find(link);
    const StepSpan ours = found == own_links_.end() ? never() : found->second;
    const bool torn = ours.by <= static_cast<double>(run_.last_row()) + round_off, torn_there = theirs.by < infinity;
    out_.furrow += torn;
    out_.engine += torn_there;
    out_.both += torn && torn_there;
    if (ours.by <= early_ || theirs.by <= early_) out_.steps = std::max(out_.steps, gap(ours, theirs));
  }

  const DeckRun& run_;
  const EngineOutput& engine_;
  const double early_;  // in steps
  std::vector<double> own_;
  std::map<int, StepSpan> own_links_;
  TearsApart out_;
};

}  // namespace

TearsApart tears_apart(const DeckRun& run, const std::vector<Tear>& own, const EngineOutput& engine, double early) {
  return Apart(run, own, engine, early).found();
}

}  // namespace furrow
