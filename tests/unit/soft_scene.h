// A scene without gravity, so soft that what meets in it goes deep.
#pragma once

#include "scenes.h"

namespace furrow::test {

inline Scene soft_scene() {
  Scene scene = empty_scene();
  for (Material& m : scene.material) m.young = 1e4;
  return scene;
}

}  // namespace furrow::test
