#pragma once

/// The answers of `thenar tendon`.

#include <string>

#include <nlohmann/json.hpp>

#include "apps/tendon_question.h"

namespace thenar {

/// Why not to trust a point, in words; empty: nothing.
[[nodiscard]] std::string warning_of(const DigitPoint& point);

/// What to beware of in the force of the tip, in words; empty: nothing.
[[nodiscard]] std::string tip_note(const TipForce& tip);

/// Force of the tip along its proximal, dorsal and radial directions [N] (3).
[[nodiscard]] Eigen::Vector3d force_in_tip_axes(const TendonCase& at, const DigitPoint& point);

/// One posture: bands, nodes, contacts, slips, torques, tip force, status.
[[nodiscard]] nlohmann::ordered_json json_of(const TendonCase& at, const DigitPoint& point);
void print_text(const TendonCase& at, const DigitPoint& point);

}  // namespace thenar
