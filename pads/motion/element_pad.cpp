#include "pads/motion/element_pad.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace thenar {
namespace {

// A free pad is as new after this many of its longest relaxation times [1]
constexpr double kForgettingTimes = 10;
constexpr double kClearGap = 1e-6;   // Gap from which the object starts towards a pad at rest [m]
constexpr int kMostIterations = 25;  // Most iterations of a step; most steps take fewer than 12
// Most pieces of a step; a caller may ask for a shorter step instead
constexpr int kStepPieces = 4;

}  // namespace

ElementPad::ElementPad(PadModel model, RigidObject object, const Pose<double>& X_PO,
                       const ElementPadOptions& options)
    : model_(std::move(model)), object_(std::move(object)), options_(options) {
  kept_.X_PO = moved_.X_PO = X_PO;
  require(object_.shape && object_.friction >= 0,
          "a pad in motion wants an object with a shape and a friction >= 0");
  // Reach of the skin with a margin, and the time after which nothing is remembered.
  renew(X_PO);
  const Eigen::Matrix3Xd& places = press_->surface().rest_positions;
  reach_ = places.colwise().norm().maxCoeff() * 1.05;
  for (const Tissue& tissue : model_.tissues)
    for (const ExponentialTerm& term : tissue.relaxation)
      forgets_ = std::max(forgets_, kForgettingTimes * term.time);
}

std::unique_ptr<MovingPad> ElementPad::clone() const {
  return std::make_unique<ElementPad>(model_, object_, kept_.X_PO, options_);
}

void ElementPad::renew(const Pose<double>& X_PO) {
  PadPressOptions options;
  options.step = options_.step;
  options.force_error = options_.mesh_error;
  options.max_elements = options_.max_elements;
  options.max_failed_pieces = kStepPieces;
  options.step.max_iterations = std::min(options.step.max_iterations, kMostIterations);
  options.max_penetration = 1;  // faces are as fine as the error of the force asks
  press_ = std::make_unique<PadPress>(model_, object_, X_PO, options);
}

void ElementPad::undo() {
  if (trial_) press_->undo_step();
  trial_ = false;
}

PadContact ElementPad::move(const Pose<double>& X_PO, double seconds) {
  undo();
  moved_ = {X_PO, kept_.rests, kept_.free + seconds};
  PadContact out;
  // A pad at rest that is out of reach stays so.
  if (kept_.rests) {
    out.gap = object_.shape->distance(X_PO.inverse().p) - reach_;
    if (out.gap > 0) return out;
    out.gap = min_gap(press_->surface(), *object_.shape, X_PO, press_->state().x);
    if (out.gap > 0) return out;
    press_->place_object(pulled_out(X_PO, -out.gap));
    out.gap = 0;
  }
  // One step of the elements; if it fails the pad is as it was.
  PressGoal goal;
  goal.X_PO = X_PO;
  goal.time = seconds;
  const PadPressResult result = press_->step(goal);
  trial_ = result.solved.status == Status::kSolved;
  if (!trial_) {
    out.status = result.solved.status;
    out.message = result.solved.message;
    moved_ = kept_;
    return out;
  }
  moved_.rests = false;
  out = touch_of(result);
  if (out.force > 0) moved_.free = 0;
  return out;
}

Pose<double> ElementPad::pulled_out(const Pose<double>& X_PO, double overlap) const {
  const Pose<double> X_OP = X_PO.inverse();
  // Node that lies deepest in the object.
  const Eigen::Matrix3Xd places = deformed_positions(press_->surface(), press_->state().x);
  Eigen::Index deepest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < places.cols(); ++k) {
    const double gap = object_.shape->distance(X_OP * Eigen::Vector3d(places.col(k)));
    if (gap >= least) continue;
    least = gap;
    deepest = k;
  }
  // Object moved out along its normal there, to a small gap.
  Pose<double> out = X_PO;
  out.p -= (overlap + kClearGap) *
           (X_PO.R * object_.shape->nearest(X_OP * Eigen::Vector3d(places.col(deepest))).normal);
  return out;
}

PadContact ElementPad::touch_of(const PadPressResult& result) const {
  PadContact out;
  const PressState& state = press_->state();
  out.force = state.normal_force.sum();
  out.force_error = result.force_error;
  // Apart: the gap to the deformed skin.
  if (out.force <= 0) {
    out.force = 0;
    const double gap = min_gap(press_->surface(), *object_.shape, state.X_PO, state.x);
    out.gap = std::max(0.0, gap);
    return out;
  }
  // Push, patch and centre of pressure; the normal is the push without friction.
  out.push = result.push;
  out.area = result.area;
  out.stick = result.stick;
  out.centre = deformed_positions(press_->surface(), state.x) * state.normal_force / out.force;
  const Eigen::Vector3d rubbed = state.friction_force.rowwise().sum();
  out.normal = (out.push.force - rubbed).normalized();
  return out;
}

void ElementPad::keep() {
  kept_ = moved_;
  trial_ = false;
  if (!kept_.rests && kept_.free > forgets_) {
    kept_.rests = true;
    renew(kept_.X_PO);
  }
}

double ElementPad::energy() const {
  if (kept_.rests) return 0;
  const TissueBody& body = press_->body();
  TissueResponse now;
  body.evaluate(body.node_displacements(press_->state().x, {}), 0, {}, {}, ElementRequest::kEnergy,
                now);
  return now.energy + press_->state().spring_energy;
}

Matrix6 ElementPad::stiffness(const Eigen::Matrix<double, 6, 1>& /*onward*/) {
  undo();
  if (kept_.rests || press_->state().normal_force.isZero(0)) return Matrix6::Zero();
  return press_->stiffness();
}

}  // namespace thenar
