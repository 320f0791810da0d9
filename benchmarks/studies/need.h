// No more than a scene needs: one term of the model switched off at a time, and what that does to what is observed.
#pragma once

#include <array>

#include "benchmarks/studies/need_terms.h"
#include "report/measurement.h"

namespace furrow::benchmarks {

enum Observable { largest, mean, curve, work, torn, place };
constexpr std::array<const char*, 6> observables{"largest force",     "mean force", "force curve",
                                                 "work of the plate", "links torn", "final positions"};

// Of {"values": by observable, of `curve` and `place` the units: root mean squares}.
std::string whole_key(const Subject& subject, int packing);

// Of {"effects": by observable, "same": whether force and positions are those of the whole model to the bit}. An effect
// is a fraction of the whole model's, of links torn the number; null where there is nothing to compare.
std::string without_key(const Subject& subject, const Term& term, int packing);

// Of {"ratios": the CPU time of the run without the term over that of the whole model's, pair by pair}.
std::string cost_key(const Subject& subject, const Term& term, int packing);

// Of the effects on the force curve of one packing in the place of another, for all pairs.
std::string between_key(const Subject& subject);

// Those that the scene has.
std::vector<Term> terms_of(const Subject& subject);

void measure_need(Measurement& measurement);

}  // namespace furrow::benchmarks
