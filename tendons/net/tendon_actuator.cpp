#include "tendons/net/tendon_actuator.h"

#include <utility>

#include "tendons/net/net_derivatives.h"
#include "tendons/net/net_rates.h"
#include "tendons/net/net_statics.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::VectorXd;

}  // namespace

TendonActuator::TendonActuator(const DigitTendons& tendons, const NetWalkOptions& options)
    : tendons_(tendons), net_(dynamic_cast<const NetTendons*>(&tendons)), options_(options) {}

const TendonAction& TendonActuator::act(const VectorXd& q, const VectorXd& t) {
  action_.snapped = false;
  answer(q, t);  // checks q and t before the net moves
  if (net_ == nullptr) return action_;
  move_net(q, t);
  add_net(q, t);
  return action_;
}

const TendonAction& TendonActuator::start_at(const VectorXd& q, const VectorXd& t,
                                             const Matrix3Xd& nodes) {
  action_.snapped = false;
  answer(q, t);
  if (net_ == nullptr) return action_;
  rest_ = net_->rest(q, t, nodes);
  add_net(q, t);
  return action_;
}

/// All but the net.
void TendonActuator::answer(const VectorXd& q, const VectorXd& t) {
  TendonPull pull = net_ == nullptr ? tendons_.pull(q, t) : net_->pull_outside(q, t);
  action_.paths = action_.status = pull.status;
  action_.hood = TendonStatus::kSound;
  action_.residual = 0;
  action_.tau = std::move(pull.tau);
  action_.R = std::move(pull.R);
  action_.slips = pull.slips;
  action_.trouble = std::move(pull.trouble);
  TendonSlopes slopes = net_ == nullptr ? tendons_.slopes(q, t) : net_->slopes_outside(q, t);
  action_.slopes = slopes.exist;
  action_.K = std::move(slopes.by_posture);
  action_.length = std::move(slopes.length);
}

void TendonActuator::move_net(const VectorXd& q, const VectorXd& t) {
  if (!known_) {
    rest_ = walk_from_straight(*net_, q, t, options_).rest;
    return;
  }
  // One solve where the slopes by posture say; that suffices for short steps.
  Matrix3Xd start = rest_.x;
  const bool follows = by_posture_.cols() == q.size();
  if (follows) {
    const VectorXd move = by_posture_ * (q - q_);
    start += Eigen::Map<const Matrix3Xd>(move.data(), 3, start.cols());
  }
  NetEquilibrium next = net_->rest(q, t, start);
  if (follows && strayed(net_->net().net, rest_.loose, start, next) <= options_.stray) {
    rest_ = std::move(next);
    return;
  }
  NetWalk walk = walk_net(*net_, rest_, q_, t_, q, t, options_);
  rest_ = std::move(walk.rest);
  action_.snapped = walk.snaps > 0;
  snaps_ += walk.snaps;
}

/// Adds torque, slopes and lengths of the net where it rests, and keeps the state.
void TendonActuator::add_net(const VectorXd& q, const VectorXd& t) {
  const Net& net = net_->net().net;
  const TendonModel<double>& model = tendons_.digit().model;
  const TreeState<double> state = pose_tree(model.tree, q);
  known_ = true;
  q_ = q, t_ = t;
  action_.residual = rest_.residual;
  action_.hood = net_status(net, state, rest_);
  action_.status = worse(action_.paths, action_.hood);
  const std::string trouble = net_trouble(net, state, rest_);
  action_.trouble += (action_.trouble.empty() || trouble.empty() ? "" : "; ") + trouble;
  action_.slips = slip_tension(net_->net(), rest_);
  action_.tau += net_torque(net, model.tree, state, rest_, model.coordinates);
  by_posture_.resize(0, 0);
  if (!no_slopes(net, rest_).empty()) {
    action_.slopes = false;
    return;
  }
  // One direction a coordinate gives all slopes: of nodes, torque and lengths.
  const internal::TangentNet tangent(net, state, {net_->drive(t), {}}, rest_);
  by_posture_.resize(rest_.x.size(), q.size());
  Eigen::MatrixXd shortens(q.size(), static_cast<Index>(net.muscles.size()));
  shortens.setZero();
  for (Index l = 0; l < q.size(); ++l) {
    const internal::NetInput turn = internal::turning(net, model.tree, state, static_cast<int>(l));
    const Matrix3Xd v = internal::node_rates(tangent, turn);
    by_posture_.col(l) = Eigen::Map<const VectorXd>(v.data(), v.size());
    for (std::size_t b = 0; b < net.bands.size(); ++b)
      if (net.bands[b].muscle >= 0)
        shortens(l, net.bands[b].muscle) -=
            internal::band_rate(tangent, static_cast<Index>(b), turn, v).length;
    if (action_.slopes)
      action_.K.col(l) +=
          internal::torque_rate(tangent, model.tree, state, turn, v, model.coordinates);
  }
  action_.R += (shortens * net_->shares()).transpose();
  if (action_.slopes) action_.length += net_->shares().transpose() * pulled_length(net, rest_);
}

}  // namespace thenar
