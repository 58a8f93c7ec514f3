#pragma once

/// The linear map from tendon tensions to the fingertip force, on any scalar.

#include <Eigen/LU>

#include "data/io/experiment.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// What the hold carries, per joint torque: columns of force and, if rigid, flexion moment.
///
/// Columns are unit loads of the tip on the world along the tip's proximal, dorsal and radial
/// directions; a rigid hold adds the moment about the radial direction. Moments about the other
/// two are left out: a digit of one ab/adduction and three flexion axes cannot tell them from
/// the lateral force. Source: [Synek2019], who hold the tip rigidly in the flexion plane.
/// @return (coordinates, 3 or 4)  [m/rad] and, in the fourth column, [1]
template <typename T>
[[nodiscard]] MatrixX<T> held_loads(const TendonModel<T>& digit, const TreeState<T>& state,
                                    const Mat3<T>& axes, TipHold hold) {
  const Vec3<T> tip = moved(state, digit.tip_link, digit.tip);
  const auto J = position_jacobian(digit.tree, state, digit.tip_link, tip, digit.coordinates);
  MatrixX<T> loads(digit.coordinates, hold == TipHold::kRigid ? 4 : 3);
  loads.template leftCols<3>() = J.transpose() * axes;
  if (hold == TipHold::kRigid)
    loads.col(3) =
        rotation_jacobian(digit.tree, state, digit.tip_link, digit.coordinates).transpose() *
        axes.col(2);
  return loads;
}

/// Tip force in the tip's own directions (proximal, dorsal, radial) per unit tension (3, muscles):
/// least squares of  loads c = R' t,  exact when there are as many loads as joints.
template <typename T>
[[nodiscard]] MatrixX<T> tip_force_map(const TendonModel<T>& digit, const TreeState<T>& state,
                                       TipHold hold) {
  const Mat3<T> R_tip = digit.tip_link < 0 ? Mat3<T>::Identity() : state[digit.tip_link].X.R;
  const MatrixX<T> loads = held_loads(digit, state, Mat3<T>(R_tip * digit.tip_axes), hold);
  const MatrixX<T> torque = muscle_arms(digit, state).transpose();
  const MatrixX<T> c =
      loads.rows() == loads.cols()
          ? MatrixX<T>(loads.partialPivLu().solve(torque))
          : MatrixX<T>(
                (loads.transpose() * loads).partialPivLu().solve(loads.transpose() * torque));
  return c.template topRows<3>();
}

}  // namespace thenar
