#pragma once

/// Likelihood of a measured force given the predicted force.

#include <vector>

#include <Eigen/Core>

#include "kinematics_fit/model/activation_plan.h"

namespace thenar {

/// Distribution of measured forces around predicted forces.
///
/// Plain: normal. Robust: Student's t in the d = 2 or 3 dimensions of the fitted components,
///   p(f) = C |S|^(-1/2) (1 + m / c^2)^(-c^2 / 2),   m = r' S^-1 r,
/// with c^2 - d degrees of freedom: the density that corresponds to the Cauchy loss of scale c in
/// the fit. In space the density is proper only for c^2 > 3; c below 2 is replaced by 2, the Cauchy
/// distribution.
struct ForceNoise {
  /// @param robust_scale  c [noise sds]; 0: normal
  explicit ForceNoise(double robust_scale);

  double c2 = 0;  // c^2; infinite: normal [1]

  /// Returns the logarithm of C. @param components  d, 2 or 3
  [[nodiscard]] double log_constant(int components) const;

  /// Logarithm of (1 + m / c^2)^(-c^2 / 2), and the weight: -2 times its derivative by m.
  struct Tail {
    double log_density = 0, weight = 0;
  };
  /// Evaluates the tail at the squared distance m [1].
  [[nodiscard]] Tail tail(double m) const;
};

/// Log density of one measured force and its derivatives.
struct TaskDensity {
  double log_density = 0;
  Eigen::Matrix3Xd by_unit;  // derivative by the forces of unit pulls [1/N] (3, pulls)
  double by_log_noise = 0;   // derivative by the logarithm of a factor on sd [1]
};

/// Computes the density of a force produced by muscles with uncertain activation; the true tensions
/// are integrated out:
///   f ~ N(A t, S),   S = noise^2 diag(sd^2) + A diag(variance) A'.
/// Tensions are normal; their positivity is neglected. Components of infinite sd are not fitted,
/// and are left out of f, A and S.
/// @param unit   forces per unit pull, 0 where not fitted, one column per pull [1] (3, pulls)
/// @param noise  factor on sd [1]
[[nodiscard]] TaskDensity task_density(const ForceNoise& model,
                                       const Eigen::Ref<const Eigen::Matrix3Xd>& unit,
                                       const std::vector<MuscleTension>& pulls,
                                       const Eigen::Vector3d& force, const Eigen::Vector3d& sd,
                                       double noise);

}  // namespace thenar
