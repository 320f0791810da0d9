#include "benchmarks/studies/work_precision.h"

#include <algorithm>
#include <complex>
#include <map>
#include <mutex>
#include <optional>

#include "benchmarks/studies/reference.h"
#include "report/linearise.h"

namespace furrow::benchmarks {
namespace {

// The cases and their references, each made once, when it is first needed.
class Scenes {
 public:
  explicit Scenes(const std::vector<CaseInfo>& wanted) {
    for (const CaseInfo& info : wanted) made_.try_emplace(info.name, info);
  }
  const Case& of(const CaseInfo& info) { return made_.at(info.name).scene.get(); }
  const Reference& reference_of(const CaseInfo& info) {
    Made& made = made_.at(info.name);
    const std::scoped_lock lock(made.mutex);
    if (!made.reference) made.reference = make_reference(info, made.scene.get());
    return *made.reference;
  }

 private:
  struct Made {
    explicit Made(const CaseInfo& info) : scene(info) {}
    LazyCase scene;
    std::mutex mutex;
    std::optional<Reference> reference;
  };
  std::map<std::string, Made> made_;
};

Json json_of(const Reference& reference) {
  return {{"other", reference.other},
          {"place", reference.disagreement.place},
          {"force", reference.disagreement.force},
          {"torn", reference.outcome.torn}};
}

double fastest_decay(const Case& scene) {
  double fastest = 0;  // 1/s
  for (const std::complex<double> value : spectrum(linearise(scene.system, scene.span.start, scene.y)))
    fastest = std::max(fastest, -value.real());
  return fastest;
}

}  // namespace

std::vector<CaseInfo> work_precision_cases(bool quick) {
  std::vector<CaseInfo> wanted = cases();
  if (!quick) return wanted;
  std::erase_if(wanted, [](const CaseInfo& info) { return info.big; });
  for (CaseInfo& info : wanted) info.finest = std::min(8 * info.finest, paper_step);
  return wanted;
}

std::vector<Variant> variants_on(const CaseInfo& info) {
  std::vector<Variant> all;
  for (const MethodInfo& method : method_catalogue()) {
    for (const Locate locate : info.locate) {
      if (locate == Locate::none || method.family == "own") all.push_back({method, locate});
    }
  }
  return all;
}

std::string reference_key(const CaseInfo& info) { return info.name + " references"; }
std::string nudged_key(const CaseInfo& info) { return info.name + " nudged"; }
std::string spectrum_key(const CaseInfo& info) { return info.name + " spectrum"; }
std::string curve_key(const CaseInfo& info, const Variant& variant) {
  return info.name + " " + WorkPrecisionCurve{.method = variant.method.name, .locate = variant.locate}.name();
}

// The curves behind all else: two runs at a time would disturb each other's caches.
void measure_work_precision(Measurement& measurement) {
  const std::vector<CaseInfo> wanted = work_precision_cases(measurement.quick());
  Scenes scenes(wanted);
  std::vector<Task> numbers, times;
  for (const CaseInfo& info : wanted) {
    const std::string input = hash_of_scene(info.scene());
    numbers.push_back({reference_key(info), [&scenes, info] { return json_of(scenes.reference_of(info)); }, input});
    numbers.push_back({nudged_key(info), [&scenes, info] { return predictability(info, scenes.of(info)); }, input});
    numbers.push_back({spectrum_key(info), [&scenes, info] { return Json(fastest_decay(scenes.of(info))); }, input});
    for (const Variant& variant : variants_on(info))
      times.push_back({curve_key(info, variant),
                       [&scenes, info, variant] {
                         return json_of(measure_curve(variant, info, scenes.of(info), scenes.reference_of(info)));
                       },
                       input, true});
  }
  measurement.run(numbers);
  measurement.run(times);
}

}  // namespace furrow::benchmarks
