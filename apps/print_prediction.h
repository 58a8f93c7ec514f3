#pragma once

/// Predicted forces beside the measured ones, as a table and as JSON.

#include <string>

#include <nlohmann/json.hpp>

#include "kinematics_fit/prediction.h"

namespace thenar {

/// Which parameters predict, and whether the fit has seen the specimen.
enum class PredictedBy {
  kOwn,            // its own, which were fitted
  kOwnPopulation,  // the population's, which it was a part of
  kStranger        // the population's; it was not fitted
};

/// @param specimen    index in fitted.specimens(), or -1
/// @param population  asked for, also of a fitted specimen
[[nodiscard]] PredictedBy predicted_by(int specimen, bool population);

[[nodiscard]] nlohmann::json prediction_json(const Prediction& prediction,
                                             const std::string& specimen, PredictedBy by);

void print_prediction(const Prediction& prediction, const Experiment& experiment, PredictedBy by);

}  // namespace thenar
