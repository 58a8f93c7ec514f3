#pragma once

/// Reliability of a run: energy error, penetration, joints beyond their limits, neglected
/// restitution.

#include <string>
#include <vector>

#include "api/scenes/simulate_scene.h"
#include "dynamics/stepping/energy_balance.h"
#include "dynamics/stepping/limit_excess.h"

namespace thenar {

/// Returns the energy error in words: "0.075 mJ unaccounted for by 0.4 s, 0.095 % of 78.6 mJ total
/// energy exchanged".
[[nodiscard]] std::string energy_error_words(const FlowBalance& balance);

/// Returns the excess over a limit in words: "11.9 deg", "40 mm".
[[nodiscard]] std::string beyond_words(const PassedLimit& limit);

/// Returns the joints of a run that exceeded their limits.
[[nodiscard]] std::vector<PassedLimit> limits_passed(const SceneResult& scene);

/// Returns the largest stated restitution that the scene's method neglects [1]; 0: none.
[[nodiscard]] double restitution_ignored(const SceneResult& scene);

/// Returns warnings about a run, one sentence each.
[[nodiscard]] std::vector<std::string> scene_warnings(const SceneResult& scene);

/// Returns the reason why a run must not be used: contacts that were not solved, energy that does
/// not balance, or positions that are not finite; empty if it may. A run that was stopped on
/// request may be used.
[[nodiscard]] std::string refusal_of(const SceneResult& scene);

}  // namespace thenar
