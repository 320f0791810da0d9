// A disc that slides on a soft floor is turned by friction with an arm that the scene chooses.
//
//   m u' = -mu m g
//   I w' = mu m g a     a = R, R - d/2 (`half_overlap`) or R - d (`contact_point`), I = m R^2/2
//
// with the overlap d of a disc at rest. LIGGGHTS takes R - d/2 on walls; between two discs of one size R - d/2 is half
// the distance of their centres, and the same as the arm to the contact point.
#include "verification/check.h"
#include "verification/rolling_scenes.h"
#include "verification/running.h"

namespace furrow::verification::rolling_resistance {
namespace {

TEST(HalfOverlap, TurnsASlidingDiscByItsArm) {
  requirement("tangential.moment_arm");
  const double deep = overlap(mass(disc) * gravity, soft), mu = 0.2, t = 0.005;
  for (const auto& [choice, arm] : {std::pair{MomentArm::radius, radius},
                                    {MomentArm::half_overlap, radius - deep / 2},
                                    {MomentArm::contact_point, radius - deep}}) {
    Scene scene = on_floor(disc, mu, soft, 0, 1, 0);
    scene.contact.rolling_friction = 0;
    scene.model.moment_arm = choice;
    scene.model.slip_damping = false;
    const Ran ran = run_scene(scene, "rk4", t / 5000, t);
    const double speed = ran.y[ran.system.vx_of(0)], spin = ran.y[ran.system.spin_of(0)];
    expect("spin gained over speed lost [1/m], arm " + std::to_string(arm), spin / (speed - 1),
           arm / (radius * radius / 2), relative(1e-9, "one force gives both; the overlap stays as it is"));
  }
}

}  // namespace
}  // namespace furrow::verification::rolling_resistance
