#pragma once

/// Bed of springs under a moving object.

#include "pad_laws/foundation_bed.h"
#include "pads/motion/moving_pad.h"
#include "pads/press_step.h"

namespace thenar {

/// Pad whose contact is FoundationBed::step().
class BedPad final : public MovingPad {
 public:
  /// @throws InputError if the object has no shape or no friction >= 0, or the bed no shear to hold
  ///         it by.
  BedPad(std::shared_ptr<const FoundationBed> bed, RigidObject object, const Pose<double>& X_PO);

  [[nodiscard]] std::unique_ptr<MovingPad> clone() const override;
  [[nodiscard]] std::string rung() const override { return "foundation"; }
  [[nodiscard]] PadContact try_step(const Pose<double>& X_PO, double seconds) override;
  void accept_step() override;
  /// Returns the energy that the springs along the normal give back when the object is drawn
  /// straight out, plus the energy in the springs of friction [J].
  [[nodiscard]] double energy() const override;
  [[nodiscard]] double reach() const override;
  [[nodiscard]] const std::vector<ExponentialTerm>& relaxation() const override {
    return bed_->relaxation();
  }
  [[nodiscard]] const Pose<double>& object_pose() const override { return kept_.X_PO; }

 private:
  struct State {
    BedState bed;
    Pose<double> X_PO;
  };
  std::shared_ptr<const FoundationBed> bed_;
  RigidObject object_;
  State kept_, moved_;
};

}  // namespace thenar
