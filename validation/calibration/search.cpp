#include "validation/calibration/search.h"

#include <nlopt.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <map>
#include <memory>
#include <stdexcept>
#include <thread>

#include "system/ode.h"

namespace furrow::validation {
namespace {

constexpr double unsaid_rank = 1e9;  // above every misfit of a point of which all is said

// Orders points as better() does, for an optimiser that knows one number.
double rank_of(const Point& point) {
  const double misfit = point.misfit();
  if (whole(point)) return std::min(misfit, unsaid_rank);
  return unsaid_rank * (1 + point.unsaid + misfit / (1 + misfit));
}

// Over the keys that have a range, as shares of it; the listed ones stay.
class Objective {
 public:
  Objective(const Evaluator& evaluator, Setting setting, int packings)
      : evaluator_(evaluator), setting_(std::move(setting)), packings_(packings) {
    for (std::size_t k = 0; k < evaluator.keys().size(); ++k) {
      if (!evaluator.keys()[k].listed()) ranged_.push_back(k);
    }
  }

  std::size_t dimension() const { return ranged_.size(); }

  double at(const double* shares) {
    for (std::size_t i = 0; i < ranged_.size(); ++i) setting_[ranged_[i]] = evaluator_.keys()[ranged_[i]].at(shares[i]);
    Point point = evaluator_.at(setting_, Packings{0, packings_});
    const double rank = rank_of(point);
    tried_.insert_or_assign(setting_, std::move(point));
    return rank;
  }

  std::vector<double> shares_of(const Setting& setting) const {
    std::vector<double> shares;
    for (const std::size_t k : ranged_)
      shares.push_back(std::clamp(evaluator_.keys()[k].share_of(setting[k]), 0.0, 1.0));
    return shares;
  }

  const std::map<Setting, Point>& tried() const { return tried_; }

  // NLopt is C: what the objective throws waits until it has returned.
  void minimise(nlopt_algorithm algorithm, std::vector<double> from, int points) {
    const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimiser(
        nlopt_create(algorithm, static_cast<unsigned>(dimension())), &nlopt_destroy);
    nlopt_opt opt = optimiser.get();
    opt_ = opt;
    nlopt_set_lower_bounds1(opt, 0);
    nlopt_set_upper_bounds1(opt, 1);
    nlopt_set_min_objective(opt, &called, this);
    nlopt_set_maxeval(opt, points);
    nlopt_set_xtol_abs1(opt, 1e-5);     // of a range: finer than any key is known
    nlopt_set_initial_step1(opt, 0.1);  // of a range; DIRECT takes none
    double least = 0;
    nlopt_optimize(opt, from.data(), &least);
    if (broken_) std::rethrow_exception(broken_);
  }

 private:
  static double called(unsigned, const double* shares, double*, void* self) {
    auto& objective = *static_cast<Objective*>(self);
    try {
      return objective.at(shares);
    } catch (...) {
      objective.broken_ = std::current_exception();
      nlopt_force_stop(objective.opt_);
      return HUGE_VAL;
    }
  }

  const Evaluator& evaluator_;
  Setting setting_;
  int packings_;
  std::vector<std::size_t> ranged_{};
  std::map<Setting, Point> tried_{};
  nlopt_opt opt_ = nullptr;
  std::exception_ptr broken_{};
};

bool has_range(const Evaluator& evaluator) {
  return std::any_of(evaluator.keys().begin(), evaluator.keys().end(), [](const VariedKey& k) { return !k.listed(); });
}

// One after the other from several threads; what one throws ends all and is thrown on.
void side_by_side(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr broken;
  const auto take = [&] {
    try {
      for (std::size_t k; (k = next++) < count;) work(k);
    } catch (...) {
      const std::scoped_lock lock(mutex);
      if (!broken) broken = std::current_exception();
      next = count;
    }
  };
  std::vector<std::jthread> others;
  for (unsigned k = 1; k < jobs && k < count; ++k) others.emplace_back(take);
  take();
  others.clear();
  if (broken) std::rethrow_exception(broken);
}

const Point& best_of(const Objective& objective) {
  const auto& tried = objective.tried();
  return std::min_element(tried.begin(), tried.end(),
                          [](const auto& a, const auto& b) { return better(a.second, b.second); })
      ->second;
}

// So many at most.
std::vector<std::size_t> best_first(const std::vector<Objective>& objectives, std::size_t most) {
  std::vector<std::size_t> order(objectives.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return better(best_of(objectives[a]), best_of(objectives[b])); });
  order.resize(std::min(order.size(), most));
  return order;
}

// Settings that cannot be told apart choose none.
void refuse_no_effect(const std::vector<Point>& points) {
  const auto alike = [&](const Point& p) { return p.values == points.front().values; };
  if (points.size() < 2 || !std::all_of(points.begin(), points.end(), alike)) return;
  throw NothingCompared("no key moves any target: " + std::to_string(points.size()) +
                        " settings give the same; vary other keys or wider ranges, or add a target that they move");
}

// Nor do those that all meet every target.
void refuse_all_alike(const std::vector<Point>& points) {
  const auto meets = [](const Point& p) { return p.failure.empty() && p.unsaid == 0 && p.misfit() == 0; };
  if (points.size() < 2 || !std::all_of(points.begin(), points.end(), meets)) return;
  throw NothingCompared("each of the " + std::to_string(points.size()) +
                        " settings meets every target, so none is the best: add a target that some miss, or vary more");
}

void refuse_failures(const std::vector<Point>& points) {
  const auto failed = [](const Point& p) { return !p.failure.empty(); };
  if (!std::all_of(points.begin(), points.end(), failed)) return;
  const std::string said = "every setting failed, the best one so: " + points.front().failure;
  if (std::all_of(points.begin(), points.end(), [](const Point& p) { return p.diverged; })) throw Divergence(said);
  throw NothingCompared(said);
}

}  // namespace

long runs_of(const SearchPlan& plan, const Evaluator& evaluator) {
  const auto combined = static_cast<long>(combinations(evaluator.keys()).size());
  const long points = has_range(evaluator)
                          ? combined * plan.global_points + std::min<long>(combined, plan.best) * plan.local_points
                          : combined;
  return points * evaluator.runs_a_point(plan.packings);
}

std::vector<Point> search(const Evaluator& evaluator, const SearchPlan& plan) {
  std::vector<Objective> objectives;
  for (const Setting& some : combinations(evaluator.keys())) objectives.emplace_back(evaluator, some, plan.packings);
  const bool ranged = has_range(evaluator);
  side_by_side(objectives.size(), plan.jobs, [&](std::size_t k) {
    Objective& objective = objectives[k];
    const std::vector<double> middle(objective.dimension(), 0.5);
    if (!ranged) return static_cast<void>(objective.at(middle.data()));
    objective.minimise(NLOPT_GN_DIRECT_L, middle, plan.global_points);
  });
  const std::vector<std::size_t> order = best_first(objectives, ranged ? static_cast<std::size_t>(plan.best) : 0);
  side_by_side(order.size(), plan.jobs, [&](std::size_t k) {
    Objective& objective = objectives[order[k]];
    objective.minimise(NLOPT_LN_SBPLX, objective.shares_of(best_of(objective).setting), plan.local_points);
  });
  std::vector<Point> points;
  for (const Objective& objective : objectives) {
    for (const auto& [setting, point] : objective.tried()) points.push_back(point);
  }
  std::sort(points.begin(), points.end(), better);
  refuse_failures(points);
  refuse_unsaid(evaluator.targets(), points);
  refuse_no_effect(points);
  refuse_all_alike(points);
  return points;
}

}  // namespace furrow::validation
