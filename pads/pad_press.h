#pragma once

/// A finger pad pressed by a rigid object, on an adaptive mesh.

#include <memory>
#include <vector>

#include "pads/pad_model.h"
#include "pads/press_step.h"

namespace thenar {

/// Press of an object on a pad, step by step. The pad's frame is that of PadShape.
class PadPress {
 public:
  PadPress(const PadModel& model, RigidObject object, const Pose<double>& X_PO,
           PadPressOptions options);

  /// Moves the object along a unit direction until it just touches the skin.
  /// @return distance moved [m]
  /// @throws InputError if it touches already, begins inside the pad or passes it by.
  double touch(const Eigen::Vector3d& along);

  /// Solves one step. A step to a pose that fails is halved, a bounded number of times; a step to a
  /// force that fails becomes a search by depths (seek_force(); on a coarse mesh the depth may lie
  /// before the touch). The mesh is refined until force error and penetration meet their bounds or
  /// the mesh has `max_elements`; a mesh refined for penetration alone is dropped if the step has
  /// no solution on it. A step that fails leaves the state unchanged.
  /// @return result with the `force_error` and `penetration` reached
  PadPressResult step(const PressGoal& goal);

  /// Restores the state at the start of the last step, on the present mesh.
  void undo_step() { state_ = start_; }
  /// Places the object at a pose where it does not touch; the pad stays deformed.
  void place_object(const Pose<double>& X_PO);
  /// Returns the slope of the object's wrench by its motion, without relaxation: press_stiffness().
  /// @param friction  coefficient instead of the object's: 1 makes nodes of a frictionless press
  ///         stick [1]
  [[nodiscard]] Eigen::Matrix<double, 6, 6> stiffness(std::optional<double> friction = {});

  /// Sets the bound of the force error from the next step on [1].
  void set_force_error(double error) { options_.force_error = error; }

  [[nodiscard]] const PressState& state() const { return state_; }
  [[nodiscard]] const HexMesh& mesh() const { return mesh_; }
  [[nodiscard]] const ContactSurface& surface() const { return surface_; }
  [[nodiscard]] const TissueBody& body() const { return *body_; }

 private:
  /// Solution that is good enough but for the penetration of some faces, with its mesh.
  struct Accepted {
    HexMesh mesh;
    PressState state, start;
    PadPressResult result;
  };
  void build_body();
  PressOutcome solve_once(const PressGoal& goal, PressState& state);
  /// Solves a step, halved where it fails; searches for a force by depths.
  PressOutcome solve(const PressGoal& goal, int cuts);
  /// Returns whether too few nodes touch for the requested error: the edge of a patch lies on
  /// nodes, which causes an error of up to 1 / nodes that the error estimate misses.
  [[nodiscard]] bool has_coarse_patch() const;
  [[nodiscard]] std::vector<int> touching_cells() const;
  /// Returns the cells with the largest errors that together hold a given share of the total.
  [[nodiscard]] std::vector<int> cells_with_large_errors(const Eigen::VectorXd& errors) const;
  /// Refines cells and transfers `start` and the present state to the new mesh.
  void refine(const std::vector<int>& marked, PressState& start);
  /// Returns the goal with its pose moved along the direction of the force to the present depth.
  [[nodiscard]] PressGoal goal_from_current_pose(const PressGoal& goal) const;
  /// Measures wrench, area, sticking share and penetration at the present state.
  void measure_result(PadPressResult& result);

  PadModel model_;
  RigidObject object_;
  PadPressOptions options_;
  HexMesh mesh_;
  std::unique_ptr<TissueBody> body_;
  std::unique_ptr<PressFactors> factors_;
  ContactSurface surface_;
  PressState state_, start_;     // present state; state at the start of the last step
  std::vector<int> deep_cells_;  // cells whose faces the object penetrates too deeply
  int iterations_ = 0;
  int failed_pieces_ = 0;  // failed pieces of the present step
};

}  // namespace thenar
