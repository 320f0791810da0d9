#pragma once

namespace furrow::studies {

struct Point {
  double step = 0;
};

}  // namespace furrow::studies
