#pragma once

namespace furrow::verification {

struct Point {
  double step = 0, error = 0;
};

}  // namespace furrow::verification
