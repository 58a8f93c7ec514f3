#pragma once

/// The digit of a subject in the size of a person, by what can be measured on the outside.

#include "data/io/experiment.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// Size of the digit of every specimen before parameters act.
enum class Scaling {
  kSubject,  // that of the subject
  kOutside   // by the lengths that its experiment states
};

/// "subject" or "outside". @throws InputError naming these for anything else.
[[nodiscard]] Scaling scaling_named(const std::string& name);

/// The digit, every bone of it in the size that was measured.
///
/// A point of the bone that runs from the joint c to the next joint, or to the tip, goes from
///   c + x d + r   to   c' + s x d + w r,     r square to d,
/// with d the bone's direction at the reference posture, c' where the joint comes to lie, and
///   s = measured length / length of the subject's bone; of a bone that was not measured the
///       geometric mean over those that were;
///   w   straight along the bone from its value at the one joint to that at the other: the
///       geometric mean of the s of the two bones that meet there; at the first joint and at the
///       tip the s of the one bone. Breadths are not asked for, as no subject states its own.
/// Points on the base, the metacarpal of a finger, move away from the first joint by its w.
/// Directions of axes, angles, friction and shares of a hood stay. If all s and w are one number,
/// everything grows about the first joint by that number.
///
/// A bone's length is that from the point of its joint to the point of the next one, or to the tip.
/// @throws InputError if the experiment states no length; names a segment that is no bone of this
/// digit; states a length outside of 0.5 to 2 times the subject's; holds its load cell at a place
/// in the subject's frame (`at_mm`); if the digit has a net, or a tendon known by its moment arms
/// alone.
[[nodiscard]] TendonDigit scale_to_outside(const TendonDigit& digit, const Experiment& experiment);

}  // namespace thenar
