#pragma once

/// Force of a fingertip as text, fields and rows.

#include <string>

#include "api/tip_force.h"
#include "report/fields.h"

namespace thenar {

[[nodiscard]] std::string text_of(const TipForceResult& answer);
[[nodiscard]] Fields fields_of(const TipForceResult& answer);
/// Returns a table with a row for each posture.
[[nodiscard]] Table table_of(const TipForceResult& answer);

/// Returns a warning about the result at a posture; may be empty.
[[nodiscard]] std::string note_of(const TipForceResult& answer, const TipForcePoint& point);

/// Returns the force along the tip's proximal, dorsal and radial axes [N] (3). The point must have
/// tip axes.
[[nodiscard]] Eigen::Vector3d force_along_tip(const TipForcePoint& point);

}  // namespace thenar
