#include "tendons/net/net_follower.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tendons/net/net_derivatives.h"
#include "tendons/net/tangent_net.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::Map;
using Eigen::Matrix3Xd;
using Eigen::VectorXd;

/// Largest residual of a net with a valid torque, over its largest pull [1].
constexpr double kMaxResidualRatio = 1e-6;

/// Returns whether an equilibrium is balanced, at least to kMaxResidualRatio.
bool is_balanced(const Net& net, const NetEquilibrium& rest) {
  if (!is_unbalanced(rest)) return true;
  double largest = 0;
  for (std::size_t b = 0; b < net.bands.size(); ++b)
    if (net.bands[b].muscle >= 0) largest = std::max(largest, rest.tension[b]);
  return rest.residual <= kMaxResidualRatio * largest;
}

}  // namespace

NetContinuationOptions follower_options() {
  NetContinuationOptions options;
  options.max_solves = 100;
  return options;
}

NetFollower::NetFollower(const NetTendons& tendons, const NetContinuationOptions& options)
    : pull_(std::make_unique<PullByTension>(tendons)), tendons_(tendons), options_(options) {}

NetFollower::NetFollower(std::unique_ptr<PullByTendon> pull, PostureAndLoad here,
                         const NetEquilibrium& rest)
    : pull_(std::move(pull)),
      tendons_(pull_->tendons()),
      options_(follower_options()),
      known_(true),
      here_(std::move(here)),
      // refined under the loads of its tendons
      rest_(pull_->rest(here_, rest.x)) {
  find_slopes();
}

void NetFollower::reach(const PostureAndLoad& to) {
  if (asked_.q.size() > 0 && asked_.q == to.q && asked_.load == to.load) return;
  asked_ = {};  // cleared in case the search throws
  reached_ = way_to(to);
  asked_ = to;
}

NetContinuation NetFollower::way_to(const PostureAndLoad& to) const {
  if (!known_) return follow_from_straight(tendons_, to.q, to.load);
  // Try one search from the prediction, enough for short steps.
  long spent = 0;
  if (by_posture_.size() > 0) {
    const VectorXd move = by_posture_ * (to.q - here_.q) + by_load_ * (to.load - here_.load);
    const Matrix3Xd start = rest_.x + Map<const Matrix3Xd>(move.data(), 3, rest_.x.cols());
    NetEquilibrium next = pull_->rest(to, start);
    const Net& net = tendons_.net().net;
    const double off = largest_deviation(net, rest_.undetermined, start, next);
    if (off <= options_.stray && why_not_differentiable(net, next).empty()) {
      const long effort = next.evaluations;
      return {std::move(next), {}, 1, effort, true};
    }
    spent = next.evaluations;
  }
  // Otherwise follow the net in shorter steps.
  NetContinuation way = follow_net(*pull_, rest_, here_, to, options_);
  way.effort += spent;
  return way;
}

TendonTorque NetFollower::torque_at(const VectorXd& q, const VectorXd& load) {
  reach({q, load});
  TendonTorque pull;
  const Net& net = tendons_.net().net;
  if (reached_.followed && is_balanced(net, reached_.rest)) {
    pull = pull_->torque({q, load}, reached_.rest);
  } else {
    const TreeState<double> state = pose_tree(tendons_.digit().model.tree, q);
    const std::string why = net_warning(net, state, reached_.rest);
    pull = infinite_torque(
        q.size(), load.size(),
        why.empty() ? fmt::format("net '{}' moves too far in a step", net.name) : why);
  }
  pull.effort = reached_.effort;
  return pull;
}

NetStep NetFollower::accept(const VectorXd& q, const VectorXd& load) {
  reach({q, load});
  NetStep step;
  if (known_) {
    // Sum the unexplained energy from here to the first snap, between snaps, and to the end.
    const VectorXd turn = q - here_.q, more = load - here_.load;
    const auto at = [&](double share) -> PostureAndLoad {
      return {here_.q + share * turn, here_.load + share * more};
    };
    PostureAndLoad from = here_;
    const NetEquilibrium* rest = &rest_;
    for (const NetJump& snap : reached_.snaps) {
      step.unexplained += unexplained(from, *rest, at(snap.from), snap.before);
      step.snaps.push_back(snap);
      from = at(snap.share);
      rest = &snap.after;
    }
    step.unexplained += unexplained(from, *rest, {q, load}, reached_.rest);
  }
  known_ = true;
  here_ = {q, load};
  rest_ = reached_.rest;
  reached_.snaps.clear();
  find_slopes();
  return step;
}

EndSlopes NetFollower::slopes(const VectorXd& q, const VectorXd& load) {
  reach({q, load});
  return pull_->slopes({q, load}, reached_.rest);
}

/// Computes the change of the potential between two states less the integral of its gradient, by
/// the trapezoidal rule; where that leaves more than `kRoundedEnergy`, by Simpson's rule.
double NetFollower::unexplained(const PostureAndLoad& from, const NetEquilibrium& rest,
                                const PostureAndLoad& to, const NetEquilibrium& there) const {
  constexpr double kRoundedEnergy = 1e-11;  // energy difference explained by rounding [J]
  const VectorXd turn = to.q - from.q, load = to.load - from.load;
  const auto rate = [&](const NetPotential& at) { return at.by_load.dot(load) - at.tau.dot(turn); };
  const NetPotential first = pull_->potential(from, rest), last = pull_->potential(to, there);
  const double gained = last.energy - first.energy, ends = rate(first) + rate(last);
  if (std::abs(gained - ends / 2) <= kRoundedEnergy) return gained - ends / 2;
  const PostureAndLoad middle{from.q + turn / 2, from.load + load / 2};
  const NetEquilibrium between = pull_->rest(middle, (rest.x + there.x) / 2);
  return gained - (ends + 4 * rate(pull_->potential(middle, between))) / 6;
}

void NetFollower::find_slopes() {
  const Net& net = tendons_.net().net;
  by_posture_.resize(0, 0);
  if (!why_not_differentiable(net, rest_).empty()) return;
  const Tree<double>& tree = tendons_.digit().model.tree;
  const TreeState<double> state = pose_tree(tree, here_.q);
  const internal::TangentNet tangent(net, state, pull_->drive(here_), rest_);
  const PullRates by = pull_->rates(here_, rest_);
  // Compute one column per joint.
  by_posture_.resize(rest_.x.size(), here_.q.size());
  for (Index j = 0; j < here_.q.size(); ++j) {
    internal::NetPerturbation input =
        internal::joint_perturbation(net, tree, state, static_cast<int>(j));
    internal::add_pull_rates(net, by.by_posture.col(j), input);
    const Matrix3Xd v = internal::node_rates(tangent, input);
    by_posture_.col(j) = Map<const VectorXd>(v.data(), v.size());
  }
  // Compute one column per pull, then convert to loads.
  Eigen::MatrixXd by_pull(rest_.x.size(), static_cast<Index>(net.muscles.size()));
  for (Index m = 0; m < by_pull.cols(); ++m) {
    internal::NetPerturbation input = internal::zero_perturbation(net, tree.size());
    internal::add_pull_rates(net, VectorXd::Unit(by_pull.cols(), m), input);
    const Matrix3Xd v = internal::node_rates(tangent, input);
    by_pull.col(m) = Map<const VectorXd>(v.data(), v.size());
  }
  by_load_ = by_pull * by.by_load;
}

}  // namespace thenar
