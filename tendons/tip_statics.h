#pragma once

/// Statics of one digit at one posture: all quantities in the force balance of its tip.

#include <string>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Balance of a digit whose tip exerts force f and moment m on the world under tendon tensions t:
///
///   J' f + W' m = R' t + tau_0
///
/// A published tip-force map f = A t has this form with J' = [1; 0], no W and R' = A.
struct TipStatics {
  Eigen::Matrix3Xd J;                // position Jacobian of the tip (3, n) [m/rad]
  Eigen::Matrix3Xd W;                // rotation Jacobian of the tip (3, n) [1]
  Eigen::MatrixXd R;                 // moment arms -d(length)/dq, flexion + (m, n) [m/rad]
  Eigen::VectorXd tau_0;             // passive torque: joint springs, without weights (n) [N m]
  Eigen::VectorXd max_tension;       // F0 (m); infinite if unknown [N]
  std::vector<std::string> muscles;  // names (m)
};

/// Returns whether W is known. Without it, W is 3 x 0.
[[nodiscard]] inline bool has_rotation(const TipStatics& statics) { return statics.W.cols() > 0; }

}  // namespace thenar
