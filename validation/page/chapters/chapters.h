// The chapters of the page: words, tables and figures from the numbers of studies, one file each. A chapter computes
// nothing that needs the solver.
#pragma once

#include "report/study.h"

namespace furrow::validation {

// All studies with their chapters.
const std::vector<Study>& catalogue();

Report order(const Shelf& shelf);
Report stability(const Shelf& shelf);
Report convergence(const Shelf& shelf);
Report ensemble(const Shelf& shelf);
Report geometry(const Shelf& shelf);
Report outlook(const Shelf& shelf);
Report work_precision(const Shelf& shelf);
Report need(const Shelf& shelf);
Report speed(const Shelf& shelf);
Report published(const Shelf& shelf);
Report responses(const Shelf& shelf);
Report statements(const Shelf& shelf);
Report readings_of_the_paper(const Shelf& shelf);

}  // namespace furrow::validation
