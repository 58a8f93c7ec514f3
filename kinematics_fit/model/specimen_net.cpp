#include "kinematics_fit/model/specimen_net.h"

#include "base/lists.h"

namespace thenar {

bool lies_at(const PathNode<double>& point, int link, const Eigen::Vector3d& p) {
  // Distance below which points coincide; both come from the same numbers [m]
  constexpr double kSamePointDistance = 1e-9;
  return point.link == link && (point.p - p).norm() < kSamePointDistance;
}

bool pulls_net(const BuiltNet& built, const Eigen::VectorXd& t) {
  return any_of(built.pulls, [&](const MuscleAttachment& pull) { return t[pull.muscle] > 0; });
}

std::optional<double> first_share(const BuiltNet& built, int m) {
  // Collect the muscle's shares of the tension that enters the net.
  const NetMuscle& muscle = built.muscles[m];
  std::vector<double> shares;
  for (const MuscleAttachment& pull : built.pulls)
    if (pull.muscle == muscle.muscle) shares.push_back(pull.share / muscle.to_net);
  // Reject pulls in series, whose shares add up to more than 1.
  constexpr double kShareRounding = 1e-9;  // rounding error of a sum of shares [1]
  if (shares.size() != 2 || std::abs(shares[0] + shares[1] - 1) > kShareRounding) return {};
  return shares[0];
}

BuiltNet built_net(const SpecimenNet<double>& net, double angle) {
  BuiltNet out = *net.built;
  // Set nodes, bands and surfaces.
  for (std::size_t i = 0; i < out.net.nodes.size(); ++i) out.net.nodes[i].p = net.place[i];
  for (std::size_t b = 0; b < out.net.bands.size(); ++b) {
    out.net.bands[b].EA = net.EA[b];
    out.net.bands[b].slack = net.slack[b];
  }
  for (std::size_t s = 0; s < out.net.surfaces.size(); ++s)
    out.net.surfaces[s].size[0] = net.radius[s];
  // Set muscles, and their shares in the pulls.
  for (std::size_t m = 0; m < out.muscles.size(); ++m) {
    out.muscles[m].to_net = net.to_net[m];
    out.muscles[m].own_path = net.own[m];
  }
  const Eigen::VectorXd shares = pull_shares(net, angle);
  for (std::size_t p = 0; p < out.pulls.size(); ++p) out.pulls[p].share = shares[p];
  return out;
}

}  // namespace thenar
