#include "sampling/methods/whitening.h"

#include <algorithm>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "base/error.h"
#include "sampling/methods/saved_shape.h"

namespace thenar::internal {

Bend::Pairs Bend::products(const Eigen::VectorXd& y) const {
  Pairs pairs(strength.cols());
  for (int k = 0, pair = 0; k < drivers; ++k)
    for (int j = 0; j <= k; ++j) pairs[pair++] = y[j] * y[k] - (j == k ? 1 : 0);
  return pairs;
}

Eigen::VectorXd Bend::apply(const Eigen::VectorXd& y) const {
  if (drivers == 0) return y;
  return y + strength * products(y);
}

Eigen::VectorXd Bend::invert(const Eigen::VectorXd& z) const {
  if (drivers == 0) return z;
  // Invert driver by driver: each depends on the previous ones only.
  Eigen::VectorXd y = z;
  for (int k = 1; k < drivers; ++k) y[k] = z[k] - strength.row(k).dot(products(y));
  // Invert all other entries at once.
  const Eigen::Index rest = z.size() - drivers;
  y.tail(rest) = z.tail(rest) - strength.bottomRows(rest) * products(y);
  return y;
}

void Bend::pull_back_gradient(const Eigen::VectorXd& y, Eigen::VectorXd& gradient) const {
  if (drivers == 0) return;
  const Pairs by_pair = strength.transpose() * gradient;
  for (int k = 0, pair = 0; k < drivers; ++k)
    for (int j = 0; j <= k; ++j, ++pair) {
      gradient[j] += by_pair[pair] * y[k];
      gradient[k] += by_pair[pair] * y[j];
    }
}

Whitening::Whitening(Metric metric, const Eigen::VectorXd& centre,
                     const Eigen::MatrixXd& covariance)
    : metric_(metric), centre_(centre) {
  // Start with the identity unless a covariance is given.
  const Eigen::Index n = centre.size();
  factor_.setOnes(n, 1);
  if (is_dense()) factor_ = inverse_ = Eigen::MatrixXd::Identity(n, n);
  if (covariance.size() == 0) return;
  require(covariance.rows() == n && covariance.cols() == n,
          "covariance must be {} x {}, got {} x {}", n, n, covariance.rows(), covariance.cols());
  require(covariance.allFinite() && covariance.isApprox(covariance.transpose(), 1e-6),
          "covariance must be finite and symmetric");
  const bool positive =
      is_dense() ? set_covariance(covariance) : set_covariance(covariance.diagonal());
  require(positive, "covariance must be positive definite");
}

void Whitening::to_position(const Eigen::VectorXd& y, Eigen::VectorXd& x) const {
  x = centre_;
  if (!is_dense()) {
    x += factor_.col(0).cwiseProduct(y);
    return;
  }
  add_product(factor_, shape_, y, x);
  if (is_bent()) x.noalias() += bent_ * bend_.products(y);
}

Eigen::VectorXd Whitening::to_whitened(const Eigen::VectorXd& x) const {
  if (!is_dense()) return (x - centre_).cwiseQuotient(factor_.col(0));
  return bend_.invert(inverse_ * (x - centre_));
}

void Whitening::whiten_gradient(const Eigen::VectorXd& y, const Eigen::VectorXd& gradient,
                                Eigen::VectorXd& slope) const {
  if (!is_dense()) {
    slope = factor_.col(0).cwiseProduct(gradient);
    return;
  }
  transposed_product(factor_, shape_, gradient, slope);
  bend_.pull_back_gradient(y, slope);
  if (orbits_) slope += y;
}

Eigen::MatrixXd Whitening::covariance() const {
  if (is_dense()) return factor_ * factor_.transpose();
  return factor_.cwiseAbs2();
}

bool Whitening::set_covariance(const Eigen::MatrixXd& covariance) {
  if (!covariance.allFinite()) return false;
  if (is_dense()) {
    const Eigen::LLT<Eigen::MatrixXd> cholesky(covariance);
    if (cholesky.info() != Eigen::Success) return false;
    return set_map(centre_, cholesky.matrixL(), {}, false);
  }
  if (covariance.minCoeff() <= 0) return false;
  factor_ = covariance.cwiseSqrt();
  return true;
}

bool Whitening::set_map(const Eigen::VectorXd& centre, const Eigen::MatrixXd& factor,
                        const Bend& bend, bool orbits) {
  const Eigen::MatrixXd inverse = factor.partialPivLu().inverse();
  if (!centre.allFinite() || !inverse.allFinite() || !bend.strength.allFinite()) return false;
  centre_ = centre;
  factor_ = factor;
  shape_ = factor.isLowerTriangular(0) ? Shape::kLower : Shape::kFull;
  inverse_ = inverse;
  bend_ = bend;
  bent_ = bend.drivers > 0 ? Eigen::MatrixXd(factor * bend.strength) : Eigen::MatrixXd();
  orbits_ = orbits;
  return true;
}

void Whitening::save(StateWriter& to) const {
  to.write(centre_);
  to.write(factor_);
  to.write(std::int64_t{bend_.drivers});
  to.write(bend_.strength);
  to.write(std::int64_t{orbits_ ? 1 : 0});
}

void Whitening::restore(StateReader& from) {
  const Eigen::Index n = size();
  const Eigen::VectorXd centre = saved_vector(from, "centre of the metric", n);
  const Eigen::MatrixXd factor = saved_matrix(from, "metric", n, is_dense() ? n : 1);
  // A bend has an entry for each pair of its drivers.
  Bend bend;
  const std::int64_t drivers = from.integer(),
                     max_drivers = std::min<std::int64_t>(Bend::kMaxDrivers, n);
  require(drivers >= 0 && drivers <= max_drivers,
          "saved state: wanted 0 to {} drivers of a bend, got {}", max_drivers, drivers);
  bend.drivers = static_cast<int>(drivers);
  bend.strength =
      drivers == 0 ? from.matrix() : saved_matrix(from, "bend", n, drivers * (drivers + 1) / 2);
  const bool orbits = from.integer() != 0;
  if (!is_dense()) {
    centre_ = centre;
    factor_ = factor;
    return;
  }
  require(set_map(centre, factor, bend, orbits), "the saved metric has no inverse");
}

}  // namespace thenar::internal
