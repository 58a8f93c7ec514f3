#pragma once

/// The force of a fingertip under given tendon tensions.
/// Example: examples/03_tip_force.cpp, examples/11_own_finger.cpp.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "api/named/digit_result.h"
#include "data/io/experiment.h"
#include "tendons/forces/tip_wrench.h"

namespace thenar {

/// Options of a tip force: a digit and the tensions of its tendons.
struct TipForceRequest {
  DigitRequest digit;                           // subject, digit and postures
  std::map<std::string, double> tension;        // tension of each muscle [N]; others are slack
  TipConstraint hold = TipConstraint::kPinned;  // motion of the tip that is prevented
  double hold_length =
      TipWrenchOptions().length;  // length that weights moments of a rigid hold [m]
};

/// Result at one posture.
struct TipForcePoint {
  Eigen::VectorXd q;                        // [rad] (joints); empty for a map
  std::string message;                      // why there is no answer; empty: there is one
  std::optional<Eigen::Matrix3d> tip_axes;  // proximal, dorsal, radial, world frame (3, 3)
  Eigen::Vector3d tip{0, 0, 0};             // position of the tip, world frame [m] (3); 0 for a map
  Eigen::Vector3d force{0, 0, 0};           // force of the tip on the world, world frame [N] (3)
  Eigen::Vector3d moment{0, 0, 0};          // about the tip, world frame [N m] (3); 0 if pinned
  Eigen::VectorXd residual;  // torque of each joint that no tip load balances [N m] (rows); of a
                             // map, what its rows leave of forces [N] and moments [N m]
  Eigen::VectorXd change;    // |d force / d angle| of each joint [N/rad] (joints)
  double condition = 0;      // condition number of the balance [1]
  bool singular = false;     // pinned tip: some tip force needs no joint torque
  bool minimum_norm =
      false;  // rigid hold: the balance has many solutions, and the result has minimum norm
  bool planar =
      false;  // all axes are parallel: loads across their plane do not load any joint, and are 0
};

/// Results posture by posture, in the order of the grid; fewer if stopped.
struct TipForceResult : DigitResult {
  TipForceRequest request;            // request that was answered
  Eigen::VectorXd tension;            // tension of each muscle [N] (muscles)
  std::vector<TipForcePoint> points;  // one result for each posture
};

/// Computes the static force of a fingertip: tip_force() or tip_wrench() at every posture.
/// @throws InputError for unknown names, a tension above kMaxTension, a rigid hold of a map,
/// or a hold length outside of 0 .. 1 m; DataError for a wrong file.
[[nodiscard]] TipForceResult compute_tip_force(const TipForceRequest& request,
                                               const Progress& progress = {});

}  // namespace thenar
