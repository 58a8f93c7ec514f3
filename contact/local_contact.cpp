#include "contact/local_contact.h"

#include <cmath>

#include <Eigen/Eigenvalues>

namespace thenar::internal {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

// Stiffness that holds what S does not determine near the former impulse; the diagonal of A is 1.
constexpr double kLocalProximal = 1e-10;
constexpr int kMostSecularSteps = 100;  // Most Newton steps on the secular equation

/// ft and fn as functions of kappa, in the axes of S.
struct Slip {
  Vector3d y, sigma, A_tn;  // ft = -y / (sigma + kappa)
  double q_n, A_nn, mu;

  [[nodiscard]] Vector3d ft(double kappa) const {
    return (-y.array() / (sigma.array() + kappa)).matrix();
  }
  [[nodiscard]] double fn(const Vector3d& t) const { return -(q_n + A_tn.dot(t)) / A_nn; }
  /// mu fn / |ft| - 1, nearly linear in kappa; and its slope.
  [[nodiscard]] std::pair<double, double> excess(double kappa) const {
    const Vector3d t = ft(kappa), dt = (-t.array() / (sigma.array() + kappa)).matrix();
    const double norm = t.norm(), n = fn(t), dn = -A_tn.dot(dt) / A_nn;
    return {mu * n / norm - 1, mu * (dn - n * t.dot(dt) / (norm * norm)) / norm};
  }
};

/// The root of excess(): Newton's steps, halved intervals where they leave the bracket.
double root_of(const Slip& slip) {
  // Bracket of the root: excess() is negative at low (outside the cone), positive at high.
  double low = 0, high = std::max(slip.y.norm() * slip.A_nn / (slip.mu * -slip.q_n), 1e-12);
  while (slip.excess(high).first < 0 && high < 1e300) {
    low = high;
    high *= 4;
  }
  double kappa = high;
  for (int step = 0; step < kMostSecularSteps; ++step) {
    const auto [value, slope] = slip.excess(kappa);
    (value < 0 ? low : high) = kappa;
    if (std::abs(value) < 1e-15 || high - low <= 1e-16 * high) break;
    const double next = kappa - value / slope;
    kappa = next > low && next < high ? next : (low + high) / 2;
  }
  return kappa;
}

}  // namespace

void LocalContact::assign(const Eigen::Ref<const Eigen::MatrixXd>& A) {
  tangents_ = static_cast<int>(A.rows()) - 1;
  A_nn_ = std::max(A(0, 0), 1e-14);
  // Schur complement S of the normal row.
  Eigen::Matrix3d S = Eigen::Matrix3d::Identity();
  Vector3d a = Vector3d::Zero();
  a.head(tangents_) = A.col(0).tail(tangents_);
  S.topLeftCorner(tangents_, tangents_) = A.bottomRightCorner(tangents_, tangents_) -
                                          a.head(tangents_) * a.head(tangents_).transpose() / A_nn_;
  // Axes of S, in which each kappa costs three divisions.
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(S);
  axes_ = eigen.eigenvectors();
  sigma_ = eigen.eigenvalues().cwiseMax(0) + Vector3d::Constant(kLocalProximal);
  A_tn_ = axes_.transpose() * a;
}

Vector4d LocalContact::solve(const Eigen::Ref<const Eigen::VectorXd>& q, double mu,
                             const Eigen::Ref<const Eigen::VectorXd>& former) const {
  Vector4d out = Vector4d::Zero();
  if (q(0) >= 0) return out;

  // Right side c in the axes of S, with the proximal pull to the former friction.
  Vector3d q_t = Vector3d::Zero(), t_former = Vector3d::Zero();
  q_t.head(tangents_) = q.tail(tangents_);
  t_former.head(tangents_) = former.tail(tangents_);
  const Vector3d y = axes_.transpose() * q_t - A_tn_ * (q(0) / A_nn_) -
                     kLocalProximal * (axes_.transpose() * t_former);
  const Slip slip{y, sigma_, A_tn_, q(0), A_nn_, mu};

  // Stick at kappa = 0, or slip at the edge of the cone.
  Vector3d t = slip.ft(0);
  double n = slip.fn(t);
  if (!(t.norm() <= mu * n)) {
    t = slip.ft(root_of(slip));
    n = std::max(slip.fn(t), 0.0);
    t *= mu * n / t.norm();
  }
  out(0) = n;
  out.segment(1, tangents_) = (axes_ * t).head(tangents_);
  return out;
}

double solve_interval(const ScaledBlock& block, double A, double q, double former) {
  if (A > 1e-14) return std::clamp(-q / A, block.lower, block.upper);
  const double end = q > 0 ? block.lower : q < 0 ? block.upper : former;
  return std::isfinite(end) ? end : former;
}

}  // namespace thenar::internal
