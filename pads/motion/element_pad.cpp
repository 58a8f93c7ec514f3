#include "pads/motion/element_pad.h"

#include <algorithm>
#include <limits>

#include "base/error.h"

namespace thenar {
namespace {

// Time after which a free pad is reset to rest, over its longest relaxation time [1]
constexpr double kMemoryTimes = 10;
constexpr double kClearGap = 1e-6;      // gap from which an object approaches a pad at rest [m]
constexpr int kMaxStepIterations = 25;  // iterations of a step; most take fewer than 12
// Failed pieces after which a step fails; a caller may ask for a shorter step instead
constexpr int kMaxFailedPieces = 4;

}  // namespace

ElementPad::ElementPad(PadModel model, RigidObject object, const Pose<double>& X_PO,
                       const ElementPadOptions& options)
    : model_(std::move(model)), object_(std::move(object)), options_(options) {
  kept_.X_PO = moved_.X_PO = X_PO;
  require(object_.shape && object_.friction >= 0,
          "a pad in motion wants an object with a shape and a friction >= 0");
  // Compute the reach of the skin with a margin, and the time after which the history is dropped.
  reset_elements(X_PO);
  const Eigen::Matrix3Xd& places = press_->surface().rest_positions;
  reach_ = places.colwise().norm().maxCoeff() * 1.05;
  for (const Tissue& tissue : model_.tissues)
    for (const ExponentialTerm& term : tissue.relaxation)
      memory_time_ = std::max(memory_time_, kMemoryTimes * term.time);
}

std::unique_ptr<MovingPad> ElementPad::clone() const {
  return std::make_unique<ElementPad>(model_, object_, kept_.X_PO, options_);
}

void ElementPad::reset_elements(const Pose<double>& X_PO) {
  PadPressOptions options;
  options.step = options_.step;
  options.force_error = options_.mesh_error;
  options.max_elements = options_.max_elements;
  options.max_failed_pieces = kMaxFailedPieces;
  options.step.max_iterations = std::min(options.step.max_iterations, kMaxStepIterations);
  options.max_penetration = 1;  // faces are as fine as the error of the force asks
  press_ = std::make_unique<PadPress>(model_, object_, X_PO, options);
}

void ElementPad::undo_trial() {
  if (has_trial_) press_->undo_step();
  has_trial_ = false;
}

PadContact ElementPad::try_step(const Pose<double>& X_PO, double seconds) {
  undo_trial();
  moved_ = {X_PO, kept_.at_rest, kept_.free_time + seconds};
  PadContact out;
  // A pad at rest stays at rest while the object does not reach it.
  if (kept_.at_rest) {
    out.gap = object_.shape->distance(X_PO.inverse().p) - reach_;
    if (out.gap > 0) return out;
    out.gap = min_gap(press_->surface(), *object_.shape, X_PO, press_->state().x);
    if (out.gap > 0) return out;
    press_->place_object(withdrawn_pose(X_PO, -out.gap));
    out.gap = 0;
  }
  // Take one step of the elements; if it fails the pad keeps its state.
  PressGoal goal;
  goal.X_PO = X_PO;
  goal.time = seconds;
  const PadPressResult result = press_->step(goal);
  has_trial_ = result.solved.status == Status::kSolved;
  if (!has_trial_) {
    out.status = result.solved.status;
    out.message = result.solved.message;
    moved_ = kept_;
    return out;
  }
  moved_.at_rest = false;
  out = contact_of(result);
  if (out.force > 0) moved_.free_time = 0;
  return out;
}

Pose<double> ElementPad::withdrawn_pose(const Pose<double>& X_PO, double overlap) const {
  const Pose<double> X_OP = X_PO.inverse();
  // Find the node that lies deepest in the object.
  const Eigen::Matrix3Xd places = deformed_positions(press_->surface(), press_->state().x);
  Eigen::Index deepest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < places.cols(); ++k) {
    const double gap = object_.shape->distance(X_OP * Eigen::Vector3d(places.col(k)));
    if (gap >= least) continue;
    least = gap;
    deepest = k;
  }
  // Move the object out along its normal there, to a small gap.
  Pose<double> out = X_PO;
  out.p -= (overlap + kClearGap) *
           (X_PO.R * object_.shape->nearest(X_OP * Eigen::Vector3d(places.col(deepest))).normal);
  return out;
}

PadContact ElementPad::contact_of(const PadPressResult& result) const {
  PadContact out;
  const PressState& state = press_->state();
  out.force = state.normal_force.sum();
  out.force_error = result.force_error;
  // Without force, measure the gap to the deformed skin.
  if (out.force <= 0) {
    out.force = 0;
    const double gap = min_gap(press_->surface(), *object_.shape, state.X_PO, state.x);
    out.gap = std::max(0.0, gap);
    return out;
  }
  // Copy wrench and patch, and compute the centre of pressure and the direction without friction.
  out.push = result.push;
  out.area = result.area;
  out.stick = result.stick;
  out.centre = deformed_positions(press_->surface(), state.x) * state.normal_force / out.force;
  const Eigen::Vector3d friction = state.friction_force.rowwise().sum();
  out.normal = (out.push.force - friction).normalized();
  return out;
}

void ElementPad::accept_step() {
  kept_ = moved_;
  has_trial_ = false;
  if (!kept_.at_rest && kept_.free_time > memory_time_) {
    kept_.at_rest = true;
    reset_elements(kept_.X_PO);
  }
}

double ElementPad::energy() const {
  if (kept_.at_rest) return 0;
  const TissueBody& body = press_->body();
  TissueResponse now;
  body.evaluate(body.node_displacements(press_->state().x, {}), 0, {}, {}, ElementRequest::kEnergy,
                now);
  return now.energy + press_->state().spring_energy;
}

Matrix6 ElementPad::stiffness(const Eigen::Matrix<double, 6, 1>& /*onward*/) {
  undo_trial();
  if (kept_.at_rest || press_->state().normal_force.isZero(0)) return Matrix6::Zero();
  return press_->stiffness();
}

}  // namespace thenar
