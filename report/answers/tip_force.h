#pragma once

/// The force of a fingertip as words, fields and rows.

#include <string>

#include "api/tip_force.h"
#include "report/fields.h"

namespace thenar {

[[nodiscard]] std::string text_of(const TipForceResult& answer);
[[nodiscard]] Fields fields_of(const TipForceResult& answer);
/// Returns a table with a row for each posture.
[[nodiscard]] Table table_of(const TipForceResult& answer);

/// Returns a warning about the answer at a posture; may be empty.
[[nodiscard]] std::string note_of(const TipForceResult& answer, const TipForcePoint& point);

/// Returns the force along proximal, dorsal and radial of the tip, where it has bones [N] (3).
[[nodiscard]] Eigen::Vector3d force_along_tip(const TipForcePoint& point);

}  // namespace thenar
