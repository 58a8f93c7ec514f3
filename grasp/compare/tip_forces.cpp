#include <cmath>
#include <limits>

#include "base/angles.h"
#include "grasp/closing_drives.h"
#include "grasp/compare/abilities.h"
#include "grasp/quality/cone_program.h"

namespace thenar {
namespace {

constexpr int kDirections = 64;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Evenly spread on the sphere: a Fibonacci spiral.
Eigen::Vector3d direction(int i) {
  const double z = 1 - (2.0 * i + 1) / kDirections, r = std::sqrt(1 - z * z);
  const double turn = kPi * (3 - std::sqrt(5.0)) * i;
  return {r * std::cos(turn), r * std::sin(turn), z};
}

/// Rows and columns of the joints that move the tip; the programme over (s, u).
ConeProgram balance(const Eigen::MatrixXd& J, const Actuation& a, const std::vector<int>& joints) {
  const Eigen::Index n = J.cols(), m = a.B.cols();
  ConeProgram program;
  program.A = Eigen::MatrixXd::Zero(n, n + m);
  program.A.leftCols(n) = J.transpose() * J;
  program.b.resize(n);
  for (Eigen::Index r = 0; r < n; ++r) {
    program.A.row(r).tail(m) = -a.B.row(joints[static_cast<std::size_t>(r)]);
    program.b[r] = a.tau_0[joints[static_cast<std::size_t>(r)]];
  }
  std::vector<Eigen::VectorXd> rows;
  std::vector<double> limits;
  const auto add = [&](Eigen::Index i, double sign, double limit) {
    if (!std::isfinite(limit)) return;
    rows.emplace_back(Eigen::VectorXd::Zero(n + m));
    rows.back()[n + i] = sign;
    limits.push_back(sign * limit);
  };
  for (Eigen::Index i = 0; i < m; ++i) {
    add(i, 1, a.upper[i]);
    add(i, -1, a.lower[i]);
  }
  program.G.resize(static_cast<Eigen::Index>(rows.size()), n + m);
  program.h.resize(program.G.rows());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    program.G.row(static_cast<Eigen::Index>(r)) = rows[r];
    program.h[static_cast<Eigen::Index>(r)] = limits[r];
  }
  program.cones.assign(rows.size(), 1);
  return program;
}

/// max d'f [N]; NaN: no answer.
double farthest(ConeProgram program, const Eigen::MatrixXd& J, const Eigen::Vector3d& d) {
  program.c = Eigen::VectorXd::Zero(program.A.cols());
  program.c.head(J.cols()) = -J.transpose() * d;
  const ConeResult result = solve(program);
  return result.status == ConeStatus::kSolved ? -result.objective : kNone;
}

}  // namespace

TipForces tip_forces(const Hand& hand, const Eigen::VectorXd& q, int tip) {
  const HandLayout& layout = hand.layout();
  const HandTip& place = layout.tip_points[static_cast<std::size_t>(tip)];
  if (place.link < 0) return {kNone, kNone};
  const Eigen::MatrixXd all = hand.jacobian(q, place.link, place.p).bottomRows<3>();
  std::vector<int> joints;
  for (int j = 0; j < all.cols(); ++j)
    if (!all.col(j).isZero(1e-12)) joints.push_back(j);
  if (joints.empty()) return {0, 0};
  Eigen::MatrixXd J(3, static_cast<Eigen::Index>(joints.size()));
  for (std::size_t i = 0; i < joints.size(); ++i)
    J.col(static_cast<Eigen::Index>(i)) = all.col(joints[i]);

  const ConeProgram program = balance(J, hand.actuation(q), joints);
  const Eigen::Vector3d closing = all * ClosingDrives(layout).rates();
  TipForces forces{closing.isZero(1e-12) ? 0 : farthest(program, J, closing.normalized()), 0};
  for (int i = 0; i < kDirections; ++i) {
    const double reach = farthest(program, J, direction(i));
    if (std::isnan(reach)) return {forces.closing, kNone};
    forces.largest = std::max(forces.largest, reach);
  }
  return forces;
}

}  // namespace thenar
