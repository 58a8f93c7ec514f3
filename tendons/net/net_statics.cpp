#include "tendons/net/net_statics.h"

#include "base/error.h"
#include "tendons/net/band_law.h"
#include "tendons/net/net_energy.h"

namespace thenar {

using Eigen::Vector3d;

double strain_energy(const Net& net, const NetEquilibrium& rest) {
  double energy = 0;
  for (std::size_t b = 0; b < net.bands.size(); ++b)
    if (net.bands[b].muscle < 0)
      energy +=
          internal::elastic_response(net, net.bands[b], net.bands[b].slack, rest.length[b]).energy;
  return energy;
}

std::vector<LinkWrench> net_wrenches(const Net& net, const TreeState<double>& state,
                                     const NetEquilibrium& rest) {
  std::vector<LinkWrench> all(state.size() + 1);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].link = static_cast<int>(i) - 1;
  const auto add = [&](int link, const Vector3d& at, const Vector3d& f) {
    const int place = link + 1;
    all[place].wrench += wrench_of_force(at, f);
  };
  const internal::NetScene scene = internal::pose_surfaces(net, state);
  // Add the pull of each band at its fixed ends.
  for (std::size_t i = 0; i < net.bands.size(); ++i) {
    const NetBand& band = net.bands[i];
    const Vector3d a = rest.x.col(band.a), b = rest.x.col(band.b);
    const Vector3d* held = nullptr;  // force on end a of a band of no length
    for (const CollapsedBand& collapsed : rest.collapsed)
      if (collapsed.band == static_cast<int>(i)) held = &collapsed.force;
    const WrappedString chord = internal::band_string(net, scene, static_cast<int>(i), a, b);
    const double t = rest.tension(static_cast<Eigen::Index>(i));
    const Vector3d fa = held ? *held : Vector3d(-t * chord.slope.head<3>());
    const Vector3d fb = held ? Vector3d(-fa) : Vector3d(-t * chord.slope.tail<3>());
    if (!net.nodes[band.a].free) add(net.nodes[band.a].link, a, fa);
    if (!net.nodes[band.b].free) add(net.nodes[band.b].link, b, fb);
    // Add the pressure of a bent band on its bone: the sum of its two pulls.
    if (!chord.bent || held) continue;
    add(net.surfaces[band.over].link, a, -fa);
    add(net.surfaces[band.over].link, b, -fb);
  }
  // Add the forces of nodes on their bones.
  for (const NetContact& c : rest.contacts)
    add(net.surfaces[c.surface].link, rest.x.col(c.node), -c.force * c.normal);
  return all;
}

Eigen::VectorXd net_torque(const Net& net, const Tree<double>& tree, const TreeState<double>& state,
                           const NetEquilibrium& rest, int coordinates) {
  return joint_torque(tree, state, net_wrenches(net, state, rest), coordinates);
}

}  // namespace thenar
