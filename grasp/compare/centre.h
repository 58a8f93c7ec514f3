#pragma once

/// Jaws of one motor on an object that is not between their middles.

#include "grasp/grasp.h"

namespace thenar {

/// grasp(), but that a free object yields to jaws: where a single digit touches and the coordinate
/// that it stopped moves other digits, too, which do not touch, the object slides before it, across
/// the approach, until another digit touches. The hand is moved instead, by half of the way that is
/// left, as jaws of one motor go equally fast, and closes on; where their ways are bent, by the way
/// at which both touch, found by bisection. The object does not turn, and nothing holds it back.
/// Kept only if another digit touches then and nothing overlaps; otherwise the grasp stays as it
/// was. The same for every hand.
Grasp centred_grasp(const TouchingHand& hand, const Pose<double>& X_WH, const Eigen::VectorXd& q,
                    const Scene& scene, const GraspOptions& options = {});

}  // namespace thenar
