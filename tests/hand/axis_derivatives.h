#pragma once

/// Derivatives of kinematics by the position and direction of one hinge's axis, in closed form.

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "hand/chain.h"

namespace thenar {

/// Derivative of a position by the five parameters of an axis (3, 5): columns are the tilts of the
/// direction along tangents() e1 and e2 [m/rad], then x, y, z of its point [m/m].
using ByAxis = Eigen::Matrix<double, 3, 5>;

/// Hinge of a posed tree whose axis is the variable. Refers to the tree and its state, which must
/// outlive it; temporaries are rejected.
struct AxisQuestion {
  AxisQuestion(const Tree<double>& of_tree, const TreeState<double>& at, Eigen::VectorXd posture,
               int moved_hinge)
      : tree(of_tree), state(at), q(std::move(posture)), hinge(moved_hinge) {}
  AxisQuestion(const Tree<double>&&, const TreeState<double>&, Eigen::VectorXd, int) = delete;
  AxisQuestion(const Tree<double>&, const TreeState<double>&&, Eigen::VectorXd, int) = delete;
  AxisQuestion(const Tree<double>&&, const TreeState<double>&&, Eigen::VectorXd, int) = delete;

  const Tree<double>& tree;
  const TreeState<double>& state;  // pose_tree(tree, q)
  Eigen::VectorXd q;               // posture [rad] (coordinates)
  int hinge;                       // index of the hinge whose axis varies
};

/// Computes d x / d axis of a point of a link. With P the parent of the hinge, R its own rotation
/// by angle a, d its direction, and v the vector from its point to x before the rotation:
///   d x / d point  = R_P (I - R)
///   d x / d tilt e = R_P (sin a  e x v + (1 - cos a) (e (d'v) + d (e'v)))
/// Zero if the hinge does not move the link. A shift of the point along d changes nothing.
/// @param x  present position of the point [m] (3)
[[nodiscard]] ByAxis position_by_axis(const AxisQuestion& question, int link,
                                      const Eigen::Vector3d& x);

/// Computes d (J column) / d axis of the position Jacobian of a point of a link, one entry per
/// coordinate [m/rad per parameter]. Columns are  axis x (x - point);  all three vectors may
/// change.
/// @param x  present position of the point [m] (3)
[[nodiscard]] std::vector<ByAxis> position_jacobian_by_axis(const AxisQuestion& question, int link,
                                                            const Eigen::Vector3d& x);

/// Computes d (J column) / d axis of the rotation Jacobian of a link, one entry per coordinate
/// [1/rad for tilts, 1/m for the point]. Columns are  axis;  a direction beyond the hinge tilts as
/// a point does, the hinge's own direction d as  R_P e,  and a shift of the point has no effect.
[[nodiscard]] std::vector<ByAxis> rotation_jacobian_by_axis(const AxisQuestion& question, int link);

}  // namespace thenar
