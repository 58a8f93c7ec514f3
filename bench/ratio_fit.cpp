// Fits against the time that they may take, and their Jacobians against jets.

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "bench/ratios.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar::bench {
namespace {

/// A fit against a limit.
Row time_of_fit(const char* what, const FitProblem& problem, int runs, double allowed_us) {
  std::vector<double> times;
  Solution fit;
  for (int run = 0; run < runs; ++run) {
    fit = solve(least_squares(problem), Eigen::VectorXd::Zero(problem.size()));
    times.push_back(1e6 * fit.seconds);
  }
  std::nth_element(times.begin(), times.begin() + runs / 2, times.end());
  Row row;
  row.name =
      fmt::format("{}, {} evaluations, in {:.0f} s", what, fit.evaluations, allowed_us / 1e6);
  row.ours = times[static_cast<std::size_t>(runs / 2)];
  row.rival = allowed_us;
  row.ratio = allowed_us / row.ours;
  row.required = 1;
  row.error = fit.status == Status::kSolved ? 0 : 1;
  return row;
}

}  // namespace

Row ratio_fit() {
  return time_of_fit("fit of a finger",
                     build_problem(sample::finger_inputs("an_chao_middle", {"H01"})), 9, 1e6);
}

Row ratio_fit_of_many() {
  return time_of_fit("fit of 64 fingers", sample::noisy_copies(64), 1, 1e7);
}

Row ratio_fit_jacobian() {
  const FitProblem problem = build_problem(sample::finger_inputs("an_chao_middle", {"H01"}));
  const Eigen::VectorXd u = Eigen::VectorXd::Zero(problem.parameters().coordinates());
  const auto jacobian = [&](const ForceKernel* kernel) {
    return force_jacobian(problem.digit(), problem.parameters(), problem.plans().front(), u,
                          kernel);
  };
  Duel duel{"Jacobian of a finger, against jets", {}, {}, 3, 0, 1e-10};
  const Eigen::MatrixXd J = jacobian(nullptr).J;
  duel.error = (jacobian(problem.kernel_of(0)).J - J).norm() / J.norm();
  duel.ours = [&] { keep(jacobian(problem.kernel_of(0))); };
  duel.rival = [&] { keep(jacobian(nullptr)); };
  return measure(duel);
}

}  // namespace thenar::bench
