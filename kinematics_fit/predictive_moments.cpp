#include "kinematics_fit/predictive_moments.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

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
      if (forces_linear_in(parameters.all[static_cast<std::size_t>(parameters.leader[c])], digit) ==
          linear)
        order.all.push_back(c);
    if (!linear) order.bent = static_cast<Eigen::Index>(order.all.size());
  }
  return order;
}

/// The first `count` columns of the lower triangular L with V = L L'; a column of a coordinate that
/// others determine is zero.
Eigen::MatrixXd first_columns_of_root(const Eigen::MatrixXd& V, Eigen::Index count) {
  constexpr double kNone = 1e-12;  // of a variance: what is left of it is rounding [1]
  Eigen::MatrixXd rest = V;
  Eigen::MatrixXd L = Eigen::MatrixXd::Zero(V.rows(), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    if (rest(k, k) <= kNone * V(k, k) || !(rest(k, k) > 0)) continue;
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
    const Parameter& p = parameters.all[static_cast<std::size_t>(parameters.leader[c])];
    // A centre beyond its bounds, as of tilts of a specimen, moves no further out.
    const double lower = std::min(center[c], p.lower - p.mean);
    const double upper = std::max(center[c], p.upper - p.mean);
    u[c] = std::clamp(u[c], lower, upper);
  }
  return u;
}

}  // namespace

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
  PredictiveMoments out{at.force, (at.J * V).cwiseProduct(at.J).rowwise().sum()};

  // Second order: how forces bend along each column of the root of V.
  const CoordinateOrder order = order_of(parameters, digit);
  const Eigen::MatrixXd L = first_columns_of_root(V(order.all, order.all), order.bent);
  Eigen::VectorXd step(n);
  for (Eigen::Index k = 0; k < order.bent; ++k) {
    if (L(k, k) == 0) continue;
    step(order.all) = L.col(k);
    const auto force = [&](double sign) {
      return force_values(digit, parameters, plan,
                          within_bounds(parameters, center, Eigen::VectorXd(sign * step)),
                          kernel.get());
    };
    const Eigen::Matrix3Xd bend = (force(1) + force(-1)) / 2 - at.force;
    if (!bend.allFinite()) continue;  // a singular tip beside the centre has no mean
    out.mean += bend;
    out.variance += 2 * bend.reshaped().cwiseAbs2();
  }
  return out;
}

}  // namespace thenar
