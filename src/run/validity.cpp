#include "run/validity.h"

#include <algorithm>
#include <cmath>

#include "methods/method.h"
#include "run/energy_floor.h"
#include "run/stiffness.h"
#include "run/watch_rules.h"
#include "scene/wording.h"

namespace furrow {
namespace {
constexpr long most_between = 200, closely_every = 25;  // steps, from one look at the energy to the next
constexpr long early_until = 200;                       // steps
constexpr int few_bodies = 8;                           // of which each step is looked at; one more body, one step more
constexpr long borders_every = 50;                      // steps, at what crosses
constexpr double renew_beyond = 1.1;                    // times what was there when it was looked at last
constexpr double judge_beyond = 1.25;                   // times the rate that the step was judged by

std::string allowance(const std::string& method, const StiffPart& part, double limit) {
  Sentence text;
  text.precision(3);
  text << method << " allows " << limit << " s for " << part.name << ", " << part.contacts
       << " contacts, damping ratio " << part.oscillator.zeta
       << ", its neighbours held; half of that if they move against it";
  return text.str();
}
}  // namespace

struct Validity::Stiffest {
  StiffPart part{{0, 0}, {}};
  double time = 0;         // s
  double judged_rate = 0;  // 1/s
  EnergyFloor floor;
  double seen_at = -infinity;  // s, the last step of all
};

Validity::~Validity() { system_.watch(false); }

Validity::Validity(System& system, const Scene& scene, Warn warn)
    : system_(system), scene_(scene), warn_(std::move(warn)), border_(system), stiffest_(std::make_unique<Stiffest>()) {
  system_.watch(true);
  system_.survey() = {};
  system_.survey().fast = 0.9 * least_passing_speed(system.parts());
  for (const Rule& rule : rules) {
    Watched& w = watch_[static_cast<std::size_t>(rule.kind)];
    w.name = rule.name;
    w.warns_above = rule.warns_above;
    w.ends_above = rule.ends_above;
    w.allowed = allowed_by(scene, rule.kind);
  }
  for (const WatchKind kind : {WatchKind::energy_made, WatchKind::energy_lost})
    of(kind).watched = system.keeps_ledger();
  step_ = make_method(scene.time.method)->info().controlled ? scene.time.max_step : scene.time.step;
  const Parts& parts = system.parts();
  balance_every_ = std::clamp<long>(parts.bodies() - few_bodies + 1, 1, most_between);
  extremes_.plate.resize(parts.plate.size());
  for (const PlatePart& p : parts.plate) plate_speed_ = std::max(plate_speed_, std::hypot(p.vx, p.vy));
  for (const double spacing : parts.node.spacing) least_spacing_ = std::min(least_spacing_, spacing);
  stiffest_->floor.add(parts);
}

void Validity::history(HistoryVisitor& visit) {
  for (Watched& w : watch_) w.history(visit);
  extremes_.history(visit);
  visit("failure", failure_);
  visit("started", started_);
  visit("seen at", stiffest_->seen_at);
  start_.history(visit);
  visit("supplied", supplied_);
  visit("all supplied", all_supplied_);
  visit("most lost", most_lost_);
  visit("plate power", plate_power_);
  visit("since booked", since_booked_);
  visit("balanced steps", balanced_steps_);
  visit("since crossed", since_crossed_);
  visit("way since crossed", way_since_crossed_);
  visit("passed", passed_);
  visit("stepped overlap", stepped_overlap_);
  visit("stepped contacts", stepped_contacts_);
  idle_.history(visit);
  stiffest_->part.history(visit);
  visit("stiffest at", stiffest_->time);
  visit("judged rate", stiffest_->judged_rate);
  visit("arrival speed", arrival_speed_);
  visit("known overlap", system_.survey().known_overlap);
  visit("reach", system_.survey().reach);
}

template <class Where>
void Validity::look(WatchKind kind, double t, double value, const Where& where) {
  Watched& w = of(kind);
  if (value > w.warns_above) ++w.times;
  if (!(value > w.worst)) return;
  const Verdict before = w.verdict();
  w.worst = value;
  w.time = t;
  w.where = where();
  if (w.verdict() != before) say(kind, w.verdict());
}

void Validity::say(WatchKind kind, Verdict verdict) {
  if (verdict < Verdict::warned || !failure_.empty()) return;
  const Watched& w = of(kind);
  Sentence text;
  text.precision(3);
  const Rule& rule = rules[static_cast<std::size_t>(kind)];
  text << "at t = " << w.time << " s " << rule.before << w.worst << rule.after;
  if (!w.where.empty()) text << " (" << w.where << ")";
  if (verdict == Verdict::warned) return warn_(text.str());
  text << ". Beyond that the run says nothing of the scene; " << what_helps(kind, scene_)
       << ", or let it go on by [allow] " << w.name;
  failure_ = text.str();
}

// A step begins when the last one ended, to the last digit: what moves by the time, a plate or driven nodes, would else pass
// between the two.
void Validity::see(const Step& given, const JumpReport& report) {
  const bool goes_on = given.h > 0 && std::fabs(given.t - given.h - stiffest_->seen_at) < 1e-6 * given.h;
  const Step step{given.t, goes_on ? given.t - stiffest_->seen_at : given.h, given.before, given.after, given.motion};
  stiffest_->seen_at = given.t;
  state_ = &given.after;
  const Survey& survey = *report.survey;
  look_at_speed(step);
  look_at_plates(step.t, survey);
  look_at_contacts(step.t, survey);
  if (step.h > 0) look_for_crossings(step, report);
  look_at_borders(step);
  look_at_step(step, survey);
  look_at_arrival(step.t);
  look_at_energy(step);
  started_ = true;
}

bool Validity::is_early() const { return balanced_steps_ < early_until; }

void Validity::look_at_energy(const Step& step) {
  if (!system_.keeps_ledger()) return;
  if (!started_) return book(step.t, observe(system_, step.t, step.after));
  ++since_booked_;
  ++balanced_steps_;
  const bool warned =
      std::max(of(WatchKind::energy_made).verdict(), of(WatchKind::energy_lost).verdict()) >= Verdict::warned;
  const bool early = is_early();
  if (since_booked_ < (early || warned ? std::min(closely_every, balance_every_) : balance_every_)) return;
  since_booked_ = 0;
  judge_energy(step.t, observe(system_, step.t, step.after), early);
}

void Validity::look_at_speed(const Step& step) {
  const auto [moved_squared, speed_squared] = step.motion;
  const double squared = std::max(speed_squared, stiffest_->floor.drive_speed * stiffest_->floor.drive_speed);
  system_.survey().reach = 4 * std::sqrt(std::max(moved_squared, squared * step_ * step_));
  if (!(speed_squared > extremes_.speed * extremes_.speed)) return;
  extremes_.speed = std::sqrt(speed_squared);
  extremes_.speed_time = step.t;
}

void Validity::look_at_plates(double t, const Survey& survey) {
  plate_power_ = 0;
  for (std::size_t k = 0; k < extremes_.plate.size(); ++k) {
    const double fx = survey.plate_fx[k], fy = survey.plate_fy[k];
    const PlatePart& p = system_.parts().plate[k];
    plate_power_ += std::fabs(fx * p.vx + fy * p.vy);
    RunExtremes::PlateForce& greatest = extremes_.plate[k];
    if (fx * fx + fy * fy > greatest.force * greatest.force) greatest = {std::hypot(fx, fy), fx, fy, t};
  }
}

void Validity::look_at_contacts(double t, const Survey& survey) {
  const ContactExtremes& seen = survey.seen;
  look(WatchKind::overlap, t, seen.overlap, [&] { return contact_name(system_.parts(), seen.deepest); });
  system_.survey().known_overlap = of(WatchKind::overlap).worst;
  look(WatchKind::behind_walls, t, seen.behind_walls, [] { return std::string(); });
  look(WatchKind::impact, t, seen.impact, [&] { return contact_name(system_.parts(), seen.hardest); });
}

void Validity::look_for_crossings(const Step& step, const JumpReport& report) {
  const auto crossed = [&](WatchKind kind, const ContactId& contact) {
    look(kind, step.t, of(kind).worst + 1, [&] { return contact_name(system_.parts(), contact); });
  };
  for (const ContactId& near : report.survey->near)
    if (crosses_plate(system_, step, near)) crossed(WatchKind::through_plates, near);
  for (const ContactId& disc : border_.crossings(step, !report.torn.empty()))
    crossed(WatchKind::through_lattices, disc);
  for (const ContactId& disc : border_.through_torn())
    look(WatchKind::crossing_lattices, step.t, ++passed_, [&] { return through_torn_border(system_, disc); });
}

void Validity::look_at_borders(const Step& step) {
  if (system_.parts().lattice.empty()) return;
  const double way = std::sqrt(step.motion.moved_squared) + stiffest_->floor.drive_speed * step.h;
  const CrossingBorders now = step.h > 0 ? passed_borders(system_, step, way > least_spacing_ / 4) : CrossingBorders();
  if (now.pairs > 0) {
    passed_ += now.pairs;
    look(WatchKind::crossing_lattices, step.t, passed_, [&] { return now.where; });
  }
  way_since_crossed_ += way + plate_speed_ * step.h;
  if (started_ && ++since_crossed_ < borders_every && !(way_since_crossed_ > least_crossing_ / 4)) return;
  since_crossed_ = 0;
  way_since_crossed_ = 0;
  const CrossingBorders found = standing_crossings(system_, step.t, step.after);
  look(WatchKind::crossing_lattices, step.t, found.pairs, [&] { return found.where; });
}

void Validity::look_at_step(const Step& step, const Survey& survey) {
  const bool deeper = survey.seen.overlap > renew_beyond * stepped_overlap_;
  const bool more = survey.seen.contacts > renew_beyond * stepped_contacts_;
  if (started_ && !deeper && !more) return;
  stepped_overlap_ = std::max(stepped_overlap_, survey.seen.overlap);
  stepped_contacts_ = std::max(stepped_contacts_, survey.seen.contacts);
  const StiffPart part = stiffest_part(system_, step.t, step.after);
  if (part.name.empty() || !(fastest_rate(part.oscillator) > fastest_rate(stiffest_->part.oscillator))) return;
  stiffest_->part = part;
  stiffest_->time = step.t;
  if (fastest_rate(part.oscillator) > judge_beyond * stiffest_->judged_rate) judge_step();
}

void Validity::judge_step() {
  const StiffPart& part = stiffest_->part;
  stiffest_->judged_rate = fastest_rate(part.oscillator);
  const double limit = largest_stable_step(scene_.time.method, part.oscillator);
  look(WatchKind::step, stiffest_->time, step_ / limit, [&] { return allowance(scene_.time.method, part, limit); });
}

void Validity::conclude() {
  if (fastest_rate(stiffest_->part.oscillator) > stiffest_->judged_rate) judge_step();
}

void Validity::look_at_arrival(double t) {
  const double speed = extremes_.speed + std::max(plate_speed_, stiffest_->floor.drive_speed);
  if (!(speed > renew_beyond * arrival_speed_)) return;
  arrival_speed_ = speed;
  Sentence where;
  where.precision(3);
  where << "at " << speed << " m/s";
  const Oscillator impact = stiffest_impact(system_.parts(), speed);
  if (impact.omega == 0) return;
  const double limit = largest_stable_step(scene_.time.method, impact);
  look(WatchKind::arrival, t, step_ / limit, [&] { return where.str(); });
}

void Validity::book(double t, const Observation& seen) {
  since_booked_ = 0;
  judge_energy(t, seen, false);
}

void Validity::judge_row(double t, const Observation& seen) {
  if (!system_.keeps_ledger()) return;
  since_booked_ = 0;
  judge_energy(t, seen, is_early());
}

void Validity::judge_energy(double t, const Observation& seen, bool early) {
  const Energies& e = seen.energy;
  if (!started_) start_ = e, idle_.begin(system_, state_);
  const IdleDiscs::Sum idle = idle_.sum(system_, t, state_);
  const double given = e.supplied(start_) + plate_power_ * step_;
  all_supplied_ = std::max(all_supplied_, given);
  supplied_ = std::max(supplied_, given - idle.kinetic);
  most_lost_ = started_ ? std::max(most_lost_, e.lost()) : e.lost();
  const double residual = e.residual(start_) - idle.left_over, taken_back = most_lost_ - e.lost();
  const double by_law = e.live() - idle.kinetic - supplied_;
  const double nothing = stiffest_->floor.of(e, t, extremes_.speed + plate_speed_);
  if (!(supplied_ > 0)) return;
  const double rough = early ? 2 * (all_supplied_ - start_.live()) / static_cast<double>(balanced_steps_) : 0;
  const auto judge = [&](WatchKind kind, double energy, const char* where) {
    const double share = (energy - rough) / supplied_;
    if (energy > nothing && (!early || share > of(kind).ends_above)) look(kind, t, share, [&] { return where; });
  };
  const double by_method = std::max(residual, 0.0) + taken_back;
  judge(WatchKind::energy_made, std::max(by_method, by_law),
        by_law > by_method      ? "there is more than was given"
        : taken_back > residual ? "heat was taken back"
                                : "");
  judge(WatchKind::energy_lost, -residual, "");
}
}  // namespace furrow
