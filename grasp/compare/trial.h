#pragma once

/// Approach number n of a hand to an object.

#include "grasp/grasp.h"

namespace thenar {

/// Where a hand begins, and how it goes at the object.
struct Trial {
  Pose<double> X_WH;     // of the hand
  Eigen::VectorXd q;     // its posture (coordinates)
  double way = 0;        // farthest approach [m]; 0: it begins where it is
  double stand_off = 0;  // GraspOptions::stand_off [1]
};

/// Posture by draw_preshape(), pose by draw_start(), way_past(), and draw_stand_off(), from
/// generators seeded with (seed, object's name, number) alone: the same draws for every hand.
[[nodiscard]] Trial draw_trial(const TouchingHand& hand, const SceneBody& object, unsigned seed,
                               int number);

/// centred_grasp() from there; `way` and `stand_off` of the options are the trial's.
/// @throws InputError as grasp()
Grasp try_grasp(const TouchingHand& hand, const Trial& trial, const Scene& scene,
                GraspOptions options);

}  // namespace thenar
