#include "contact/local_contact.h"

#include <cmath>

#include <Eigen/Eigenvalues>

namespace thenar::internal {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

// Proximal term that holds impulses in the null space of S near the previous ones, over the
// diagonal of A, which is 1 [1]
constexpr double kLocalProximal = 1e-10;
constexpr double kMinNormalMobility = 1e-14;  // smallest A_nn that is divided by [1]
constexpr int kMaxSecularSteps = 100;         // Newton steps on the secular equation, at most
constexpr double kSecularTolerance = 1e-15;   // |excess()| of a root, near rounding [1]
constexpr double kBracketTolerance = 1e-16;   // relative width of a bracket, below rounding [1]

/// Secular equation of a slipping contact: ft and fn as functions of kappa, in the axes of S.
struct SlipEquation {
  Vector3d y, sigma, A_tn;  // ft = -y / (sigma + kappa)
  double q_n, A_nn, mu;

  [[nodiscard]] Vector3d ft(double kappa) const {
    return (-y.array() / (sigma.array() + kappa)).matrix();
  }
  [[nodiscard]] double fn(const Vector3d& t) const { return -(q_n + A_tn.dot(t)) / A_nn; }
  /// Returns  mu fn / |ft| - 1,  which is nearly linear in kappa, and its derivative.
  [[nodiscard]] std::pair<double, double> excess(double kappa) const {
    const Vector3d t = ft(kappa), dt = (-t.array() / (sigma.array() + kappa)).matrix();
    const double norm = t.norm(), n = fn(t), dn = -A_tn.dot(dt) / A_nn;
    return {mu * n / norm - 1, mu * (dn - n * t.dot(dt) / (norm * norm)) / norm};
  }
};

/// Returns the root of excess(), by Newton steps with bisection if they leave the bracket.
double solve_secular_equation(const SlipEquation& slip) {
  // Bracket of the root: excess() is negative at low (outside the cone), positive at high.
  double low = 0, high = std::max(slip.y.norm() * slip.A_nn / (slip.mu * -slip.q_n), 1e-12);
  while (slip.excess(high).first < 0 && high < 1e300) {
    low = high;
    high *= 4;
  }
  // Newton iteration from the upper end.
  double kappa = high;
  for (int step = 0; step < kMaxSecularSteps; ++step) {
    const auto [value, slope] = slip.excess(kappa);
    (value < 0 ? low : high) = kappa;
    if (std::abs(value) < kSecularTolerance || high - low <= kBracketTolerance * high) break;
    const double next = kappa - value / slope;
    kappa = next > low && next < high ? next : (low + high) / 2;
  }
  return kappa;
}

}  // namespace

void LocalContact::assign(const Eigen::Ref<const Eigen::MatrixXd>& A) {
  tangents_ = static_cast<int>(A.rows()) - 1;
  A_nn_ = std::max(A(0, 0), kMinNormalMobility);
  // Schur complement S of the normal row.
  Eigen::Matrix3d S = Eigen::Matrix3d::Identity();
  Vector3d a = Vector3d::Zero();
  a.head(tangents_) = A.col(0).tail(tangents_);
  S.topLeftCorner(tangents_, tangents_) = A.bottomRightCorner(tangents_, tangents_) -
                                          a.head(tangents_) * a.head(tangents_).transpose() / A_nn_;
  // Eigenvectors of S, in which each kappa costs three divisions.
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(S);
  axes_ = eigen.eigenvectors();
  sigma_ = eigen.eigenvalues().cwiseMax(0) + Vector3d::Constant(kLocalProximal);
  A_tn_ = axes_.transpose() * a;
}

Vector4d LocalContact::solve(const Eigen::Ref<const Eigen::VectorXd>& q, double mu,
                             const Eigen::Ref<const Eigen::VectorXd>& previous) const {
  Vector4d out = Vector4d::Zero();
  if (q(0) >= 0) return out;

  // Right-hand side c in the axes of S, with the proximal term of the previous friction.
  Vector3d q_t = Vector3d::Zero(), t_previous = Vector3d::Zero();
  q_t.head(tangents_) = q.tail(tangents_);
  t_previous.head(tangents_) = previous.tail(tangents_);
  const Vector3d y = axes_.transpose() * q_t - A_tn_ * (q(0) / A_nn_) -
                     kLocalProximal * (axes_.transpose() * t_previous);
  const SlipEquation slip{y, sigma_, A_tn_, q(0), A_nn_, mu};

  // Stick at kappa = 0, or slip on the boundary of the cone.
  Vector3d t = slip.ft(0);
  double n = slip.fn(t);
  if (!(t.norm() <= mu * n)) {
    t = slip.ft(solve_secular_equation(slip));
    n = std::max(slip.fn(t), 0.0);
    t *= mu * n / t.norm();
  }
  out(0) = n;
  out.segment(1, tangents_) = (axes_ * t).head(tangents_);
  return out;
}

double solve_interval(const ScaledBlock& block, double A, double q, double previous) {
  if (A > kMinNormalMobility) return std::clamp(-q / A, block.lower, block.upper);
  const double end = q > 0 ? block.lower : q < 0 ? block.upper : previous;
  return std::isfinite(end) ? end : previous;
}

}  // namespace thenar::internal
