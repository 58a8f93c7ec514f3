#pragma once

/// Charts that diagnose a sampler or a model.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "posterior/run/posterior_summary.h"
#include "report/json.h"

namespace thenar {

/// Simulation-based calibration: ranks of true values among draws of simulated data.
struct CalibrationRanks {
  std::vector<std::string> names;     // names of the quantities (quantities)
  Eigen::MatrixXi rank;               // 0 .. draws (quantities, simulations)
  int draws = 0;                      // draws of each simulation
  std::vector<std::string> warnings;  // reasons to doubt the sampler, see RankCalibration::warnings
};

/// Error of one sampler over time.
struct SamplerCourse {
  std::string name;
  std::vector<double> seconds;  // wall time, warm-up included [s] (points)
  std::vector<double> error;  // RMS error of the posterior mean over entries, in posterior sds [1]
};

/// Returns a chart of the Pareto k of every observation, with names above the limit.
/// @throws InputError if there is not one name for each.
[[nodiscard]] Json pareto_chart(const LeftOutObservations& left_out);

/// Returns a chart of the empirical distribution of ranks minus the uniform one, with a
/// simultaneous 95 % band. Curves that leave the band are named, the others look alike.
/// @throws InputError if names and ranks disagree.  Source: [Sailynoja2022].
[[nodiscard]] Json calibration_chart(const CalibrationRanks& calibration);

/// Returns a chart of error over time on logarithmic axes, one line for each sampler.
[[nodiscard]] Json sampler_chart(const std::vector<SamplerCourse>& samplers);

}  // namespace thenar
