#pragma once

/// Errors of the trials that depend on the extensor hood, by muscle, and the number of parameters
/// that a fit uses for it.

#include <optional>
#include <string>
#include <vector>

#include "kinematics_fit/covariance.h"
#include "kinematics_fit/prediction.h"

namespace thenar {

/// Errors of the trials that load one muscle only.
struct MuscleError {
  std::string muscle;
  ForceError error;
};

/// Errors of the trials that load one muscle of the hood.
struct HoodRowErrors {
  std::vector<MuscleError> muscles;  // errors by muscle, in the order of the trials
  ForceError total;                  // error over the trials of all these muscles
};

/// Returns the muscles whose force the hood distributes by fractions, or that pull the net.
[[nodiscard]] std::vector<std::string> hood_muscles(const TendonDigit& digit);

/// Computes the errors of the trials that load one of the muscles, and no other. A muscle whose
/// measured forces are all zero is left out.
/// @return nothing if there is no such trial
[[nodiscard]] std::optional<HoodRowErrors> hood_row_errors(const Prediction& prediction,
                                                           const std::vector<std::string>& muscles);

/// Number of free parameters of a hood or net in a fit.
struct HoodCount {
  int entries = 0;       // number of entries of z, of the population and of every specimen [1]
  double effective = 0;  // sum of 1 - sd^2 over the entries, with posterior sds in prior sds: their
                         // part of Covariance::effective_parameters [1]
};

/// Counts the parameters hood/* and net/*.
[[nodiscard]] HoodCount count_hood(const Covariance& covariance);

}  // namespace thenar
