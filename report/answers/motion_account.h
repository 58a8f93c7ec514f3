#pragma once

/// Reliability of a motion, in words: energy that does not balance, surfaces that overlap, joints
/// beyond their limits, bounces left out.

#include <string>
#include <vector>

#include "api/scenes/simulate_scene.h"
#include "dynamics/stepping/energy_balance.h"
#include "dynamics/stepping/limit_excess.h"
#include "report/fields.h"

namespace thenar {

/// "0.075 mJ lost to nothing by 0.4 s, 0.095 % of 78.6 mJ turned over"
[[nodiscard]] std::string energy_error_words(const FlowBalance& balance);

/// "11.9 deg", "40 mm"
[[nodiscard]] std::string beyond_words(const PassedLimit& limit);

/// Each with `joint` and `beyond`, in rad or m.
[[nodiscard]] std::vector<Fields> limit_fields(const std::vector<PassedLimit>& limits);

/// Joints of a run that went beyond their limits.
[[nodiscard]] std::vector<PassedLimit> limits_passed(const SceneResult& scene);

/// The largest restitution that a scene states and that its method leaves out [1]; 0: none.
[[nodiscard]] double restitution_ignored(const SceneResult& scene);

/// A row for each measure of how far a run is to be believed.
[[nodiscard]] Table account_table(const SceneResult& scene);

}  // namespace thenar
