#pragma once

/// Approach number n of a hand to an object.

#include "grasp/closing/grasp.h"

namespace thenar {

/// Where a hand begins, and how it goes at the object.
struct Pregrasp {
  Pose<double> X_WH;     // of the hand
  Eigen::VectorXd q;     // its posture (coordinates)
  double way = 0;        // farthest approach [m]; 0: it begins where it is
  double stand_off = 0;  // GraspOptions::stand_off [1]
};

/// Posture by sample_preshape(), pose by sample_approach_pose(), approach_distance(), and
/// sample_stand_off(), from generators seeded with (seed, object's name, number) alone: the same
/// draws for every hand.
[[nodiscard]] Pregrasp sample_pregrasp(const CollisionHand& hand, const SceneBody& object,
                                       unsigned seed, int number);

/// centred_grasp() from there; `way` and `stand_off` of the options are the pregrasp's.
/// @throws InputError as grasp()
Grasp attempt_grasp(const CollisionHand& hand, const Pregrasp& pregrasp, const Scene& scene,
                    GraspOptions options);

// Jaws of one motor on an object that is not between their middles.

/// grasp(), but that a free object yields to jaws: where a single digit touches and the coordinate
/// that it stopped moves other digits, too, which do not touch, the object slides before it, across
/// the approach, until another digit touches. The hand is moved instead, by half of the way that is
/// left, as jaws of one motor go equally fast, and closes on; where their ways are bent, by the way
/// at which both touch, found by bisection. The object does not turn, and nothing holds it back.
/// Kept only if another digit touches then and nothing overlaps; otherwise the grasp stays as it
/// was. The same for every hand.
Grasp centred_grasp(const CollisionHand& hand, const Pose<double>& X_WH, const Eigen::VectorXd& q,
                    const Scene& scene, const GraspOptions& options = {});

}  // namespace thenar
