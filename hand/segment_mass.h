#pragma once

/// Mass of a segment: measured, or a solid capsule of soft tissue about its bone.

#include "data/io/subject.h"
#include "hand/skeleton.h"

namespace thenar {

/// Mean density of a hand segment [kg/m^3]. Source: [Dempster1955] hand, 1.16 kg/l.
inline constexpr double kHandDensity = 1160;

/// Mass, centre and inertia of one segment at the reference posture.
/// Measured values win; else a capsule from `proximal` to `distal` of `radius` and
/// kHandDensity; all zero if the subject says neither. A measured mass without moments of inertia
/// takes those of the capsule, scaled to the mass; without a radius they stay unknown, which
/// LinkMass::no_inertia tells.
[[nodiscard]] LinkMass segment_mass(const Segment& segment);

/// Mass of two bodies moving as one (parallel-axis theorem).
[[nodiscard]] LinkMass combine(const LinkMass& a, const LinkMass& b);

/// The same body after a displacement.
[[nodiscard]] LinkMass displace(const Pose<double>& X, const LinkMass& body);

}  // namespace thenar
