#pragma once

/// Algebra of products of second-order cones, as interior-point methods need it.

#include <vector>

#include <Eigen/Core>

namespace thenar::internal {

/// u o v = (u' v, u0 v1 + v0 u1), cone by cone.
[[nodiscard]] Eigen::VectorXd cone_product(const std::vector<int>& cones, const Eigen::VectorXd& u,
                                           const Eigen::VectorXd& v);

/// The w with u o w = v; u inside the cones.
[[nodiscard]] Eigen::VectorXd cone_quotient(const std::vector<int>& cones, const Eigen::VectorXd& u,
                                            const Eigen::VectorXd& v);

/// (1, 0, ...) of each cone.
[[nodiscard]] Eigen::VectorXd cone_identity(const std::vector<int>& cones);

/// Largest step a with u + a d in the cones, at most `most`; u inside.
[[nodiscard]] double step_to_cone(const std::vector<int>& cones, const Eigen::VectorXd& u,
                                  const Eigen::VectorXd& d, double most);

/// The symmetric W of Nesterov and Todd with  W z = W^-1 s,  one block a cone.
class ConeScaling {
 public:
  /// @param s, z  both inside the cones (m)
  ConeScaling(const std::vector<int>& cones, const Eigen::VectorXd& s, const Eigen::VectorXd& z);

  [[nodiscard]] Eigen::MatrixXd times(const Eigen::MatrixXd& right) const;   // W right
  [[nodiscard]] Eigen::MatrixXd divide(const Eigen::MatrixXd& right) const;  // W^-1 right

 private:
  std::vector<Eigen::MatrixXd> blocks_, inverses_;
};

}  // namespace thenar::internal
