#pragma once

/// Efforts of springs, dampers, drives, loads and force elements, their slopes and powers.

#include <vector>

#include <Eigen/Core>

#include "dynamics/stepping/force_element.h"
#include "dynamics/stepping/scene_motion.h"

namespace thenar {

/// Generalized forces on a scene apart from contacts, limits and dry friction.
class AppliedEfforts {
 public:
  /// @param scene, model  must outlive the object
  AppliedEfforts(const MovingScene& scene, const TreeModel& model);

  /// Selects the forces and drives that act: those whose time span contains t [s].
  void select_active_forces(double t) { selection_time_ = t; }
  [[nodiscard]] double selection_time() const { return selection_time_; }
  /// Updates has_slopes() and has_flows() after the scene's drives have changed.
  void update_force_kinds();
  /// Returns true if the scene has springs, dampers, stiff drives or elements.
  [[nodiscard]] bool has_slopes() const { return has_slopes_; }
  /// Returns true if energy may flow without contacts.
  [[nodiscard]] bool has_flows() const { return has_flows_; }

  /// Computes efforts and their slopes, and sets the loads on bodies.
  /// @param motion  set to the state; receives the loads
  /// @return false if an element has no valid force
  bool compute(SceneMotion& motion, const SceneState& state, ElementNeed need = ElementNeed::kAll);

  /// Advances the states of elements by h with the rates of the last compute(), semi-implicitly:
  /// z += h z' / (1 + h decay). @param h  [s]
  void advance_states(double h, SceneState& state) const;

  /// Sets `power` to the mean powers over a step, without contacts. Call after compute().
  void compute_powers(const SceneMotion& motion, const StepEfforts& at);

  /// Computes the energy of joint springs [J].
  [[nodiscard]] double spring_energy(const SceneState& state) const;

  /// Returns the input of the elements at a state.
  [[nodiscard]] ElementInput element_input(const SceneMotion& motion, const SceneState& state,
                                           ElementNeed need = ElementNeed::kAll) const {
    return {state.t, selection_time_, state.q, state.v, state.z, motion.links(), 0, need};
  }

  /// Replaces the elements by fresh clones of the scene's.
  void reset_elements();

  Eigen::VectorXd tau;                      // generalized forces [N m], [N] (v)
  Eigen::VectorXd stiffness, damping;       // diagonal slopes of springs, dampers and drives (v)
  EnergyFlows power = EnergyFlows::Zero();  // mean powers over a step [W]
  SceneElements elements;

 private:
  void add_springs(const SceneState& state);
  void add_drive(const SceneDrive& drive, const SceneState& state);

  const MovingScene& scene_;
  const TreeModel& model_;
  std::vector<std::size_t> resisting_joints_;  // joints with springs or dampers
  bool has_slopes_ = false, has_flows_ = false;
  double selection_time_ = 0;  // instant that selects forces and drives [s]
};

}  // namespace thenar
