#include "contact/sliding_pivots.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

#include "base/numbers.h"
#include "solvers/linear_complementarity.h"

namespace thenar::internal {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double kSlideShare = 1e-9;  // Slip over the scale from which it has a direction [1]

/// f = fixed + z  in bearing rows,  and  G f + g = 0  gives the rows that follow.
struct States {
  VectorXd fixed;              // (rows)
  std::vector<Index> bearing;  // z >= 0 there, and u >= 0
  std::vector<Index> following;
  MatrixXd G;  // (rows, rows); those of following rows count
  VectorXd g;  // (rows)

  /// u = 0 in a row.
  void hold(const ScaledContacts& contacts, Index row) {
    following.push_back(row);
    G.row(row) = contacts.A().row(row);
    g[row] = contacts.b()[row];
  }
};

void add_interval(const ScaledContacts& contacts, const ScaledBlock& block, double f,
                  States& states) {
  const Index i = block.start;
  const bool ends_below = block.lower > -kInfinity, ends_above = block.upper < kInfinity;
  // One end: left to Lemke's algorithm. Otherwise fixed at an end that f has reached, or u = 0.
  if (ends_below && !ends_above) {
    states.fixed[i] = block.lower;
    states.bearing.push_back(i);
  } else if ((ends_below && f <= block.lower) || (ends_above && f >= block.upper)) {
    states.fixed[i] = ends_below && f <= block.lower ? block.lower : block.upper;
  } else {
    states.hold(contacts, i);
  }
}

void add_cone(const ScaledContacts& contacts, const ScaledBlock& block, const VectorXd& f,
              const VectorXd& u, States& states) {
  const Index i = block.start, tangents = block.rows - 1;
  // The normal is left to Lemke's algorithm.
  states.bearing.push_back(i);
  // Direction d of the slip, or against the friction where there is none.
  const VectorXd slip = u.segment(i + 1, tangents), drag = f.segment(i + 1, tangents);
  const double speed = slip.norm();
  const bool slides = speed > kSlideShare * contacts.scale(),
             sticks = !slides && f[i] > 0 && drag.norm() < block.mu * f[i];
  const VectorXd along = slides            ? VectorXd(slip / speed)
                         : drag.norm() > 0 ? VectorXd(-drag.normalized())
                                           : VectorXd::Zero(tangents);
  for (Index k = 0; k < tangents; ++k) {
    const Index row = i + 1 + k;
    if (sticks) {
      states.hold(contacts, row);
      continue;
    }
    // Slip: ft + mu fn d + mu fn (I - d d') ut / |ut| = 0: the part of ut along d turns nothing.
    states.following.push_back(row);
    states.G(row, row) = 1;
    states.G(row, i) = block.mu * along[k];
    if (!slides) continue;
    VectorXd across = -along[k] * along;
    across[k] += 1;
    across *= block.mu * std::max(0.0, f[i]) / speed;
    states.G.row(row) += across.transpose() * contacts.A().middleRows(i + 1, tangents);
    states.g[row] = across.dot(contacts.b().segment(i + 1, tangents));
  }
}

}  // namespace

bool pivot_sliding(const ScaledContacts& contacts, Eigen::Ref<VectorXd> f,
                   const Eigen::Ref<const VectorXd>& u, int& pivots) {
  // States of all rows at f and u.
  const Index n = contacts.rows();
  States states;
  states.fixed.setZero(n);
  states.G.setZero(n, n);
  states.g.setZero(n);
  for (const ScaledBlock& block : contacts.blocks())
    if (block.is_cone())
      add_cone(contacts, block, f, u, states);
    else
      add_interval(contacts, block, f[block.start], states);
  // Impulses f = F (z, 1): bearing rows are z, and following rows solve G f + g = 0.
  const auto unknowns = static_cast<Index>(states.bearing.size());
  MatrixXd F = MatrixXd::Zero(n, unknowns + 1);
  for (Index k = 0; k < unknowns; ++k) F(states.bearing[static_cast<std::size_t>(k)], k) = 1;
  F.col(unknowns) = states.fixed;
  if (!states.following.empty()) {
    const MatrixXd rows = states.G(states.following, Eigen::all);
    MatrixXd rest = rows * F;
    rest.col(unknowns) += states.g(states.following);
    const MatrixXd follow =
        -MatrixXd(rows(Eigen::all, states.following)).completeOrthogonalDecomposition().solve(rest);
    for (Index k = 0; k < follow.rows(); ++k)
      F.row(states.following[static_cast<std::size_t>(k)]) += follow.row(k);
  }
  // Linear complementarity problem of the bearing rows: z >= 0, and velocities >= 0.
  LinearComplementarity normals;
  const MatrixXd rows = contacts.A()(states.bearing, Eigen::all);
  normals.M = rows * F.leftCols(unknowns);
  normals.q = rows * F.col(unknowns) + contacts.b()(states.bearing);
  const ComplementaritySolution found = solve_complementarity(normals);
  pivots += found.pivots;
  if (found.status != Status::kSolved) return false;
  f = F.leftCols(unknowns) * found.z + F.col(unknowns);
  return true;
}

}  // namespace thenar::internal
