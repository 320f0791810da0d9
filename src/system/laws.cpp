// The law of each pair of materials, from what a scene says of contacts.
#include "physics/damping.h"
#include "physics/linear.h"
#include "system/parts.h"

namespace furrow {
namespace {

Elastic elastic_of(const Material& m) {
  if (m.rigid) return {.rigid = true};
  return {.young = *m.young, .poisson = m.poisson ? *m.poisson : *m.young / (2 * *m.shear) - 1};
}

const ContactPair* pair_of(const ContactParameters& contact, const std::string& a, const std::string& b) {
  for (const ContactPair& p : contact.pair) {
    if ((p.materials[0] == a && p.materials[1] == b) || (p.materials[0] == b && p.materials[1] == a)) return &p;
  }
  return nullptr;
}

struct Damping {
  double beta = 0, normal = 0, tangential = 0;  // -, N s/m
};

// The one that is given, or the other one.
Damping damping_of(const auto& given, const Damping& otherwise) {
  if (given.damping) return {0, *given.damping, given.tangential_damping.value_or(*given.damping)};
  if (given.damping_factor) return {*given.damping_factor};
  if (given.restitution) return {damping_factor(*given.restitution)};
  return given.tsuji_alpha ? Damping{damping_factor_of_tsuji(*given.tsuji_alpha)} : otherwise;
}

// What the scene says for all, with what the pair says for itself.
ContactParameters merged(const ContactParameters& all, const ContactPair* pair) {
  ContactParameters c = all;
  if (!pair) return c;
  const auto take = [](auto& to, const auto& from) {
    if (from) to = *from;
  };
  take(c.friction, pair->friction);
  take(c.rolling_friction, pair->rolling_friction);
  take(c.normal_stiffness, pair->normal_stiffness);
  take(c.tangential_stiffness, pair->tangential_stiffness);
  take(c.rolling_stiffness, pair->rolling_stiffness);
  take(c.rolling_damping, pair->rolling_damping);
  return c;
}

void set_options(const Model& model, const ContactParameters& c, const Damping& damping, ContactLaw& law) {
  ContactOptions& o = law.options;
  o.force = model.law;
  o.dashpot = damping.normal;
  o.tangential_dashpot = model.slip_damping ? damping.tangential : 0;
  if (law.friction > 0) o.after_slip = model.after_slip;
  o.rolling_spring = model.rolling == Rolling::spring && law.rolling > 0;
  if (o.rolling_spring) {
    o.rolling_stiffness = c.rolling_stiffness.value_or(0);
    o.rolling_damping = c.rolling_damping.value_or(default_rolling_damping);
  }
  if (model.law == ForceLaw::linear)
    make_linear(law, c.normal_stiffness.value_or(0), c.tangential_stiffness.value_or(0), damping.beta);
  if (!model.slip_damping) law.shear_ratio = 0;
}

}  // namespace

std::vector<ContactLaw> laws_of(const Scene& scene) {
  std::vector<ContactLaw> laws;
  const Damping damping = damping_of(scene.contact, {});
  for (const Material& a : scene.material) {
    for (const Material& b : scene.material) {
      const ContactPair* pair = pair_of(scene.contact, a.name, b.name);
      const ContactParameters c = merged(scene.contact, pair);
      const Damping own = pair ? damping_of(*pair, damping) : damping;
      const double rolling = scene.model.rolling == Rolling::none ? 0 : c.rolling_friction;
      laws.push_back(contact_law(elastic_of(a), elastic_of(b), own.beta, c.friction, rolling));
      if (scene.model.pull) let_pull(laws.back());
      set_options(scene.model, c, own, laws.back());
    }
  }
  return laws;
}

}  // namespace furrow
