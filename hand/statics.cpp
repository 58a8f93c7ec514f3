#include "hand/statics.h"

#include "base/error.h"

namespace thenar {
namespace {

/// Adds J_p' f of a force at a point of a link, without forming J.
void add_force(const Skeleton& skeleton, const TreeState<double>& state, const PointForce& force,
               Eigen::VectorXd& tau) {
  const Eigen::Vector3d p = moved(state, force.link, force.p);
  for_each_hinge_to_base(skeleton.tree, force.link, [&](int i) {
    const Hinge<double>& hinge = skeleton.tree[i];
    const Eigen::Vector3d moment = (p - state[i].point).cross(force.f_W);
    tau[hinge.coordinate] += hinge.ratio * state[i].axis.dot(moment);
  });
}

}  // namespace

Eigen::VectorXd load_torque(const Skeleton& skeleton, const Eigen::Ref<const Eigen::VectorXd>& q,
                            const Loads& loads) {
  const int links = static_cast<int>(skeleton.tree.size());
  // Check the size of q, and the links of forces.
  require(q.size() == skeleton.coordinates(), "the skeleton has {} coordinates, q has {}",
          skeleton.coordinates(), q.size());
  for (const PointForce& force : loads.forces)
    require(force.link >= -1 && force.link < links, "a force acts on link {} of {}", force.link,
            links);

  // Add external forces, then weights.
  const TreeState<double> state = pose_tree(skeleton.tree, q);
  Eigen::VectorXd tau = Eigen::VectorXd::Zero(skeleton.coordinates());
  for (const PointForce& force : loads.forces) add_force(skeleton, state, force, tau);
  for (int i = 0; i < links; ++i) {
    const LinkMass& body = skeleton.masses[i];
    add_force(skeleton, state, {i, body.com, body.mass * loads.gravity}, tau);
  }
  return tau;
}

Eigen::VectorXd joint_torque(const Tree<double>& tree, const TreeState<double>& state,
                             const std::vector<LinkWrench>& wrenches, int coordinates) {
  Eigen::VectorXd torque = Eigen::VectorXd::Zero(coordinates);
  for (const LinkWrench& on : wrenches)
    for_each_hinge_to_base(tree, on.link, [&](int i) {
      // Add the moment about a point of the hinge, along its axis.
      const auto& at = state[static_cast<std::size_t>(i)];
      const auto& hinge = tree[static_cast<std::size_t>(i)];
      torque[hinge.coordinate] +=
          hinge.ratio * at.axis.dot(on.wrench.moment - at.point.cross(on.wrench.force));
    });
  return torque;
}

}  // namespace thenar
