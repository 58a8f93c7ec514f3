#pragma once

/// Numbers of a subject that no hand has: most often of another unit.

#include <string>
#include <vector>

#include "data/io/subject.h"

namespace thenar {

/// Lists doubts to check before a subject is trusted, a sentence each. The limits are our choices,
/// wide enough for hands of children and large robots:
///   digits     from tip to furthest axis 15 mm (5 mm a joint) to 0.5 m; the tip is nearer to its
///              last axis than to an earlier one, and not within 4 mm of it
///   joints     ranges above 4 degrees, unless a single joint is held evenly about 0; limits within
///              270 degrees; stiffness up to 50 N m/rad
///   strands    constant moment arms, the longest of 0.1 mm to 0.1 m; paths that pass their
///   furthest
///              axis within 0.8 to 50 mm, with points up to 1 m apart; 3 mm at least in one of all
///   muscles    0.5 N to 5 kN, fibres of 2 mm to 0.5 m, tendons up to 1 m, pennations up to 70
///              degrees, and not all below 0.6 degrees
///   segments   that move: up to 1.5 kg, the heaviest above 0.5 g; within 80 mm of their axes and
///              centres of mass; radii of 1 to 150 mm
[[nodiscard]] std::vector<std::string> subject_doubts(const Subject& subject);

}  // namespace thenar
