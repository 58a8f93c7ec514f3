#pragma once

/// True parameters of a thumb, expressed relative to the thumb that is fitted.

#include <optional>

#include "kinematics_fit/model/parameter.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// Returns a digit in the frame of another: turned and shifted so that its tip and the tip's
/// directions at the reference posture are those of `start`. Angles, lengths and tip forces do not
/// change.
/// @throws InputError if the digits have other hinges, or strands that run along paths.
[[nodiscard]] TendonDigit in_frame_of(const TendonDigit& start, const TendonDigit& digit);

/// Returns the value of a parameter of `start` at which it has the axis, or the arm, of `truth`
/// [SI]; empty for other kinds. With d0 and p0 the axis at the start and e its tangents, the true
/// axis (d, p) has
///   tilt_k = e_k.d / d0.d,   shift_k = e_k.(p + s d - p0),  s such that d0.(p + s d - p0) = 0.
/// @param truth  in the frame of `start`
/// @throws InputError if the true axis is perpendicular to the axis of `start`: no tilt reaches it.
[[nodiscard]] std::optional<double> true_value(const Parameter& parameter, const TendonDigit& start,
                                               const TendonDigit& truth);

}  // namespace thenar
