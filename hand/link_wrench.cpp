#include "hand/link_wrench.h"

namespace thenar {

Eigen::VectorXd joint_torque(const Tree<double>& tree, const TreeState<double>& state,
                             const std::vector<LinkWrench>& wrenches, int coordinates) {
  Eigen::VectorXd torque = Eigen::VectorXd::Zero(coordinates);
  for (const LinkWrench& on : wrenches)
    for_each_hinge_to_base(tree, on.link, [&](int i) {
      // Moment about a point of the hinge, along its axis.
      const auto& at = state[static_cast<std::size_t>(i)];
      const auto& hinge = tree[static_cast<std::size_t>(i)];
      torque[hinge.coordinate] +=
          hinge.ratio * at.axis.dot(on.wrench.moment - at.point.cross(on.wrench.force));
    });
  return torque;
}

}  // namespace thenar
