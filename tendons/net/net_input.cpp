#include "tendons/net/net_input.h"

namespace thenar::internal {

NetInput still(const Net& net, std::size_t links) {
  const std::vector<Eigen::Vector3d> none(links, Eigen::Vector3d::Zero());
  return {std::vector<BodyRate>(links + 1), none, none,
          Eigen::VectorXd::Zero(static_cast<Eigen::Index>(net.bands.size()))};
}

NetInput turning(const Net& net, const Tree<double>& tree, const TreeState<double>& state,
                 int coordinate) {
  NetInput input = still(net, tree.size());
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const BodyRate& parent = input.body(tree[i].parent);
    BodyRate& link = input.link[i + 1];
    link = parent;
    input.axis[i] = parent.w.cross(state[i].axis);
    input.point[i] = parent.at(state[i].point);
    if (tree[i].coordinate != coordinate) continue;
    link.w += tree[i].ratio * state[i].axis;
    link.v -= tree[i].ratio * state[i].axis.cross(state[i].point);
  }
  return input;
}

}  // namespace thenar::internal
