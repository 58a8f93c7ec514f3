#include "tendons/net/net_follower.h"

#include <cmath>
#include <utility>

#include "tendons/net/net_derivatives.h"
#include "tendons/net/net_statics.h"
#include "tendons/net/tangent_net.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::Map;
using Eigen::Matrix3Xd;
using Eigen::VectorXd;

/// A net out of balance by more than this share of its largest pull has no torque [1].
constexpr double kOutOfBalance = 1e-6;

bool is_balanced(const NetEquilibrium& rest, const VectorXd& drive) {
  if (rest.status != NetStatus::kStalled && rest.status != NetStatus::kFarSideWrap) return true;
  return rest.residual <= kOutOfBalance * drive.maxCoeff();
}

/// A torque that no integrator accepts.
TendonTorque no_torque(Index joints, Index muscles, std::string why) {
  TendonTorque pull;
  pull.tau = VectorXd::Constant(joints, HUGE_VAL);
  pull.R = Eigen::MatrixXd::Zero(muscles, joints);
  pull.status = TendonStatus::kUnbalanced;
  pull.warning = std::move(why);
  return pull;
}

}  // namespace

NetContinuationOptions follower_options() {
  NetContinuationOptions options;
  options.max_solves = 100;
  return options;
}

NetFollower::NetFollower(const NetTendons& tendons, const NetContinuationOptions& options)
    : tendons_(tendons), options_(options) {}

void NetFollower::reach(const PostureAndLoad& to) {
  if (asked_.q.size() > 0 && asked_.q == to.q && asked_.t == to.t) return;
  asked_ = to;
  if (!known_) {
    reached_ = follow_from_straight(tendons_, to.q, to.t);
    return;
  }
  // One search from where slopes say suffices for short steps.
  if (by_posture_.size() > 0) {
    const VectorXd move = by_posture_ * (to.q - here_.q) + by_load_ * (to.t - here_.t);
    const Matrix3Xd start = rest_.x + Map<const Matrix3Xd>(move.data(), 3, rest_.x.cols());
    NetEquilibrium next = tendons_.rest(to.q, to.t, start);
    const Net& net = tendons_.net().net;
    const double off = largest_deviation(net, rest_.undetermined, start, next);
    if (off <= options_.stray && why_not_differentiable(net, next).empty()) {
      const long effort = next.evaluations;
      reached_ = {std::move(next), {}, 1, effort, true};
      return;
    }
  }
  // Otherwise in shorter ones.
  reached_ = follow_net(tendons_, rest_, here_, to, options_);
}

TendonTorque NetFollower::at(const VectorXd& q, const VectorXd& t) {
  reach({q, t});
  TendonTorque pull;
  if (reached_.followed && is_balanced(reached_.rest, tendons_.drive(t))) {
    pull = tendons_.torque_at_rest(q, t, reached_.rest);
  } else {
    const Net& net = tendons_.net().net;
    const TreeState<double> state = pose_tree(tendons_.digit().model.tree, q);
    const std::string why = net_warning(net, state, reached_.rest);
    pull = no_torque(q.size(), t.size(),
                     why.empty() ? fmt::format("net '{}' moves too far in a step", net.name) : why);
  }
  pull.effort = reached_.effort;
  return pull;
}

NetStep NetFollower::accept(const VectorXd& q, const VectorXd& t) {
  reach({q, t});
  NetStep step;
  if (known_) {
    // From here to the first snap, from snap to snap, and on to there.
    const VectorXd turn = q - here_.q, load = t - here_.t;
    PostureAndLoad from = here_;
    const NetEquilibrium* rest = &rest_;
    for (const NetJump& snap : reached_.snaps) {
      step.unexplained += unexplained(
          from, *rest, {here_.q + snap.from * turn, here_.t + snap.from * load}, snap.before);
      step.snaps.push_back(snap);
      from = {here_.q + snap.share * turn, here_.t + snap.share * load};
      rest = &snap.after;
    }
    step.unexplained += unexplained(from, *rest, {q, t}, reached_.rest);
  }
  known_ = true;
  here_ = {q, t};
  rest_ = reached_.rest;
  reached_.snaps.clear();
  find_slopes();
  return step;
}

NetFollower::Potential NetFollower::potential(const PostureAndLoad& at,
                                              const NetEquilibrium& rest) const {
  const Net& net = tendons_.net().net;
  const TendonModel<double>& model = tendons_.digit().model;
  Potential out;
  out.L = tendons_.shares().transpose() * muscle_band_length(net, rest);
  out.energy = strain_energy(net, rest) + at.t.dot(out.L);
  out.tau = net_torque(net, model.tree, pose_tree(model.tree, at.q), rest, model.coordinates);
  return out;
}

/// Change of the potential between two states less  -tau dq + L dt,  by the trapezoid between them;
/// where that leaves more than `kRound`, by Simpson's rule.
double NetFollower::unexplained(const PostureAndLoad& from, const NetEquilibrium& rest,
                                const PostureAndLoad& to, const NetEquilibrium& there) const {
  constexpr double kRound = 1e-11;  // [J]
  const VectorXd turn = to.q - from.q, load = to.t - from.t;
  const auto rate = [&](const Potential& at) { return at.L.dot(load) - at.tau.dot(turn); };
  const Potential first = potential(from, rest), last = potential(to, there);
  const double gained = last.energy - first.energy, ends = rate(first) + rate(last);
  if (std::abs(gained - ends / 2) <= kRound) return gained - ends / 2;
  const PostureAndLoad middle{from.q + turn / 2, from.t + load / 2};
  const NetEquilibrium between = tendons_.rest(middle.q, middle.t, (rest.x + there.x) / 2);
  return gained - (ends + 4 * rate(potential(middle, between))) / 6;
}

void NetFollower::find_slopes() {
  const Net& net = tendons_.net().net;
  by_posture_.resize(0, 0);
  if (!why_not_differentiable(net, rest_).empty()) return;
  const Tree<double>& tree = tendons_.digit().model.tree;
  const TreeState<double> state = pose_tree(tree, here_.q);
  const internal::TangentNet tangent(net, state, {tendons_.drive(here_.t), {}}, rest_);
  // One column a joint.
  by_posture_.resize(rest_.x.size(), here_.q.size());
  for (Index j = 0; j < here_.q.size(); ++j) {
    const Matrix3Xd v = internal::node_rates(
        tangent, internal::joint_perturbation(net, tree, state, static_cast<int>(j)));
    by_posture_.col(j) = Map<const VectorXd>(v.data(), v.size());
  }
  // One column a pull, then shares of the digit's muscles.
  Eigen::MatrixXd by_pull(rest_.x.size(), static_cast<Index>(net.muscles.size()));
  for (Index m = 0; m < by_pull.cols(); ++m) {
    internal::NetPerturbation input = internal::still(net, tree.size());
    for (std::size_t b = 0; b < net.bands.size(); ++b)
      if (net.bands[b].muscle == m) input.tension[static_cast<Index>(b)] = 1;
    const Matrix3Xd v = internal::node_rates(tangent, input);
    by_pull.col(m) = Map<const VectorXd>(v.data(), v.size());
  }
  by_load_ = by_pull * tendons_.shares();
}

}  // namespace thenar
