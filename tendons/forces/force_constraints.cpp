#include "tendons/forces/force_constraints.h"

#include <cmath>

#include "base/error.h"
#include "tendons/forces/tip_balance.h"

namespace thenar {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

ForceConstraint effort_constraint(const VectorXd& max_tension, double p, double max_effort) {
  require(max_tension.allFinite() && (max_tension.array() >= 0).all(),
          "effort needs a finite F0 >= 0 for every muscle");
  require(p >= 1 && std::isfinite(p), "the power of an effort must be >= 1, got {}", p);
  require(max_effort > 0 && std::isfinite(max_effort),
          "the greatest effort must be positive, got {}", max_effort);
  // Give muscles without strength no weight.
  const VectorXd weight =
      (max_tension.array() > 0).select(max_tension.array().max(1e-300).inverse(), 0);
  return [weight, p, max_effort](const Vector3d&, const VectorXd& t) {
    require(t.size() == weight.size(), "max_tension has {} tendons, t has {}", weight.size(),
            t.size());
    // Compute the sum of powers and its gradient by the tensions.
    const Eigen::ArrayXd a = weight.cwiseProduct(t).array();
    ConstraintValue value{VectorXd(1), Eigen::MatrixX3d::Zero(1, 3), MatrixXd(1, t.size())};
    value.g(0) = a.abs().pow(p).sum() - max_effort;
    value.dg_dt = (p * a.sign() * a.abs().pow(p - 1) * weight.array()).matrix().transpose();
    return value;
  };
}

ForceConstraint friction_constraint(const Vector3d& n, double mu) {
  require(mu >= 0 && std::isfinite(mu), "contact friction must be >= 0, got {}", mu);
  const Vector3d normal = internal::unit_direction(n);
  return [normal, mu](const Vector3d& f, const VectorXd& t) {
    // Split the force into normal and tangential parts.
    const double f_n = normal.dot(f);
    const Vector3d f_t = f - f_n * normal;
    ConstraintValue value{VectorXd(2), Eigen::MatrixX3d(2, 3), MatrixXd::Zero(2, t.size())};
    value.g << f_t.squaredNorm() - mu * mu * f_n * f_n, -f_n;
    value.dg_df.row(0) = 2 * (f_t - mu * mu * f_n * normal);
    value.dg_df.row(1) = -normal;
    return value;
  };
}

ForceConstraint load_constraint(const Eigen::MatrixX3d& A, const MatrixXd& B, const VectorXd& b) {
  require(A.rows() == b.size() && B.rows() == b.size(), "A has {} rows, B {}, b {}", A.rows(),
          B.rows(), b.size());
  require(A.allFinite() && B.allFinite() && b.allFinite(), "A, B and b must be finite");
  return [A, B, b](const Vector3d& f, const VectorXd& t) {
    require(t.size() == B.cols(), "B has {} tendons, t has {}", B.cols(), t.size());
    // Compute the quadratic form of the load and its gradients.
    const VectorXd load = A * f + B * t + b;
    ConstraintValue value{VectorXd(1), Eigen::MatrixX3d(1, 3), MatrixXd(1, t.size())};
    value.g(0) = load.squaredNorm() - 1;
    value.dg_df = 2 * load.transpose() * A;
    value.dg_dt = 2 * load.transpose() * B;
    return value;
  };
}

}  // namespace thenar
