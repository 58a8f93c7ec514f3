#pragma once

/// How much muscles lengthen from one posture to another.

#include <string>

#include "tendons/digit_tendons.h"

namespace thenar {

/// Change of length, and whether to believe it.
struct [[nodiscard]] Excursion {
  Eigen::VectorXd e;    // lengthening [m] (muscles)
  std::string trouble;  // the first on the way, why not to trust this; empty: nothing
};

/// Excursion  e = - integral of R dq  along the straight line between two postures, by Gauss's rule
/// of five points on pieces of at most 0.1 rad. Where R is a gradient (separate tendons, constant
/// shares) the line does not matter. That of a net, and of shares that change with posture, is the
/// rate at which its torque takes up a muscle's power; the stretch of its own bands is left out.
/// @param t  tensions at which R is taken [N] (muscles)
Excursion excursion(const DigitTendons& tendons, const Eigen::VectorXd& from,
                    const Eigen::VectorXd& to, const Eigen::VectorXd& t);

}  // namespace thenar
