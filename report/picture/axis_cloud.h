#pragma once

/// Joint axes of many draws as a cloud about the bones.

#include <optional>
#include <string>
#include <vector>

#include "kinematics_fit/model/fit_parameters.h"
#include "report/blocks.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// Digits of one kind of draws: of the population, or of one specimen.
struct AxisCloud {
  std::string name;                        // "population", "H01"
  std::vector<TendonModel<double>> drawn;  // one model for each draw; 100 to 300 look well
};

/// Returns the digits at `most` evenly spread draws.
/// @param moving  indices in parameters.all of the rows of `values`; all others stay at their means
/// @param values  [SI] (moving, draws)
[[nodiscard]] AxisCloud axis_cloud(const std::string& name, const TendonDigit& digit,
                                   const FitParameters& parameters, const std::vector<int>& moving,
                                   const Eigen::Ref<const Eigen::MatrixXd>& values,
                                   Eigen::Index most = 150);

/// Returns a picture: bones, the axes before the fit by name, the clouds, and the true axes if
/// known.
/// @param start  the digit before the fit
/// @param truth  true digit behind simulated data
/// @param q      posture [rad]
[[nodiscard]] Json axis_cloud_picture(const TendonDigit& start, const Eigen::VectorXd& q,
                                      const std::vector<AxisCloud>& clouds,
                                      const std::optional<TendonModel<double>>& truth,
                                      const std::string& caption);

}  // namespace thenar
