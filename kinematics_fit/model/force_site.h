#pragma once

/// Forces of a digit on a load cell that does not hold its tip, for any scalar type.

#include <vector>

#include "data/io/experiment.h"
#include "kinematics_fit/model/planned_site.h"
#include "kinematics_fit/model/specimen_model.h"

namespace thenar {

/// Returns the digit with the place of the load cell as its tip.
template <typename T>
[[nodiscard]] TendonModel<T> held_elsewhere(TendonModel<T> digit, const PlannedSite& site) {
  digit.tip_link = site.link;
  digit.tip = site.point.cast<T>();
  return digit;
}

/// Returns the rows of a matrix that belong to the coordinates of a site.
template <typename T>
[[nodiscard]] MatrixX<T> balanced_rows(const MatrixX<T>& matrix, const PlannedSite& site) {
  MatrixX<T> rows(site.balanced.size(), matrix.cols());
  for (std::size_t i = 0; i < site.balanced.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)) = matrix.row(site.balanced[i]);
  return rows;
}

/// Returns the torque per load of a cell that holds a segment, as tip_constraint_loads(), about the
/// joints that move the segment [m/rad] (balanced, loads).
template <typename T>
[[nodiscard]] MatrixX<T> segment_loads(const TendonModel<T>& digit, const PlannedSite& site,
                                       const TreeState<T>& state, TipConstraint hold,
                                       DecidedForces known) {
  return balanced_rows<T>(
      tip_constraint_loads(held_elsewhere(digit, site), state, hold, known, T(0)), site);
}

/// Returns the force per unit tension on a cell that holds a segment between the base and the tip,
/// along that segment's proximal, dorsal and radial directions [1] (3, muscles).
///
/// Only the joints between the base and the held segment load the cell:  loads c = R' t  in their
/// rows, as in held_tip_forces(). Torque about the distal joints does not reach the cell: joint
/// limits, a splint or the hand that holds the rest of the finger balance it. If there are fewer
/// joints than loads, the forces have minimum norm, because torques do not determine how bones and
/// cell share the load.
template <typename T>
[[nodiscard]] MatrixX<T> segment_force_map(const TendonModel<T>& digit, const PlannedSite& site,
                                           const TreeState<T>& state, const VectorX<T>& q,
                                           TipConstraint hold, DecidedForces known) {
  const MatrixX<T> L = segment_loads(digit, site, state, hold, known);
  const MatrixX<T> torque =
      balanced_rows<T>(MatrixX<T>(muscle_arms(digit, state, q).transpose()), site);
  return forces_of_hold(L, torque, known);
}

/// Returns the pull of every muscle's tendon on the digit and its mount per unit tension, where the
/// tendon leaves them: a unit vector along its run, or along the bone [1] (3, muscles), in the axes
/// of the base. Tendons that end on the digit pull nothing.
template <typename T>
[[nodiscard]] MatrixX<T> leaving_pulls(const TendonModel<T>& digit, const TreeState<T>& state,
                                       TendonExit leave) {
  MatrixX<T> pulls = MatrixX<T>::Zero(3, static_cast<Eigen::Index>(digit.pulls.size()));
  for (std::size_t m = 0; m < digit.pulls.size(); ++m) {
    // Find the most proximal run between the base and a moving link.
    const TendonPath<T>& path = digit.paths[digit.pulls[m]];
    std::size_t k = path.size();
    while (k > 1 && (path[k - 1].link < 0) == (path[k - 2].link < 0)) --k;
    if (k <= 1) continue;
    const std::size_t base = path[k - 1].link < 0 ? k - 1 : k - 2, moving = 2 * k - 3 - base;
    if (leave == TendonExit::kAlongBone) {
      pulls.col(m) = digit.tip_axes.col(0);
    } else {
      pulls.col(m) = (path[base].p - moved(state, path[moving].link, path[moving].p)).normalized();
    }
  }
  return pulls;
}

/// Returns the force of the digit on its mount per stated tension, while its tip is held [1] (3,
/// muscles).
///
/// Free body: digit and mount together. Tendons pull on it where they leave, the tip's cell pushes
/// it with -f, and the mount's cell with -f_mount:
///
///   f_mount = sum t u - f.
///
/// @param tip_force  force of the tip on its cell per stated tension, axes of the base (3, muscles)
template <typename T>
[[nodiscard]] MatrixX<T> mount_force_map(const SpecimenModel<T>& model, const PlannedSite& site,
                                         const TreeState<T>& state, const MatrixX<T>& tip_force) {
  return leaving_pulls(model.digit, state, site.leave) * model.gain.asDiagonal() - tip_force;
}

}  // namespace thenar
