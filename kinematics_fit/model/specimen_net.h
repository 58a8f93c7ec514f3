#pragma once

/// Floating extensor net of one specimen, with its parameters set, for any scalar type.

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "kinematics_fit/model/parameter.h"
#include "tendons/hood.h"
#include "tendons/net/build_net.h"
#include "tendons/path.h"

namespace thenar {

/// Quantities of a net that parameters may move. All others, and the topology, are in `built`.
template <typename T>
struct SpecimenNet {
  std::shared_ptr<const BuiltNet> built;  // net before the fit
  std::vector<Vec3<T>> place;  // position of each node on its link at the reference posture;
                               // initial position of floating nodes [m] (nodes)
  VectorX<T> EA;               // axial stiffness of each band [N] (bands)
  VectorX<T> slack;            // slack length of each band [m] (bands)
  VectorX<T> radius;           // size[0] of each surface [m] (surfaces)
  VectorX<T> to_net;  // share of the tension of each of built->muscles that goes into the net [1]
  VectorX<T> first;  // part of that share that goes to the first of two pulls at kHoodAngle; unused
                     // for other muscles [1]
  VectorX<T> slope;  // change of the logit of `first` by flexion of the MCP joint [1/rad]
  std::vector<TendonPath<T>> own;  // path of each of built->muscles from the net on
};

/// Returns the share of the first pull in the tension that built.muscles[m] gives the net, if the
/// muscle has two pulls [1]; nothing if it has more or fewer.
[[nodiscard]] std::optional<double> first_share(const BuiltNet& built, int m);

/// Copies the net to another scalar type; all its numbers are constants.
template <typename T>
[[nodiscard]] SpecimenNet<T> cast_net(std::shared_ptr<const BuiltNet> from) {
  SpecimenNet<T> to;
  const Net& net = from->net;
  // Convert nodes, bands and surfaces.
  for (const NetNode& node : net.nodes) to.place.push_back(node.p.template cast<T>());
  to.EA.resize(static_cast<Eigen::Index>(net.bands.size()));
  to.slack.resize(to.EA.size());
  for (Eigen::Index b = 0; b < to.EA.size(); ++b) {
    to.EA[b] = T(net.bands[b].EA);
    to.slack[b] = T(net.bands[b].slack);
  }
  to.radius.resize(static_cast<Eigen::Index>(net.surfaces.size()));
  for (Eigen::Index s = 0; s < to.radius.size(); ++s) to.radius[s] = T(net.surfaces[s].size[0]);
  // Convert the shares of the muscles that pull it.
  to.to_net.resize(static_cast<Eigen::Index>(from->muscles.size()));
  to.first.resize(to.to_net.size());
  to.slope = VectorX<T>::Zero(to.to_net.size());
  for (std::size_t m = 0; m < from->muscles.size(); ++m) {
    to.to_net[m] = T(from->muscles[m].to_net);
    to.first[m] = T(first_share(*from, static_cast<int>(m)).value_or(1));
    to.own.emplace_back();
    for (const PathNode<double>& node : from->muscles[m].own_path)
      to.own.back().push_back({node.link, node.p.template cast<T>()});
  }
  to.built = std::move(from);
  return to;
}

/// Returns whether a point of a net coincides with that point of a tendon's path, so that they move
/// together.
[[nodiscard]] bool lies_at(const PathNode<double>& point, int link, const Eigen::Vector3d& p);

/// Moves all points of a net that coincide with a point of a tendon's path: insertions, exits, and
/// points of the muscles' own paths.
template <typename T>
void move_with_path(const PathNode<double>& point, const Vec3<T>& by, SpecimenNet<T>& to) {
  const BuiltNet& built = *to.built;
  for (std::size_t i = 0; i < built.net.nodes.size(); ++i)
    if (!built.net.nodes[i].free && lies_at(point, built.net.nodes[i].link, built.net.nodes[i].p))
      to.place[i] += by;
  for (std::size_t m = 0; m < built.muscles.size(); ++m)
    for (std::size_t k = 0; k < built.muscles[m].own_path.size(); ++k)
      if (lies_at(point, built.muscles[m].own_path[k].link, built.muscles[m].own_path[k].p))
        to.own[m][k].p += by;
}

/// Sets one parameter of a net that still has the initial value of that parameter.
/// @param tip_axes  proximal, dorsal and radial direction of the digit, as columns (3, 3)
template <typename T>
void set_net_parameter(const Eigen::Matrix3d& tip_axes, const Parameter& p, const T& value,
                       SpecimenNet<T>& to) {
  using std::exp;
  switch (p.kind) {
    case ParameterKind::kNetStiffness:
      if (p.item < 0)
        to.EA *= exp(value);
      else
        to.EA[p.item] *= exp(value);
      break;
    case ParameterKind::kNetSlack:
      to.slack[p.item] *= exp(value);
      break;
    case ParameterKind::kNetPlace:
      to.place[p.item] += tip_axes.col(p.component).cast<T>() * value;
      break;
    case ParameterKind::kNetRadius:
      to.radius[p.item] += value;
      break;
    case ParameterKind::kNetEntry:
      to.to_net[p.item] = shift_fraction(to.to_net[p.item], value);
      break;
    case ParameterKind::kNetCentral:
      to.first[p.item] = shift_fraction(to.first[p.item], value);
      break;
    case ParameterKind::kNetSlope:
      to.slope[p.item] = value;
      break;
    default:
      break;  // no parameter of a net
  }
}

/// Returns the share of each pull of the net in the tension of its muscle [1] (pulls). With h =
/// to_net, the shares of a muscle with two pulls are
///   h c  and  h (1 - c),   c = first shifted by  slope (angle - kHoodAngle)  on the logit scale;
/// other pulls share h as built.
/// @param angle  flexion of the metacarpophalangeal joint [rad]
template <typename T>
[[nodiscard]] VectorX<T> pull_shares(const SpecimenNet<T>& net, const T& angle) {
  const BuiltNet& built = *net.built;
  VectorX<T> shares(static_cast<Eigen::Index>(built.pulls.size()));
  for (std::size_t m = 0; m < built.muscles.size(); ++m) {
    const auto at = static_cast<Eigen::Index>(m);
    const bool divided = first_share(built, static_cast<int>(m)).has_value();
    const T first =
        divided ? shift_fraction(net.first[at], T(net.slope[at] * (angle - T(kHoodAngle)))) : T(1);
    bool is_first = true;
    for (std::size_t p = 0; p < built.pulls.size(); ++p) {
      if (built.pulls[p].muscle != built.muscles[m].muscle) continue;
      const T part = divided ? (is_first ? first : T(1) - first)
                             : T(built.pulls[p].share / built.muscles[m].to_net);
      shares[p] = part * net.to_net[at];
      is_first = false;
    }
  }
  return shares;
}

/// Returns the pulls on the net for tensions t of the digit's muscles [N] (pulls).
/// @param angle  flexion of the metacarpophalangeal joint [rad]
template <typename T>
[[nodiscard]] VectorX<T> net_pulls(const SpecimenNet<T>& net, const T& angle, const VectorX<T>& t) {
  VectorX<T> pulls = pull_shares(net, angle);
  for (Eigen::Index p = 0; p < pulls.size(); ++p) pulls[p] *= t[net.built->pulls[p].muscle];
  return pulls;
}

/// Adds the moment arms of everything outside of the net, see NetTendons: R becomes
///   diag(1 - to_net) R + diag(to_net) R_own  (muscles, coordinates) [m/rad].
template <typename T>
void take_outside_arms(const SpecimenNet<T>& net, const Tree<T>& tree, const TreeState<T>& state,
                       MatrixX<T>& R) {
  for (std::size_t m = 0; m < net.own.size(); ++m) {
    const T& share = net.to_net[m];
    const int row = net.built->muscles[m].muscle;
    R.row(row) = (T(1) - share) * R.row(row) +
                 share * moment_arms(tree, state, net.own[m], static_cast<int>(R.cols()));
  }
}

/// Returns whether any muscle pulls the net. An unloaded net exerts no joint torque, because forces
/// are measured relative to the unloaded finger.
[[nodiscard]] bool pulls_net(const BuiltNet& built, const Eigen::VectorXd& t);

/// Returns the net with these numbers.
/// @param angle  flexion of the metacarpophalangeal joint for which muscles divide their tension
///               among their pulls [rad]
[[nodiscard]] BuiltNet built_net(const SpecimenNet<double>& net, double angle = kHoodAngle);

}  // namespace thenar
