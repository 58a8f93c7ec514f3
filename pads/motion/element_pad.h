#pragma once

/// Finite elements of a pad under a moving object.

#include "pads/motion/moving_pad.h"
#include "pads/pad_press.h"

namespace thenar {

struct ElementPadOptions {
  PressOptions step;
  double mesh_error = 0.5;  // estimated force error above which the mesh is refined [1]
  int max_elements = 2000;  // elements of a mesh up to which it is refined
};

/// Pad whose contact is PadPress. Over a pad at rest, a distant object costs one distance query. A
/// pad that nothing has touched for ten times its longest relaxation time is reset to rest, on its
/// coarsest mesh.
class ElementPad final : public MovingPad {
 public:
  /// @throws InputError as PadPress, or if the object has no shape.
  ElementPad(PadModel model, RigidObject object, const Pose<double>& X_PO,
             const ElementPadOptions& options = {});

  [[nodiscard]] std::unique_ptr<MovingPad> clone() const override;
  [[nodiscard]] std::string rung() const override { return "elements"; }
  [[nodiscard]] PadContact try_step(const Pose<double>& X_PO, double seconds) override;
  void accept_step() override;
  /// Computes the stiffness from the tangent of the elements, with the present sticking and
  /// slipping nodes.
  [[nodiscard]] Matrix6 stiffness(const Eigen::Matrix<double, 6, 1>& onward) override;
  [[nodiscard]] double energy() const override;
  [[nodiscard]] double reach() const override { return reach_; }
  [[nodiscard]] const std::vector<ExponentialTerm>& relaxation() const override {
    return model_.tissues.front().relaxation;
  }
  [[nodiscard]] const Pose<double>& object_pose() const override { return kept_.X_PO; }

 private:
  /// State of the pad except that of its elements.
  struct State {
    Pose<double> X_PO;
    bool at_rest = true;   // the pad is undeformed and has no history
    double free_time = 0;  // time since the last contact [s]
  };
  /// Resets the elements to rest on the coarsest mesh.
  void reset_elements(const Pose<double>& X_PO);
  /// Undoes the changes of the elements by the last trial step.
  void undo_trial();
  /// Returns the object's pose, moved out of a pad at rest along its normal, so that it enters
  /// straight.
  [[nodiscard]] Pose<double> withdrawn_pose(const Pose<double>& X_PO, double overlap) const;
  [[nodiscard]] PadContact contact_of(const PadPressResult& result) const;

  PadModel model_;
  RigidObject object_;
  ElementPadOptions options_;
  double reach_ = 0;        // bound of the distance of the pad's points from its origin [m]
  double memory_time_ = 0;  // time after which the history is negligible [s]
  std::unique_ptr<PadPress> press_;
  State kept_, moved_;
  bool has_trial_ = false;  // the elements are at a trial step that is not accepted yet
};

}  // namespace thenar
