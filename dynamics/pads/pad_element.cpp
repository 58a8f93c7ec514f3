#include "dynamics/pads/pad_element.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/units.h"
#include "dynamics/mechanism/tree_motion.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kMomentArm = 5e-3;  // lever that turns moments into forces, half a fingertip [m]
// Changes of the push and motions below these do not move the pad
constexpr double kNegligibleError = 0.2;          // change of the push over its allowed error [1]
constexpr double kNegligibleDistance = 1e-4;      // translation [m]
constexpr double kNegligibleAngle = 1 * kDegree;  // rotation [rad]
constexpr double kUnsolvedDoubt = 8;              // doubt() of a pad without a solution [1]
// Shortest and longest next step, over the present one, and safety factor of its estimate [1]
constexpr double kMinStepRatio = 0.3, kMaxStepRatio = 2, kStepSafety = 0.9;
constexpr double kMinStepError = 1e-6;         // smallest error in that estimate, as it divides [1]
constexpr double kStiffnessUpdateError = 0.2;  // error above which K is recomputed [1]
constexpr double kMinPadStep = 5e-5;           // shortest step that a pad asks for [s]
constexpr int kRestartSteps = 8;               // moves from outside to the present pose
constexpr double kRestartDistance = 4e-3;      // distance of the first one, along the push [m]
constexpr double kRetryInterval = 5e-3;        // time between two restarts [s]
constexpr double kInstantTolerance = 1e-12;    // largest difference of equal instants [s]
constexpr double kPoseTolerance = 1e-6;        // largest difference of equal poses [m], [rad]
constexpr double kForceSquareFloor = 1e-24;    // smallest squared force that divides [N^2]
constexpr double kMaxFirstDepth = 2e-4;        // depth of the step that makes contact [m]
constexpr double kApproachRatio = 0.9;  // part of the gap in one step, as speeds may rise [1]
constexpr double kRestChange = 1e-3;    // change by relaxation over the allowed error, at rest [1]

}  // namespace

PadElement::PadElement(std::string name, int body, const Pose<double>& X_BP, int other,
                       std::shared_ptr<const MovingPad> pad, const PadElementOptions& options)
    : name_(std::move(name)),
      body_(body),
      other_(other),
      X_BP_(X_BP),
      origin_(std::move(pad)),
      pad_(origin_->clone()),
      options_(options),
      max_next_step_(std::numeric_limits<double>::infinity()) {
  require(options.force_error > 0 && options.min_force > 0 &&
              std::isfinite(options.force_error + options.min_force),
          "a pad wants errors and least forces above 0, got {} and {} N", options.force_error,
          options.min_force);
}

std::unique_ptr<ForceElement> PadElement::clone() const {
  return std::make_unique<PadElement>(name_, body_, X_BP_, other_, origin_, options_);
}

Pose<double> PadElement::object_pose(const ElementInput& at) const {
  return (at.motion.pose(body_) * X_BP_).inverse() * at.motion.pose(other_);
}

double PadElement::equivalent_force(const Vector6& change) const {
  const Vector3d force = change.tail<3>();
  const Vector3d moment = change.head<3>() - kept_.contact.centre.cross(force);
  return std::max(force.norm(), moment.norm() / kMomentArm);
}

PadElement::Prediction PadElement::predict(double t, const Pose<double>& X_PO) const {
  Prediction out;
  out.allowed_error =
      options_.force_error * std::max(kept_.contact.push.force.norm(), options_.min_force);
  if (kept_.contact.force <= 0) return out;
  // Extrapolate the elastic push with K from the last accepted state, and relax it.
  const MemoryStep weights = memory_step(pad_->relaxation(), std::max(0.0, t - accepted_.t));
  const Vector6 more = stiffness_ * motion_from(accepted_.X_PO, X_PO);
  for (Eigen::Index k = 0; k < 6; ++k) {
    const ExponentialMemory& memory = accepted_.memory[k];
    out.push[k] = history_of(weights, memory) + weights.now * (memory.x + more[k]);
  }
  out.stiffness_ratio = weights.now;
  out.change = equivalent_force(out.push - wrench_vector(kept_.contact.push)) / out.allowed_error;
  // A pad cannot pull.
  if (out.push.tail<3>().dot(kept_.contact.normal) <= 0) {
    out.push.setZero();
    out.stiffness_ratio = 0;
  }
  return out;
}

