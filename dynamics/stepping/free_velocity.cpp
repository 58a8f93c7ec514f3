#include "dynamics/stepping/free_velocity.h"

namespace thenar {

FreeVelocity::FreeVelocity(const MovingScene& scene, const TreeModel& model)
    : mass(model), scene_(scene), model_(model), inverse_(model) {
  v = zero_ = change_ = implicit_ = Eigen::VectorXd::Zero(model.layout.v);
}

bool FreeVelocity::compute(const SceneMotion& motion, const AppliedEfforts& efforts,
                           const SceneState& state, double h, double theta) {
  // Factorise A with the slopes of springs, dampers, drives and elements.
  implicit_ = (theta * h) * efforts.damping + (theta * h * theta * h) * efforts.stiffness;
  const bool positive = h > 0 && !efforts.elements.empty()
                            ? factorise_with_elements(motion, efforts.elements.action(), theta * h)
                            : mass.compute(motion.links(), implicit_);
  // Add the velocity change by the efforts of the step.
  v = state.v;
  if (h > 0) add_efforts(motion, efforts, h);
  return positive;
}

/// Factorises A with the slopes of elements. If A is then not positive definite, which a tendon
/// over a bent joint may cause, only the positive part of their diagonal is used.
bool FreeVelocity::factorise_with_elements(const SceneMotion& motion, const ElementAction& action,
                                           double dh) {
  slopes_ = dh * action.damping + (dh * dh) * action.stiffness;
  if (mass.compute(motion.links(), implicit_, slopes_)) return true;
  slopes_ = Eigen::MatrixXd(slopes_.diagonal().cwiseMax(0).asDiagonal());
  implicit_ += slopes_.diagonal();
  return mass.compute(motion.links(), implicit_);
}

void FreeVelocity::add_efforts(const SceneMotion& motion, const AppliedEfforts& efforts, double h) {
  solve_efforts(motion, efforts, h, change_);
  v += change_;
}

void FreeVelocity::solve_efforts(const SceneMotion& motion, const AppliedEfforts& efforts, double h,
                                 Eigen::VectorXd& out) {
  // Subtract velocity product and weights from the efforts, then solve.
  inverse_.efforts(motion.links(), scene_.gravity, zero_, out);
  out = h * (efforts.tau - out);
  mass.solve(model_, out);
}

void FreeVelocity::apply_impulses(const Eigen::VectorXd& impulses) {
  change_ = impulses;
  mass.solve(model_, change_);
  v += change_;
}

}  // namespace thenar
