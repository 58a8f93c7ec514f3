#pragma once

/// Poses of a tree posture after posture, without the heap.

#include "hand/chain.h"

namespace thenar {

/// pose_tree() written over `state`, whose room is used again; to the last bit the same.
/// @param q  coordinates, anything indexable [rad]
template <typename Q>
void pose_tree_over(const Tree<double>& tree, const Q& q, TreeState<double>& state) {
  state.resize(tree.size());
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const Hinge<double>& hinge = tree[i];
    const Mat3<double> turn =
        rotation_about(hinge.direction, hinge.ratio * q[hinge.coordinate] + hinge.offset);
    LinkState<double>& link = state[i];
    // The base does not move; other links move with their parents.
    if (hinge.parent < 0) {
      link.axis = hinge.direction;
      link.point = hinge.point;
      link.X.R = turn;
    } else {
      const Pose<double>& parent = state[static_cast<std::size_t>(hinge.parent)].X;
      link.axis.noalias() = parent.R * hinge.direction;
      link.point = parent * hinge.point;
      link.X.R.noalias() = parent.R * turn;
    }
    link.X.p = link.point - link.X.R * hinge.point;  // points of the axis do not move
  }
}

}  // namespace thenar
