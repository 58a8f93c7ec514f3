#pragma once

/// Linear map from tendon tensions to the force of a constrained fingertip, for any scalar type.

#include "data/io/experiment.h"
#include "solvers/orthogonal_solve.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// Length that makes the flexion moment of a rigid constraint comparable with its forces: a middle
/// phalanx [m]. It only matters if the constraint carries more loads than there are joints.
inline constexpr double kHoldLength = 0.0236;

/// Forces of a constrained tip that are determined by the joint torques. Joints with parallel axes
/// feel no force perpendicular to their plane, so that their torques do not determine it: it is set
/// to zero.
enum class DecidedForces {
  kInSpace,  // proximal, dorsal and radial
  kInPlane   // in the plane of flexion: proximal and dorsal
};

/// Returns the torque about each joint per load that the constraint can carry: forces of the tip on
/// the world along the tip's proximal, dorsal and (in space) radial directions and, if rigid,
/// moments about the radial and (in space) proximal and dorsal directions. Moments are divided by a
/// length, so that all loads are in [N]: `out_of_plane` for the last two, which are omitted if it
/// is zero [Synek2019].
/// @return (coordinates, 2 or 3 in the plane, 3, 4 or 6 in space) [m/rad]
template <typename T>
[[nodiscard]] MatrixX<T> tip_constraint_loads(const TendonModel<T>& digit,
                                              const TreeState<T>& state, TipConstraint hold,
                                              DecidedForces known, const T& out_of_plane) {
  // Number of forces, and of moments: none, one or all three.
  const int forces = known == DecidedForces::kInPlane ? 2 : 3;
  const bool all_moments = known == DecidedForces::kInSpace && out_of_plane != T(0);
  const int moments = hold == TipConstraint::kPinned ? 0 : all_moments ? 3 : 1;
  // Compute position and directions of the tip.
  const Mat3<T> axes =
      digit.tip_link < 0 ? digit.tip_axes : Mat3<T>(state[digit.tip_link].X.R * digit.tip_axes);
  const Vec3<T> tip = moved(state, digit.tip_link, digit.tip);
  // Compute the torques of unit forces.
  const Eigen::Matrix<T, Eigen::Dynamic, 3> all =
      position_jacobian(digit.tree, state, digit.tip_link, tip, digit.coordinates).transpose() *
      axes;
  MatrixX<T> loads(digit.coordinates, forces + moments);
  loads.leftCols(forces) = all.leftCols(forces);
  if (moments == 0) return loads;
  // Compute the torques of unit moments, divided by their lengths.
  const MatrixX<T> turning =
      rotation_jacobian(digit.tree, state, digit.tip_link, digit.coordinates).transpose() * axes;
  loads.col(forces) = turning.col(2) * T(kHoldLength);
  if (moments == 3) loads.template rightCols<2>() = turning.template leftCols<2>() * out_of_plane;
  return loads;
}

/// Returns the forces among the loads c of a constraint, one per column (3, torques).
///
/// Solves  L c = torque : with minimum norm if the constraint carries more loads than there are
/// joints, exactly if as many, by least squares if fewer. In the plane the radial force is zero.
/// @param L       torque per load, from tip_constraint_loads() [m/rad] (joints, loads)
/// @param torque  joint torques [N m] (joints, torques)
template <typename T>
[[nodiscard]] MatrixX<T> forces_of_hold(const MatrixX<T>& L, const MatrixX<T>& torque,
                                        DecidedForces known) {
  const MatrixX<T> loads =
      L.rows() < L.cols() ? solve_least_norm(L, torque) : solve_least_squares(L, torque);
  if (known == DecidedForces::kInSpace) return loads.template topRows<3>();
  MatrixX<T> in_plane = MatrixX<T>::Zero(3, loads.cols());
  in_plane.template topRows<2>() = loads.template topRows<2>();
  return in_plane;
}

/// Returns the tip forces in the tip's own directions (proximal, dorsal, radial) that balance joint
/// torques, one per column (3, torques): forces_of_hold().
/// @param torque  joint torques [N m] (coordinates, torques)
template <typename T>
[[nodiscard]] MatrixX<T> held_tip_forces(const TendonModel<T>& digit, const TreeState<T>& state,
                                         TipConstraint hold, DecidedForces known,
                                         const T& out_of_plane, const MatrixX<T>& torque) {
  return forces_of_hold(MatrixX<T>(tip_constraint_loads(digit, state, hold, known, out_of_plane)),
                        torque, known);
}

}  // namespace thenar
