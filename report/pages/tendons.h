#pragma once

/// Pages of one digit: its tendons over postures, the bands of its hood, its motion.

#include <vector>

#include "api/simulate.h"
#include "api/tendon_infer.h"
#include "api/tendon_solve.h"
#include "kinematics_fit/bands/hood_comparison.h"
#include "report/picture/mesh_table.h"

namespace thenar {

/// Returns linked scenes of the net at some of the postures, bands coloured by tension, within the
/// skin where the sweep has the source of its subject. @param meshes  receives the meshes of the
/// skin
[[nodiscard]] Json net_scenes(const TendonSweepResult& sweep, std::size_t most, MeshTable& meshes);

/// Returns charts of the ratio of terminal to central slip over the angle that varies along a row,
/// one line for each row; and of the tension of every slip.
[[nodiscard]] Json slip_charts(const TendonSweepResult& sweep);

/// Returns a page with the net in space, its slips, moment arms and tip force over a sweep, or at
/// one posture.
[[nodiscard]] Json page_of(const TendonSweepResult& sweep);
[[nodiscard]] Json page_of(const TendonSolveResult& solution);

/// Returns a page with the verdict on every band, and proposed measurements. Defined in
/// tendon_infer.cpp.
[[nodiscard]] Json page_of(const InferNetResult& inference);

/// Returns a page with an animation of the digit; angles, tensions and energy over time. Defined in
/// motion.cpp.
[[nodiscard]] Json page_of(const DigitMotionResult& motion);

/// Returns a section with the extensor mechanism on every rung: the net in space and its slips over
/// a sweep, and the errors of predicted tip forces of every specimen over the time for a posture.
/// Defined in hood.cpp.
/// @param meshes  receives the meshes of the skin
[[nodiscard]] Json hood_page(const TendonSweepResult& sweep,
                             const std::vector<HoodComparison>& comparisons, MeshTable& meshes);

}  // namespace thenar
