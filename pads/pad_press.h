#pragma once

/// A finger pad pressed by a rigid object, on a mesh that refines itself.

#include <memory>
#include <vector>

#include "pads/pad_model.h"
#include "pads/press_step.h"

namespace thenar {

/// A pad and an object, step after step. The pad's frame is that of PadShape.
class PadPress {
 public:
  PadPress(const PadModel& model, RigidObject object, const Pose<double>& X_PO,
           PadPressOptions options);

  /// Moves the object along a unit direction until it just touches a node. @return how far [m]
  /// @throws InputError if it touches already, begins inside the pad or passes it by.
  double touch(const Eigen::Vector3d& along);

  /// One step, cut in halves where it fails (a bounded number of them), or a force sought by depths
  /// (seek_force(); it may lie before the touch on a coarse mesh), the mesh refined until
  /// force and penetration are as good as asked or `max_elements` are passed: `force_error` says
  /// how good it became, and `penetration`, for whose sake no mesh is taken that has no answer. A
  /// step that fails leaves the state at its beginning.
  PadPressResult step(const PressGoal& goal);

  /// Back to the beginning of the last step, on the mesh as it is now.
  void undo() { state_ = before_; }
  /// Puts the object somewhere else, where it does not touch; the pad stays as it is.
  void begin_at(const Pose<double>& X_PO);
  /// d push / d motion of the object, at once: press_stiffness().
  /// @param friction  instead of the object's: 1 for a press without friction, whose nodes stick
  [[nodiscard]] Eigen::Matrix<double, 6, 6> stiffness(std::optional<double> friction = {});

  /// Sets the force error that is asked from the next step on.
  void set_force_error(double error) { options_.force_error = error; }

  [[nodiscard]] const PressState& state() const { return state_; }
  [[nodiscard]] const HexMesh& mesh() const { return mesh_; }
  [[nodiscard]] const ContactSurface& surface() const { return surface_; }
  [[nodiscard]] const TissueBody& body() const { return *body_; }

 private:
  /// An answer whose object is too deep in some faces, and the mesh that it is on.
  struct Kept {
    HexMesh mesh;
    PressState state, start;
    PadPressResult result;
  };
  void build();
  PressOutcome solve_once(const PressGoal& goal, PressState& state);
  /// Solves a step, in pieces where necessary; finds a force by a search.
  PressOutcome solve(const PressGoal& goal, int cuts);
  /// Returns whether too few nodes touch for the error that is asked: the edge of a patch lies on
  /// nodes, which is an error of up to 1 / nodes that no estimate sees.
  [[nodiscard]] bool patch_is_coarse() const;
  [[nodiscard]] std::vector<int> touching_cells() const;
  /// The elements with the largest errors, which hold a share of the whole.
  [[nodiscard]] std::vector<int> cells_of_errors(const Eigen::VectorXd& errors) const;
  /// Refines cells; carries `start` and the present state over.
  void refine(const std::vector<int>& marked, PressState& start);
  /// A goal of a force begins where the object is along its direction.
  [[nodiscard]] PressGoal from_here(const PressGoal& goal) const;
  /// Area, stick and depths in faces of the present state.
  void measure(PadPressResult& result);

  PadModel model_;
  RigidObject object_;
  PadPressOptions options_;
  HexMesh mesh_;
  std::unique_ptr<TissueBody> body_;
  std::unique_ptr<PressFactors> factors_;
  ContactSurface surface_;
  PressState state_, before_;    // of now; at the beginning of the last step
  std::vector<int> deep_cells_;  // whose faces the object is too deep in
  int iterations_ = 0;
  int pieces_ = 0;  // of the present step that failed
};

}  // namespace thenar
