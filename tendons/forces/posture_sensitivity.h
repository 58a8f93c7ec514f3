#pragma once

/// Posture derivatives of fingertip forces.

#include <vector>

#include <Eigen/Core>

#include "tendons/digit_tendons.h"
#include "tendons/forces/tip_wrench.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// Condition number of a tip's Jacobian above which a posture error of one degree may change most
/// of the force [1]: in fingers of 45, 25 and 20 mm joints are then within about half a degree of
/// straight.
inline constexpr double kNearlyStraight = 300;

/// Computes tip_statics() with the moment arms of these tendons, whatever their path model.
/// @param tendons  without a net
/// @param q        posture (n) [rad]
[[nodiscard]] TipStatics tip_statics(const DigitTendons& tendons, const Eigen::VectorXd& q);

/// Derivative of TipStatics by one coordinate of the posture.
struct StaticsDerivative {
  Eigen::Matrix3Xd J, W;  // (3, n) [m/rad^2], [1/rad]
  Eigen::MatrixXd R;      // (m, n) [m/rad^2]
  Eigen::VectorXd tau_0;  // (n) [N m/rad]
};

/// Computes the derivatives of the statics by central differences of fourth order over 0.001 rad,
/// accurate to about 1e-11 of the statics, which are smooth whatever their condition.
/// Ill-conditioned steps are left to the closed forms below.
/// @param tendons  without a net
/// @param q        posture (n) [rad]
/// @return one for each coordinate (n)
[[nodiscard]] std::vector<StaticsDerivative> statics_derivatives(const DigitTendons& tendons,
                                                                 const Eigen::VectorXd& q);

/// Computes the derivative of tip_force() by every coordinate at constant tensions. With B = J', f
/// = B+ tau and r = tau - B f:   df = B+ (dtau - dB f) + B+ B+' dB' r.
/// @return world frame (3, n) [N/rad]; infinite where the rank of J is below 3, or below 2 in the
/// plane of parallel axes, which W identifies
/// Source: [Golub1973] for derivatives of pseudo-inverses.
[[nodiscard]] Eigen::Matrix3Xd tip_force_jacobian(const TipStatics& statics,
                                                  const std::vector<StaticsDerivative>& slopes,
                                                  const Eigen::VectorXd& t);

/// Computes the derivative of tip_wrench(): moment [N m/rad] above force [N/rad], (6, n); infinite
/// if the rank is below min(n, 6), or min(n, 3) where all axes are parallel. Minimum norm adds (1 -
/// B+ B) dB' B+' w to the derivative.
[[nodiscard]] Eigen::MatrixXd tip_wrench_jacobian(const TipStatics& statics,
                                                  const std::vector<StaticsDerivative>& slopes,
                                                  const Eigen::VectorXd& t,
                                                  const TipWrenchOptions& options = {});

/// Frame in which a direction is fixed while the posture changes.
enum class DirectionFrame { kWorld, kTip };

}  // namespace thenar
