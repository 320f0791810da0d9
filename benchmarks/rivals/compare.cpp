// furrow and other programs on the same scene, in turn. First whether they agree: the push on the plate at two steps
// before the bed is chaotic (early.h), then height of the bed at rest and mean push. Then the CPU time of a step: that of the whole process for all steps, less that for one step.
//
// usage: compare DECKS WORK FURROW RESULT ROUNDS    called by scripts/rivals; RESULT: in Google Benchmark's form
// Exit codes: 0 good; 1 furrow itself failed, or does not agree with its own runs; 4 input or output. A rival that
// fails or does not agree is a result.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "benchmarks/measuring/made_by.h"
#include "benchmarks/measuring/samples.h"
#include "benchmarks/rivals/early.h"
#include "benchmarks/rivals/rivals.h"
#include "output/build_info.h"
#include "output/files.h"
#include "output/machine.h"
#include "run/observe.h"

namespace {

namespace fs = std::filesystem;
using furrow::benchmarks::agrees_early;
using furrow::benchmarks::Bed;
using furrow::benchmarks::early_agreement;
using furrow::benchmarks::Interval;
using furrow::benchmarks::Rival;
using furrow::benchmarks::rounded;
using furrow::benchmarks::rows_of;
using furrow::benchmarks::Task;
using Json = nlohmann::ordered_json;

constexpr double plate_speed = 0.1;                      // m/s
constexpr long rest_steps = 5'000, push_steps = 30'000;  // the mean is over the last 28,000 of the latter
constexpr long first_pushed = 2'000;
constexpr int perturbed_runs = 8;

struct Seen {
  double height = 0, push = 0;  // m, N
};

double height_of(const Bed& bed, const std::vector<std::vector<double>>& rows) {
  const furrow::System& system = bed.prepared.system;
  if (static_cast<int>(rows.size()) != system.parts().disc.count()) throw std::runtime_error("not all discs are there");
  furrow::State y = bed.prepared.y;
  for (int i = 0; i < system.parts().disc.count(); ++i) {
    y[system.x_of(i)] = rows[i][1];
    y[system.y_of(i)] = rows[i][2];
  }
  return furrow::surface_height(system, y);
}

double push_of(const std::vector<std::vector<double>>& rows, double steps_per_unit, std::size_t column) {
  double sum = 0;
  int count = 0;
  for (const std::vector<double>& row : rows) {
    if (row[0] * steps_per_unit < first_pushed) continue;
    sum += row[column];
    ++count;
  }
  // One in a hundred steps at the least, and up to the end: what is missing would count as what the rest is.
  if (count < (push_steps - first_pushed) / 100 || rows.back()[0] * steps_per_unit < 0.99 * push_steps)
    throw std::runtime_error("forces are missing");
  return std::fabs(sum / count);
}

fs::path cleared(const fs::path& directory) {
  fs::remove_all(directory);
  fs::create_directories(directory);
  return directory;
}

Seen look(const Bed& bed, const Rival& rival) {
  const fs::path place = bed.directory / "look";
  const auto run = [&](double speed, long steps) {
    const Task task{speed, steps, true, cleared(place)};
    furrow::run_measured_well(rival.command(bed, task));
  };
  run(0, rest_steps);
  const bool own = rival.package.empty();
  Seen seen;
  seen.height = height_of(bed, own ? rows_of(place / "run/state.csv", 8) : rows_of(place / "end.txt", 3));
  run(plate_speed, push_steps);
  const double per_second = 1 / bed.prepared.scene.time.step;
  seen.push = own ? push_of(rows_of(place / "run/plate_force.csv", 5), per_second, 2)
                  : push_of(rows_of(place / "force.txt", 2), 1, 1);
  return seen;
}

// How far one and the same program differs from itself when its discs start 1e-9 m elsewhere: the scene is chaotic.
std::vector<double> pushes_from_nearby(const Bed& bed, const Rival& own) {
  std::vector<double> pushes;
  std::mt19937_64 random(1);
  const auto shift = [&] { return 1e-9 * (static_cast<double>(random() >> 11) * 0x1p-52 - 1); };  // m
  Bed nearby = bed;
  nearby.directory = bed.directory / "nearby";
  fs::create_directories(nearby.directory);
  for (int k = 0; k < perturbed_runs; ++k) {
    furrow::Scene scene = bed.prepared.scene;
    for (furrow::Disc& d : scene.disc) d.position = {d.position.x + shift(), d.position.y + shift()};
    furrow::benchmarks::write_scene(nearby, scene);
    pushes.push_back(look(nearby, own).push);
  }
  return pushes;
}

struct Band {
  double height, height_tolerance, push, push_tolerance;
  bool holds(const Seen& seen) const {
    return std::fabs(seen.height - height) <= height_tolerance && std::fabs(seen.push - push) <= push_tolerance;
  }
};

// Push: four standard deviations of furrow's own runs. Height: a twentieth of a radius; a wrong mass, gravity or
// stiffness moves it by more (half the stiffness: 4 % of the overlap times the number of layers).
Band band_of(const Bed& bed, const Seen& own, const std::vector<double>& pushes) {
  double mean = 0, square = 0;
  for (const double p : pushes) mean += p / static_cast<double>(pushes.size());
  for (const double p : pushes) square += (p - mean) * (p - mean) / static_cast<double>(pushes.size() - 1);
  return {own.height, 0.05 * bed.prepared.scene.disc[0].radius, mean, 4 * std::sqrt(square)};
}

struct Times {
  std::vector<double> cpu, real;  // s a step, by round
};

// What a process needs to start is measured separately and subtracted.
void time_step(const Bed& bed, const Rival& rival, Times& times) {
  const auto ran = [&](long steps) {
    const Task task{plate_speed, steps, false, cleared(bed.directory / "timed")};
    return furrow::run_measured_well(rival.command(bed, task));
  };
  const auto all = ran(rival.steps), one = ran(1);
  const auto steps = static_cast<double>(rival.steps - 1);
  times.cpu.push_back((all.cpu_seconds - one.cpu_seconds) / steps);
  times.real.push_back((all.real_seconds - one.real_seconds) / steps);
}

// Contacts that touch, the mean over the run: what all programs evaluate, if they agree.
double mean_contacts(const Bed& bed, const Rival& own) {
  const fs::path place = cleared(bed.directory / "look");
  furrow::run_measured_well(own.command(bed, {plate_speed, own.steps, true, place}));
  double sum = 0;
  const auto rows = rows_of(place / "run/motion.csv", 8);
  for (const auto& row : rows) sum += row[4];
  return sum / static_cast<double>(rows.size());
}

struct Entry {
  Rival rival;
  Json json;  // what all of its reports say
  Times times{};
  bool failed = false;
};

Entry looked_at(const Bed& bed, const Rival& rival, const Band& band) {
  Entry entry{rival, {{"name", rival.name}, {"run_name", rival.name}}};
  entry.json["label"] = rival.law;
  entry.json["version"] = furrow::benchmarks::version_of(rival.package);
  entry.json["build"] = furrow::benchmarks::build_of(rival.package);
  entry.json["evaluations"] = rival.evaluations;
  try {
    entry.json["early"] = early_agreement(bed, rival);
    const Seen seen = look(bed, rival);
    entry.json["height"] = rounded(seen.height);
    entry.json["push"] = rounded(seen.push);
    entry.json["agrees_early"] = agrees_early(entry.json["early"]);
    entry.json["agrees"] = entry.json["agrees_early"] && band.holds(seen);
  } catch (const std::exception& failure) {
    entry.json["error_occurred"] = true;
    entry.json["error_message"] = failure.what();
    entry.failed = true;
  }
  std::fprintf(stderr, "%s\n", entry.json.dump().c_str());
  return entry;
}

Json rounded_list(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(rounded(value));
  return list;
}

// Each round, then the median with what the program is and whether it agrees.
void conclude(Entry& entry, const std::vector<double>& own, double contacts, Json& benchmarks) {
  Json& json = entry.json;
  const std::size_t rounds = entry.times.cpu.size();
  json["repetitions"] = rounds;
  json["threads"] = 1;
  if (entry.failed) {
    json["run_type"] = "iteration";
    benchmarks.push_back(json);
    return;
  }
  const auto report = [&](const Json& base, double cpu, double real) {
    Json one = base;
    one["real_time"] = rounded(1e6 * real);
    one["cpu_time"] = rounded(1e6 * cpu);
    one["time_unit"] = "us";
    one["s/contact"] = rounded(cpu / contacts / entry.rival.evaluations);
    benchmarks.push_back(one);
  };
  for (std::size_t k = 0; k < rounds; ++k) {
    const Json round{{"name", entry.rival.name},
                     {"run_name", entry.rival.name},
                     {"run_type", "iteration"},
                     {"repetitions", rounds},
                     {"repetition_index", k},
                     {"threads", 1},
                     {"iterations", entry.rival.steps - 1}};
    report(round, entry.times.cpu[k], entry.times.real[k]);
  }
  const Interval time = furrow::benchmarks::median_interval(entry.times.cpu);
  const Interval ratio = furrow::benchmarks::median_interval(furrow::benchmarks::ratios(entry.times.cpu, own));
  json["name"] = entry.rival.name + "_median";
  json["run_type"] = "aggregate";
  json["aggregate_name"] = "median";
  json["aggregate_unit"] = "time";
  json["iterations"] = rounds;
  json["ratio"] = rounded_list({ratio.low, ratio.middle, ratio.high});
  report(json, time.middle, furrow::benchmarks::median_interval(entry.times.real).middle);
  const Json& smooth = json["early"][0];
  std::printf(
      "%-28s push before chaos, mu = 0: off by %.2g, %.2g of its greatest at steps of 1e-4, 1e-5 s, order %.2f\n",
      entry.rival.name.c_str(), smooth["errors"][0].get<double>(), smooth["errors"][1].get<double>(),
      smooth["order"].get<double>());
  std::printf("%-28s the same with friction: off by %.2g at 1e-5 s: %s\n", "",
              json["early"][1]["errors"][1].get<double>(), entry.rival.law.c_str());
  std::printf("%-28s %8.2f us a step   %6.2f [%5.2f, %5.2f]   height %.4f m, push %6.1f N%s\n",
              entry.rival.name.c_str(), 1e6 * time.middle, ratio.middle, ratio.low, ratio.high,
              json["height"].get<double>(), json["push"].get<double>(),
              json["agrees"]         ? ""
              : json["agrees_early"] ? "   does not agree: not ranked"
                                     : "   does not agree before chaos: not ranked");
}

int compare(const fs::path& decks, const fs::path& work, const fs::path& program, const fs::path& result, int rounds) {
  const Bed bed = furrow::benchmarks::make_bed(decks, cleared(work), program);
  const std::vector<Rival> all = furrow::benchmarks::rivals();
  const Seen own = look(bed, all[0]);
  const std::vector<double> pushes = pushes_from_nearby(bed, all[0]);
  const Band band = band_of(bed, own, pushes);
  const double contacts = mean_contacts(bed, all[0]);
  std::vector<Entry> entries;
  for (const Rival& rival : all) entries.push_back(looked_at(bed, rival, band));
  for (int round = 0; round < rounds; ++round) {
    std::fprintf(stderr, "round %d of %d\n", round + 1, rounds);
    for (Entry& entry : entries) {
      if (!entry.failed) time_step(bed, entry.rival, entry.times);
    }
  }
  Json json{{"context",
             {{"made_by", furrow::benchmarks::made_by()},
              {"machine", furrow::processor_name()},
              {"compiler", furrow::build_info().compiler},
              {"flags", furrow::build_info().flags},
              {"contacts", rounded(contacts)},
              {"discs", bed.prepared.system.parts().disc.count()},
              {"rest_height", rounded(band.height)},
              {"height_tolerance", band.height_tolerance},
              {"push", rounded(band.push)},
              {"push_tolerance", rounded(band.push_tolerance)},
              {"own_pushes", rounded_list(pushes)}}},
            {"benchmarks", Json::array()}};
  std::printf("CPU time a step, and over that of %s: median and its interval over %d rounds\n", all[0].name.c_str(),
              rounds);
  for (Entry& entry : entries) {
    conclude(entry, entries[0].times.cpu, contacts, json["benchmarks"]);
  }
  std::printf("To agree: push before chaos, mu = 0, of order %.2g at least and off by less than %.0e at 1e-5 s\n",
              furrow::benchmarks::least_early_order, furrow::benchmarks::most_early_error);
  std::printf("and height %.4f +- %.4f m, push %.1f +- %.1f N\n", band.height, band.height_tolerance, band.push,
              band.push_tolerance);
  furrow::OutputFile file = furrow::OutputFile::replacing(result);
  file << json.dump(1) << "\n";
  file.finish();
  const auto own_fails = [](const Entry& one) { return one.failed || !one.json.at("agrees").get<bool>(); };
  return own_fails(entries[0]) || own_fails(entries[1]) ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() != 5) {
    std::fprintf(stderr, "usage: compare DECKS WORK FURROW RESULT ROUNDS\n");
    return 2;
  }
  try {
    return compare(words[0], words[1], words[2], words[3], std::stoi(words[4]));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "compare: %s\n", error.what());
    return 4;
  }
}
