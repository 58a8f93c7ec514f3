#include "tendons/net/net_continuation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tendons/net/net_derivatives.h"
#include "tendons/net/net_search.h"
#include "tendons/net/net_statics.h"
#include "tendons/net/tangent_net.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

/// Velocity of all nodes of a net at rest while posture and tensions change; none without slopes.
Matrix3Xd node_velocity(const NetTendons& tendons, const NetEquilibrium& rest, const VectorXd& q,
                        const VectorXd& t, const VectorXd& q_dot, const VectorXd& t_dot) {
  const Net& net = tendons.net().net;
  const Tree<double>& tree = tendons.digit().model.tree;
  // The perturbation is the sum of all joint velocities ...
  const TreeState<double> state = pose_tree(tree, q);
  const internal::TangentNet tangent(net, state, {tendons.drive(t), {}}, rest);
  internal::NetPerturbation input = internal::still(net, tree.size());
  for (Eigen::Index j = 0; j < q_dot.size(); ++j) {
    if (q_dot[j] == 0) continue;
    const internal::NetPerturbation turn =
        internal::joint_perturbation(net, tree, state, static_cast<int>(j));
    for (std::size_t i = 0; i < input.link.size(); ++i) {
      input.link[i].v += q_dot[j] * turn.link[i].v;
      input.link[i].w += q_dot[j] * turn.link[i].w;
    }
    for (std::size_t i = 0; i < input.axis.size(); ++i) {
      input.axis[i] += q_dot[j] * turn.axis[i];
      input.point[i] += q_dot[j] * turn.point[i];
    }
  }
  // ... and of the rates of the pulls.
  const VectorXd drive_dot = tendons.drive(t_dot);
  for (std::size_t b = 0; b < net.bands.size(); ++b)
    if (net.bands[b].muscle >= 0)
      input.tension[static_cast<Eigen::Index>(b)] = drive_dot[net.bands[b].muscle];
  return internal::node_rates(tangent, input);
}

/// Whether a knot may be asked where it is.
bool settled(const Net& net, const NetEquilibrium& rest) {
  return why_not_differentiable(net, rest).empty();
}

bool unbalanced(const NetEquilibrium& rest) {
  return rest.status == NetStatus::kStalled || rest.status == NetStatus::kFarSideWrap;
}

/// Whether a muscle pulls the net, so that its knots have a place.
bool pulled(const NetTendons& tendons, const VectorXd& t) {
  constexpr double kSlack = 1e-6;  // [N]
  const VectorXd drive = tendons.drive(t);
  return drive.size() > 0 && drive.maxCoeff() > kSlack;
}

}  // namespace

double largest_deviation(const Net& net, const std::vector<int>& loose_before, const Matrix3Xd& x,
                         const NetEquilibrium& rest) {
  const auto among = [](const std::vector<int>& nodes, int node) {
    return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
  };
  double furthest = 0;
  for (std::size_t i = 0; i < net.nodes.size(); ++i) {
    const auto node = static_cast<int>(i);
    if (!net.nodes[i].free || among(loose_before, node) || among(rest.undetermined, node)) continue;
    furthest = std::max(furthest, (rest.x.col(node) - x.col(node)).norm());
  }
  return furthest;
}

namespace {

double largest(const VectorXd& entries) { return entries.size() > 0 ? entries.maxCoeff() : 0; }

/// A net under way. Its place is the share of the way that is done, 0 to 1.
class NetWalk {
 public:
  NetWalk(const NetTendons& tendons, const NetEquilibrium& rest, const PostureAndLoad& from,
          const PostureAndLoad& to, const NetContinuationOptions& options)
      : tendons_(tendons),
        from_(from),
        to_(to),
        turn_(to.q - from.q),
        load_(to.t - from.t),
        options_(options),
        walk_{rest, {}, 0, 0, true} {
    // The least part of the way that counts as a step.
    const double most = std::max({largest(from.t), largest(to.t), 1e-3});
    const double turned = largest(turn_.cwiseAbs()) / options.min_turn;
    const double loaded = largest(load_.cwiseAbs()) / (options.min_load * most);
    least_ = 1 / std::max({turned, loaded, 1.0});
  }

  NetContinuation run() {
    while (done_ < 1) take_step();
    return std::move(walk_);
  }

