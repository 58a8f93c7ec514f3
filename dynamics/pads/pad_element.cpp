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

constexpr double kFingertipArm = 5e-3;      // half a fingertip [m]
constexpr double kStillShare = 0.2;         // of what is allowed, that does not move a pad [1]
constexpr double kStillWay = 1e-4;          // nor does a way [m]
constexpr double kStillTurn = 1 * kDegree;  // and a turn below these [rad]
constexpr double kNoAnswer = 8;             // doubt where a pad has no answer [1]
constexpr double kStepShrink = 0.3, kStepGrowth = 2;  // change of the length of a step [1]
constexpr double kNewStiffness = 0.2;     // error of a prediction from which K is asked for [1]
constexpr double kLeastPadStep = 5e-5;    // steps are not made shorter for a pad [s]
constexpr int kWayIn = 8;                 // steps of a pad that begins anew
constexpr double kStartDistance = 4e-3;   // where its object begins, along the push [m]
constexpr double kRetryTime = 5e-3;       // before it is tried again [s]
constexpr double kSameInstant = 1e-12;    // nearer instants are one [s]
constexpr double kNoForceSquare = 1e-24;  // square of a force [N^2]
constexpr double kFirstDip = 2e-4;        // way into a pad of the step that meets it [m]
constexpr double kForeseenShare = 0.9;    // of the way that is foreseen, as speeds rise [1]

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
      foresees_(std::numeric_limits<double>::infinity()) {
  require(options.force_error > 0 && options.least_force > 0 &&
              std::isfinite(options.force_error + options.least_force),
          "a pad wants errors and least forces above 0, got {} and {} N", options.force_error,
          options.least_force);
}

std::unique_ptr<ForceElement> PadElement::clone() const {
  return std::make_unique<PadElement>(name_, body_, X_BP_, other_, origin_, options_);
}

Pose<double> PadElement::object_pose(const ElementInput& at) const {
  return (at.motion.pose(body_) * X_BP_).inverse() * at.motion.pose(other_);
}

double PadElement::size_of(const Vector6& change) const {
  const Vector3d force = change.tail<3>();
  const Vector3d moment = change.head<3>() - kept_.touch.centre.cross(force);
  return std::max(force.norm(), moment.norm() / kFingertipArm);
}

PadElement::Prediction PadElement::predict(double t, const Pose<double>& X_PO) const {
  Prediction out;
  out.push.setZero();
  out.allowed =
      options_.force_error * std::max(kept_.touch.push.force.norm(), options_.least_force);
  if (kept_.touch.force <= 0) return out;
  // Elastic push with the stiffness of the last look, relaxed since.
  const MemoryStep weights = memory_step(pad_->relaxation(), std::max(0.0, t - accepted_.t));
  const Vector6 more = stiffness_ * motion_from(accepted_.X_PO, X_PO);
  for (Eigen::Index k = 0; k < 6; ++k) {
    const ExponentialMemory& memory = accepted_.memory[static_cast<std::size_t>(k)];
    out.push[k] = history_of(weights, memory) + weights.now * (memory.x + more[k]);
  }
  out.share = weights.now;
  out.change = size_of(out.push - six_of(kept_.touch.push)) / out.allowed;
  // A pad does not pull.
  if (out.push.tail<3>().dot(kept_.touch.normal) <= 0) {
    out.push.setZero();
    out.share = 0;
  }
  return out;
}

