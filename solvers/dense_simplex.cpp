#include "solvers/dense_simplex.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/LU>

#include "base/numbers.h"

namespace thenar::internal {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Relative violation of a bound that counts as none [1]
constexpr double kBoundViolation = 1e-12;
constexpr double kMinReducedCost = 1e-12;  // minimum reduced cost of an entering variable
constexpr double kMinRate = 1e-12;         // rate of a basic variable below which it does not move
constexpr double kStepTie = 1e-13;         // difference in length below which steps tie

/// Entering variable and its direction of motion.
struct Entering {
  Index variable;
  double sign;  // +1 or -1
};

/// Step of the entering variable, with the leaving variable and its bound.
struct Step {
  double length;
  Index leaving;  // position in the basis; -1: the entering variable moves to its other bound
  double bound;   // bound at which the leaving variable ends
};

/// State of the simplex method.
class DenseSimplex {
 public:
  explicit DenseSimplex(const LinearProgram& program)
      : n_(program.A.cols()), rows_(program.A.rows()) {
    // Set up the variables x and row activities z:  [A, -1] (x, z) = 0.
    M_.resize(rows_, n_ + rows_);
    M_ << program.A, -MatrixXd::Identity(rows_, rows_);
    lower_.resize(n_ + rows_);
    upper_.resize(n_ + rows_);
    lower_ << program.lower, program.row_lower;
    upper_ << program.upper, program.row_upper;
    cost_ = VectorXd::Zero(n_ + rows_);
    cost_.head(n_) = program.objective;
    // Start with x at zero or the nearest bound, and the activities as basis.
    basis_.values = VectorXd::Zero(n_ + rows_).cwiseMax(lower_).cwiseMin(upper_);
    is_basic_.assign(static_cast<std::size_t>(n_ + rows_), false);
    for (Index i = 0; i < rows_; ++i) {
      basis_.basic.push_back(n_ + i);
      is_basic_[n_ + i] = true;
    }
  }

  SimplexVertex run() {
    const Index bland_after = 10 * (n_ + rows_), max_steps = 100 * (n_ + rows_) + 1000;
    // In each step, compute basic values, then choose entering and leaving variables.
    for (Index step = 0; step < max_steps; ++step) {
      compute_basic_values();
      const VectorXd violations = violation_signs();
      // In phase 1, reduce the violations of the basic variables.
      const bool feasible = violations.isZero(0);
      const std::optional<Entering> entering =
          choose_entering(reduced_costs(feasible, violations), step > bland_after);
      if (!entering) return {feasible ? Status::kSolved : Status::kInfeasible, basis_};
      // Rates of the basic variables, and the ratio test.
      const VectorXd rates = -entering->sign * lu_.solve(VectorXd(M_.col(entering->variable)));
      const Step move = ratio_test(*entering, rates, violations, step > bland_after);
      if (!std::isfinite(move.length))
        return {feasible ? Status::kUnbounded : Status::kStalled, basis_};
      pivot(*entering, move);
    }
    return {Status::kStalled, basis_};
  }

 private:
  [[nodiscard]] Index basic(Index k) const { return basis_.basic[k]; }

  /// Factorises the basis and computes the values of the basic variables.
  void compute_basic_values() {
    MatrixXd B(rows_, rows_);
    for (Index k = 0; k < rows_; ++k) {
      B.col(k) = M_.col(basic(k));
      basis_.values(basic(k)) = 0;
    }
    if (rows_ == 0) return;
    lu_.compute(B);
    const VectorXd values = lu_.solve(VectorXd(-M_ * basis_.values));
    for (Index k = 0; k < rows_; ++k) basis_.values(basic(k)) = values(k);
  }

  /// Returns +1 for a basic variable below its bound, -1 above, 0 inside.
  [[nodiscard]] VectorXd violation_signs() const {
    VectorXd signs = VectorXd::Zero(rows_);
    for (Index k = 0; k < rows_; ++k) {
      const double value = basis_.values(basic(k)), scale = std::max(1.0, std::abs(value));
      if (value < lower_(basic(k)) - kBoundViolation * scale) signs(k) = 1;
      if (value > upper_(basic(k)) + kBoundViolation * scale) signs(k) = -1;
    }
    return signs;
  }