 private:
  /// Predicts and corrects, with a step so short that the correction is small.
  void take_step() {
    const Net& net = tendons_.net().net;
    const bool follows = settled(net, walk_.rest) && pulled(tendons_, from_.t + done_ * load_) &&
                         pulled(tendons_, to_.t) && walk_.solves < options_.max_solves;
    Matrix3Xd rate = Matrix3Xd::Zero(3, walk_.rest.x.cols());
    if (follows)
      rate = node_velocity(tendons_, walk_.rest, from_.q + done_ * turn_, from_.t + done_ * load_,
                           turn_, load_);
    else
      step_ = 1 - done_;
    if (walk_.solves >= options_.max_solves) walk_.followed = false;
    for (;;) {
      const double end = step_ >= 1 - done_ ? 1 : done_ + step_;
      const Matrix3Xd start = walk_.rest.x + (end - done_) * rate;
      NetEquilibrium next = rest_at(end, start);
      // Distance between prediction and equilibrium.
      const bool judged = follows && settled(net, next);
      const double off = judged ? largest_deviation(net, walk_.rest.undetermined, start, next) : 0;
      const bool astray = off > options_.stray || (follows && !judged);
      if (!astray || !(end - done_ > least_) || walk_.solves >= options_.max_solves) {
        if (off > options_.stray) note_snap(next, end, off);
        return accept(std::move(next), end, off);
      }
      const double shorter = judged ? std::min(next_step(off), 0.5) : 0.5;
      step_ = std::max(shorter * (end - done_), 0.5 * least_);
    }
  }

  /// Length of the next step per that of one after which the net lay `off` from its prediction,
  /// which grows with the square of the step.
  /// @param off  [m]; 0: not judged
  [[nodiscard]] double next_step(double off) const {
    constexpr double kSafety = 0.8, kShortest = 0.1, kLongest = 4;
    if (off == 0) return kLongest;
    return std::clamp(kSafety * std::sqrt(options_.stray / off), kShortest, kLongest);
  }

  [[nodiscard]] NetEquilibrium rest_at(double place, const Matrix3Xd& start) {
    NetEquilibrium rest =
        tendons_.rest(from_.q + place * turn_, from_.t + place * load_, start);
    ++walk_.solves;
    walk_.effort += rest.evaluations;
    return rest;
  }

  /// Strain energy and what the pulls t hold,  strain + t L,  of the net alone [J].
  [[nodiscard]] double potential(const NetEquilibrium& rest, const VectorXd& t) const {
    const Net& net = tendons_.net().net;
    return strain_energy(net, rest) + tendons_.drive(t).dot(muscle_band_length(net, rest));
  }

  /// Notes a jump to `next`, at the end of a step so short that the net would have followed it by
  /// its slopes,  d(strain + t L) = -tau dq + L dt.
  void note_snap(const NetEquilibrium& next, double end, double moved) {
    const Net& net = tendons_.net().net;
    const TendonModel<double>& model = tendons_.digit().model;
    const NetEquilibrium& rest = walk_.rest;
    const VectorXd q = from_.q + done_ * turn_, t = from_.t + done_ * load_;
    const double step = end - done_;
    // Energy that it would have there, less what it has.
    const VectorXd tau =
        net_torque(net, model.tree, pose_tree(model.tree, q), rest, model.coordinates);
    const double led = potential(rest, t) - step * tau.dot(turn_) +
                       step * tendons_.drive(load_).dot(muscle_band_length(net, rest));
    NetJump snap;
    snap.from = done_, snap.share = end;
    snap.before = rest, snap.after = next;
    snap.moved = moved;
    snap.released = led - potential(next, t + step * load_);
    // Band whose tension changed most.
    Eigen::Index most = 0;
    (next.tension - rest.tension).cwiseAbs().maxCoeff(&most);
    snap.band = net.bands[static_cast<std::size_t>(most)].name;
    walk_.snaps.push_back(std::move(snap));
  }

  /// Takes the equilibrium at the end of a step, `off` from its prediction [m].
  void accept(NetEquilibrium next, double end, double off) {
    // No balance found from the prediction: search from scratch.
    if (unbalanced(next)) {
      NetEquilibrium cold = rest_at(end, {});
      if (!unbalanced(cold)) {
        next = std::move(cold);
        const double moved = largest_deviation(tendons_.net().net, walk_.rest.undetermined,
                                               walk_.rest.x, next);
        if (moved > options_.stray) note_snap(next, end, moved);
      }
    }
    walk_.rest = std::move(next);
    step_ = std::max(next_step(off), 0.5) * (end - done_);
    done_ = end;
  }

  const NetTendons& tendons_;
  const PostureAndLoad &from_, &to_;
  VectorXd turn_, load_;  // whole change of posture [rad] and tension [N]
  const NetContinuationOptions& options_;
  NetContinuation walk_;
  double least_ = 0, done_ = 0, step_ = 1;  // shares of the way [1]
};

}  // namespace

NetContinuation follow_net(const NetTendons& tendons, const NetEquilibrium& rest,
                           const PostureAndLoad& from, const PostureAndLoad& to,
                           const NetContinuationOptions& options) {
  return NetWalk(tendons, rest, from, to, options).run();
}

// NOLINTNEXTLINE(misc-no-recursion): once, for the finger without frozen joints
NetContinuation follow_from_straight(const NetTendons& tendons, const VectorXd& q,
                                     const VectorXd& t, const NetContinuationOptions& options) {
  // A finger with frozen joints goes the way of the one that can bend them.
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
