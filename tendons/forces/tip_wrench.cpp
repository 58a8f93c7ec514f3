#include "tendons/forces/tip_wrench.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/SVD>

#include "base/error.h"
#include "tendons/forces/tip_balance.h"

namespace thenar {

TipWrench tip_wrench(const TipStatics& statics, const Eigen::Ref<const Eigen::VectorXd>& t,
                     const TipWrenchOptions& options) {
  internal::require_statics(statics);
  internal::require_tension(statics.R.rows(), t);
  require(has_rotation(statics), "a held tip needs the rotation Jacobian W of the tip");
  require(options.length > 0 && std::isfinite(options.length),
          "the length that weighs moments must be positive, got {} m", options.length);

  // Scale the unknowns to (m / length, f): both are forces, so that their norm is meaningful.
  const Eigen::Index n = statics.J.cols();
  Eigen::MatrixXd balance(n, 6);
  balance << options.length * statics.W.transpose(), statics.J.transpose();
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(balance, Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(internal::kRankTolerance);
  const auto& sigma = svd.singularValues();

  const Eigen::VectorXd tau = statics.R.transpose() * t + statics.tau_0;
  const Eigen::VectorXd wrench = svd.solve(tau);
  const int possible = plane_normal(statics.J, statics.W) ? 3 : 6;
  const auto wanted = std::min<Eigen::Index>(n, possible);
  const double condition =
      svd.rank() >= wanted ? sigma(0) / sigma(wanted - 1) : std::numeric_limits<double>::infinity();
  return {options.length * wrench.head<3>(),
          wrench.tail<3>(),
          tau - balance * wrench,
          condition,
          static_cast<int>(svd.rank()),
          svd.rank() < possible,
          possible};
}

}  // namespace thenar
