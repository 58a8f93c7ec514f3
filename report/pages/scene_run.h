#pragma once

/// Pages of simulated scenes.

#include "api/scenes/simulate_scene.h"
#include "report/blocks.h"
#include "report/picture/mesh_table.h"

namespace thenar {

/// Returns a page with an animation of the scene, contact forces as arrows; energies, places and
/// forces over time.
[[nodiscard]] Json page_of(const SceneResult& scene);

/// Returns the animation alone, with still pictures below, for pages of several scenes.
/// @param meshes    receives its meshes
/// @param instants  largest number of its instants
[[nodiscard]] Json film_of(const SceneResult& scene, Eigen::Index instants, MeshTable& meshes);

/// Returns a banner with the reliability of the run, and its assumptions.
[[nodiscard]] Json run_banner(const SceneResult& scene);

/// Returns a banner of a motion that may be used, with cautions. @param solved  why it may be used
[[nodiscard]] Json used_banner(const std::string& solved, const std::vector<std::string>& warnings);

/// Returns a page with slip, penetration and energy of all runs.
[[nodiscard]] Json page_of(const SceneSweepResult& sweep);

}  // namespace thenar
