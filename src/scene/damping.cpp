// The ways to give the damping of contacts, and what the linear law needs.
#include <algorithm>
#include <utility>

#include "scene/findings.h"
#include "scene/wording.h"

namespace furrow {
namespace {

using Number = std::optional<double>;

void judge_one(const std::string& path, const auto& given, const Model& model, Findings& found) {
  const char* first = nullptr;
  for (const auto& [key, value] : {std::pair<const char*, Number>{"damping_factor", given.damping_factor},
                                   {"restitution", given.restitution},
                                   {"tsuji_alpha", given.tsuji_alpha},
                                   {"damping", given.damping}}) {
    if (value && first)
      found.error(path + '.' + key, std::string(first) + " is given too; give one of them", {path + '.' + first});
    if (value && !first) first = key;
  }
  if (given.tangential_damping && !given.damping)
    found.error(path + ".tangential_damping", "needs damping [N s/m]", {path + ".damping"});
  if (given.tsuji_alpha && model.law == ForceLaw::linear)
    found.error(path + ".tsuji_alpha", "is of Hertz's law; model.law is linear", {"model.law"});
}

// Every pair of materials needs its springs.
void judge_linear(const Scene& scene, Findings& found) {
  const ContactParameters& all = scene.contact;
  const auto missing = [&](const char* key, const Number& given, auto of_pair) {
    if (given) return;
    const auto has_own = [&](const ContactPair& p) { return (p.*of_pair).has_value(); };
    const std::size_t pairs = scene.material.size() * (scene.material.size() + 1) / 2;
    if (all.pair.size() == pairs && std::all_of(all.pair.begin(), all.pair.end(), has_own)) return;
    found.error("contact", std::string(key) + " [N/m] is required: model.law is linear", {"model.law", "contact.pair"});
  };
  const auto slides = [](const ContactPair& p) { return p.friction.value_or(0) > 0; };
  missing("normal_stiffness", all.normal_stiffness, &ContactPair::normal_stiffness);
  if (all.friction > 0 || std::any_of(all.pair.begin(), all.pair.end(), slides))
    missing("tangential_stiffness", all.tangential_stiffness, &ContactPair::tangential_stiffness);
}

}  // namespace

void judge_damping(const Scene& scene, Findings& found) {
  judge_one("contact", scene.contact, scene.model, found);
  for (std::size_t i = 0; i < scene.contact.pair.size(); ++i)
    judge_one(item("contact.pair", i), scene.contact.pair[i], scene.model, found);
  if (scene.model.law == ForceLaw::linear) judge_linear(scene, found);
}

}  // namespace furrow
