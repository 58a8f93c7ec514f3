#pragma once

/// Pages of the demo: fits, posteriors, hoods and thumbs on real data.

#include <string>
#include <vector>

#include "report/picture/mesh_table.h"
#include "studies/demo/page_set.h"
#include "studies/questions/demo.h"

namespace thenar {

/// Returns the pages of the demo, a page for each question, the front page first. Page by page:
/// accuracy, forces and solvers; parameters and the finger; the population; posteriors, and each of
/// them; the hood; thumbs; scenes in motion; hands that grasp; pads.
/// @param seconds  duration of the demo [s]
[[nodiscard]] std::vector<SetPage> demo_pages(const DemoResult& demo, double seconds);

/// Returns a page with the errors of every posterior on every experiment, fitted or not, and
/// diagnostics of its chains.
[[nodiscard]] Json posteriors_at_a_glance(const std::vector<DemoPosterior>& posteriors);

/// Returns a page that compares thumbs: axes, feasible thumbtip forces, largest forces along the
/// thumb's own directions. @param meshes  receives the meshes of their skins
[[nodiscard]] Json thumb_page(const std::vector<DemoThumb>& thumbs, MeshTable& meshes);

/// The file of the front page.
inline constexpr const char* kFrontPage = "report.html";

/// Returns three pages: the wine glass that is squeezed out of a grasp; the thumb on a mug, with
/// the angle of its pad over the force of the grip; and how accurate the steppers are over
/// processor time.
[[nodiscard]] std::vector<SetPage> moving_scene_pages(const DemoMotion& motion);

/// Returns a line for each specimen: its relative error in sample and left out; and the place of
/// the page.
/// @param page  absolute path
[[nodiscard]] std::string demo_text(const DemoResult& demo, const std::string& page,
                                    double seconds);

}  // namespace thenar
