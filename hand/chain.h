#pragma once

/// Kinematics of a tree of hinges as a product of exponentials, on any scalar.
///
/// A point that sits at p in the reference posture moves to
///   exp([S_1] q_1) ... exp([S_i] q_i) p,
/// the product running over the hinges between the base and its link. Each hinge is a
/// point and a unit direction, both at the reference posture; no link frames are needed.
/// Source: [Murray1994] eq. 3.3 and 3.54.

#include <string>
#include <vector>

#include "base/spatial.h"

namespace thenar {

/// Hinge of the tree; the link that it moves has the same index.
template <typename T>
struct Hinge {
  int parent;         // hinge that moves the parent link; -1: the base
  int coordinate;     // entry of q that drives it; several hinges may share one
  double ratio;       // angle = ratio * q + offset [rad/rad]
  double offset;      // [rad]
  Vec3<T> direction;  // unit, reference posture (3)
  Vec3<T> point;      // any point of the axis, reference posture [m] (3)
};

/// Link after a motion: its displacement from the reference posture, and its present hinge.
template <typename T>
struct LinkState {
  Pose<T> X;      // displacement of the link's points from the reference posture
  Vec3<T> axis;   // unit direction of the hinge that moves it (3)
  Vec3<T> point;  // any point of that hinge's axis [m] (3)
};

template <typename T>
using Tree = std::vector<Hinge<T>>;
template <typename T>
using TreeState = std::vector<LinkState<T>>;

/// Computes forward kinematics: the pose of every link, written into `state`, whose memory is
/// reused.
/// @param tree  hinges, parents before children
/// @param q     coordinates, any indexable type [rad]
template <typename T, typename Q>
void pose_tree_over(const Tree<T>& tree, const Q& q, TreeState<T>& state) {
  state.resize(tree.size());
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const Hinge<T>& hinge = tree[i];
    // Rotate about the hinge.
    const T angle = T(hinge.ratio) * T(q[hinge.coordinate]) + T(hinge.offset);
    const Mat3<T> turn = rotation_about(hinge.direction, angle);
    LinkState<T>& link = state[i];
    // Move links with their parents; the base does not move.
    if (hinge.parent < 0) {
      link.axis = hinge.direction;
      link.point = hinge.point;
      link.X.R = turn;
    } else {
      const Pose<T>& parent = state[hinge.parent].X;
      link.axis.noalias() = parent.R * hinge.direction;
      link.point = parent * hinge.point;
      link.X.R.noalias() = parent.R * turn;
    }
    link.X.p = link.point - link.X.R * hinge.point;  // points of the axis do not move
  }
}

/// Returns the state of a tree at posture q, as pose_tree_over() writes it.
template <typename T, typename Q>
[[nodiscard]] TreeState<T> pose_tree(const Tree<T>& tree, const Q& q) {
  TreeState<T> state;
  pose_tree_over(tree, q, state);
  return state;
}

/// Computes the present position of a point of link `link` (-1: the base) [m] (3).
/// @param p  position at the reference posture [m] (3)
template <typename T>
[[nodiscard]] Vec3<T> moved(const TreeState<T>& state, int link, const Vec3<T>& p) {
  return link < 0 ? p : Vec3<T>(state[link].X * p);
}

/// Calls visit(hinge index) for every hinge between the link and the base.
template <typename T, typename Visit>
void for_each_hinge_to_base(const Tree<T>& tree, int link, Visit visit) {
  for (int i = link; i >= 0; i = tree[i].parent) visit(i);
}

/// Calls visit(i, on_b) for every hinge between two links, up to their common ancestor, the deeper
/// one first; on_b: it moves b, not a.
template <typename T, typename Visit>
void for_each_hinge_between(const Tree<T>& tree, int a, int b, Visit visit) {
  while (a != b) {
    const bool on_b = b > a;  // parents have smaller indices
    int& deeper = on_b ? b : a;
    visit(deeper, on_b);
    deeper = tree[deeper].parent;
  }
}

/// Computes the position Jacobian of a point of a link,  d p / d q,  3 x coordinates [m/rad].
/// @param p  present position of the point [m] (3)
template <typename T>
[[nodiscard]] Eigen::Matrix<T, 3, Eigen::Dynamic> position_jacobian(const Tree<T>& tree,
                                                                    const TreeState<T>& state,
                                                                    int link, const Vec3<T>& p,
                                                                    int coordinates) {
  Eigen::Matrix<T, 3, Eigen::Dynamic> J(3, coordinates);
  J.setZero();
  for_each_hinge_to_base(tree, link, [&](int i) {
    J.col(tree[i].coordinate) += T(tree[i].ratio) * state[i].axis.cross(p - state[i].point);
  });
  return J;
}

/// Computes the rotation Jacobian of a link: angular velocity = J q_dot, 3 x coordinates [1].
template <typename T>
[[nodiscard]] Eigen::Matrix<T, 3, Eigen::Dynamic> rotation_jacobian(const Tree<T>& tree,
                                                                    const TreeState<T>& state,
                                                                    int link, int coordinates) {
  Eigen::Matrix<T, 3, Eigen::Dynamic> J(3, coordinates);
  J.setZero();
  for_each_hinge_to_base(
      tree, link, [&](int i) { J.col(tree[i].coordinate) += T(tree[i].ratio) * state[i].axis; });
  return J;
}

/// Computes the spatial Jacobian of a point of a link, rotation above translation: 6 x coordinates.
template <typename T>
[[nodiscard]] Eigen::Matrix<T, 6, Eigen::Dynamic> spatial_jacobian(const Tree<T>& tree,
                                                                   const TreeState<T>& state,
                                                                   int link, const Vec3<T>& p,
                                                                   int coordinates) {
  Eigen::Matrix<T, 6, Eigen::Dynamic> J(6, coordinates);
  J.template topRows<3>() = rotation_jacobian(tree, state, link, coordinates);
  J.template bottomRows<3>() = position_jacobian(tree, state, link, p, coordinates);
  return J;
}

}  // namespace thenar
