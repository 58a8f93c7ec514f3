#pragma once

/// Linear map from tendon tensions to the force of a held fingertip, on any scalar.

#include "data/io/experiment.h"
#include "solvers/orthogonal_solve.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// Length that makes the flexion moment of a rigid hold comparable with its forces: a middle
/// phalanx [m]. It matters only where the hold carries more loads than there are joints.
inline constexpr double kHoldLength = 0.0236;

/// Torque about each joint per load that the hold can carry: forces of the tip on the world along
/// the tip's proximal, dorsal and radial directions and, if rigid, moments about the radial,
/// proximal and dorsal directions. Moments are divided by a length, so that all loads are in [N]:
/// `out_of_plane` for the last two, which are left out where it is zero [Synek2019].
/// @return (coordinates, 3, 4 or 6) [m/rad]
template <typename T>
[[nodiscard]] MatrixX<T> tip_constraint_loads(const TendonModel<T>& digit,
                                              const TreeState<T>& state, TipConstraint hold,
                                              const T& out_of_plane) {
  // Three forces, one moment, or all three moments.
  const int columns = hold == TipConstraint::kPinned ? 3 : out_of_plane == T(0) ? 4 : 6;
  // The tip's place and directions.
  const Mat3<T> axes =
      digit.tip_link < 0 ? digit.tip_axes : Mat3<T>(state[digit.tip_link].X.R * digit.tip_axes);
  const Vec3<T> tip = moved(state, digit.tip_link, digit.tip);
  // Torques of unit forces.
  MatrixX<T> loads(digit.coordinates, columns);
  loads.template leftCols<3>() =
      position_jacobian(digit.tree, state, digit.tip_link, tip, digit.coordinates).transpose() *
      axes;
  if (columns == 3) return loads;
  // Torques of unit moments, each in units of a length.
  const MatrixX<T> moments =
      rotation_jacobian(digit.tree, state, digit.tip_link, digit.coordinates).transpose() * axes;
  loads.col(3) = moments.col(2) * T(kHoldLength);
  if (columns == 6) loads.template rightCols<2>() = moments.template leftCols<2>() * out_of_plane;
  return loads;
}

/// Tip force in the tip's own directions (proximal, dorsal, radial) per unit tension (3, muscles).
///
/// Solves  loads c = R' t : in least norm where the hold carries more loads than there are joints,
/// exactly where as many, in least squares where fewer.
template <typename T>
[[nodiscard]] MatrixX<T> tip_force_map(const TendonModel<T>& digit, const TreeState<T>& state,
                                       const VectorX<T>& q, TipConstraint hold,
                                       const T& out_of_plane) {
  // Torques of the muscles, balanced by the loads of the hold.
  const MatrixX<T> L = tip_constraint_loads(digit, state, hold, out_of_plane);
  const MatrixX<T> torque = muscle_arms(digit, state, q).transpose();
  const MatrixX<T> loads =
      L.rows() < L.cols() ? solve_least_norm(L, torque) : solve_least_squares(L, torque);
  return loads.template topRows<3>();
}

}  // namespace thenar
