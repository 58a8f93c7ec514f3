#include "pads/motion/element_pad.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace thenar {
namespace {

constexpr double kForgets = 10;  // times the longest relaxation [1]

}  // namespace

ElementPad::ElementPad(PadModel model, RigidObject object, const Pose<double>& X_PO,
                       const ElementPadOptions& options)
    : model_(std::move(model)), object_(std::move(object)), options_(options), X_PO_(X_PO) {
  require(object_.shape && object_.friction >= 0,
          "a pad in motion wants an object with a shape and a friction >= 0");
  renew(X_PO);
  const Eigen::Matrix3Xd& places = press_->surface().places;
  reach_ = places.colwise().norm().maxCoeff() * 1.05;
  for (const Tissue& tissue : model_.tissues)
    for (const ExponentialTerm& term : tissue.relaxation)
      forgets_ = std::max(forgets_, kForgets * term.time);
}

std::unique_ptr<MovingPad> ElementPad::clone() const {
  return std::make_unique<ElementPad>(model_, object_, X_PO_, options_);
}

void ElementPad::renew(const Pose<double>& X_PO) {
  PadPressOptions options;
  options.step = options_.step;
  options.force_error = options_.mesh_error;
  options.max_elements = options_.max_elements;
  options.max_penetration = 1;  // faces are as fine as the error of the force asks
  press_ = std::make_unique<PadPress>(model_, object_, X_PO, options);
}

PadContact ElementPad::move(const Pose<double>& X_PO, double seconds) {
  if (trial_) press_->undo();
  trial_ = false;
  X_moved_ = X_PO;
  moved_free_ = free_ + seconds;
  PadContact out;
  // A pad at rest that is out of reach stays so.
  const Pose<double> X_OP = X_PO.inverse();
  moved_rests_ =
      rests_ && (object_.shape->distance(X_OP.p) > reach_ ||
                 smallest_gap(press_->surface(), *object_.shape, X_PO, press_->state().x) > 0);
  if (moved_rests_) return out;
  PressGoal goal;
  goal.X_PO = X_PO;
  goal.time = seconds;
  // A press begins where the object is; nothing has touched on the way there.
  if (rests_) press_->begin_at(X_PO_);
  const PadPressResult result = press_->step(goal);
  trial_ = result.solved.status == Status::kSolved;
  if (!trial_) {
    out.status = result.solved.status;
    out.message = result.solved.message;
    moved_rests_ = rests_;
    return out;
  }
  out = touch_of(result);
  if (out.force > 0) moved_free_ = 0;
  return out;
}

PadContact ElementPad::touch_of(const PadPressResult& result) const {
  PadContact out;
  const PressState& state = press_->state();
  out.force = state.normal.sum();
  out.force_error = result.force_error;
  if (out.force <= 0) {
    out.force = 0;
    return out;
  }
  out.push = result.push;
  out.area = result.area;
  out.stick = result.stick;
  out.centre = places_of(press_->surface(), state.x) * state.normal / out.force;
  const Eigen::Vector3d rubbed = state.shear.rowwise().sum();
  out.normal = (out.push.force - rubbed).normalized();
  return out;
}

void ElementPad::keep() {
  X_PO_ = X_moved_;
  free_ = moved_free_;
  rests_ = moved_rests_;
  trial_ = false;
  if (!rests_ && free_ > forgets_) {
    rests_ = true;
    renew(X_PO_);
  }
}

Matrix6 ElementPad::stiffness() {
  if (trial_) press_->undo();
  trial_ = false;
  if (rests_ || press_->state().normal.isZero(0)) return Matrix6::Zero();
  return press_->stiffness();
}

}  // namespace thenar
