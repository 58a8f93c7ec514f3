#pragma once

/// Errors of the trials that the extensor hood decides, muscle by muscle, and what a fit spends on
/// it.

#include <optional>
#include <string>
#include <vector>

#include "kinematics_fit/covariance.h"
#include "kinematics_fit/prediction.h"

namespace thenar {

/// Errors of the trials under one muscle alone.
struct MuscleError {
  std::string muscle;
  ForceError error;
};

struct HoodRowErrors {
  std::vector<MuscleError> muscles;  // in the order of the trials
  ForceError together;               // of the trials of all these muscles
};

/// Muscles that the hood of a digit divides by fractions, or that pull its net.
[[nodiscard]] std::vector<std::string> hood_muscles(const TendonDigit& digit);

/// Errors of the trials that load one of the muscles, and no other. A muscle whose measured forces
/// are all zero is left out.
/// @return empty if there is no such trial
[[nodiscard]] std::optional<HoodRowErrors> hood_row_errors(const Prediction& prediction,
                                                           const std::vector<std::string>& muscles);

/// Free numbers of a hood or net in a fit.
struct HoodCount {
  int entries = 0;       // of z: of the population, and of every specimen [1]
  double effective = 0;  // sum of 1 - sd^2 over them, sd the posterior's in prior sds: their part
                         // of Covariance::effective_parameters [1]
};

/// Counts the parameters hood/* and net/*.
[[nodiscard]] HoodCount count_hood(const Covariance& covariance);

}  // namespace thenar
