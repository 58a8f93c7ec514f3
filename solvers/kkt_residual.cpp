#include "solvers/kkt_residual.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Variables or rows with their bounds.
struct Bounded {
  const VectorXd &value, &lower, &upper;

  [[nodiscard]] double violation() const {
    double worst = 0;
    for (Index i = 0; i < value.size(); ++i) {
      const double below = (lower(i) - value(i)) / std::max(1.0, std::abs(lower(i)));
      const double above = (value(i) - upper(i)) / std::max(1.0, std::abs(upper(i)));
      if (std::isnan(value(i))) return std::numeric_limits<double>::quiet_NaN();
      if (std::isfinite(lower(i))) worst = std::max(worst, below);
      if (std::isfinite(upper(i))) worst = std::max(worst, above);
    }
    return worst;
  }

  /// Sets multipliers of infinite bounds to zero, and returns the sum of the others times the
  /// distance to their bounds.
  [[nodiscard]] double complementarity(VectorXd& prices) const {
    double sum = 0;
    for (Index i = 0; i < value.size(); ++i) {
      const double bound = prices(i) > 0 ? upper(i) : lower(i);
      if (!std::isfinite(bound)) prices(i) = 0;
      if (prices(i) != 0) sum += std::abs(prices(i) * (bound - value(i)));
    }
    return sum;
  }
};

VectorXd row_values(const NonlinearProgram& program, const VectorXd& x) {
  return program.row_lower.size() > 0 ? program.constraints(x) : VectorXd(0);
}

}  // namespace

KktResidual kkt_residual(const NonlinearProgram& program, const VectorXd& x, VectorXd rows,
                         VectorXd bounds) {
  // Violation, and complementarity of bounds and rows.
  const VectorXd values = row_values(program, x);
  KktResidual result;
  result.violation = violation(program, x);
  result.complementarity =
      Bounded{x, program.lower, program.upper}.complementarity(bounds) +
      Bounded{values, program.row_lower, program.row_upper}.complementarity(rows);
  // Gradient of the Lagrangian.
  VectorXd d = program.gradient(x) + bounds;
  if (rows.size() > 0) d += program.jacobian(x).transpose() * rows;
  result.stationarity = d.size() > 0 ? d.cwiseAbs().maxCoeff() : 0;
  if (!d.allFinite()) result.stationarity = std::numeric_limits<double>::quiet_NaN();
  return result;
}

double gradient_scale(const NonlinearProgram& program, const VectorXd& x, const VectorXd& rows,
                      const VectorXd& bounds) {
  VectorXd terms = program.gradient(x).cwiseAbs() + bounds.cwiseAbs();
  if (rows.size() > 0) terms += program.jacobian(x).cwiseAbs().transpose() * rows.cwiseAbs();
  return terms.size() > 0 ? max_or_nan(terms) : 0;
}

double violation(const NonlinearProgram& program, const VectorXd& x) {
  const VectorXd values = row_values(program, x);
  const double rows = Bounded{values, program.row_lower, program.row_upper}.violation();
  const double bounds = Bounded{x, program.lower, program.upper}.violation();
  return max_or_nan(rows, bounds);
}

}  // namespace thenar
