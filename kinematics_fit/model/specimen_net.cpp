#include "kinematics_fit/model/specimen_net.h"

#include <algorithm>

namespace thenar {

bool lies_at(const PathNode<double>& point, int link, const Eigen::Vector3d& p) {
  constexpr double kSame = 1e-9;  // both are computed from the same numbers [m]
  return point.link == link && (point.p - p).norm() < kSame;
}

bool pulls_net(const BuiltNet& built, const Eigen::VectorXd& t) {
  return std::any_of(built.pulls.begin(), built.pulls.end(),
                     [&](const MuscleAttachment& pull) { return t[pull.muscle] > 0; });
}

BuiltNet built_net(const SpecimenNet<double>& net) {
  BuiltNet out = *net.built;
  // Nodes, bands and surfaces.
  for (std::size_t i = 0; i < out.net.nodes.size(); ++i) out.net.nodes[i].p = net.place[i];
  for (std::size_t b = 0; b < out.net.bands.size(); ++b) {
    out.net.bands[b].EA = net.EA[static_cast<Eigen::Index>(b)];
    out.net.bands[b].slack = net.slack[static_cast<Eigen::Index>(b)];
  }
  for (std::size_t s = 0; s < out.net.surfaces.size(); ++s)
    out.net.surfaces[s].size[0] = net.radius[static_cast<Eigen::Index>(s)];
  // Muscles, and their shares in the pulls.
  for (std::size_t m = 0; m < out.muscles.size(); ++m) {
    const double before = out.muscles[m].to_net, after = net.to_net[static_cast<Eigen::Index>(m)];
    out.muscles[m].to_net = after;
    out.muscles[m].own = net.own[m];
    for (MuscleAttachment& pull : out.pulls)
      if (pull.muscle == out.muscles[m].muscle) pull.share *= after / before;
  }
  return out;
}

}  // namespace thenar
