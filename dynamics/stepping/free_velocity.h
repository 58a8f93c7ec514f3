#pragma once

/// Velocity of a scene after a step without contact impulses.

#include <Eigen/Core>

#include "dynamics/mechanism/composite_body.h"
#include "dynamics/stepping/applied_efforts.h"
#include "dynamics/stepping/scene_motion.h"

namespace thenar {

/// Velocity update of a step, implicit in springs and dampers, with the factorised matrix A to
/// which contact impulses are then applied.
class FreeVelocity {
 public:
  /// @param scene, model  must outlive the object
  FreeVelocity(const MovingScene& scene, const TreeModel& model);

  /// Computes  v = state.v + A^-1 h (tau - c(q, v)),  with c the velocity product and weights, and
  /// factorises  A = M + theta h damping + (theta h)^2 stiffness.  Springs and dampers thus act at
  /// the end of the step (theta = 1) or in its mean (theta = 1/2), to first order.
  /// @param efforts  computed at the state
  /// @param h        [s]; 0: v = state.v and A = M, for impacts
  /// @return true if A is positive definite
  bool compute(const SceneMotion& motion, const AppliedEfforts& efforts, const SceneState& state,
               double h, double theta);

  /// Adds A^-1 h (tau - c(q, v)) to v.
  void add_efforts(const SceneMotion& motion, const AppliedEfforts& efforts, double h);
  /// Computes out = A^-1 h (tau - c(q, v)) with the present factor. @param out  (v)
  void solve_efforts(const SceneMotion& motion, const AppliedEfforts& efforts, double h,
                     Eigen::VectorXd& out);
  /// Adds A^-1 impulses to v. @param impulses  generalized impulses [N m s], [N s] (v)
  void apply_impulses(const Eigen::VectorXd& impulses);

  Eigen::VectorXd v;        // velocity [rad/s], [m/s] (v)
  MassMatrix<double> mass;  // factor of A

 private:
  bool factorise_with_elements(const SceneMotion& motion, const ElementAction& action, double dh);

  const MovingScene& scene_;
  const TreeModel& model_;
  InverseDynamics<double> inverse_;
  Eigen::VectorXd zero_, change_;
  Eigen::VectorXd implicit_;  // diagonal that springs and dampers add to M (v)
  Eigen::MatrixXd slopes_;    // matrix that elements add to M (v, v)
};

}  // namespace thenar
