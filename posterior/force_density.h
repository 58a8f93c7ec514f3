#pragma once

/// Likelihood of a measured force given the predicted force.

#include <vector>

#include <Eigen/Core>

#include "kinematics_fit/model/activation_plan.h"

namespace thenar {

/// Distribution of measured forces about predicted forces.
///
/// Plain: normal. Robust: Student's t in the d = 2 or 3 dimensions of the fitted components,
///   p(f) = C |S|^(-1/2) (1 + m / c^2)^(-c^2 / 2),   m = r' S^-1 r,
/// with c^2 - d degrees of freedom: the fit's Cauchy loss of scale c as a density. In space the
/// density is proper only for c^2 > 3; a c below 2 counts as 2, Cauchy's distribution.
struct ForceNoise {
  /// @param robust_scale  c [noise sds]; 0: normal
  explicit ForceNoise(double robust_scale);

  double c2;  // c^2; infinite: normal [1]

  /// Logarithm of C. @param components  d, 2 or 3
  [[nodiscard]] double log_constant(int components) const;

  /// Logarithm of (..)^(-c^2 / 2) and -2 times its derivative by m.
  struct Tail {
    double log_density, weight;
  };
  [[nodiscard]] Tail tail(double m) const;
};

/// Log density of one measured force and its derivatives.
struct TaskDensity {
  double log_density;
  Eigen::Matrix3Xd by_unit;  // by the forces of unit pulls [1/N] (3, pulls)
  double by_log_noise;       // by the logarithm of a factor on sd [1]
};

/// Density of a force made by muscles whose activation is known with an error; the true tensions
/// are integrated out:
///   f ~ N(A t, S),   S = noise^2 diag(sd^2) + A diag(variance) A'.
/// Tensions are normal: their positivity is neglected. A component of infinite sd is not fitted: f,
/// A and S are without it.
/// @param unit   forces per unit pull, 0 where not fitted, one column for each of `pulls` [1] (3,
///               pulls)
/// @param noise  factor on sd [1]
[[nodiscard]] TaskDensity task_density(const ForceNoise& model,
                                       const Eigen::Ref<const Eigen::Matrix3Xd>& unit,
                                       const std::vector<MuscleTension>& pulls,
                                       const Eigen::Vector3d& force, const Eigen::Vector3d& sd,
                                       double noise);

}  // namespace thenar
