#include "system/contact.h"

namespace furrow {

std::string contact_name(const Parts& parts, const ContactId& c) {
  if (c.a < 0) return {};
  const std::string own = of_disc(c.kind) ? parts.body_name(c.a) : parts.node_name(c.a);
  if (c.kind == disc_disc) return own + " and " + parts.body_name(c.b);
  if (c.kind == disc_lattice)
    return own + " and lattice " + (parts.lattice[c.b].name.empty() ? std::to_string(c.b) : parts.lattice[c.b].name);
  return own + (of_wall(c.kind) ? " and wall " : " and plate ") + std::to_string(c.b);
}

}  // namespace furrow
