#pragma once

/// The page of the demo: fits, posteriors, hoods and thumbs on real data.

#include <string>
#include <vector>

#include "api/demo.h"
#include "report/blocks.h"
#include "report/scene/mesh_table.h"

namespace thenar {

/// All sections in one page: accuracy, forces, solvers, parameters, the finger, its population, the
/// hood, thumbs, posteriors, the study of a thumb and scenes in motion; `more` sections stand at
/// its end.
/// @param seconds  that the whole took [s]
[[nodiscard]] Json demo_page(const DemoResult& demo, const Json& more, double seconds);

/// Errors of every posterior on every experiment, seen or not, and figures of its chains.
[[nodiscard]] Json posteriors_at_a_glance(const std::vector<DemoPosterior>& posteriors);

/// Thumbs side by side: axes, feasible thumbtip forces, largest forces along the thumb's own
/// directions.
[[nodiscard]] Json thumb_page(const std::vector<DemoThumb>& thumbs);

/// Pages of their own beside the page of the demo, with charts of all that was measured.
inline constexpr const char* kGlassPage = "wine_glass.html";
inline constexpr const char* kThumbPage = "thumb_mug.html";

/// The wine glass that is squeezed out of a grasp; the thumb on a mug, the angle of its pad over
/// the force of the grip; and how accurate the steppers are over processor time. Three sections.
/// @param meshes  gets those that the films show
[[nodiscard]] Json moving_scene_sections(const DemoMotion& motion, MeshTable& meshes);

/// A line for each specimen: its relative error in sample and left out; and where the page is.
/// @param page  absolute path
[[nodiscard]] std::string demo_text(const DemoResult& demo, const std::string& page,
                                    double seconds);

}  // namespace thenar
