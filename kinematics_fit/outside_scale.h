#pragma once

/// Scaling of a subject's digit to the size of a person, from lengths measured on the outside.

#include <array>

#include "base/enum_names.h"
#include "data/io/experiment.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// Size of the digit of every specimen before parameters act.
enum class Scaling {
  kSubject,  // size of the subject
  kOutside   // lengths stated by the specimen's experiment
};

inline constexpr std::array kScalingNames{EnumName{Scaling::kSubject, "subject"},
                                          EnumName{Scaling::kOutside, "outside"}};

/// Scales every bone of the digit to its measured length.
///
/// A point of the bone that runs from the joint c to the next joint, or to the tip, is mapped from
///   c + x d + r   to   c' + s x d + w r,     r perpendicular to d,
/// with d the bone's direction in the reference posture, c' the new position of the joint, and
///   s   measured length / length of the subject's bone; for a bone that was not measured, the
///       geometric mean over those that were;
///   w   linear along the bone between its values at the two joints: the geometric mean of the s of
///       the two bones that meet there; at the first joint and at the tip, the s of the single
///       bone. Breadths are not used, because no subject states its own.
/// Points on the base, the metacarpal of a finger, are scaled about the first joint by its w.
/// Directions of axes, angles, friction and fractions of a hood do not change. If all s and w are
/// equal, the digit is scaled uniformly about the first joint.
///
/// The length of a bone is the distance between the points of its joint and of the next one, or the
/// tip.
/// @throws InputError if the experiment states no length; names a segment that is no bone of this
/// digit; states a length outside of 0.5 to 2 times the subject's; gives the place of its load cell
/// in the subject's frame (`at_mm`); or if the digit has a net, or a tendon with moment arms but no
///         path.
[[nodiscard]] TendonDigit scale_to_outside(const TendonDigit& digit, const Experiment& experiment);

}  // namespace thenar
