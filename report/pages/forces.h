#pragma once

#include <vector>

#include "kinematics_fit/prediction.h"
#include "report/blocks.h"

namespace thenar {

/// Measured against predicted forces as arrows, one panel a posture, in the finger's flexion plane
/// and in the plane of its proximal and radial directions. Components must be proximal, dorsal,
/// radial. @param caption  says which predictions these are
[[nodiscard]] Json force_panels(const Prediction& prediction, const std::string& caption);

}  // namespace thenar
