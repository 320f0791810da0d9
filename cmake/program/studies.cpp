#include "benchmarks/studies/studies.h"

#include "program_with_all.h"
#include "validation/studies/studies.h"
#include "verification/studies/studies.h"

namespace furrow {

const std::vector<Study>& catalogue() {
  static const std::vector<Study> all{
      {"order", "observed order of each method on each kind of force", verification::order},
      {"published", "every method on published problems that have nothing to do with contacts",
       verification::published},
      {"stability", "where methods fail: stable steps by theory, and the solver's own blow-up",
       verification::stability},
      {"work_precision", "error against evaluations and CPU time, every method on every scene",
       benchmarks::work_precision},
      {"need", "terms of the model that a scene could do without", benchmarks::need},
      {"geometry", "which lattice and plate come closest to the paper's first scene", validation::geometry},
      {"convergence", "which of the paper's numbers do not depend on the time step", validation::convergence},
      {"ensemble", "the paper's numbers over many packings of the bed", validation::ensemble},
      {"statements", "the paper, sentence by sentence; gaps and misprints tried both ways", validation::statements},
      {"outlook", "what the paper leaves to later: speed of the plate, size of the particles", validation::outlook},
      {"speed", "what scripts/rivals and scripts/track have measured, put together for the page", benchmarks::speed},
  };
  return all;
}

}  // namespace furrow
