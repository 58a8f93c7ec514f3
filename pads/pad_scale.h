#pragma once

/// Pads of other sizes, of the same shape and tissue.

#include "pad_laws/calibrated_laws.h"
#include "pads/pad_shape.h"

namespace thenar {

/// All lengths times s.
/// @param shape  lengths [m];  @param s  [1]
/// @throws InputError unless s > 0 and finite, or if the pad has a skin of its own and s is not 1.
[[nodiscard]] PadShape scaled_shape(PadShape shape, double s);

/// Laws of the pad times s, under objects times s. Stress depends on strain alone, so at the same
/// strains, depth s d under radius s R, stresses are the same, and forces s^2 of those before:
///   F'(d, R) = s^2 F(d / s, R / s),   r'(F, R) = s r(F / s^2, R / s),
/// r the patch's radius. In the constants:
///   k' = k s^(2 - n - q),   c' = c s^(1 - 2 gamma - s_R),   h' = s h,
/// with q = s_R = 0 for the power law; exponents, shares, moduli and the rest of the bed's numbers
/// have no length. Errors are those of the pad before, under objects times s; depths and forces of
/// the evidence are scaled, the digest is left out unless s is 1. Relaxation is in time alone.
///
/// A pad twice as large, with n = 1.79 and q = 0.82, has k' = 0.655 k: a depth of 1 mm is half the
/// strain for it, and an object of 10 mm is as one of 5 mm.
/// @param laws  of the pad before;  @param s  [1]
/// @throws InputError unless s > 0 and finite.
[[nodiscard]] CalibratedLaws scaled_laws(CalibratedLaws laws, double s);

}  // namespace thenar
