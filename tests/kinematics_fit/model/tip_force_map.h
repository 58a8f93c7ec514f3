#pragma once

/// Map from tensions to forces of a constrained tip, which tests check forces with.

#include "kinematics_fit/model/tip_constraint.h"

namespace thenar {

/// Returns held_tip_forces() per unit tension of each muscle, for tendons without a net (3,
/// muscles).
template <typename T>
[[nodiscard]] MatrixX<T> tip_force_map(const TendonModel<T>& digit, const TreeState<T>& state,
                                       const VectorX<T>& q, TipConstraint hold, DecidedForces known,
                                       const T& out_of_plane) {
  return held_tip_forces(digit, state, hold, known, out_of_plane,
                         MatrixX<T>(muscle_arms(digit, state, q).transpose()));
}

}  // namespace thenar
