#include "solvers/second_order_cone.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thenar::internal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Calls a function with the first row and the number of rows of each cone.
template <typename Visit>
void for_each_cone(const std::vector<int>& cones, const Visit& visit) {
  Eigen::Index start = 0;
  for (const int rows : cones) {
    visit(start, rows);
    start += rows;
  }
}

/// Returns u' J v with J = diag(1, -1, ..., -1).
double lorentz_product(const VectorXd& u, const VectorXd& v) {
  return u(0) * v(0) - u.tail(u.size() - 1).dot(v.tail(v.size() - 1));
}
/// Returns sqrt(u' J u), computed without cancellation.
double lorentz_norm(const VectorXd& u) {
  const double r = u.tail(u.size() - 1).norm();
  return std::sqrt(std::max((u(0) - r) * (u(0) + r), std::numeric_limits<double>::min()));
}

/// Returns [w0, w1'; w1, I + w1 w1' / (1 + w0)] for w of Lorentz norm 1.
MatrixXd boost(double w0, const VectorXd& w1) {
  const Eigen::Index n = w1.size();
  MatrixXd W(n + 1, n + 1);
  W(0, 0) = w0;
  W.block(0, 1, 1, n) = w1.transpose();
  W.block(1, 0, n, 1) = w1;
  W.block(1, 1, n, n) = MatrixXd::Identity(n, n) + w1 * w1.transpose() / (1 + w0);
  return W;
}

/// Returns the smallest positive root of  a x^2 + 2 b x + c  with c > 0; infinite if there is none.
double first_positive_root(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (discriminant < 0 || (b >= 0 && a >= 0)) return std::numeric_limits<double>::infinity();
  const double root = std::sqrt(discriminant);
  return b < 0 ? c / (root - b) : -(b + root) / a;
}

/// Returns the longest step within one cone.
double step_in_cone(const VectorXd& u, const VectorXd& d) {
  // Distance to the side of the cone, and to its tip.
  const double norm = lorentz_norm(u),
               to_side =
                   first_positive_root(lorentz_product(d, d), lorentz_product(u, d), norm * norm);
  if (d(0) >= 0) return to_side;
  return std::min(to_side, -u(0) / d(0));  // rounding may hide the exit through the tip
}

MatrixXd times_blocks(const std::vector<MatrixXd>& blocks, const MatrixXd& right) {
  MatrixXd result(right.rows(), right.cols());
  Eigen::Index i = 0;
  for (const MatrixXd& block : blocks) {
    result.middleRows(i, block.rows()) = block * right.middleRows(i, block.rows());
    i += block.rows();
  }
  return result;
}

}  // namespace

VectorXd cone_product(const std::vector<int>& cones, const VectorXd& u, const VectorXd& v) {
  VectorXd result(u.size());
  for_each_cone(cones, [&](Eigen::Index i, int n) {
    result.segment(i + 1, n - 1) = u(i) * v.segment(i + 1, n - 1) + v(i) * u.segment(i + 1, n - 1);
    result(i) = u.segment(i, n).dot(v.segment(i, n));
  });
  return result;
}

VectorXd cone_quotient(const std::vector<int>& cones, const VectorXd& u, const VectorXd& v) {
  VectorXd result(u.size());
  for_each_cone(cones, [&](Eigen::Index i, int n) {
    // Multiply by the inverse of the arrow matrix of u.
    const VectorXd u1 = u.segment(i + 1, n - 1), v1 = v.segment(i + 1, n - 1);
    const double norm = lorentz_norm(u.segment(i, n));
    const double w0 = (u(i) * v(i) - u1.dot(v1)) / (norm * norm);
    result(i) = w0;
    result.segment(i + 1, n - 1) = (v1 - w0 * u1) / u(i);
  });
  return result;
}

VectorXd cone_identity(const std::vector<int>& cones) {
  Eigen::Index rows = 0;
  for (const int n : cones) rows += n;
  VectorXd e = VectorXd::Zero(rows);
  for_each_cone(cones, [&](Eigen::Index i, int) { e(i) = 1; });
  return e;
}

double step_to_cone(const std::vector<int>& cones, const VectorXd& u, const VectorXd& d,
                    double max_step) {
  double step = max_step;
  for_each_cone(cones, [&](Eigen::Index i, int n) {
    step = std::min(step, step_in_cone(u.segment(i, n), d.segment(i, n)));
  });
  return step;
}

ConeScaling::ConeScaling(const std::vector<int>& cones, const VectorXd& s, const VectorXd& z) {
  for_each_cone(cones, [&](Eigen::Index i, int n) {
    // Scaling point of the normalised pair, and its square root as a boost.
    const double s_norm = lorentz_norm(s.segment(i, n)), z_norm = lorentz_norm(z.segment(i, n));
    const VectorXd s_unit = s.segment(i, n) / s_norm, z_unit = z.segment(i, n) / z_norm;
    const double gamma = std::sqrt((1 + s_unit.dot(z_unit)) / 2);
    const VectorXd w1 = (s_unit.tail(n - 1) - z_unit.tail(n - 1)) / (2 * gamma);
    const double w0 = std::sqrt(1 + w1.squaredNorm()), eta = std::sqrt(s_norm / z_norm);
    blocks_.emplace_back(eta * boost(w0, w1));
    inverses_.emplace_back(boost(w0, -w1) / eta);
  });
}

MatrixXd ConeScaling::times(const MatrixXd& right) const { return times_blocks(blocks_, right); }
MatrixXd ConeScaling::divide(const MatrixXd& right) const { return times_blocks(inverses_, right); }

}  // namespace thenar::internal
