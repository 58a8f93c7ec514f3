#include "posterior/force_density.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

#include "base/units.h"

namespace thenar {

ForceNoise::ForceNoise(double robust_scale) {
  if (robust_scale == 0) {
    c2 = std::numeric_limits<double>::infinity();
    return;
  }
  c2 = std::pow(std::max(robust_scale, 2.0), 2);
}

double ForceNoise::log_constant(int components) const {
  const double half = 0.5 * components;
  if (std::isinf(c2)) return -half * std::log(2 * kPi);
  return std::lgamma(c2 / 2) - std::lgamma((c2 - components) / 2) - half * std::log(kPi * c2);
}

ForceNoise::Tail ForceNoise::tail(double m) const {
  if (std::isinf(c2)) return {-0.5 * m, 1};
  return {-0.5 * c2 * std::log1p(m / c2), 1 / (1 + m / c2)};
}

TaskDensity task_density(const ForceNoise& model, const Eigen::Ref<const Eigen::Matrix3Xd>& unit,
                         const std::vector<MuscleTension>& pulls, const Eigen::Vector3d& force,
                         const Eigen::Vector3d& sd, double noise) {
  // Residual r and covariance S, with the tensions integrated out. A component that is not fitted
  // gets residual 0 and variance 1, so that it does not contribute.
  const Eigen::Vector3d known = sd.array().isFinite().select(sd, 0.0);
  Eigen::Vector3d r = force;
  Eigen::Matrix3d S = (noise * known).cwiseAbs2().asDiagonal();
  for (int i = 0; i < 3; ++i)
    if (known[i] == 0) S(i, i) = 1;
  for (Eigen::Index j = 0; j < unit.cols(); ++j) {
    const Eigen::Vector3d a = unit.col(j);
    r -= a * pulls[j].tension;
    S += a * pulls[j].variance * a.transpose();
  }

  // Compute the log density from the Cholesky factor of S.
  const Eigen::LLT<Eigen::Matrix3d> llt(S);
  const Eigen::Matrix3d P = llt.solve(Eigen::Matrix3d::Identity());
  const Eigen::Vector3d p = P * r;
  const ForceNoise::Tail tail = model.tail(r.dot(p));
  const double half_log_determinant = llt.matrixLLT().diagonal().array().log().sum();

  // d log p = weight p' A dt + tr(G dS),  G = (weight p p' - P) / 2.
  const Eigen::Matrix3d G = 0.5 * (tail.weight * p * p.transpose() - P);
  const auto components = static_cast<int>((known.array() > 0).count());
  TaskDensity out{model.log_constant(components) - half_log_determinant + tail.log_density,
                  Eigen::Matrix3Xd(3, unit.cols()),
                  2 * noise * noise * G.diagonal().dot(known.cwiseAbs2())};
  for (Eigen::Index j = 0; j < unit.cols(); ++j)
    out.by_unit.col(j) = tail.weight * pulls[j].tension * p +
                         2 * pulls[j].variance * (G * Eigen::Vector3d(unit.col(j)));
  return out;
}

}  // namespace thenar
