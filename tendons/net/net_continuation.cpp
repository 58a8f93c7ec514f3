#include "tendons/net/net_continuation.h"

#include <algorithm>
#include <cmath>

#include "tendons/net/net_derivatives.h"
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

NetContinuation follow_net(const NetTendons& tendons, const NetEquilibrium& rest, const VectorXd& q,
                           const VectorXd& t, const VectorXd& to_q, const VectorXd& to_t,
                           const NetContinuationOptions& options) {
  const Net& net = tendons.net().net;
  // Whole change of posture and tension.
  const VectorXd turn = to_q - q, load = to_t - t;
  const double most =
      std::max({t.size() > 0 ? t.maxCoeff() : 0, to_t.size() > 0 ? to_t.maxCoeff() : 0, 1e-3});
  // The least part of the way that counts as a step.
  const double turned = turn.size() > 0 ? turn.cwiseAbs().maxCoeff() / options.min_turn : 0;
  const double loaded =
      load.size() > 0 ? load.cwiseAbs().maxCoeff() / (options.min_load * most) : 0;
  const double least = 1 / std::max({turned, loaded, 1.0});
  NetContinuation walk{rest, 0, 0};
  double done = 0, step = 1;
  // Predict and correct until the end is reached.
  while (done < 1) {
    const bool follows = settled(net, walk.rest) && pulled(tendons, t + done * load) &&
                         pulled(tendons, to_t) && walk.solves < options.max_solves;
    Matrix3Xd rate = Matrix3Xd::Zero(3, walk.rest.x.cols());
    if (follows)
      rate = node_velocity(tendons, walk.rest, q + done * turn, t + done * load, turn, load);
    else
      step = 1 - done;
    // Shorten the step until the correction is small.
    for (;;) {
      const double end = step >= 1 - done ? 1 : done + step;
      const Matrix3Xd start = walk.rest.x + (end - done) * rate;
      NetEquilibrium next = tendons.rest(q + end * turn, t + end * load, start);
      ++walk.solves;
      // Distance between prediction and equilibrium.
      const bool judged = follows && settled(net, next);
      const double off = judged ? largest_deviation(net, walk.rest.undetermined, start, next) : 0;
      const bool astray = off > options.stray || (follows && !judged);
      if (astray && end - done > least && walk.solves < options.max_solves) {
        step = 0.5 * (end - done);
        continue;
      }
      if (off > options.stray) ++walk.snaps;
      // No balance found from the prediction: search from scratch.
      if (unbalanced(next)) {
        NetEquilibrium cold = tendons.rest(q + end * turn, t + end * load, {});
        ++walk.solves;
        if (!unbalanced(cold)) {
          next = std::move(cold);
          ++walk.snaps;
        }
      }
      // Accept, and try a step twice as long.
      walk.rest = std::move(next);
      step = 2 * (end - done);
      done = end;
      break;
    }
  }
  return walk;
}

NetContinuation follow_from_straight(const NetTendons& tendons, const VectorXd& q,
                                     const VectorXd& t, const NetContinuationOptions& options) {
  const VectorXd straight = tendons.net().frame.straight;
  return follow_net(tendons, tendons.rest(straight, t, {}), straight, t, q, t, options);
}

}  // namespace thenar