  /// Returns the reduced costs: of the objective, or of the sum of violations in phase 1 (n + r).
  [[nodiscard]] VectorXd reduced_costs(bool feasible, const VectorXd& violations) const {
    VectorXd basic_costs = violations, costs = VectorXd::Zero(n_ + rows_);
    if (feasible) costs = cost_;
    for (Index k = 0; feasible && k < rows_; ++k) basic_costs(k) = cost_(basic(k));
    if (rows_ == 0) return costs;
    const VectorXd y = lu_.transpose().solve(basic_costs);
    return costs - M_.transpose() * y;
  }

  /// Chooses the entering variable from the reduced costs d; none at an optimum.
  [[nodiscard]] std::optional<Entering> choose_entering(const VectorXd& d, bool bland_rule) const {
    std::optional<Entering> best;
    double steepest = kMinReducedCost;
    for (Index j = 0; j < n_ + rows_; ++j) {
      // Dantzig's rule, or Bland's least index.
      if (is_basic_[j] || std::abs(d(j)) <= steepest) continue;
      const double bound = d(j) > 0 ? upper_(j) : lower_(j);
      if (basis_.values(j) == bound) continue;
      best = Entering{j, d(j) > 0 ? 1.0 : -1.0};
      if (bland_rule) return best;
      steepest = std::abs(d(j));
    }
    return best;
  }

  /// Returns the bound that blocks a basic variable; one that violates its bounds is blocked where
  /// it reaches them.
  [[nodiscard]] double blocking_bound(Index k, double rate, double violation) const {
    if (violation > 0) return rate > 0 ? lower_(basic(k)) : -kInfinity;
    if (violation < 0) return rate < 0 ? upper_(basic(k)) : kInfinity;
    return rate > 0 ? upper_(basic(k)) : lower_(basic(k));
  }

  /// Finds the longest step that no basic variable blocks.
  [[nodiscard]] Step ratio_test(const Entering& entering, const VectorXd& rates,
                                const VectorXd& violations, bool bland_rule) const {
    const Index j = entering.variable;
    // The entering variable may move to its other bound.
    Step best{upper_(j) - lower_(j), -1, entering.sign > 0 ? upper_(j) : lower_(j)};
    for (Index k = 0; k < rows_; ++k) {
      if (std::abs(rates(k)) < kMinRate) continue;
      const double bound = blocking_bound(k, rates(k), violations(k));
      if (!std::isfinite(bound)) continue;
      const double length = std::max(0.0, (bound - basis_.values(basic(k))) / rates(k));
      // Ties: the largest rate or, by Bland's rule, the least index.
      const bool tie = best.leaving >= 0 && std::abs(length - best.length) <= kStepTie;
      const bool preferred =
          tie && (bland_rule ? basic(k) < basic(best.leaving)
                             : std::abs(rates(k)) > std::abs(rates(best.leaving)));
      if (preferred || (!tie && length < best.length)) best = {length, k, bound};
    }
    return best;
  }

  /// Exchanges the entering and the leaving variable.
  void pivot(const Entering& entering, const Step& move) {
    const Index j = entering.variable;
    if (move.leaving < 0) {
      basis_.values(j) = move.bound;
      return;
    }
    const Index left = basic(move.leaving);
    basis_.values(left) = move.bound;
    is_basic_[left] = false;
    is_basic_[j] = true;
    basis_.basic[move.leaving] = j;
  }

  Index n_, rows_;
  MatrixXd M_;                     // [A, -1]        (r, n + r)
  VectorXd lower_, upper_, cost_;  // bounds and costs of x and z     (n + r)
  SimplexBasis basis_;
  std::vector<bool> is_basic_;
  Eigen::PartialPivLU<MatrixXd> lu_;
};

}  // namespace

SimplexVertex dense_simplex(const LinearProgram& program) { return DenseSimplex(program).run(); }

}  // namespace thenar::internal