void PadElement::set_motion_jacobian(const ElementInput& at) {
  // Angular, then linear velocity along each axis of the pad.
  const Pose<double> X_WP = at.motion.pose(body_) * X_BP_;
  const int pad = at.motion.link_of(body_), object = at.motion.link_of(other_);
  const Vector3d none(0, 0, 0);
  J_.setZero(at.v.size(), 6);
  for (int k = 0; k < 3; ++k) {
    const Vector3d axis = X_WP.R.col(k);
    at.motion.add_relative_jacobian_row(object, pad, X_WP.p, none, axis, J_.col(k));
    at.motion.add_relative_jacobian_row(object, pad, X_WP.p, axis, none, J_.col(3 + k));
  }
}

double PadElement::approach_speed_bound(const ElementInput& at) const {
  const Vector6 speed = J_.transpose() * at.v;
  return speed.tail<3>().norm() + speed.head<3>().norm() * pad_->reach();
}

bool PadElement::add_action(const ElementInput& at, ElementAction& out) {
  if (kept_.contact.force <= 0) return has_valid_push();
  const Prediction predicted = predict(at.t, object_pose(at));
  if (predicted.stiffness_ratio == 0) return has_valid_push();
  // Add the generalized force of the push, and its symmetric stiffness.
  set_motion_jacobian(at);
  out.tau.noalias() -= J_ * predicted.push;
  if (at.need == ElementNeed::kAll) {
    const Matrix6 slope = 0.5 * predicted.stiffness_ratio * (stiffness_ + stiffness_.transpose());
    out.stiffness.noalias() += J_ * slope * J_.transpose();
  }
  return has_valid_push();
}

bool PadElement::is_negligible(const Prediction& predicted, const Pose<double>& X_PO) const {
  if (kept_.contact.force <= 0) return false;
  const Vector6 motion = motion_from(kept_.X_PO, X_PO);
  return predicted.change < kNegligibleError && motion.tail<3>().norm() < kNegligibleDistance &&
         motion.head<3>().norm() < kNegligibleAngle;
}

void PadElement::try_move(double t, const Pose<double>& X_PO, const Prediction& predicted) {
  // Solve the pad at the end of the motion, from its kept state.
  trial_.t = t;
  trial_.X_PO = X_PO;
  trial_.contact = pad_->try_step(X_PO, t - kept_.t);
  if (trial_.contact.status != Status::kSolved) {
    trial_.error = kUnsolvedDoubt;
    return;
  }
  // Compare the predicted push with the solution.
  const double allowed =
      std::max(predicted.allowed_error, options_.force_error * trial_.contact.push.force.norm());
  trial_.error = equivalent_force(wrench_vector(trial_.contact.push) - predicted.push) / allowed;
}

void PadElement::move_to_accepted(double t, const Pose<double>& X_PO, double allowed_error) {
  if (accepted_.t <= kept_.t + kInstantTolerance || kept_.contact.force <= 0) return;
  // A single move would spread the motion over the time since the last kept move, and relax too
  // much of it. Estimate the error that this makes.
  const std::vector<ExponentialTerm>& terms = pad_->relaxation();
  const double spread = memory_step(terms, std::max(0.0, t - kept_.t)).now,
               late = memory_step(terms, std::max(0.0, t - accepted_.t)).now;
  const Vector6 more = stiffness_ * motion_from(accepted_.X_PO, X_PO);
  if (equivalent_force((late - spread) * more) < kNegligibleError * allowed_error) return;
  // Move the pad to the accepted state first.
  try_move(accepted_.t, accepted_.X_PO, predict(accepted_.t, accepted_.X_PO));
  if (trial_.contact.status == Status::kSolved) keep_trial(trial_.error > kStiffnessUpdateError);
}

double PadElement::step_error(const ElementInput& at) {
  // A failed pad waits for its next restart, and a negligible motion makes no error.
  if (failure_.unsolved && at.t < failure_.retry_time) return 0;
  const Pose<double> X_PO = object_pose(at);
  const Prediction predicted = predict(at.t, X_PO);
  if (is_negligible(predicted, X_PO)) return 0;
  move_to_accepted(at.t, X_PO, predicted.allowed_error);
  try_move(at.t, X_PO, predicted);
  // Accept any error of a step that is too short to be divided.
  const double seconds = at.t - accepted_.t;
  if (seconds < kMinPadStep) return 0;
  if (kept_.contact.force > 0) return trial_.error;
  // Before contact, bound the travel by the gap, so that the object cannot pass the pad.
  set_motion_jacobian(at);
  const double travel = seconds * std::max(accepted_.speed, approach_speed_bound(at)),
               max_travel = std::max(accepted_.gap, trial_.contact.gap) + kMaxFirstDepth;
  return std::max(trial_.error, travel / max_travel);
}

