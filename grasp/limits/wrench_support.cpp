#include "grasp/limits/wrench_support.h"

#include <algorithm>

#include "base/error.h"
#include "base/numbers.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kMaxLeverage = 1e4;        // maximum ratio of a load to the limits of forces [1]
constexpr double kReachedShare = 1 - 1e-4;  // fraction of a value that counts as reaching it [1]

/// Returns the cone program of a force set, without an objective.
ConeProgram program_of(const ForceSet& forces) {
  return {
      VectorXd::Zero(forces.wrench.cols()), forces.A, forces.b, forces.G, forces.h, forces.cones};
}

void add_equalities(ConeProgram& program, const MatrixXd& rows, const VectorXd& values) {
  const Index old = program.A.rows();
  program.A.conservativeResize(old + rows.rows(), program.c.size());
  program.A.bottomRows(rows.rows()) = rows;
  program.b.conservativeResize(old + rows.rows());
  program.b.tail(rows.rows()) = values;
}

/// Returns the largest limit of a program; 0: it has none.
double max_limit(const ConeProgram& program) {
  return std::max(program.b.lpNorm<Eigen::Infinity>(), program.h.lpNorm<Eigen::Infinity>());
}

/// Returns whether the last variable reaches a value far above all limits. The program is scaled by
/// this value.
bool reaches_value(ConeProgram program, double value) {
  program.b /= value;
  program.h /= value;
  // Add one more limit: the scaled variable is at most 1.
  const Index n = program.c.size();
  internal::append_limit(program, Eigen::RowVectorXd::Unit(n, n - 1), 1);
  const ConeResult result = solve(program);
  return result.status == Status::kSolved && -result.objective > kReachedShare;
}

/// Marks a solution as unbounded if its value exceeds the limits by kMaxLeverage: structure then
/// supports the load except for rounding errors of normals, and the program is so badly scaled that
/// its solver may stall.
void mark_if_unlimited(const ConeProgram& program, double direction, ConeResult& solution) {
  const double max_value = kMaxLeverage * max_limit(program) / direction;
  if (max_value == 0) return;
  const bool beyond = solution.status == Status::kSolved
                          ? -solution.objective > max_value
                          : is_undecided(solution.status) && reaches_value(program, max_value);
  if (beyond) solution.status = Status::kUnbounded;
}

/// Reads the support from a solution; the value is minus the objective.
WrenchSupport support_of(const ForceSet& forces, const ConeResult& solution) {
  const VectorXd y = solution.x.head(forces.wrench.cols());
  WrenchSupport support{solution.status, kNaN, kNaN,
                        ScaledWrench::from_coordinates(forces.wrench * y),
                        contact_forces(forces, y),
                        // The dual objective bounds the value from above.
                        solution.residual};
  if (solution.status == Status::kSolved) {
    support.value = -solution.objective;
    support.bound = std::max(support.value, -solution.dual);
  }
  if (solution.status == Status::kUnbounded) support.value = support.bound = kInfinity;
  // Without a solution the forces have no meaningful wrench.
  if (solution.status != Status::kSolved) support.wrench = {};
  return support;
}

void require_direction(const VectorXd& d) {
  require(d.allFinite() && d.norm() > 0,
          "the direction must be finite and not zero, its norm is {}", d.norm());
}

}  // namespace

WrenchSupport wrench_support(const ForceSet& forces, const ScaledWrench& u) {
  require_direction(u.vector());
  ConeProgram program = program_of(forces);
  program.c = -forces.wrench.transpose() * u.vector();
  return support_of(forces, solve(program));
}

WrenchSupport support_along(const ForceSet& forces, const MatrixXd& rows, const VectorXd& start,
                            const VectorXd& direction) {
  require_direction(direction);
  require(rows.cols() == 6 && rows.rows() == start.size() && start.size() == direction.size(),
          "rows are {} x {}, wanted {} x 6, and the direction {}", rows.rows(), rows.cols(),
          start.size(), direction.size());
  require(rows.allFinite() && start.allFinite(), "rows and start must be finite");
  // Add a variable k to maximise.
  ConeProgram program = program_of(forces);
  internal::append_variable(program);
  program.c(program.c.size() - 1) = -1;
  // Constrain it:  rows W y - k direction = start.
  MatrixXd equalities(rows.rows(), program.c.size());
  equalities << rows * forces.wrench, -direction;
  add_equalities(program, equalities, start);
  ConeResult solution = solve(program);
  // Loads far above all limits are unbounded up to rounding.
  mark_if_unlimited(program, direction.norm(), solution);
  return support_of(forces, solution);
}

WrenchSupport load_margin(const ForceSet& forces, const ScaledWrench& d) {
  return support_along(forces, Eigen::Matrix<double, 6, 6>::Identity(), WrenchCoordinates::Zero(),
                       -resistible_part(forces, d).vector());
}

}  // namespace thenar
