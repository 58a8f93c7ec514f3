#include "contact/sliding_pivots.h"

#include <algorithm>

#include <Eigen/QR>

#include "base/numbers.h"
#include "solvers/linear_complementarity.h"

namespace thenar::internal {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double kMinSlipRatio = 1e-9;  // slip over the scale above which a contact slides [1]

/// Roles of all rows in a step: f = fixed + z in loaded rows, and G f + g = 0 in dependent rows.
struct RowStates {
  VectorXd fixed;                // fixed part of the impulses (rows)
  std::vector<Index> loaded;     // rows with the complementarity  z >= 0 _|_ u >= 0
  std::vector<Index> dependent;  // rows that are eliminated
  MatrixXd G;                    // only dependent rows are used (rows, rows)
  VectorXd g;                    // only dependent rows are used (rows)

  /// Makes a row dependent, with the equation u = 0.
  void add_zero_velocity_row(const ScaledContacts& contacts, Index row) {
    dependent.push_back(row);
    G.row(row) = contacts.A().row(row);
    g[row] = contacts.b()[row];
  }
};

void add_interval(const ScaledContacts& contacts, const ScaledBlock& block, double f,
                  RowStates& states) {
  const Index i = block.start;
  const bool ends_below = block.lower > -kInfinity, ends_above = block.upper < kInfinity;
  // One bound: a loaded row. Otherwise fixed at a bound that f has reached, or u = 0.
  if (ends_below && !ends_above) {
    states.fixed[i] = block.lower;
    states.loaded.push_back(i);
  } else if ((ends_below && f <= block.lower) || (ends_above && f >= block.upper)) {
    states.fixed[i] = ends_below && f <= block.lower ? block.lower : block.upper;
  } else {
    states.add_zero_velocity_row(contacts, i);
  }
}

void add_cone(const ScaledContacts& contacts, const ScaledBlock& block, const VectorXd& f,
              const VectorXd& u, RowStates& states) {
  const Index i = block.start, tangents = block.rows - 1;
  // The normal row is loaded.
  states.loaded.push_back(i);
  // Direction d of the slip, or opposite to the friction if there is no slip.
  const VectorXd slip = u.segment(i + 1, tangents), friction = f.segment(i + 1, tangents);
  const double speed = slip.norm();
  const bool slides = speed > kMinSlipRatio * contacts.scale(),
             sticks = !slides && f[i] > 0 && friction.norm() < block.mu * f[i];
  const VectorXd along = slides                ? VectorXd(slip / speed)
                         : friction.norm() > 0 ? VectorXd(-friction.normalized())
                                               : VectorXd::Zero(tangents);
  for (Index k = 0; k < tangents; ++k) {
    const Index row = i + 1 + k;
    if (sticks) {
      states.add_zero_velocity_row(contacts, row);
      continue;
    }
    // Slip: ft + mu fn d + mu fn (I - d d') ut / |ut| = 0, as only ut across d rotates d.
    states.dependent.push_back(row);
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

bool take_pivoting_step(const ScaledContacts& contacts, Eigen::Ref<VectorXd> f,
                        const Eigen::Ref<const VectorXd>& u, int& pivots) {
  // Determine the roles of all rows at f and u.
  const Index n = contacts.rows();
  RowStates states;
  states.fixed.setZero(n);
  states.G.setZero(n, n);
  states.g.setZero(n);
  for (const ScaledBlock& block : contacts.blocks())
    if (block.is_cone())
      add_cone(contacts, block, f, u, states);
    else
      add_interval(contacts, block, f[block.start], states);
  // Impulses f = F (z, 1): eliminate the dependent rows by G f + g = 0.
  const auto unknowns = static_cast<Index>(states.loaded.size());
  MatrixXd F = MatrixXd::Zero(n, unknowns + 1);
  for (Index k = 0; k < unknowns; ++k) F(states.loaded[k], k) = 1;
  F.col(unknowns) = states.fixed;
  if (!states.dependent.empty()) {
    const MatrixXd rows = states.G(states.dependent, Eigen::all);
    MatrixXd rhs = rows * F;
    rhs.col(unknowns) += states.g(states.dependent);
    const MatrixXd solution =
        -MatrixXd(rows(Eigen::all, states.dependent)).completeOrthogonalDecomposition().solve(rhs);
    for (Index k = 0; k < solution.rows(); ++k) F.row(states.dependent[k]) += solution.row(k);
  }
  // Solve the linear complementarity problem of the loaded rows.
  LinearComplementarity normals;
  const MatrixXd rows = contacts.A()(states.loaded, Eigen::all);
  normals.M = rows * F.leftCols(unknowns);
  normals.q = rows * F.col(unknowns) + contacts.b()(states.loaded);
  const ComplementaritySolution found = solve_complementarity(normals);
  pivots += found.pivots;
  if (found.status != Status::kSolved) return false;
  f = F.leftCols(unknowns) * found.z + F.col(unknowns);
  return true;
}

}  // namespace thenar::internal
