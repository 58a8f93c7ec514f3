#include "tendons/forces/tip_balance.h"

#include <Eigen/SVD>

#include "base/error.h"
#include "base/numbers.h"

namespace thenar::internal {

void require_statics(const TipStatics& statics) {
  // Check shapes.
  const Eigen::Index n = statics.J.cols(), m = statics.R.rows();
  require(n > 0, "a finger without joints balances nothing");
  require(statics.R.cols() == n, "R has {} joints, J has {}", statics.R.cols(), n);
  require(statics.W.cols() == 0 || statics.W.cols() == n, "W has {} joints, J has {}",
          statics.W.cols(), n);
  require(statics.tau_0.size() == n, "tau_0 has {} joints, J has {}", statics.tau_0.size(), n);
  require(statics.max_tension.size() == m, "R has {} tendons, max_tension has {}", m,
          statics.max_tension.size());
  // Check values.
  require(statics.J.allFinite() && statics.W.allFinite() && statics.R.allFinite() &&
              statics.tau_0.allFinite(),
          "J, W, R and tau_0 must be finite");
  for (Eigen::Index i = 0; i < m; ++i)
    require(statics.max_tension(i) >= 0, "tendon {} has a greatest tension of {} N, wanted >= 0", i,
            statics.max_tension(i));
}

void require_tension(Eigen::Index tendons, const Eigen::Ref<const Eigen::VectorXd>& t) {
  require(tendons == t.size(), "R has {} tendons, t has {}", tendons, t.size());
  for (Eigen::Index i = 0; i < t.size(); ++i)
    require(t(i) >= 0 && t(i) < kInfinity, "tendon {} cannot push: tension {} N", i, t(i));
}

TipBalance tip_balance(const TipStatics& statics) {
  require_statics(statics);
  TipBalance balance;

  // Decompose the force side, with the zeros of a straight finger made exact.
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(statics.J, Eigen::ComputeFullU | Eigen::ComputeThinV);
  Eigen::VectorXd sigma = svd.singularValues();
  sigma = (sigma.array() > kRankTolerance * sigma(0)).select(sigma, 0);
  balance.U = svd.matrixU();
  balance.rank = static_cast<int>((sigma.array() > 0).count());
  balance.force_part = Eigen::MatrixXd::Zero(statics.J.cols(), 3);
  balance.force_part.leftCols(sigma.size()) = svd.matrixV() * sigma.asDiagonal();

  // Scale the tension side by F0.
  const auto& F0 = statics.max_tension;
  const auto usable = F0.array().isFinite() && F0.array() > 0;
  balance.unit = usable.select(F0, 1.0);
  balance.upper = usable.select(Eigen::VectorXd::Ones(F0.size()), F0);
  balance.tension_part = -statics.R.transpose() * balance.unit.asDiagonal();
  balance.constant = statics.tau_0;

  // Scale rows to order one, so that a solver's tolerance has the same meaning at every joint; a
  // row that is only rounding stays small.
  Eigen::MatrixXd rows(statics.J.cols(), F0.size() + 1);
  rows << balance.tension_part, balance.constant;
  const Eigen::VectorXd largest = rows.cwiseAbs().rowwise().maxCoeff();
  const double floor = largest.maxCoeff() > 0 ? 1e-6 * largest.maxCoeff() : 1;
  balance.row_scale = largest.cwiseMax(floor).cwiseInverse();
  balance.force_part = balance.row_scale.asDiagonal() * balance.force_part;
  balance.tension_part = balance.row_scale.asDiagonal() * balance.tension_part;
  balance.constant = balance.row_scale.cwiseProduct(balance.constant);

  // Scale force columns to the size of tendon columns.
  const double force_size = balance.force_part.norm(), tension_size = balance.tension_part.norm();
  balance.force_unit = force_size > 0 && tension_size > 0 ? tension_size / force_size : 1;
  balance.force_part *= balance.force_unit;
  return balance;
}

LinearProgram balance_program(const TipBalance& balance, const Eigen::MatrixXd& loads) {
  const Eigen::Index k = loads.cols(), m = balance.upper.size();
  LinearProgram program;
  program.objective = Eigen::VectorXd::Zero(k + m);
  program.A.resize(loads.rows(), k + m);
  program.A << loads, balance.tension_part;
  program.row_lower = program.row_upper = balance.constant;
  program.lower = Eigen::VectorXd::Zero(k + m);
  program.lower.head(k).setConstant(-kInfinity);
  program.upper = Eigen::VectorXd::Constant(k + m, kInfinity);
  program.upper.tail(m) = balance.upper;
  return program;
}

Eigen::VectorXd tension(const TipBalance& balance, const Eigen::VectorXd& a) {
  return balance.unit.cwiseProduct(a.cwiseMax(0).cwiseMin(balance.upper));
}

Eigen::VectorXd activation(const TipStatics& statics, const Eigen::VectorXd& t) {
  const auto& F0 = statics.max_tension;
  return (F0.array() > 0).select(t.array() / F0.array().max(1e-300), 0);
}

double imbalance(const TipStatics& statics, const Eigen::Vector3d& force,
                 const Eigen::VectorXd& tension) {
  const Eigen::VectorXd left =
      statics.J.transpose() * force - statics.R.transpose() * tension - statics.tau_0;
  return left.cwiseAbs().maxCoeff();
}

Eigen::Matrix3Xd without_rounding(const Eigen::Matrix3Xd& unit_vectors) {
  return (unit_vectors.array().abs() > kUnitRounding).select(unit_vectors, 0);
}

Eigen::Vector3d unit_direction(const Eigen::Vector3d& direction) {
  require(direction.allFinite(), "a direction must be finite");
  const double largest = direction.cwiseAbs().maxCoeff();
  require(largest > 0, "a direction must not be zero");
  return (direction / largest).normalized();
}

}  // namespace thenar::internal
