#pragma once

/// Links of a scene, placed at a state.

#include <Eigen/Core>

#include "dynamics/mechanism/composite_body.h"
#include "dynamics/stepping/scene_state.h"

namespace thenar {

/// Motion of a scene's links at the state where they were placed last.
class SceneMotion {
 public:
  explicit SceneMotion(const TreeModel& model) : links_(model) { links_.clear_loads(); }

  /// Places links at a state; nothing is done where they are there already.
  void place(const SceneState& state) {
    if (is_placed_ && q_ == state.q && v_ == state.v) return;
    links_.set_position(state.q);
    links_.set_speed(state.v);
    q_ = state.q;
    v_ = state.v;
    is_placed_ = true;
  }
  /// Moves links to a position, or to other speeds, for once.
  void move_to(const Eigen::VectorXd& q) {
    is_placed_ = false;
    links_.set_position(q);
  }
  void speed_up(const Eigen::VectorXd& v) {
    is_placed_ = false;
    links_.set_speed(v);
  }
  /// Forgets where links were placed.
  void forget() { is_placed_ = false; }

  [[nodiscard]] TreeMotion<double>& links() { return links_; }
  [[nodiscard]] const TreeMotion<double>& links() const { return links_; }
  /// Speeds of the last place() (v).
  [[nodiscard]] const Eigen::VectorXd& placed_speeds() const { return v_; }

 private:
  TreeMotion<double> links_;
  Eigen::VectorXd q_, v_;   // of the last place() (q), (v)
  bool is_placed_ = false;  // and links are still there
};

}  // namespace thenar