void PadElement::accept_step(const ElementInput& at) {
  // Predict the push at the end of the step.
  const Pose<double> X_PO = object_pose(at);
  max_next_step_ = std::numeric_limits<double>::infinity();
  failure_.restarted = false;
  const double seconds = at.t - accepted_.t;
  const bool waits = failure_.unsolved && at.t < failure_.retry_time;
  const Prediction predicted = predict(at.t, X_PO);
  if (!waits) failure_.unsolved = false;
  // Solve the pad, unless the last trial was this motion.
  if (!waits && !is_negligible(predicted, X_PO)) {
    const bool is_tried = std::abs(trial_.t - at.t) < kInstantTolerance &&
                          motion_from(trial_.X_PO, X_PO).norm() < kPoseTolerance;
    if (!is_tried) {
      move_to_accepted(at.t, X_PO, predicted.allowed_error);
      try_move(at.t, X_PO, predicted);
    }
    // Restart a failed pad; otherwise keep the move, and estimate the next step from its error.
    failure_.unsolved = trial_.contact.status != Status::kSolved;
    if (failure_.unsolved) {
      if (at.t >= failure_.retry_time) restart_pad(at.t, X_PO);
    } else {
      const double error = trial_.error;
      keep_trial(error > kStiffnessUpdateError);
      if (kept_.contact.force > 0 && seconds > 0)
        max_next_step_ =
            std::max(kMinPadStep,
                     seconds * std::clamp(kStepSafety / std::sqrt(std::max(error, kMinStepError)),
                                          kMinStepRatio, kMaxStepRatio));
    }
  }
  // Before contact, limit the next step by the gap.
  advance_accepted(at.t, X_PO);
  accepted_.gap = kept_.contact.gap;
  if (kept_.contact.force > 0 || failure_.unsolved) return;
  set_motion_jacobian(at);
  accepted_.speed = approach_speed_bound(at);
  if (accepted_.speed > 0)
    max_next_step_ =
        std::max(kMinPadStep, kApproachRatio * (accepted_.gap + kMaxFirstDepth) / accepted_.speed);
}

void PadElement::restart_pad(double t, const Pose<double>& X_PO) {
  // Press a fresh pad from outside along the last push, instantaneously.
  std::unique_ptr<MovingPad> fresh = origin_->clone();
  PadContact contact;
  for (int i = 0; i <= kRestartSteps; ++i) {
    Pose<double> X = X_PO;
    X.p -= kRestartDistance * (1 - static_cast<double>(i) / kRestartSteps) * kept_.contact.normal;
    contact = fresh->try_step(X, 0);
    if (contact.status != Status::kSolved) {
      failure_.retry_time = t + kRetryInterval;
      return;
    }
    fresh->accept_step();
  }
  failure_.restarted = kept_.contact.force > 0;  // without contact no history is lost
  // Replace the old pad, and clear its memory.
  pad_ = std::move(fresh);
  kept_.memory = {};
  trial_.t = -1;
  kept_.t = t;
  kept_.X_PO = X_PO;
  kept_.contact = contact;
  failure_.unsolved = false;
  update_memory(0);
  stiffness_ = kept_.contact.force > 0 ? pad_->stiffness(Vector6::Ones()) : Matrix6::Zero();
}

void PadElement::keep_trial(bool new_stiffness) {
  // Keep the trial as the state of the pad.
  const double seconds = trial_.t - kept_.t;
  const Vector6 motion = motion_from(kept_.X_PO, trial_.X_PO);
  pad_->accept_step();
  kept_.t = trial_.t;
  kept_.X_PO = trial_.X_PO;
  trial_.t = -1;
  // Update K where contact begins or the prediction was poor.
  const bool begins = kept_.contact.force <= 0;
  kept_.contact = trial_.contact;
  update_memory(seconds);
  if (kept_.contact.force <= 0) {
    stiffness_.setZero();
  } else if (begins || new_stiffness) {
    stiffness_ = pad_->stiffness(motion);
  }
}

