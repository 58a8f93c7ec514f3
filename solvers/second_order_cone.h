#pragma once

/// Algebra of products of second-order cones for interior-point methods.

#include <vector>

#include <Eigen/Core>

namespace thenar::internal {

/// Returns u o v = (u' v, u0 v1 + v0 u1), cone by cone.
[[nodiscard]] Eigen::VectorXd cone_product(const std::vector<int>& cones, const Eigen::VectorXd& u,
                                           const Eigen::VectorXd& v);

/// Returns the w with u o w = v; u must be inside the cones.
[[nodiscard]] Eigen::VectorXd cone_quotient(const std::vector<int>& cones, const Eigen::VectorXd& u,
                                            const Eigen::VectorXd& v);

/// Returns the identity element (1, 0, ...) of each cone.
[[nodiscard]] Eigen::VectorXd cone_identity(const std::vector<int>& cones);

/// Returns the largest step a <= `max_step` for which u + a d stays in the cones; u must be inside.
[[nodiscard]] double step_to_cone(const std::vector<int>& cones, const Eigen::VectorXd& u,
                                  const Eigen::VectorXd& d, double max_step);

/// Nesterov-Todd scaling: the symmetric W with  W z = W^-1 s,  one block per cone.
class ConeScaling {
 public:
  /// @param s, z  points inside the cones (m)
  ConeScaling(const std::vector<int>& cones, const Eigen::VectorXd& s, const Eigen::VectorXd& z);

  [[nodiscard]] Eigen::MatrixXd times(const Eigen::MatrixXd& right) const;   // W right
  [[nodiscard]] Eigen::MatrixXd divide(const Eigen::MatrixXd& right) const;  // W^-1 right

 private:
  std::vector<Eigen::MatrixXd> blocks_, inverses_;
};

}  // namespace thenar::internal
