#pragma once

/// The part of `thenar simulate` that moves scenes.

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "api/simulate_scene.h"
#include "apps/outputs.h"

namespace thenar {

/// What scenes alone are asked with.
struct SceneArguments {
  std::string method;
  std::optional<double> step_ms;
  std::vector<SceneVariation> vary;
};

/// `NAME=from:to:count`. @throws InputError if the text is none.
[[nodiscard]] SceneVariation parse_scene_variation(const std::string& text);

/// --method, --step-ms, --vary
void add_scene_options(CLI::App& command, SceneArguments& options);

/// Simulates, delivers, and refuses as the other answers of `simulate` do.
void simulate_and_deliver(const SceneRequest& request, const Outputs& outputs);

}  // namespace thenar
