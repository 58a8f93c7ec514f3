#pragma once

/// Distribution of a tangential load over the springs of a contact patch with friction.

#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Distribution of a tangential load over the springs of a patch.
struct ShearShares {
  std::vector<bool> sticks;  // true: the spring sticks (springs)
  double borne = 0;          // load that the springs carry: all of it, or the friction limit [N]
};

/// Distributes a tangential load over the springs of a patch, which share one tangential
/// displacement d:
///   sum of min(stiffness_i d, friction normal_i) = load.
/// Springs at their friction limit slip, as in the contact of Cattaneo and Mindlin: under a
/// paraboloid of pressure of radius a and total force N, equal springs stick within
///   a (1 - load / (friction N))^(1/4).
/// @param normal     normal forces, >= 0 [N] (springs)
/// @param stiffness  tangential stiffnesses, > 0 [N/m] (springs)
/// @param friction   coefficient of Coulomb friction [1]
/// @param load       tangential load, >= 0 [N]
[[nodiscard]] ShearShares share_shear(const Eigen::VectorXd& normal,
                                      const Eigen::VectorXd& stiffness, double friction,
                                      double load);

}  // namespace thenar
