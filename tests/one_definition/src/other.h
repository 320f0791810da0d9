#pragma once

namespace furrow::studies {

struct Point {
  double step = 0, error = 0;
};

}  // namespace furrow::studies
