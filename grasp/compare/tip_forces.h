#pragma once

/// Tip forces of a hand at a posture.

#include <Eigen/Core>

#include "hand/hand.h"

namespace thenar {

/// Maximum tip forces within the actuation of the hand and its joint limits:
///   max d'f  over  L f = B u + R r + tau_0,  f = J s,  lower <= u <= upper,
///   L = J' + sum J_o' c_o c'
/// for the joints that move the tip, J (3, joints) [m/rad]; c is the tip's unit direction in
/// closing, and o are other tips that a closing coordinate moves with it: these meet the same force
/// c'f along their own directions c_o. Jaws of one motor thus pinch with half of its effort each,
/// 2 r f = u. A tendon over several joints of one digit, DriveCoupling::kCompliant, balances f at
/// all of them.
///
/// Excluded are forces that structure supports without effort (J'f = 0), and joints that are locked
/// or lie nearer to the base than the outermost non-backdrivable one, which supports what it
/// presses: see hand_forces(). NaN: an effort that matters is unknown.
struct TipForces {
  double closing = 0;  // maximum force along the tip's direction of closing: pressing force [N]
  /// Maximum |f|, by ascent from 65 directions; infinite: joint limits support one [N]
  double largest = 0;
};

/// Computes the maximum forces of a tip at a posture.
/// @param q  (coordinates) [rad];  @param tip  entry of HandLayout::tip_points
[[nodiscard]] TipForces tip_forces(const Hand& hand, const Eigen::VectorXd& q, int tip);

}  // namespace thenar
