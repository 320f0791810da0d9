// Runs one fixed kernel and says what it took; under callgrind, with --toggle-collect=measured, only the kernel counts.
//
// usage: track_kernels beds DIRECTORY                   makes the scenes that kernels start from
//        track_kernels list                             one line a kernel
//        track_kernels run NAME DIRECTORY [REPETITIONS] one line of JSON; with 0 repetitions the kernel runs once and
//                                                       neither its time nor its error is said
// NAME may also be one of the paper's scenes, which are run as a whole.
// Exit codes: 0 good, 1 repetitions do not agree on the answer, 2 usage, 4 input or output.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "benchmarks/tracking/kernels.h"
#include "output/build_info.h"
#include "output/machine.h"
#include "scene/hash.h"

// For callgrind's --toggle-collect: a name as it stands, never inlined.
extern "C" [[gnu::noinline]] void measured(const std::function<void(long)>& work, long calls) { work(calls); }

namespace {

using furrow::hexadecimal;
using furrow::benchmarks::Kernel;
using furrow::benchmarks::Work;
using Json = nlohmann::ordered_json;

const Kernel& kernel_of(const std::string& name) {
  for (const auto* all : {&furrow::benchmarks::kernels(), &furrow::benchmarks::whole_scenes()}) {
    for (const Kernel& kernel : *all) {
      if (kernel.name == name) return kernel;
    }
  }
  throw std::invalid_argument("no kernel '" + name + "'; track_kernels list shows them");
}

int run(const Kernel& kernel, const std::string& beds, int repetitions) {
  Json json{{"kernel", kernel.name},
            {"calls", kernel.calls},
            {"cpu_seconds", Json::array()},
            {"real_seconds", Json::array()}};
  for (int k = 0; k < std::max(1, repetitions); ++k) {
    const Work work = kernel.make(beds);
    const double before = furrow::cpu_seconds(), wall = furrow::wall_seconds();
    measured(work.run, kernel.calls);
    if (repetitions > 0) {
      json["cpu_seconds"].push_back(furrow::cpu_seconds() - before);
      json["real_seconds"].push_back(furrow::wall_seconds() - wall);
    }
    const std::string answer = hexadecimal(work.answer());
    if (k > 0 && json["answer"] != answer) {
      std::fprintf(stderr, "track_kernels: %s has two answers, %s and %s\n", kernel.name.c_str(),
                   json["answer"].get<std::string>().c_str(), answer.c_str());
      return 1;
    }
    json["answer"] = answer;
    if (k == 0) json["error"] = repetitions > 0 && work.error ? Json(work.error()) : Json();
  }
  json["compiler"] = furrow::build_info().compiler;
  json["flags"] = furrow::build_info().flags;
  std::printf("%s\n", json.dump().c_str());
  return 0;
}

int usage() {
  std::fprintf(stderr, "usage: track_kernels beds DIRECTORY | list | run NAME DIRECTORY [REPETITIONS]\n");
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  try {
    if (words.size() == 2 && words[0] == "beds") return furrow::benchmarks::make_beds(words[1]), 0;
    if (words.size() == 1 && words[0] == "list") {
      for (const Kernel& k : furrow::benchmarks::kernels()) std::printf("%-20s %s\n", k.name.c_str(), k.what.c_str());
      return 0;
    }
    if (words.size() < 3 || words.size() > 4 || words[0] != "run") return usage();
    return run(kernel_of(words[1]), words[2], words.size() > 3 ? std::atoi(words[3].c_str()) : 5);
  } catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "track_kernels: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "track_kernels: %s\n", error.what());
    return 4;
  }
}
