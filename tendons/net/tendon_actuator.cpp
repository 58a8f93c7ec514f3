#include "tendons/net/tendon_actuator.h"

#include <utility>

#include "tendons/net/net_derivatives.h"
#include "tendons/net/net_statics.h"
#include "tendons/net/tangent_net.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::VectorXd;

}  // namespace

TendonActuator::TendonActuator(const DigitTendons& tendons, const NetContinuationOptions& options)
    : tendons_(tendons), net_(dynamic_cast<const NetTendons*>(&tendons)), options_(options) {}

const TendonAction& TendonActuator::act(const VectorXd& q, const VectorXd& t) {
  action_.snapped = false;
  evaluate_outside(q, t);  // checks q and t before the net moves
  if (net_ == nullptr) return action_;
  move_net(q, t);
  add_net(q, t);
  return action_;
}

const TendonAction& TendonActuator::start_at(const VectorXd& q, const VectorXd& t,
                                             const Matrix3Xd& nodes) {
  action_.snapped = false;
  evaluate_outside(q, t);
  if (net_ == nullptr) return action_;
  rest_ = net_->rest(q, t, nodes);
  add_net(q, t);
  return action_;
}

/// Evaluates all tendons except the net.
void TendonActuator::evaluate_outside(const VectorXd& q, const VectorXd& t) {
  TendonTorque pull = net_ == nullptr ? tendons_.evaluate(q, t) : net_->torque_outside(q, t);
  // Set the status of the tendons outside the net.
  action_.paths = action_.status = pull.status;
  action_.hood = TendonStatus::kValid;
  action_.residual = 0;
  // Set torque and arms.
  action_.tau = std::move(pull.tau);
  action_.R = std::move(pull.R);
  action_.slips = pull.slips;
  action_.warning = std::move(pull.warning);
  // Set derivatives and lengths.
  TendonDerivatives slopes =
      net_ == nullptr ? tendons_.derivatives(q, t) : net_->derivatives_outside(q, t);
  action_.slopes = slopes.exist;
  action_.K = std::move(slopes.by_posture);
  action_.length = std::move(slopes.length);
}

void TendonActuator::move_net(const VectorXd& q, const VectorXd& t) {
  if (!known_) {
    rest_ = follow_from_straight(*net_, q, t, options_).rest;
    return;
  }
  // Try one solve from the prediction by posture, enough for short steps.
  Matrix3Xd start = rest_.x;
  const bool follows = by_posture_.cols() == q.size();
  if (follows) {
    const VectorXd move = by_posture_ * (q - q_);
    start += Eigen::Map<const Matrix3Xd>(move.data(), 3, start.cols());
  }
  NetEquilibrium next = net_->rest(q, t, start);
  // Accept an equilibrium near the prediction.
  if (follows &&
      largest_deviation(net_->net().net, rest_.undetermined, start, next) <= options_.stray) {
    rest_ = std::move(next);
    return;
  }
  // Otherwise follow the net in smaller steps.
  NetContinuation walk = follow_net(*net_, rest_, {q_, t_}, {q, t}, options_);
  rest_ = std::move(walk.rest);
  action_.snapped = !walk.snaps.empty();
  snaps_ += static_cast<int>(walk.snaps.size());
}

/// Adds torque, derivatives and lengths of the net in its equilibrium, and stores the state.
void TendonActuator::add_net(const VectorXd& q, const VectorXd& t) {
  const Net& net = net_->net().net;
  const TendonModel<double>& model = tendons_.digit().model;
  const TreeState<double> state = pose_tree(model.tree, q);
  // Store the new state.
  known_ = true;
  q_ = q, t_ = t;
  // Combine status and warnings.
  action_.residual = rest_.residual;
  action_.hood = net_status(net, state, rest_);
  action_.status = worse(action_.paths, action_.hood);
  const std::string warning = net_warning(net, state, rest_);
  action_.warning += (action_.warning.empty() || warning.empty() ? "" : "; ") + warning;
  // Add slips and torque.
  action_.slips = slip_tension(net_->net(), rest_);
  action_.tau += net_torque(net, model.tree, state, rest_, model.coordinates);
  by_posture_.resize(0, 0);
  if (!why_not_differentiable(net, rest_).empty()) {
    action_.slopes = false;
    return;
  }
  // Compute one direction per coordinate for derivatives of nodes, torque and lengths.
  const internal::TangentNet tangent(net, state, {net_->drive(t), {}}, rest_);
  by_posture_.resize(rest_.x.size(), q.size());
  Eigen::MatrixXd shortens(q.size(), static_cast<Index>(net.muscles.size()));
  shortens.setZero();
  for (Index l = 0; l < q.size(); ++l) {
    const internal::NetPerturbation turn =
        internal::joint_perturbation(net, model.tree, state, static_cast<int>(l));
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
  // Convert arms and lengths to the digit's muscles.
  action_.R += (shortens * net_->shares()).transpose();
  if (action_.slopes) action_.length += net_->shares().transpose() * muscle_band_length(net, rest_);
}

}  // namespace thenar
