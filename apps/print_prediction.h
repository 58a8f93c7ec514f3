#pragma once

/// Predicted forces beside the measured ones, as a table and as JSON.

#include <string>

#include <nlohmann/json.hpp>

#include "kinematics_fit/prediction.h"

namespace thenar {

/// @param fitted  whether the specimen is one that was fitted
[[nodiscard]] nlohmann::json prediction_json(const Prediction& prediction,
                                             const std::string& specimen, bool fitted);

void print_prediction(const Prediction& prediction, const Experiment& experiment, bool fitted);

}  // namespace thenar
