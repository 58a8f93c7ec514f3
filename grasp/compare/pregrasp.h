#pragma once

/// Approach number n of a hand to an object.

#include <set>
#include <string>
#include <vector>

#include "grasp/closing/grasp.h"

namespace thenar {

/// Start of a grasp: pose, posture, and distances of its approach.
struct Pregrasp {
  Pose<double> X_WH;             // of the hand
  Eigen::VectorXd q;             // posture (coordinates)
  double approach_distance = 0;  // largest distance of approach [m]; 0: closes where it is
  double stand_off = 0;          // GraspOptions::stand_off [1]
};

/// Names of the digits that touch; the palm is none.
[[nodiscard]] std::set<std::string> digits_of(const Hand& hand,
                                              const std::vector<HandContact>& contacts);

/// Names of the digits that touch with their outermost links.
[[nodiscard]] std::set<std::string> tips_of(const Hand& hand,
                                            const std::vector<HandContact>& contacts);

/// Samples approach `number`: sample_preshape(), sample_approach_pose(), approach_distance() and
/// sample_stand_off(), from generators seeded with (seed, object's name, number) alone, so that
/// every hand gets the same random numbers.
[[nodiscard]] Pregrasp sample_pregrasp(const CollisionHand& hand, const GraspBody& object,
                                       unsigned seed, int number);

/// centred_grasp() from a pregrasp, which gives `way` and `stand_off` of the options.
/// @throws InputError as grasp()
Grasp attempt_grasp(const CollisionHand& hand, const Pregrasp& pregrasp, const GraspSetup& setup,
                    GraspOptions options);

/// Self-centring: lets a free object slide until the second jaw of a coupled pair touches it.
///
/// grasp() first. If a single digit touches, and the coordinate that it stopped also moves other
/// digits, which do not touch, the object slides before it, across the approach, until another
/// digit touches. The hand is moved instead, by half of the distance left, as jaws of one motor go
/// equally fast, and closes further; on curved paths it moves by the distance at which both touch,
/// found by bisection. The object does not turn, and nothing holds it back. The result is kept only
/// if another digit touches then and nothing overlaps; otherwise the first grasp stays. An only
/// digit pushes the object until it rests on what stands still, as on a fixed jaw.
/// The same for every hand.
Grasp centred_grasp(const CollisionHand& hand, const Pose<double>& X_WH, const Eigen::VectorXd& q,
                    const GraspSetup& setup, const GraspOptions& options = {});

}  // namespace thenar
