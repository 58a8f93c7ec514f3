#include "kinematics_fit/misfit.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/special_functions.h"
#include "kinematics_fit/fit_residuals.h"

namespace thenar {
namespace {

// Tail probability below which a misfit is beyond chance [1]
constexpr double kChanceProbability = 1e-4;
constexpr double kNoiseStraySds = 0.5;  // prior sd of the log of a factor on the noise [1]

/// Returns the sum of squared residuals without the robust loss, force by force.
double plain_squares(const Eigen::VectorXd& r, double robust_scale) {
  double sum = 0;
  for (Eigen::Index row = 0; row < r.size(); row += 3)
    sum += plain_residual(r.segment<3>(row), robust_scale).squaredNorm();
  return sum;
}

/// Counts force components of finite sd, of trials and of activation rows.
int fitted_numbers(const FitProblem& problem, int e) {
  const ExperimentPlan& plan = problem.plans()[e];
  return static_cast<int>((plan.sd.array() < HUGE_VAL).count()) +
         plan.measured * static_cast<int>(problem.activations_of(e).tasks.size());
}

}  // namespace

const char* const kMisfitAdvice =
    "Look at the sign and order of the force components, the hold, signs and units of moment arms "
    "and loads, the noise that was stated, and at parameters that are fixed but in doubt: free "
    "these";

Misfit compute_misfit(double chi_square, int numbers, double effective) {
  Misfit out;
  out.chi_square = chi_square;
  out.numbers = numbers;
  out.degrees_of_freedom = std::max(0.0, numbers - effective);
  // Report no misfit without degrees of freedom.
  constexpr double kMinFreedom = 1e-6;  // smallest number that is not rounding [1]
  if (out.degrees_of_freedom < kMinFreedom) return out;
  out.times_noise = std::sqrt(chi_square / out.degrees_of_freedom);
  out.tail = chi_square_tail(chi_square, out.degrees_of_freedom);
  out.beyond_chance = out.tail < kChanceProbability && out.times_noise > std::exp(kNoiseStraySds);
  return out;
}

std::vector<Misfit> misfits(const FitProblem& problem, const Eigen::VectorXd& z,
                            const Covariance& covariance) {
  std::vector<Misfit> all;
  for (int e = 0; e < static_cast<int>(problem.experiments().size()); ++e) {
    // Sum the residuals, and the leverage of the parameters that move this specimen.
    const Residuals data = data_residuals(problem, z, e, WithJacobian::kNo);
    const int forces = force_rows(problem, e);
    const double effective = covariance.leverage[e].leftCols(forces).squaredNorm();
    all.push_back(compute_misfit(plain_squares(data.r.head(forces), problem.robust_scale()),
                                 fitted_numbers(problem, e), effective));
  }
  return all;
}

std::string describe(const Misfit& misfit) {
  if (!misfit.beyond_chance) return "";
  return fmt::format(
      "the fit misses the forces by {:.1f} times the stated noise (chi-square {:.4g}, {:.1f} "
      "degrees of freedom), beyond chance: the model or the data are wrong. {}",
      misfit.times_noise, misfit.chi_square, misfit.degrees_of_freedom, kMisfitAdvice);
}

}  // namespace thenar
