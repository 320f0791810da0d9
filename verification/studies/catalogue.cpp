#include "studies/catalogue.h"

namespace furrow::studies {

const std::vector<Study>& catalogue() {
  static const std::vector<Study> all{
      {"work_precision", "error against evaluations and CPU time, every method on every scene", work_precision},
  };
  return all;
}

}  // namespace furrow::studies
