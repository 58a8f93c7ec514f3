#pragma once

/// Efforts of springs, dampers, drives and elements on a scene, their slopes and their powers.

#include <vector>

#include <Eigen/Core>

#include "dynamics/stepping/force_element.h"
#include "dynamics/stepping/scene_motion.h"

namespace thenar {

class AppliedEfforts {
 public:
  /// @param scene, model  outlive it
  AppliedEfforts(const MovingScene& scene, const TreeModel& model);

  /// Selects the forces and drives that act from now on: those whose span holds t [s].
  void act_as_at(double t) { acting_ = t; }
  [[nodiscard]] double acting() const { return acting_; }
  /// Notes what kinds of forces the scene has, after its drives have changed.
  void note_what_acts();
  /// Returns whether some spring, damper or drive may be stiff.
  [[nodiscard]] bool has_slopes() const { return has_slopes_; }
  /// Returns whether energy flows where nothing touches.
  [[nodiscard]] bool has_flows() const { return has_flows_; }

  /// Sets efforts and their slopes, and loads on bodies.
  /// @param motion  placed at the state
  /// @return whether all elements could act
  bool load(SceneMotion& motion, const SceneState& state, ElementNeed need = ElementNeed::kAll);

  /// Advances states of elements by what they did last [SceneElements].
  void advance_states(double h, SceneState& state) const;

  /// Sets powers in the mean over a step of all but contacts, after load() [W].
  void find_powers(const SceneMotion& motion, const StepEfforts& at);

  /// Energy in springs of joints [J].
  [[nodiscard]] double spring_energy(const SceneState& state) const;

  /// Returns the inputs of elements at a state.
  [[nodiscard]] ElementInput input_at(const SceneMotion& motion, const SceneState& state,
                                      ElementNeed need = ElementNeed::kAll) const {
    return {state.t, acting_, state.q, state.v, state.z, motion.links(), 0, need};
  }

  /// Lets elements remember nothing.
  void forget();

  Eigen::VectorXd tau;                      // [N m], [N] (v)
  Eigen::VectorXd stiffness, damping;       // of springs, dampers and drives, over the speeds (v)
  EnergyFlows power = EnergyFlows::Zero();  // [W]
  SceneElements elements;

 private:
  void add_springs(const SceneState& state);
  void add_drive(const SceneDrive& drive, const SceneState& state);

  const MovingScene& scene_;
  const TreeModel& model_;
  std::vector<std::size_t> resisting_;  // joints with springs or dampers
  bool has_slopes_ = false, has_flows_ = false;
  double acting_ = 0;  // [s]
};

}  // namespace thenar
