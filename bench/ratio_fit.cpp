// The full fit of one finger, 115 coordinates to 72 forces, against the second that it may take.

#include <algorithm>
#include <chrono>
#include <vector>

#include <fmt/format.h>

#include "bench/ratios.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar::bench {

Row ratio_fit() {
  constexpr double kAllowed = 1e6;  // [us]
  constexpr int kRuns = 9;
  const FitProblem problem = build_problem(sample::finger_inputs("an_chao_middle", {"H01"}));
  std::vector<double> times;
  Solution fit;
  for (int run = 0; run < kRuns; ++run) {
    fit = solve(least_squares(problem), Eigen::VectorXd::Zero(problem.size()));
    times.push_back(1e6 * fit.seconds);
  }
  std::nth_element(times.begin(), times.begin() + kRuns / 2, times.end());

  Row row;
  row.name = fmt::format("fit of a finger, {} evaluations, in 1 s", fit.evaluations);
  row.ours = times[kRuns / 2];
  row.rival = kAllowed;
  row.ratio = kAllowed / row.ours;
  row.required = 1;
  row.error = fit.status == Status::kSolved ? 0 : 1;
  return row;
}

}  // namespace thenar::bench
