#pragma once

/// Moment arms and length changes of the tendons of a digit, without any tension.
/// Example: examples/02_moment_arms.cpp.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "api/named/digit_result.h"

namespace thenar {

/// Result at one posture.
struct MomentArmPoint {
  Eigen::VectorXd q;              // [rad] (joints)
  std::string message;            // why there is no answer; empty: there is one
  Eigen::MatrixXd arms;           // -d length / dq; flexion, radial + [m/rad] (muscles, joints)
  Eigen::VectorXd length_change;  // change since MomentArmResult::reference; longer + [m] (muscles)
  Eigen::Vector3d tip{0, 0, 0};   // world frame [m] (3)
};

/// Results posture by posture, in the order of the grid; fewer if stopped.
struct MomentArmResult : DigitResult {
  Eigen::VectorXd reference;  // posture of no length change [rad] (joints)
  Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic> crosses;  // true: the muscle has an arm about
                                                                // a joint (muscles, joints)
  std::vector<MomentArmPoint> points;
};

/// Computes the moment arms  -d length / dq  of every muscle about every joint that it crosses, and
/// its length change from the posture with all joints at 0 (or, if tendon paths are not reliable
/// there, from the first posture). Arms and lengths of a muscle that pulls several strands of a
/// hood are averages weighted by the shares of its tension; derivatives of the lengths equal the
/// arms where shares are constant and sheaths frictionless.
/// @throws InputError for unknown names, a tip map, or a net, whose arms depend on tensions;
/// DataError for a wrong file.
[[nodiscard]] MomentArmResult compute_moment_arms(const DigitRequest& request,
                                                  const Progress& progress = {});

/// Computes the moment arms of a built digit at the postures of its grid.
/// @throws InputError for a tip map or a net
[[nodiscard]] MomentArmResult compute_moment_arms(const DigitCase& digit,
                                                  const Progress& progress = {});

}  // namespace thenar
