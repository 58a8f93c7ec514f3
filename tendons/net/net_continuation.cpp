#include "tendons/net/net_continuation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/lists.h"
#include "tendons/net/net_derivatives.h"
#include "tendons/net/net_search.h"
#include "tendons/net/tangent_net.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

/// Computes the velocity of all nodes of a net in equilibrium while posture and loads change.
Matrix3Xd node_velocity(const NetPull& pull, const NetEquilibrium& rest, const PostureAndLoad& at,
                        const PostureAndLoad& rate) {
  const Net& net = pull.tendons().net().net;
  const Tree<double>& tree = pull.tendons().digit().model.tree;
  // Sum the perturbations of all joint velocities.
  const TreeState<double> state = pose_tree(tree, at.q);
  const internal::TangentNet tangent(net, state, pull.drive(at), rest);
  internal::NetPerturbation input = internal::zero_perturbation(net, tree.size());
  for (Eigen::Index j = 0; j < rate.q.size(); ++j) {
    if (rate.q[j] == 0) continue;
    const internal::NetPerturbation turn =
        internal::joint_perturbation(net, tree, state, static_cast<int>(j));
    for (std::size_t i = 0; i < input.link.size(); ++i) {
      input.link[i].v += rate.q[j] * turn.link[i].v;
      input.link[i].w += rate.q[j] * turn.link[i].w;
    }
    for (std::size_t i = 0; i < input.axis.size(); ++i) {
      input.axis[i] += rate.q[j] * turn.axis[i];
      input.point[i] += rate.q[j] * turn.point[i];
    }
  }
  // Add the rates of the pulls and solve for the nodes.
  const PullRates by = pull.rates(at, rest);
  internal::add_pull_rates(net, by.by_posture * rate.q + by.by_load * rate.load, input);
  return internal::node_rates(tangent, input);
}

/// Returns whether the net is differentiable, so that its nodes are determined.
bool is_differentiable(const Net& net, const NetEquilibrium& rest) {
  return why_not_differentiable(net, rest).empty();
}

}  // namespace

double largest_deviation(const Net& net, const std::vector<int>& loose_before, const Matrix3Xd& x,
                         const NetEquilibrium& rest) {
  double furthest = 0;
  for (std::size_t i = 0; i < net.nodes.size(); ++i) {
    const auto node = static_cast<int>(i);
    if (!net.nodes[i].free || contains(loose_before, node) || contains(rest.undetermined, node))
      continue;
    furthest = std::max(furthest, (rest.x.col(node) - x.col(node)).norm());
  }
  return furthest;
}

namespace {

/// Returns the largest entry, 0 if there is none.
double largest_entry(const VectorXd& entries) {
  return entries.size() > 0 ? entries.maxCoeff() : 0;
}

/// Continuation of a net along a straight way. Its position is the fraction done, 0 to 1.
class NetWalk {
 public:
  NetWalk(const NetPull& pull, const NetEquilibrium& rest, const PostureAndLoad& from,
          const PostureAndLoad& to, const NetContinuationOptions& options)
      : pull_(pull),
        net_(pull.tendons().net().net),
        from_(from),
        to_(to),
        way_{to.q - from.q, to.load - from.load},
        options_(options),
        walk_{rest, {}, 0, 0, true} {
    // Compute the smallest step as a fraction of the way.
    const double turned = largest_entry(way_.q.cwiseAbs()) / options.min_turn;
    const double loaded =
        largest_entry(way_.load.cwiseAbs()) / pull.min_change(from.load, to.load, options.min_load);
    min_step_ = 1 / std::max({turned, loaded, 1.0});
  }

  /// Follows the net to the end of the way.
  NetContinuation run() {
    while (done_ < 1) take_step();
    return std::move(walk_);
  }

 private:
  /// Takes one predictor-corrector step, so short that the correction is small.
  void take_step() {
    const bool follows = is_differentiable(net_, walk_.rest) && pull_.pulls(at(done_).load) &&
                         pull_.pulls(to_.load) && walk_.solves < options_.max_solves;
    Matrix3Xd rate = Matrix3Xd::Zero(3, walk_.rest.x.cols());
    if (follows)
      rate = node_velocity(pull_, walk_.rest, at(done_), way_);
    else
      step_ = 1 - done_;
    if (walk_.solves >= options_.max_solves) walk_.followed = false;
    for (;;) {
      const double end = step_ >= 1 - done_ ? 1 : done_ + step_;
      const Matrix3Xd start = walk_.rest.x + (end - done_) * rate;
      NetEquilibrium next = equilibrium_at(end, start);
      // Measure the distance between prediction and equilibrium.
      const bool judged = follows && is_differentiable(net_, next);
      const double off = judged ? largest_deviation(net_, walk_.rest.undetermined, start, next) : 0;
      const bool astray = off > options_.stray || (follows && !judged);
      if (!astray || !(end - done_ > min_step_) || walk_.solves >= options_.max_solves) {
        if (off > options_.stray) record_snap(next, end, off);
        return accept(std::move(next), end, off);
      }
      const double shorter = judged ? std::min(next_step(off), 0.5) : 0.5;
      step_ = std::max(shorter * (end - done_), 0.5 * min_step_);
    }
  }

