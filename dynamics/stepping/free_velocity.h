#pragma once

/// Speeds of a scene after a step without impulses.

#include <Eigen/Core>

#include "dynamics/mechanism/composite_body.h"
#include "dynamics/stepping/applied_efforts.h"
#include "dynamics/stepping/scene_motion.h"

namespace thenar {

class FreeVelocity {
 public:
  /// @param scene, model  outlive it
  FreeVelocity(const MovingScene& scene, const TreeModel& model);

  /// Sets v = state.v + A^-1 h (tau - h(q, v)) and the factor of
  ///   A = M + d h damping + (d h)^2 stiffness,
  /// so that springs and dampers are taken at the end of the step (d = 1) or in its mean (d = 1/2),
  /// to first order; h = 0: state.v alone.
  /// @param efforts  loaded at the state
  /// @return whether A is positive definite
  bool set(const SceneMotion& motion, const AppliedEfforts& efforts, const SceneState& state,
           double h, double d);

  /// Adds A^-1 h (tau - h(q, v)) to v.
  void add_efforts(const SceneMotion& motion, const AppliedEfforts& efforts, double h);
  /// Sets out = A^-1 h (tau - h(q, v)), with the factor that `mass` has. @param out  (v)
  void solve_efforts(const SceneMotion& motion, const AppliedEfforts& efforts, double h,
                     Eigen::VectorXd& out);
  /// Adds A^-1 of generalised impulses to v. @param impulses  (v)
  void push(const Eigen::VectorXd& impulses);

  Eigen::VectorXd v;        // (v)
  MassMatrix<double> mass;  // factor of A

 private:
  bool set_with_elements(const SceneMotion& motion, const ElementAction& action, double dh);

  const MovingScene& scene_;
  const TreeModel& model_;
  InverseDynamics<double> inverse_;
  Eigen::VectorXd zero_, change_;
  Eigen::VectorXd implicit_;  // what springs and dampers add to the mass matrix (v)
  Eigen::MatrixXd slopes_;    // of elements, as they enter A (v, v)
};

}  // namespace thenar
