#include "kinematics_fit/predictive_moments.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/lists.h"
#include "base/numbers.h"
#include "base/random_stream.h"
#include "base/special_functions.h"

namespace thenar {
namespace {

/// Forces are linear in these parameters as long as all others stand still. Those of a net are not
/// linear in tensions.
bool forces_linear_in(const Parameter& p, const TendonDigit& digit) {
  return (p.kind == ParameterKind::kGain && !digit.net) || p.kind == ParameterKind::kTipForce ||
         p.kind == ParameterKind::kPostureForce;
}

/// Coordinates by kind: first those in which forces bend, then those in which they are linear.
struct CoordinateOrder {
  std::vector<Eigen::Index> all;
  Eigen::Index bent = 0;  // number of the first kind
};

CoordinateOrder order_of(const FitParameters& parameters, const TendonDigit& digit) {
  CoordinateOrder order;
  for (const bool linear : {false, true}) {
    for (int c = 0; c < parameters.coordinates(); ++c)
      if (forces_linear_in(parameters.all[parameters.leader[c]], digit) == linear)
        order.all.push_back(c);
    if (!linear) order.bent = static_cast<Eigen::Index>(order.all.size());
  }
  return order;
}

/// The first `count` columns of the lower triangular L with V = L L'; a column of a coordinate that
/// others determine is zero.
Eigen::MatrixXd first_columns_of_root(const Eigen::MatrixXd& V, Eigen::Index count) {
  // Share of a variance below which its rest is rounding [1]
  constexpr double kRoundedVarianceShare = 1e-12;
  Eigen::MatrixXd rest = V;
  Eigen::MatrixXd L = Eigen::MatrixXd::Zero(V.rows(), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    if (rest(k, k) <= kRoundedVarianceShare * V(k, k) || !(rest(k, k) > 0)) continue;
    const Eigen::Index below = V.rows() - k;
    L.col(k).tail(below) = rest.col(k).tail(below) / std::sqrt(rest(k, k));
    rest.bottomRightCorner(below, below).noalias() -=
        L.col(k).tail(below) * L.col(k).tail(below).transpose();
  }
  return L;
}

/// center + step, each coordinate within the bounds of its parameter.
Eigen::VectorXd within_bounds(const FitParameters& parameters, const Eigen::VectorXd& center,
                              const Eigen::VectorXd& step) {
  Eigen::VectorXd u = center + step;
  for (int c = 0; c < parameters.coordinates(); ++c) {
    const Parameter& p = parameters.all[parameters.leader[c]];
    // A centre beyond its bounds, as of tilts of a specimen, moves no further out.
    const double lower = std::min(center[c], p.lower - p.mean);
    const double upper = std::max(center[c], p.upper - p.mean);
    u[c] = std::clamp(u[c], lower, upper);
  }
  return u;
}

/// The step, each coordinate shortened so that it stays within the bounds of its parameter to
/// either side of the centre.
Eigen::VectorXd shortened(const FitParameters& parameters, const Eigen::VectorXd& center,
                          const Eigen::VectorXd& step) {
  const Eigen::VectorXd up = within_bounds(parameters, center, step) - center,
                        down = center - within_bounds(parameters, center, -step);
  return (up.array().abs() < down.array().abs()).select(up, down);
}

/// Forces at draws of u ~ N(center, V), each coordinate within its bounds, two draws on either side
/// of the centre [N] (3 trials, kMomentDraws).
Eigen::MatrixXd drawn_forces(const TendonDigit& digit, const FitParameters& parameters,
                             const ExperimentPlan& plan, const Eigen::VectorXd& center,
                             const Eigen::MatrixXd& V, const ForceKernel* kernel) {
  const Eigen::MatrixXd root = first_columns_of_root(V, V.cols());
  RandomStream random(1, 0, 0);
  Eigen::MatrixXd u(center.size(), kMomentDraws);
  for (Eigen::Index k = 0; k < u.cols(); k += 2) {
    Eigen::VectorXd z(V.cols());
    for (double& each : z) each = random.normal();
    const Eigen::VectorXd step = root * z;
    u.col(k) = within_bounds(parameters, center, step);
    u.col(k + 1) = within_bounds(parameters, center, -step);
  }
  if (kernel != nullptr) return kernel->forces(u);
  Eigen::MatrixXd forces(3 * plan.force.cols(), u.cols());
  for (Eigen::Index k = 0; k < u.cols(); ++k)
    forces.col(k) =
        force_values(digit, parameters, plan, Eigen::VectorXd(u.col(k)), nullptr).reshaped();
  return forces;
}

}  // namespace

RobustMoments robust_moments(const Eigen::VectorXd& draws) {
  std::vector<double> values;
  for (const double draw : draws)
    if (std::isfinite(draw)) values.push_back(draw);
  if (values.empty()) return {kNaN, kNaN};
  std::sort(values.begin(), values.end());
  const auto last = static_cast<double>(values.size() - 1);
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(std::lround(share * last))];
  };
  return {at(0.5), (at(0.975) - at(0.025)) / (2 * kNormal95HalfWidth)};
}

