#include "hand/tree_velocity.h"

#include <Eigen/Geometry>

namespace thenar::internal {

TreeVelocity joint_velocity_tree(const Tree<double>& tree, const TreeState<double>& state,
                                 int coordinate) {
  const std::vector<Eigen::Vector3d> none(tree.size(), Eigen::Vector3d::Zero());
  TreeVelocity rate{std::vector<BodyTwist>(tree.size() + 1), none, none};
  for (std::size_t i = 0; i < tree.size(); ++i) {
    // Move the link with its parent, and about its hinge if that belongs to the coordinate.
    const BodyTwist& parent = rate.body(tree[i].parent);
    BodyTwist& link = rate.link[i + 1];
    link = parent;
    rate.axis[i] = parent.w.cross(state[i].axis);
    rate.point[i] = parent.velocity_at(state[i].point);
    if (tree[i].coordinate != coordinate) continue;
    link.w += tree[i].ratio * state[i].axis;
    link.v -= tree[i].ratio * state[i].axis.cross(state[i].point);
  }
  return rate;
}

}  // namespace thenar::internal
