#pragma once

/// Scaling of pads and their laws to other sizes, with the same shape and tissue.

#include "pad_laws/calibrated_laws.h"
#include "pads/pad_shape.h"

namespace thenar {

/// Returns the shape with all lengths scaled by s.
/// @param s  scale [1]
/// @throws InputError unless s > 0 and finite, or if the pad has a skin of its own and s is not 1.
[[nodiscard]] PadShape scaled_shape(PadShape shape, double s);

/// Returns the laws of a pad scaled by s. Stress depends on strain alone, so at equal strains,
/// depth s d under an object of radius s R, stresses are equal and forces are scaled by s^2:
///   F'(d, R) = s^2 F(d / s, R / s),   r'(F, R) = s r(F / s^2, R / s),
/// r the patch's radius. In the constants:
///   k' = k s^(2 - n - q),   c' = c s^(1 - 2 gamma - s_R),   h' = s h,
/// with q = s_R = 0 for the power law; exponents, shares, moduli and the other constants of the bed
/// do not contain a length. Errors are those of the original pad, for objects scaled by s. Depths
/// and forces of the evidence are scaled; the digest is cleared unless s is 1. Relaxation depends
/// on time alone and is unchanged.
///
/// Example: a pad twice as large, with n = 1.79 and q = 0.82, has k' = 0.655 k. A depth of 1 mm is
/// half the strain for it, and an object of 10 mm acts like one of 5 mm.
/// @param laws  laws of the original pad;  @param s  scale [1]
/// @throws InputError unless s > 0 and finite.
[[nodiscard]] CalibratedLaws scaled_laws(CalibratedLaws laws, double s);

}  // namespace thenar
