#pragma once

/// Poses and velocities of a scene's links, cached by state.

#include <Eigen/Core>

#include "dynamics/mechanism/composite_body.h"
#include "dynamics/stepping/scene_state.h"

namespace thenar {

/// Motion of a scene's links; set_state() recomputes it only for another state.
class SceneMotion {
 public:
  explicit SceneMotion(const TreeModel& model) : links_(model) { links_.clear_loads(); }

  /// Computes poses and velocities at a state, unless they are those of the last call.
  void set_state(const SceneState& state) {
    if (is_placed_ && q_ == state.q && v_ == state.v) return;
    links_.set_position(state.q);
    links_.set_speed(state.v);
    q_ = state.q;
    v_ = state.v;
    is_placed_ = true;
  }
  /// Computes poses alone; the next set_state() recomputes everything.
  void set_position(const Eigen::VectorXd& q) {
    is_placed_ = false;
    links_.set_position(q);
  }
  /// Computes velocities alone, at the present poses; the next set_state() recomputes everything.
  void set_speeds(const Eigen::VectorXd& v) {
    is_placed_ = false;
    links_.set_speed(v);
  }
  /// Invalidates the cache.
  void invalidate() { is_placed_ = false; }

  [[nodiscard]] TreeMotion<double>& links() { return links_; }
  [[nodiscard]] const TreeMotion<double>& links() const { return links_; }
  /// Returns the velocities of the last set_state() (v).
  [[nodiscard]] const Eigen::VectorXd& speeds() const { return v_; }

 private:
  TreeMotion<double> links_;
  Eigen::VectorXd q_, v_;   // positions and velocities of the last set_state() (q), (v)
  bool is_placed_ = false;  // links_ still has that state
};

}  // namespace thenar
