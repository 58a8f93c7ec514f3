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

/// Returns whether forces are linear in a parameter while all others are constant. Forces of a net
/// are not linear in tensions.
bool forces_linear_in(const Parameter& p, const TendonDigit& digit) {
  return (p.kind == ParameterKind::kGain && !digit.net) || p.kind == ParameterKind::kTipForce ||
         p.kind == ParameterKind::kPostureForce;
}

/// Coordinates in order: first those in which forces are nonlinear, then those in which they are
/// linear.
struct CoordinateOrder {
  std::vector<Eigen::Index> all;
  Eigen::Index nonlinear = 0;  // number of nonlinear coordinates
};

CoordinateOrder order_of(const FitParameters& parameters, const TendonDigit& digit) {
  CoordinateOrder order;
  for (const bool linear : {false, true}) {
    for (int c = 0; c < parameters.coordinates(); ++c)
      if (forces_linear_in(parameters.all[parameters.leader[c]], digit) == linear)
        order.all.push_back(c);
    if (!linear) order.nonlinear = static_cast<Eigen::Index>(order.all.size());
  }
  return order;
}

/// Returns the first `count` columns of the lower triangular L with V = L L'; the column of a
/// coordinate that others determine is zero.
Eigen::MatrixXd first_columns_of_root(const Eigen::MatrixXd& V, Eigen::Index count) {
  // Share of a variance below which its remainder is rounding error [1]
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

/// Returns center + step, with each coordinate clamped to the bounds of its parameter.
Eigen::VectorXd within_bounds(const FitParameters& parameters, const Eigen::VectorXd& center,
                              const Eigen::VectorXd& step) {
  Eigen::VectorXd u = center + step;
  for (int c = 0; c < parameters.coordinates(); ++c) {
    const Parameter& p = parameters.all[parameters.leader[c]];
    // Extend the bounds to a centre beyond them, as of tilts of a specimen.
    const double lower = std::min(center[c], p.lower - p.mean);
    const double upper = std::max(center[c], p.upper - p.mean);
    u[c] = std::clamp(u[c], lower, upper);
  }
  return u;
}

/// Returns the step with each coordinate shortened to stay within the bounds of its parameter on
/// both sides of the centre.
Eigen::VectorXd shortened(const FitParameters& parameters, const Eigen::VectorXd& center,
                          const Eigen::VectorXd& step) {
  const Eigen::VectorXd up = within_bounds(parameters, center, step) - center,
                        down = center - within_bounds(parameters, center, -step);
  return (up.array().abs() < down.array().abs()).select(up, down);
}

/// Returns forces at draws of u ~ N(center, V), clamped to the bounds, in antithetic pairs [N] (3
/// trials, kMomentDraws).
Eigen::MatrixXd drawn_forces(const TendonDigit& digit, const FitParameters& parameters,
                             const ExperimentPlan& plan, const Eigen::VectorXd& center,
                             const Eigen::MatrixXd& V, const ForceKernel* kernel) {
  const Eigen::MatrixXd root = first_columns_of_root(V, V.cols());
  RandomStream random(1, 0, 0);
  Eigen::MatrixXd u(center.size(), kMomentDraws);
  // Draw antithetic pairs.
  for (Eigen::Index k = 0; k < u.cols(); k += 2) {
    Eigen::VectorXd z(V.cols());
    for (double& each : z) each = random.normal();
    const Eigen::VectorXd step = root * z;
    u.col(k) = within_bounds(parameters, center, step);
    u.col(k + 1) = within_bounds(parameters, center, -step);
  }
  // Evaluate the forces at all draws.
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
  // Expand to first order: the force at the centre, and its slopes.
  const std::shared_ptr<const ForceKernel> kernel = compile_forces(digit, parameters, plan);
  const ForceJacobian at = force_jacobian(digit, parameters, plan, center, kernel.get());
  PredictiveMoments out{at.force, (at.J * V).cwiseProduct(at.J).rowwise().sum(), {}};

  // Add the second order: curvature along each column of the root of V, and the asymmetry of both
  // sides.
  const CoordinateOrder order = order_of(parameters, digit);
  const Eigen::MatrixXd L = first_columns_of_root(V(order.all, order.all), order.nonlinear);
  Eigen::VectorXd step(n);
  const Eigen::VectorXd first_order = out.variance;  // variance to first order [N^2] (3 trials)
  Eigen::VectorXd asymmetry = Eigen::VectorXd::Zero(first_order.size()),
                  curvature = asymmetry;  // squared asymmetry and curvature [N^2] (3 trials)
  for (Eigen::Index k = 0; k < order.nonlinear; ++k) {
    if (L(k, k) == 0) continue;
    step(order.all) = L.col(k);
    const Eigen::VectorXd way = shortened(parameters, center, step);
    const Eigen::Matrix3Xd above =
                               force_values(digit, parameters, plan, center + way, kernel.get()),
                           below =
                               force_values(digit, parameters, plan, center - way, kernel.get());
    const Eigen::Matrix3Xd bend = (above + below) / 2 - at.force;
    out.mean += bend;
    curvature += bend.reshaped().cwiseAbs2();
    asymmetry += ((above - below).reshaped() / 2 - at.J * way).cwiseAbs2();
  }

  out.variance += 2 * curvature;

  // Find trials for which the expansion is not accurate.
  const auto trials = out.mean.cols();
  for (Eigen::Index i = 0; i < trials; ++i) {
    const double slopes = first_order.segment<3>(3 * i).sum();
    out.by_draws.push_back(
        !(asymmetry.segment<3>(3 * i).sum() <= kMaxUnevenness * kMaxUnevenness * slopes &&
          curvature.segment<3>(3 * i).sum() <= slopes));
  }
  // Replace their moments by those of draws.
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
