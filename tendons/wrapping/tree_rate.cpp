#include "tendons/wrapping/tree_rate.h"

#include <Eigen/Geometry>

namespace thenar::internal {

TreeRate turning_tree(const Tree<double>& tree, const TreeState<double>& state, int coordinate) {
  const std::vector<Eigen::Vector3d> none(tree.size(), Eigen::Vector3d::Zero());
  TreeRate rate{std::vector<BodyRate>(tree.size() + 1), none, none};
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const BodyRate& parent = rate.body(tree[i].parent);
    BodyRate& link = rate.link[i + 1];
    link = parent;
    rate.axis[i] = parent.w.cross(state[i].axis);
    rate.point[i] = parent.at(state[i].point);
    if (tree[i].coordinate != coordinate) continue;
    link.w += tree[i].ratio * state[i].axis;
    link.v -= tree[i].ratio * state[i].axis.cross(state[i].point);
  }
  return rate;
}

}  // namespace thenar::internal
