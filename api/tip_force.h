#pragma once

/// The force of a fingertip under given tendon tensions.

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
  DigitRequest digit;
  std::map<std::string, double> tension;           // tension of each muscle [N]; others are slack
  TipConstraint hold = TipConstraint::kPinned;     //
  double hold_length = TipWrenchOptions().length;  // weighs moments of a rigid hold [m]
};

/// The answer at one posture.
struct TipForcePoint {
  Eigen::VectorXd q;                        // [rad] (joints); empty for a map
  std::string message;                      // why there is no answer; empty: there is one
  std::optional<Eigen::Matrix3d> tip_axes;  // proximal, dorsal, radial now, in world axes (3, 3)
  Eigen::Vector3d tip{0, 0, 0};             // position of the tip, world frame [m] (3); 0 for a map
  Eigen::Vector3d force{0, 0, 0};           // force of the tip on the world, world frame [N] (3)
  Eigen::Vector3d moment{
      0, 0, 0};  // moment of the tip on the world about the tip, world frame [N m] (3); 0 if pinned
  Eigen::VectorXd residual;  // torque that no load of the tip balances [N m] (rows)
  Eigen::VectorXd
      change;            // derivative of the force's magnitude by each joint angle [N/rad] (joints)
  double condition = 0;  // condition number of the balance [1]
  bool singular = false;      // a pinned tip: some force meets no torque
  bool minimum_norm = false;  // a rigid hold: many wrenches balance
  bool planar = false;        // all axes are parallel: loads across their plane load
                              // no joint, and are 0 here
};

/// Answers posture by posture, in the order of the grid; as many as were done.
struct TipForceResult : DigitResult {
  TipForceRequest request;
  Eigen::VectorXd tension;  // tension of each muscle [N] (muscles)
  std::vector<TipForcePoint> points;
};

/// Computes the static force of a fingertip: tip_force() or tip_wrench() at every posture.
/// @throws InputError for what is unknown, a tension that no tendon bears, a rigid hold of a map,
/// or a hold length outside of 0 .. 1 m; DataError for a wrong file.
[[nodiscard]] TipForceResult compute_tip_force(const TipForceRequest& request,
                                               const Progress& progress = {});

}  // namespace thenar
