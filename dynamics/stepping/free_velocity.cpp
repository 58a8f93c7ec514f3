#include "dynamics/stepping/free_velocity.h"

namespace thenar {

FreeVelocity::FreeVelocity(const MovingScene& scene, const TreeModel& model)
    : mass(model), scene_(scene), model_(model), inverse_(model) {
  v = zero_ = change_ = implicit_ = Eigen::VectorXd::Zero(model.layout.v);
}

bool FreeVelocity::set(const SceneMotion& motion, const AppliedEfforts& efforts,
                       const SceneState& state, double h, double d) {
  // Factor of A with the slopes of springs, dampers, drives and elements.
  implicit_ = (d * h) * efforts.damping + (d * h * d * h) * efforts.stiffness;
  const bool positive = h > 0 && !efforts.elements.empty()
                            ? set_with_elements(motion, efforts.elements.action(), d * h)
                            : mass.set(motion.links(), implicit_);
  // Speeds by the efforts of the step.
  v = state.v;
  if (h > 0) add_efforts(motion, efforts, h);
  return positive;
}

/// Sets the factor of A with the slopes of elements; where these pull A below zero, as a tendon
/// over a bent joint may, what is positive on their diagonal alone.
bool FreeVelocity::set_with_elements(const SceneMotion& motion, const ElementAction& action,
                                     double dh) {
  slopes_ = dh * action.damping + (dh * dh) * action.stiffness;
  if (mass.set(motion.links(), implicit_, slopes_)) return true;
  slopes_ = Eigen::MatrixXd(slopes_.diagonal().cwiseMax(0).asDiagonal());
  implicit_ += slopes_.diagonal();
  return mass.set(motion.links(), implicit_);
}

void FreeVelocity::add_efforts(const SceneMotion& motion, const AppliedEfforts& efforts, double h) {
  solve_efforts(motion, efforts, h, change_);
  v += change_;
}

void FreeVelocity::solve_efforts(const SceneMotion& motion, const AppliedEfforts& efforts, double h,
                                 Eigen::VectorXd& out) {
  // Efforts less those that the velocity product and weights need.
  inverse_.efforts(motion.links(), scene_.gravity, zero_, out);
  out = h * (efforts.tau - out);
  mass.solve(model_, out);
}

void FreeVelocity::push(const Eigen::VectorXd& impulses) {
  change_ = impulses;
  mass.solve(model_, change_);
  v += change_;
}

}  // namespace thenar
