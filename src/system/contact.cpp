#include "system/contact.h"

namespace furrow {

std::string contact_name(const Parts& parts, const ContactId& c) {
  if (c.a < 0) return {};
  const std::string own = of_disc(c.kind) ? parts.body_name(c.a) : parts.node_name(c.a);
  if (c.kind == disc_disc) return own + " and " + parts.body_name(c.b);
  const auto known_as = [&](const char* what, const std::string& name) {
    return own + " and " + what + " " + (name.empty() ? std::to_string(c.b) : name);
  };
  if (c.kind == disc_lattice) return known_as("lattice", parts.lattice[c.b].name);
  return of_wall(c.kind) ? known_as("wall", parts.wall[c.b].name) : known_as("plate", parts.plate[c.b].name);
}

double rolling_inertia(const Parts& parts, const ContactId& pair) {
  const auto about_contact = [&](int i) {
    return parts.disc.inertia[i] + parts.disc.mass[i] * parts.disc.radius[i] * parts.disc.radius[i];
  };
  if (!of_disc(pair.kind)) return 0;
  const double a = about_contact(pair.a);
  if (pair.kind != disc_disc) return a;
  const double b = about_contact(pair.b);
  return 1 / (1 / a + 1 / b);
}

}  // namespace furrow
