#pragma once

/// Finite elements of a pad in motion.

#include "pads/motion/moving_pad.h"
#include "pads/pad_press.h"

namespace thenar {

struct ElementPadOptions {
  PressOptions step;
  double mesh_error = 0.5;  // estimate of the force's error above which cells are cut [1]
  int max_elements = 2000;  // the mesh is not refined beyond
};

/// PadPress under an object that moves. An object that is farther off than nodes can be, over a pad
/// at rest, costs one look at its distance; a pad that nothing has touched for ten times its
/// longest relaxation is as new, on its coarsest mesh.
class ElementPad final : public MovingPad {
 public:
  /// @throws InputError as PadPress, or if the object has no shape.
  ElementPad(PadModel model, RigidObject object, const Pose<double>& X_PO,
             const ElementPadOptions& options = {});

  [[nodiscard]] std::unique_ptr<MovingPad> clone() const override;
  [[nodiscard]] std::string rung() const override { return "elements"; }
  [[nodiscard]] PadContact move(const Pose<double>& X_PO, double seconds) override;
  void keep() override;
  /// Computes the stiffness from the tangent of the elements, with nodes that stick and slip as
  /// they do.
  [[nodiscard]] Matrix6 stiffness(const Eigen::Matrix<double, 6, 1>& onward) override;
  [[nodiscard]] double energy() const override;
  [[nodiscard]] double reach() const override { return reach_; }
  [[nodiscard]] const std::vector<ExponentialTerm>& relaxation() const override {
    return model_.tissues.front().relaxation;
  }
  [[nodiscard]] const Pose<double>& object_pose() const override { return kept_.X_PO; }

 private:
  /// State of the pad without that of its elements.
  struct State {
    Pose<double> X_PO;
    bool rests = true;  // it is as new
    double free = 0;    // time since anything touched [s]
  };
  void renew(const Pose<double>& X_PO);
  /// Undoes the changes of the elements by the last move.
  void undo();
  /// The object, moved out of a pad at rest along its normal, so that it came in straight.
  [[nodiscard]] Pose<double> pulled_out(const Pose<double>& X_PO, double overlap) const;
  [[nodiscard]] PadContact touch_of(const PadPressResult& result) const;

  PadModel model_;
  RigidObject object_;
  ElementPadOptions options_;
  double reach_ = 0;    // no point of the pad is farther from its origin [m]
  double forgets_ = 0;  // after this time nothing is remembered [s]
  std::unique_ptr<PadPress> press_;
  State kept_, moved_;
  bool trial_ = false;  // the press is at the last move, which is not kept
};

}  // namespace thenar
