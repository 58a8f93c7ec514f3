#include "tendons/net/net_input.h"

namespace thenar::internal {

namespace {

Eigen::VectorXd no_change(const Net& net) {
  return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(net.bands.size()));
}

}  // namespace

NetInput still(const Net& net, std::size_t links) {
  const std::vector<Eigen::Vector3d> none(links, Eigen::Vector3d::Zero());
  return {{std::vector<BodyRate>(links + 1), none, none}, no_change(net)};
}

NetInput turning(const Net& net, const Tree<double>& tree, const TreeState<double>& state,
                 int coordinate) {
  return {turning_tree(tree, state, coordinate), no_change(net)};
}

}  // namespace thenar::internal
