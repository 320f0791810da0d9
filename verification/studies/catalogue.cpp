#include "studies/catalogue.h"

namespace furrow::studies {

const std::vector<Study>& catalogue() {
  static const std::vector<Study> all{
      {"order", "observed order of each method on each kind of force", order},
      {"stability", "where methods fail: stable steps by theory, and the solver's own blow-up", stability},
      {"work_precision", "error against evaluations and CPU time, every method on every scene", work_precision},
      {"need", "terms of the model that a scene could do without", need},
      {"geometry", "which lattice and plate come closest to the paper's first scene", geometry},
      {"convergence", "which of the paper's numbers do not depend on the time step", convergence},
      {"ensemble", "the paper's numbers over many packings of the bed", ensemble},
      {"statements", "the paper, sentence by sentence; gaps and misprints tried both ways", statements},
      {"outlook", "what the paper leaves to later: speed of the plate, size of the particles", outlook},
      {"speed", "what scripts/rivals and scripts/track have measured, put together for the page", speed},
  };
  return all;
}

}  // namespace furrow::studies
