#include "benchmarks/tracking/comparison.h"

#include <algorithm>
#include <cstdio>
#include <thread>

#include "benchmarks/measuring/made_by.h"
#include "benchmarks/measuring/samples.h"
#include "output/machine.h"

namespace furrow::benchmarks {
namespace {

using benchmarks::Interval;

constexpr int repetitions = 5;  // in one process; their least is the sample: noise only ever adds

struct Samples {
  std::vector<double> now, base, again, real;  // s, round by round; real: what a clock on the wall says of `now`
  Json said_now, said_base;
};

double least(const Json& said, const char* clock = "cpu_seconds") {
  const auto all = said.at(clock).get<std::vector<double>>();
  return *std::min_element(all.begin(), all.end());
}

Samples sample(const Build& build, const Build& base, const std::string& kernel, int rounds) {
  Samples s;
  for (int round = 0; round < rounds; ++round) {
    s.said_base = timed(base, kernel, repetitions);
    s.base.push_back(least(s.said_base));
    s.said_now = timed(build, kernel, repetitions);
    s.now.push_back(least(s.said_now));
    s.real.push_back(least(s.said_now, "real_seconds"));
    s.again.push_back(least(timed(base, kernel, repetitions)));
  }
  return s;
}

Json rounded(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(benchmarks::rounded(value));
  return list;
}

// As Google Benchmark writes it, with more keys: times are of one call, instructions and samples of all calls.
Json result_of(const std::string& name, const Samples& s, const Json& now, const Json& base) {
  const double calls = now.at("calls");
  const auto a_call = [&](const std::vector<double>& all) {
    return benchmarks::rounded(1e9 * benchmarks::median_interval(all).middle / calls);
  };
  Json json{{"name", name + "_median"},
            {"run_name", name},
            {"run_type", "aggregate"},
            {"repetitions", s.now.size()},
            {"threads", 1},
            {"aggregate_name", "median"},
            {"aggregate_unit", "time"},
            {"iterations", calls},
            {"real_time", a_call(s.real)},
            {"cpu_time", a_call(s.now)},
            {"time_unit", "ns"},
            {"cpu_seconds", rounded(s.now)},
            {"base_cpu_seconds", rounded(s.base)},
            {"instructions", now.at("instructions")},
            {"base_instructions", base.at("instructions")},
            {"answer", now.at("answer")},
            {"error", s.said_now.at("error")}};
  if (!now.at("answer").is_string() || now["answer"] != base.at("answer")) {
    json["verdict"] = "another answer";
    return json;
  }
  const Interval ratio = benchmarks::median_interval(benchmarks::ratios(s.now, s.base));
  const double noise = benchmarks::noise_floor(benchmarks::median_interval(benchmarks::ratios(s.again, s.base)));
  json["ratio"] = rounded({ratio.low, ratio.middle, ratio.high});
  json["noise"] = benchmarks::rounded(noise);
  json["verdict"] = benchmarks::verdict(ratio, noise);
  return json;
}

void show(const std::string& name, const Json& result) {
  std::fprintf(stderr, "%-20s ", name.c_str());
  if (result.contains("ratio")) {
    const auto ratio = result["ratio"].get<std::vector<double>>();
    std::fprintf(stderr, "%6.3f [%5.3f, %5.3f]  noise %5.1f %%  ", ratio[1], ratio[0], ratio[2],
                 100 * result["noise"].get<double>());
  } else {
    std::fprintf(stderr, "%39s", "");
  }
  const double change = result["instructions"].get<double>() / result["base_instructions"].get<double>() - 1;
  std::fprintf(stderr, "instructions %+7.2f %%  %s\n", 100 * change, result["verdict"].get<std::string>().c_str());
}

}  // namespace

int compare(const Build& build, const Build& base, int rounds) {
  make_beds(build);
  const Json now = counted(build), before = counted(base);
  Json line{{"context",
             {{"made_by", made_by()},
              {"machine", processor_name()},
              {"num_cpus", std::thread::hardware_concurrency()},
              {"compiler", now.front().at("compiler")},
              {"flags", now.front().at("flags")}}},
            {"benchmarks", Json::array()}};
  std::fprintf(stderr, "CPU time, new over base: median and its 95 %% interval over %d rounds\n", rounds);
  bool same_answers = !kernel_names(build).empty();
  for (const std::string& name : kernel_names(build)) {
    const Json result = result_of(name, sample(build, base, name, rounds), now.at(name), before.at(name));
    same_answers = same_answers && result.contains("ratio");
    show(name, result);
    line["benchmarks"].push_back(result);
  }
  std::printf("%s\n", line.dump().c_str());
  return same_answers ? 0 : 1;
}

}  // namespace furrow::benchmarks