PredictiveMoments predictive_moments(const TendonDigit& digit, const FitParameters& parameters,
                                     const ExperimentPlan& plan, const Eigen::VectorXd& center,
                                     const Eigen::MatrixXd& V) {
  const Eigen::Index n = parameters.coordinates();
  require(center.size() == n && V.rows() == n && V.cols() == n,
          "{} coordinates have a centre of {} and a covariance of {} x {}", n, center.size(),
          V.rows(), V.cols());
  // First order: the force at the centre, and its slopes.
  const std::shared_ptr<const ForceKernel> kernel = compile_forces(digit, parameters, plan);
  const ForceJacobian at = force_jacobian(digit, parameters, plan, center, kernel.get());
  PredictiveMoments out{at.force, (at.J * V).cwiseProduct(at.J).rowwise().sum(), {}};

  // Second order: how forces bend along each column of the root of V, and how uneven both sides
  // are.
  const CoordinateOrder order = order_of(parameters, digit);
  const Eigen::MatrixXd L = first_columns_of_root(V(order.all, order.all), order.bent);
  Eigen::VectorXd step(n);
  const Eigen::VectorXd of_slopes = out.variance;  // [N^2] (3 trials)
  Eigen::VectorXd uneven = Eigen::VectorXd::Zero(of_slopes.size()), bent = uneven;  // the same
  for (Eigen::Index k = 0; k < order.bent; ++k) {
    if (L(k, k) == 0) continue;
    step(order.all) = L.col(k);
    const Eigen::VectorXd way = shortened(parameters, center, step);
    const Eigen::Matrix3Xd above =
                               force_values(digit, parameters, plan, center + way, kernel.get()),
                           below =
                               force_values(digit, parameters, plan, center - way, kernel.get());
    const Eigen::Matrix3Xd bend = (above + below) / 2 - at.force;
    out.mean += bend;
    bent += bend.reshaped().cwiseAbs2();
    uneven += ((above - below).reshaped() / 2 - at.J * way).cwiseAbs2();
  }

  out.variance += 2 * bent;

  // Trials that the expansion does not tell.
  const auto trials = out.mean.cols();
  for (Eigen::Index i = 0; i < trials; ++i) {
    const double slopes = of_slopes.segment<3>(3 * i).sum();
    out.by_draws.push_back(
        !(uneven.segment<3>(3 * i).sum() <= kMaxUnevenness * kMaxUnevenness * slopes &&
          bent.segment<3>(3 * i).sum() <= slopes));
  }
  if (!contains(out.by_draws, true)) return out;
  const Eigen::MatrixXd draws = drawn_forces(digit, parameters, plan, center, V, kernel.get());
  for (Eigen::Index row = 0; row < 3 * trials; ++row) {
    if (!out.by_draws[row / 3]) continue;
    const RobustMoments moments = robust_moments(draws.row(row));
    out.mean.reshaped()[row] = moments.median;
    out.variance[row] = moments.sd * moments.sd;
  }
  return out;
}

}  // namespace thenar