void PadElement::update_memory(double seconds) {
  if (kept_.contact.force <= 0) kept_.memory = {};
  // Find the elastic push whose relaxation gives the pad's push.
  const MemoryStep weights = memory_step(pad_->relaxation(), std::max(0.0, seconds));
  const Vector6 push = wrench_vector(kept_.contact.push);
  for (Eigen::Index k = 0; k < 6 && kept_.contact.force > 0; ++k) {
    ExponentialMemory& memory = kept_.memory[k];
    (void)remember(weights, (push[k] - history_of(weights, memory)) / weights.now, memory);
  }
  accepted_.memory = kept_.memory;
  accepted_.t = kept_.t;
  accepted_.X_PO = kept_.X_PO;
}

PadElement::PushMemory PadElement::memory_at(double t, const Pose<double>& X_PO) const {
  const MemoryStep weights = memory_step(pad_->relaxation(), std::max(0.0, t - accepted_.t));
  const Vector6 more = stiffness_ * motion_from(accepted_.X_PO, X_PO);
  PushMemory out = accepted_.memory;
  for (std::size_t k = 0; k < 6; ++k) (void)remember(weights, out[k].x + more[k], out[k]);
  return out;
}

void PadElement::advance_accepted(double t, const Pose<double>& X_PO) {
  if (kept_.contact.force > 0) accepted_.memory = memory_at(t, X_PO);
  accepted_.t = t;
  accepted_.X_PO = X_PO;
}

double PadElement::energy(const ElementInput& at) {
  if (kept_.contact.force <= 0) return 0;
  // Work of the elastic push since the pad moved.
  const Pose<double> X_PO = object_pose(at);
  const Vector6 motion = motion_from(kept_.X_PO, X_PO);
  const std::vector<ExponentialTerm>& terms = pad_->relaxation();
  const PushMemory memory = memory_at(at.t, X_PO);
  Vector6 push;
  for (std::size_t k = 0; k < 6; ++k) push[k] = memory[k].x;
  const double work = (push - 0.5 * stiffness_ * motion).dot(motion);
  // Remaining share of the elastic energy:  1 - sum g_i + sum part_i^2 / g_i.
  const Vector3d force = push.tail<3>();
  double share = 1;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const Vector3d term(memory[3].terms[i], memory[4].terms[i], memory[5].terms[i]);
    const double part = term.dot(force) / std::max(force.squaredNorm(), kForceSquareFloor);
    if (terms[i].share > 0) share += part * part / terms[i].share - terms[i].share;
  }
  return std::max(0.0, pad_->energy() + work) * share;
}

void PadElement::add_contacts(const ElementInput& at, std::vector<ContactSample>& out) {
  const Prediction predicted = predict(at.t, object_pose(at));
  if (kept_.contact.force <= 0 || predicted.stiffness_ratio == 0) return;
  const Pose<double> X_WP = at.motion.pose(body_) * X_BP_;
  const Vector3d moment = predicted.push.head<3>(), force = predicted.push.tail<3>();
  // Contact samples hold the force on the body with the lower index.
  const double sign = body_ < other_ ? 1 : -1;
  ContactSample contact;
  contact.a = std::min(body_, other_);
  contact.b = std::max(body_, other_);
  contact.point = X_WP * kept_.contact.centre;
  contact.normal = sign * (X_WP.R * kept_.contact.normal);
  contact.force = sign * (X_WP.R * force);
  contact.torsion = kept_.contact.normal.dot(moment - kept_.contact.centre.cross(force));
  contact.mode = kept_.contact.stick > 0.5 ? ContactMode::kStick : ContactMode::kSlide;
  contact.area = kept_.contact.area;
  contact.stick = kept_.contact.stick;
  out.push_back(contact);
}

bool PadElement::may_start_motion(const ElementInput& at) const {
  if (!has_valid_push()) return true;
  if (kept_.contact.force <= 0) return false;
  // Compare the push with its fully relaxed value.
  const Prediction now = predict(at.t, accepted_.X_PO),
                   later = predict(std::numeric_limits<double>::infinity(), accepted_.X_PO);
  return equivalent_force(later.push - now.push) > kRestChange * now.allowed_error;
}

}  // namespace thenar
