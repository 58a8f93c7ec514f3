#pragma once

/// Sampling of approach number n of a hand to an object, and grasps that centre the object.

#include <set>
#include <string>
#include <vector>

#include "grasp/closing/grasp.h"

namespace thenar {

/// Start of a grasp: pose, posture, and distances of its approach.
struct Pregrasp {
  Pose<double> X_WH;  // pose of the hand
  Eigen::VectorXd q;  // posture (coordinates)
  double approach_distance =
      0;                 // maximum distance of the approach [m]; 0: the hand closes without one
  double stand_off = 0;  // GraspOptions::stand_off [1]
};

/// Returns the names of the digits in contact, without the palm.
[[nodiscard]] std::set<std::string> touching_digits(const Hand& hand,
                                                    const std::vector<HandContact>& contacts);

/// Returns the names of the digits whose outermost link is in contact.
[[nodiscard]] std::set<std::string> touching_tips(const Hand& hand,
                                                  const std::vector<HandContact>& contacts);

/// Samples approach `number`: sample_preshape(), sample_approach_pose(), approach_distance() and
/// sample_stand_off(), from generators seeded with (seed, object's name, number) only, so that
/// every hand gets the same random numbers.
[[nodiscard]] Pregrasp sample_pregrasp(const CollisionHand& hand, const GraspBody& object,
                                       unsigned seed, int number);

/// Runs centred_grasp() from a pregrasp, which replaces the distances of the options.
/// @throws InputError as grasp()
Grasp attempt_grasp(const CollisionHand& hand, const Pregrasp& pregrasp, const GraspSetup& setup,
                    GraspOptions options);

/// Runs grasp(), and centres a free object between coupled jaws: it slides until the second jaw
/// touches.
///
/// Centring is tried if a single digit touches, and the coordinate that it stopped also moves other
/// digits, which do not touch. The object then slides in front of the digit, across the approach,
/// until another digit touches. The implementation moves the hand instead, by half of the remaining
/// distance, as jaws of one motor move equally fast, and continues closing; on curved paths it
/// moves by the distance at which both touch, found by bisection. The object does not turn, and
/// nothing resists its motion. The result is kept only if another digit then touches and nothing
/// overlaps; otherwise the first grasp is returned. A hand with a single digit pushes the object
/// until it rests on a fixed part, as on a fixed jaw.
Grasp centred_grasp(const CollisionHand& hand, const Pose<double>& X_WH, const Eigen::VectorXd& q,
                    const GraspSetup& setup, const GraspOptions& options = {});

}  // namespace thenar