  /// Computes the ratio of the next step's length to that of a step with prediction error `off`,
  /// which grows with the square of the step.
  /// @param off  [m]; 0: not measured
  [[nodiscard]] double next_step(double off) const {
    // Safety factor of the next step, and bounds of its ratio to the last step [1]
    constexpr double kStepSafety = 0.8, kMinStepRatio = 0.1, kMaxStepRatio = 4;
    if (off == 0) return kMaxStepRatio;
    return std::clamp(kStepSafety * std::sqrt(options_.stray / off), kMinStepRatio, kMaxStepRatio);
  }

  /// Solves for the equilibrium at a fraction of the way.
  [[nodiscard]] NetEquilibrium equilibrium_at(double place, const Matrix3Xd& start) {
    NetEquilibrium rest = pull_.rest(at(place), start);
    ++walk_.solves;
    walk_.effort += rest.evaluations;
    return rest;
  }

  /// Returns posture and load at a fraction of the way.
  [[nodiscard]] PostureAndLoad at(double place) const {
    return {from_.q + place * way_.q, from_.load + place * way_.load};
  }

  /// Records a snap to `next`, at the end of a step so short that the net would have followed its
  /// potential linearly.
  void record_snap(const NetEquilibrium& next, double end, double moved) {
    const NetEquilibrium& rest = walk_.rest;
    // Compare the extrapolated energy with the actual one.
    const NetPotential here = pull_.potential(at(done_), rest);
    const double extrapolated =
        here.energy + (end - done_) * (here.by_load.dot(way_.load) - here.tau.dot(way_.q));
    NetJump snap;
    snap.from = done_, snap.share = end;
    snap.before = rest, snap.after = next;
    snap.moved = moved;
    snap.released = extrapolated - pull_.potential(at(end), next).energy;
    // Find the band whose tension changed most.
    Eigen::Index most = 0;
    (next.tension - rest.tension).cwiseAbs().maxCoeff(&most);
    snap.band = net_.bands[most].name;
    walk_.snaps.push_back(std::move(snap));
  }

  /// Accepts the equilibrium at the end of a step, with prediction error `off` [m].
  void accept(NetEquilibrium next, double end, double off) {
    // Search without a start if no equilibrium was found from the prediction.
    if (is_unbalanced(next)) {
      NetEquilibrium cold = equilibrium_at(end, {});
      if (!is_unbalanced(cold)) {
        next = std::move(cold);
        const double moved = largest_deviation(net_, walk_.rest.undetermined, walk_.rest.x, next);
        if (moved > options_.stray) record_snap(next, end, moved);
      }
    }
    walk_.rest = std::move(next);
    step_ = std::max(next_step(off), 0.5) * (end - done_);
    done_ = end;
  }

  const NetPull& pull_;
  const Net& net_;
  const PostureAndLoad &from_, &to_;
  PostureAndLoad way_;  // total change of posture and load
  const NetContinuationOptions& options_;
  NetContinuation walk_;
  double min_step_ = 0, done_ = 0, step_ = 1;  // fractions of the way [1]
};

}  // namespace

NetContinuation follow_net(const NetTendons& tendons, const NetEquilibrium& rest,
                           const PostureAndLoad& from, const PostureAndLoad& to,
                           const NetContinuationOptions& options) {
  return follow_net(PullByTension(tendons), rest, from, to, options);
}

NetContinuation follow_net(const NetPull& pull, const NetEquilibrium& rest,
                           const PostureAndLoad& from, const PostureAndLoad& to,
                           const NetContinuationOptions& options) {
  return NetWalk(pull, rest, from, to, options).run();
}

// NOLINTNEXTLINE(misc-no-recursion): one level, for the finger without frozen joints
NetContinuation follow_from_straight(const NetTendons& tendons, const VectorXd& q,
                                     const VectorXd& t, const NetContinuationOptions& options) {
  // Follow the finger with all joints free if joints are frozen.
  const FreeFinger& free = tendons.free_finger();
  if (free.tendons) {
    NetContinuation walk =
        follow_from_straight(*free.tendons, free.posture(q), free.tensions(t), options);
    walk.rest = tendons.rest(q, t, walk.rest.x);
    return walk;
  }
  const VectorXd straight = tendons.net().frame.straight;
  NetContinuation walk =
      follow_net(tendons, tendons.rest(straight, t, {}), {straight, t}, {q, t}, options);
  if (is_sound(walk.rest)) return walk;
  return search_rest(tendons, q, t, std::move(walk), options);
}

}  // namespace thenar
