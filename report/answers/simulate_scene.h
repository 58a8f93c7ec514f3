#pragma once

/// Text, fields and tables of simulated scenes.

#include <string>

#include "api/scenes/scene_account.h"
#include "report/fields.h"

namespace thenar {

/// Returns a text with final bodies, pairs that touched, energy, and the account of the run.
[[nodiscard]] std::string text_of(const SceneResult& scene);
[[nodiscard]] Fields fields_of(const SceneResult& scene);
/// Returns a table with a row for each instant: energies, places of all bodies that move, contacts.
[[nodiscard]] Table table_of(const SceneResult& scene);

/// Returns a text with a row for each run: varied numbers, largest slip, penetration, energy, cost.
[[nodiscard]] std::string text_of(const SceneSweepResult& sweep);
[[nodiscard]] Fields fields_of(const SceneSweepResult& sweep);
[[nodiscard]] Table table_of(const SceneSweepResult& sweep);

/// Returns the reason why a run of a sweep must not be used; empty if all may.
[[nodiscard]] std::string refusal_of(const SceneSweepResult& sweep);

/// Returns the name of the stepping method: "events", "time-stepping" ..
[[nodiscard]] std::string method_of(const SceneResult& scene);

}  // namespace thenar
