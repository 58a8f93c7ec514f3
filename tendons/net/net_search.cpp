#include "tendons/net/net_search.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Solves for an equilibrium without a start.
NetContinuation solve_without_start(const NetTendons& tendons, const VectorXd& q,
                                    const VectorXd& t) {
  NetContinuation found;
  found.rest = tendons.rest(q, t, {});
  found.solves = 1;
  found.effort = found.rest.evaluations;
  return found;
}

/// Follows a net through postures and loads in turn, from its equilibrium at the first of them.
NetContinuation follow_ways(const NetTendons& tendons, const std::vector<PostureAndLoad>& places,
                            const NetContinuationOptions& options) {
  NetContinuation walk = solve_without_start(tendons, places.front().q, places.front().load);
  for (std::size_t i = 1; i < places.size(); ++i) {
    NetContinuation leg = follow_net(tendons, walk.rest, places[i - 1], places[i], options);
    walk.rest = std::move(leg.rest);
    walk.snaps.insert(walk.snaps.end(), leg.snaps.begin(), leg.snaps.end());
    walk.solves += leg.solves;
    walk.effort += leg.effort;
    walk.followed = walk.followed && leg.followed;
  }
  return walk;
}

/// Order in which joints of the straight finger are bent one after the other.
enum class BendOrder { kFromTip, kFromBase };
std::vector<PostureAndLoad> joint_by_joint(const VectorXd& straight, const VectorXd& q,
                                           const VectorXd& t, BendOrder order) {
  std::vector<PostureAndLoad> places{{straight, t}};
  for (Index i = 0; i < q.size(); ++i) {
    const Index j = order == BendOrder::kFromTip ? q.size() - 1 - i : i;
    places.push_back(places.back());
    places.back().q[j] = q[j];
  }
  return places;
}

/// Returns the way under an even pull of all muscles of the net, with the given tensions at its
/// end.
std::vector<PostureAndLoad> under_even_load(const NetTendons& tendons, const VectorXd& straight,
                                            const VectorXd& q, const VectorXd& t) {
  VectorXd even = t;
  const double most = std::max(1.0, t.maxCoeff());
  for (const NetMuscle& muscle : tendons.net().muscles) even[muscle.muscle] = most;
  return {{straight, even}, {q, even}, {q, t}};
}

}  // namespace

NetContinuation search_rest(const NetTendons& tendons, const VectorXd& q, const VectorXd& t,
                            NetContinuation found, const NetContinuationOptions& options) {
  // Solves on one leg of a way; a way that needs more is rejected
  constexpr int kMaxLegSolves = 100;
  const VectorXd& straight = tendons.net().frame.straight;
  NetContinuationOptions quick = options;
  quick.max_solves = std::min(options.max_solves, kMaxLegSolves);
  const std::vector<std::function<NetContinuation()>> ways{
      [&] { return solve_without_start(tendons, q, t); },
      [&] { return follow_ways(tendons, under_even_load(tendons, straight, q, t), quick); },
      [&] {
        return follow_ways(tendons, joint_by_joint(straight, q, t, BendOrder::kFromTip), quick);
      },
      [&] {
        return follow_ways(tendons, joint_by_joint(straight, q, t, BendOrder::kFromBase), quick);
      }};
  for (const auto& way : ways) {
    NetContinuation other = way();
    found.solves += other.solves;
    found.effort += other.effort;
    if (!is_sound(other.rest)) continue;
    // Record a snap at the end, since the equilibrium is not on the straight way.
    if (found.snaps.empty()) {
      NetJump jump;
      jump.from = 1;
      jump.before = found.rest;
      jump.after = other.rest;
      found.snaps.push_back(std::move(jump));
    }
    found.rest = std::move(other.rest);
    return found;
  }
  return found;
}

}  // namespace thenar
