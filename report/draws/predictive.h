#pragma once

/// Forces predicted by a posterior, and measured forces.

#include <string>

#include <Eigen/Core>

#include "data/io/experiment.h"
#include "report/json.h"

namespace thenar {

/// Predicted and measured forces of one experiment.
struct PredictedForces {
  Experiment experiment;
  Eigen::MatrixXd replicated;  // draws with noise, one column a draw [N] (3 trials, draws)
  std::string what;            // "H01, in sample": the caption starts with it
};

/// Returns a chart of measured components over posterior predictive 50 and 95 % intervals, by
/// posture and tendon.
/// @throws InputError unless `replicated` has three rows for each trial.
[[nodiscard]] Json predictive_block(const PredictedForces& predicted);

}  // namespace thenar