void PadElement::set_rows(const ElementInput& at) {
  // Rows of the object's motion against the pad, in the pad's axes at its origin: turns, then ways.
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

double PadElement::fastest(const ElementInput& at) const {
  const Vector6 speed = J_.transpose() * at.v;
  return speed.tail<3>().norm() + speed.head<3>().norm() * pad_->reach();
}

bool PadElement::add_action(const ElementInput& at, ElementAction& out) {
  // Without a touch there is no push.
  if (kept_.touch.force <= 0) return has_answer();
  const Prediction seen = predict(at.t, object_pose(at));
  if (seen.share == 0) return has_answer();
  // Efforts by the push, against the object's motion relative to the pad, and its symmetric slope.
  set_rows(at);
  out.tau.noalias() -= J_ * seen.push;
  if (at.need == ElementNeed::kAll) {
    const Matrix6 slope = 0.5 * seen.share * (stiffness_ + stiffness_.transpose());
    out.stiffness.noalias() += J_ * slope * J_.transpose();
  }
  return has_answer();
}

bool PadElement::changed_little(const Prediction& seen, const Pose<double>& X_PO) const {
  if (kept_.touch.force <= 0) return false;
  const Vector6 motion = motion_from(kept_.X_PO, X_PO);
  return seen.change < kStillShare && motion.tail<3>().norm() < kStillWay &&
         motion.head<3>().norm() < kStillTurn;
}

void PadElement::try_move(double t, const Pose<double>& X_PO, const Prediction& seen) {
  // Contact at the end of the motion, from what the pad kept.
  trial_.t = t;
  trial_.X_PO = X_PO;
  trial_.touch = pad_->move(X_PO, t - kept_.t);
  if (trial_.touch.status != Status::kSolved) {
    trial_.error = kNoAnswer;
    return;
  }
  // Error of the prediction, over what the push allows.
  const double allowed =
      std::max(seen.allowed, options_.force_error * trial_.touch.push.force.norm());
  trial_.error = size_of(six_of(trial_.touch.push) - seen.push) / allowed;
}

void PadElement::catch_up(double t, const Pose<double>& X_PO, double allowed) {
  if (accepted_.t <= kept_.t + kSameInstant || kept_.touch.force <= 0) return;
  // After a rest that the pad has not seen, a motion would count as spread over the rest. Where the
  // pad would feel that, it is first moved to the end of the rest.
  const std::vector<ExponentialTerm>& terms = pad_->relaxation();
  const double spread = memory_step(terms, std::max(0.0, t - kept_.t)).now,
               late = memory_step(terms, std::max(0.0, t - accepted_.t)).now;
  const Vector6 more = stiffness_ * motion_from(accepted_.X_PO, X_PO);
  if (size_of((late - spread) * more) < kStillShare * allowed) return;
  try_move(accepted_.t, accepted_.X_PO, predict(accepted_.t, accepted_.X_PO));
  if (trial_.touch.status == Status::kSolved) keep_move(trial_.error > kNewStiffness);
}

double PadElement::step_error(const ElementInput& at) {
  // A pad without an answer waits, and one that hardly moved has no doubt.
  if (lost_.stale && at.t < lost_.retry) return 0;
  const Pose<double> X_PO = object_pose(at);
  const Prediction seen = predict(at.t, X_PO);
  if (changed_little(seen, X_PO)) return 0;
  catch_up(at.t, X_PO, seen.allowed);
  try_move(at.t, X_PO, seen);
  // Steps are not made shorter than this: what jumps in so short a time jumps.
  const double seconds = at.t - accepted_.t;
  if (seconds < kLeastPadStep) return 0;
  if (kept_.touch.force > 0) return trial_.error;
  // Not touched before: an object that moves farther than the gaps may have gone through.
  set_rows(at);
  const double way = seconds * std::max(accepted_.speed, fastest(at)),
               most = std::max(accepted_.gap, trial_.touch.gap) + kFirstDip;
  return std::max(trial_.error, way / most);
}

void PadElement::accept_step(const ElementInput& at) {
  // Pose at the end of the step, and the push that was predicted for it.
  const Pose<double> X_PO = object_pose(at);
  foresees_ = std::numeric_limits<double>::infinity();
  lost_.anew = false;
  const double seconds = at.t - accepted_.t;
  const bool waits = lost_.stale && at.t < lost_.retry;
  const Prediction seen = predict(at.t, X_PO);
  if (!waits) lost_.stale = false;
  // Move the pad, unless the last trial was this very motion.
  if (!waits && !changed_little(seen, X_PO)) {
    const bool is_tried =
        std::abs(trial_.t - at.t) < kSameInstant && motion_from(trial_.X_PO, X_PO).norm() < 1e-6;
    if (!is_tried) {
      catch_up(at.t, X_PO, seen.allowed);
      try_move(at.t, X_PO, seen);
    }
    // Begin anew without an answer; otherwise keep the move, whose error bounds the next step.
    lost_.stale = trial_.touch.status != Status::kSolved;
    if (lost_.stale) {
      if (at.t >= lost_.retry) begin_anew(at.t, X_PO);
    } else {
      const double error = trial_.error;
      keep_move(error > kNewStiffness);
      if (kept_.touch.force > 0 && seconds > 0)
        foresees_ = std::max(
            kLeastPadStep,
            seconds * std::clamp(0.9 / std::sqrt(std::max(error, 1e-6)), kStepShrink, kStepGrowth));
    }
  }
  // Apart: no step may be longer than the way to the pad.
  go_on(at.t, X_PO);
  accepted_.gap = kept_.touch.gap;
  if (kept_.touch.force > 0 || lost_.stale) return;
  set_rows(at);
  accepted_.speed = fastest(at);
  if (accepted_.speed > 0)
    foresees_ =
        std::max(kLeastPadStep, kForeseenShare * (accepted_.gap + kFirstDip) / accepted_.speed);
}

void PadElement::begin_anew(double t, const Pose<double>& X_PO) {
  // The object comes from outside, along the last push, at once.
  std::unique_ptr<MovingPad> fresh = origin_->clone();
  PadContact contact;
  for (int i = 0; i <= kWayIn; ++i) {
    Pose<double> X = X_PO;
    X.p -= kStartDistance * (1 - static_cast<double>(i) / kWayIn) * kept_.touch.normal;
    contact = fresh->move(X, 0);
    if (contact.status != Status::kSolved) {
      lost_.retry = t + kRetryTime;
      return;
    }
    fresh->keep();
  }
  lost_.anew = kept_.touch.force > 0;  // otherwise it has nothing to forget
  // The fresh pad takes the place of the old one, with nothing remembered.
  pad_ = std::move(fresh);
  kept_.memory = {};
  trial_.t = -1;
  kept_.t = t;
  kept_.X_PO = X_PO;
  kept_.touch = contact;
  lost_.stale = false;
  remember_push(0);
  stiffness_ = kept_.touch.force > 0 ? pad_->stiffness(Vector6::Ones()) : Matrix6::Zero();
}

void PadElement::keep_move(bool new_stiffness) {
  // The pad keeps the trial.
  const double seconds = trial_.t - kept_.t;
  const Vector6 motion = motion_from(kept_.X_PO, trial_.X_PO);
  pad_->keep();
  kept_.t = trial_.t;
  kept_.X_PO = trial_.X_PO;
  trial_.t = -1;
  // Stiffness where the touch begins, or where a prediction was poor.
  const bool begins = kept_.touch.force <= 0;
  kept_.touch = trial_.touch;
  remember_push(seconds);
  if (kept_.touch.force <= 0) {
    stiffness_.setZero();
  } else if (begins || new_stiffness) {
    stiffness_ = pad_->stiffness(motion);
  }
}

void PadElement::remember_push(double seconds) {
  if (kept_.touch.force <= 0) kept_.memory = {};
  // The elastic push that the relaxation makes the pad's out of.
  const MemoryStep weights = memory_step(pad_->relaxation(), std::max(0.0, seconds));
  const Vector6 push = six_of(kept_.touch.push);
  for (Eigen::Index k = 0; k < 6 && kept_.touch.force > 0; ++k) {
    ExponentialMemory& memory = kept_.memory[static_cast<std::size_t>(k)];
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
  for (std::size_t k = 0; k < 6; ++k)
    (void)remember(weights, out[k].x + more[static_cast<Eigen::Index>(k)], out[k]);
  return out;
}

void PadElement::go_on(double t, const Pose<double>& X_PO) {
  if (kept_.touch.force > 0) accepted_.memory = memory_at(t, X_PO);
  accepted_.t = t;
  accepted_.X_PO = X_PO;
}

double PadElement::energy(const ElementInput& at) {
  if (kept_.touch.force <= 0) return 0;
  // The elastic push of now, and what each term has left of it.
  const Pose<double> X_PO = object_pose(at);
  const Vector6 motion = motion_from(kept_.X_PO, X_PO);
  const std::vector<ExponentialTerm>& terms = pad_->relaxation();
  const PushMemory memory = memory_at(at.t, X_PO);
  Vector6 push;
  for (std::size_t k = 0; k < 6; ++k) push[static_cast<Eigen::Index>(k)] = memory[k].x;
  const double work = (push - 0.5 * stiffness_ * motion).dot(motion);  // since the pad moved
  // Share of the elastic energy that its terms have left:  1 - sum g_i + sum part_i^2 / g_i.
  const Vector3d force = push.tail<3>();
  double share = 1;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const Vector3d left(memory[3].terms[i], memory[4].terms[i], memory[5].terms[i]);
    const double part = left.dot(force) / std::max(force.squaredNorm(), kNoForceSquare);
    if (terms[i].share > 0) share += part * part / terms[i].share - terms[i].share;
  }
  return std::max(0.0, pad_->energy() + work) * share;
}

void PadElement::add_contacts(const ElementInput& at, std::vector<ContactSample>& out) {
  const Prediction seen = predict(at.t, object_pose(at));
  if (kept_.touch.force <= 0 || seen.share == 0) return;
  // Push at the instant, and the pad's frame in the world.
  const Pose<double> X_WP = at.motion.pose(body_) * X_BP_;
  const Vector3d moment = seen.push.head<3>(), force = seen.push.tail<3>();
  // On the body with the lower index.
  const double sign = body_ < other_ ? 1 : -1;
  ContactSample contact;
  contact.a = std::min(body_, other_);
  contact.b = std::max(body_, other_);
  contact.point = X_WP * kept_.touch.centre;
  contact.normal = sign * (X_WP.R * kept_.touch.normal);
  contact.force = sign * (X_WP.R * force);
  contact.torsion = kept_.touch.normal.dot(moment - kept_.touch.centre.cross(force));
  contact.mode = kept_.touch.stick > 0.5 ? ContactMode::kStick : ContactMode::kSlide;
  contact.area = kept_.touch.area;
  contact.stick = kept_.touch.stick;
  out.push_back(contact);
}

bool PadElement::may_start_motion(const ElementInput& at) const {
  if (!has_answer()) return true;
  if (kept_.touch.force <= 0) return false;
  // Whether it still relaxes by more than a thousandth of what is allowed.
  const Prediction now = predict(at.t, accepted_.X_PO),
                   later = predict(std::numeric_limits<double>::infinity(), accepted_.X_PO);
  return size_of(later.push - now.push) > 1e-3 * now.allowed;
}

}  // namespace thenar
