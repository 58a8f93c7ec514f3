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

// Violations of a bound below this count as none, over the scale [1]
constexpr double kBoundViolation = 1e-12;
constexpr double kLeastPrice = 1e-12;  // Least reduced cost that is worth a step
constexpr double kLeastPivot = 1e-12;  // Rates of basic variables below this count as none
constexpr double kStepTie = 1e-13;     // Steps whose lengths differ by less tie

/// The variable that enters, and which way it moves.
struct Entering {
  Index variable;
  double way;  // +1 or -1
};

/// Step of the entering variable: its length, and the basic variable that leaves, with its bound.
struct Step {
  double length;
  Index leaving;  // place in the basis; -1: none, the entering variable crosses to its other bound
  double bound;
};

class DenseSimplex {
 public:
  explicit DenseSimplex(const LinearProgram& program)
      : n_(program.A.cols()), rows_(program.A.rows()) {
    // Variables are x and the activities of the rows:  [A, -1] (x, z) = 0.
    M_.resize(rows_, n_ + rows_);
    M_ << program.A, -MatrixXd::Identity(rows_, rows_);
    lower_.resize(n_ + rows_);
    upper_.resize(n_ + rows_);
    lower_ << program.lower, program.row_lower;
    upper_ << program.upper, program.row_upper;
    cost_ = VectorXd::Zero(n_ + rows_);
    cost_.head(n_) = program.objective;
    // All at zero or the nearest bound, with the activities as basis.
    basis_.at = VectorXd::Zero(n_ + rows_).cwiseMax(lower_).cwiseMin(upper_);
    is_basic_.assign(static_cast<std::size_t>(n_ + rows_), false);
    for (Index i = 0; i < rows_; ++i) {
      basis_.basic.push_back(n_ + i);
      is_basic_[n_ + i] = true;
    }
  }

  SimplexVertex run() {
    const Index patient = 10 * (n_ + rows_), most = 100 * (n_ + rows_) + 1000;
    // Each step: basic variables, entering variable, leaving variable.
    for (Index step = 0; step < most; ++step) {
      place_basic();
      const VectorXd missing = missing_signs();
      // While basic variables miss their bounds, that is what is lessened.
      const bool feasible = missing.isZero(0);
      const std::optional<Entering> entering = choose(duals(feasible, missing), step > patient);
      if (!entering) return {feasible ? Status::kSolved : Status::kInfeasible, basis_};
      // How basic variables move with the entering one.
      const VectorXd rates = -entering->way * lu_.solve(VectorXd(M_.col(entering->variable)));
      const Step move = longest(*entering, rates, missing, step > patient);
      if (!std::isfinite(move.length))
        return {feasible ? Status::kUnbounded : Status::kStalled, basis_};
      take(*entering, move);
    }
    return {Status::kStalled, basis_};
  }

 private:
  [[nodiscard]] Index basic(Index k) const { return basis_.basic[k]; }

  /// Factors the basis and puts its variables where the others leave them.
  void place_basic() {
    MatrixXd B(rows_, rows_);
    for (Index k = 0; k < rows_; ++k) {
      B.col(k) = M_.col(basic(k));
      basis_.at(basic(k)) = 0;
    }
    if (rows_ == 0) return;
    lu_.compute(B);
    const VectorXd values = lu_.solve(VectorXd(-M_ * basis_.at));
    for (Index k = 0; k < rows_; ++k) basis_.at(basic(k)) = values(k);
  }

  /// +1 for a basic variable below its bound, -1 above, 0 inside.
  [[nodiscard]] VectorXd missing_signs() const {
    VectorXd signs = VectorXd::Zero(rows_);
    for (Index k = 0; k < rows_; ++k) {
      const double value = basis_.at(basic(k)), scale = std::max(1.0, std::abs(value));
      if (value < lower_(basic(k)) - kBoundViolation * scale) signs(k) = 1;
      if (value > upper_(basic(k)) + kBoundViolation * scale) signs(k) = -1;
    }
    return signs;
  }

  /// Returns for every variable the slope of the objective, or of the infeasibility while the basis
  /// is infeasible (variables and rows).
  [[nodiscard]] VectorXd duals(bool feasible, const VectorXd& missing) const {
    VectorXd basic_costs = missing, costs = VectorXd::Zero(n_ + rows_);
    if (feasible) costs = cost_;
    for (Index k = 0; feasible && k < rows_; ++k) basic_costs(k) = cost_(basic(k));
    if (rows_ == 0) return costs;
    const VectorXd y = lu_.transpose().solve(basic_costs);
    return costs - M_.transpose() * y;
  }

  [[nodiscard]] std::optional<Entering> choose(const VectorXd& d, bool bland_rule) const {
    std::optional<Entering> best;
    double steepest = kLeastPrice;
    for (Index j = 0; j < n_ + rows_; ++j) {
      // Dantzig's rule, or Bland's least index.
      if (is_basic_[j] || std::abs(d(j)) <= steepest) continue;
      const double bound = d(j) > 0 ? upper_(j) : lower_(j);
      if (basis_.at(j) == bound) continue;
      best = Entering{j, d(j) > 0 ? 1.0 : -1.0};
      if (bland_rule) return best;
      steepest = std::abs(d(j));
    }
    return best;
  }

  /// The bound that stops a basic variable; one that misses its bounds stops where it meets them.
  [[nodiscard]] double stop(Index k, double rate, double missing) const {
    if (missing > 0) return rate > 0 ? lower_(basic(k)) : -kInfinity;
    if (missing < 0) return rate < 0 ? upper_(basic(k)) : kInfinity;
    return rate > 0 ? upper_(basic(k)) : lower_(basic(k));
  }

  [[nodiscard]] Step longest(const Entering& entering, const VectorXd& rates,
                             const VectorXd& missing, bool bland_rule) const {
    const Index j = entering.variable;
    // The entering variable may cross to its other bound.
    Step best{upper_(j) - lower_(j), -1, entering.way > 0 ? upper_(j) : lower_(j)};
    for (Index k = 0; k < rows_; ++k) {
      if (std::abs(rates(k)) < kLeastPivot) continue;
      const double bound = stop(k, rates(k), missing(k));
      if (!std::isfinite(bound)) continue;
      const double length = std::max(0.0, (bound - basis_.at(basic(k))) / rates(k));
      // Ties: the largest rate, or by Bland's rule the least index.
      const bool tie = best.leaving >= 0 && std::abs(length - best.length) <= kStepTie;
      const bool preferred =
          tie && (bland_rule ? basic(k) < basic(best.leaving)
                             : std::abs(rates(k)) > std::abs(rates(best.leaving)));
      if (preferred || (!tie && length < best.length)) best = {length, k, bound};
    }
    return best;
  }

  void take(const Entering& entering, const Step& move) {
    const Index j = entering.variable;
    if (move.leaving < 0) {
      basis_.at(j) = move.bound;
      return;
    }
    const Index left = basic(move.leaving);
    basis_.at(left) = move.bound;
    is_basic_[left] = false;
    is_basic_[j] = true;
    basis_.basic[move.leaving] = j;
  }

  Index n_, rows_;
  MatrixXd M_;                     // [A, -1]        (r, n + r)
  VectorXd lower_, upper_, cost_;  // of x and z     (n + r)
  SimplexBasis basis_;
  std::vector<bool> is_basic_;
  Eigen::PartialPivLU<MatrixXd> lu_;
};

}  // namespace

SimplexVertex dense_simplex(const LinearProgram& program) { return DenseSimplex(program).run(); }

}  // namespace thenar::internal
