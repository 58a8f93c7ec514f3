#pragma once

/// A law at a point in motion: soft finger, power law.

#include <array>
#include <optional>

#include "pad_laws/contact_law.h"
#include "pads/motion/moving_pad.h"
#include "pads/press_step.h"
#include "pads/skin_gap.h"

namespace thenar {

/// A law where the undeformed skin lies deepest in the object; the patch sticks, slips and twists
/// as a whole. Its friction and torsion are those of springs, k = LawContact::shear and k a b,
/// which on an incompressible half space holds for circles, which the object's motion at the patch
/// stretches step by step, so that rolling is no slip; they relax as the force does, and stay
/// within the ellipsoid  |f_t|^2 + (torque / e)^2 <= (mu f_n)^2 with the e mu of the law, by the
/// way straight back to it. A patch that shrinks loses what it cannot carry, so that friction gives
/// back no more than it took. Sources: [Howe1996] for the ellipsoid, [Elata1996].
class LawPad final : public MovingPad {
 public:
  /// @param name  of the rung
  /// @throws InputError as PadChart, or if law or object are missing, or the law has no stiffness
  /// across.
  LawPad(std::string name, const PadShape& shape, std::shared_ptr<const ContactLaw> law,
         RigidObject object, const Pose<double>& X_PO);

  [[nodiscard]] std::unique_ptr<MovingPad> clone() const override;
  [[nodiscard]] std::string rung() const override { return name_; }
  [[nodiscard]] PadContact move(const Pose<double>& X_PO, double seconds) override;
  void keep() override;
  /// Returns the energy of the normal force, a power of depth, and of the springs of friction [J].
  [[nodiscard]] double energy() const override { return kept_.energy; }
  [[nodiscard]] double reach() const override { return reach_; }
  [[nodiscard]] const std::vector<ExponentialTerm>& relaxation() const override {
    return law_->relaxation();
  }
  [[nodiscard]] const Pose<double>& object_pose() const override { return kept_.X_PO; }

 private:
  struct State {
    Pose<double> X_PO;
    Eigen::Vector2d disc{0, 0};  // where it touched, or was nearest
    Pose<double> X_look;         // of the object when all of the skin was looked at
    double lead = 0;             // as DeepestSkin then [m]
    bool touched = false;
    ExponentialMemory normal;               // [N]
    std::array<ExponentialMemory, 4> drag;  // friction along x, y, z [N]; torque [N m]
    std::array<double, 2> spring{0, 0};     // that carries friction [N/m], torque [N m/rad]
    double energy = 0;                      // as LawPad::energy() [J]
  };
  /// Friction and torsion of a step. @return friction [N] (3), torque about the normal [N m]
  [[nodiscard]] Eigen::Vector4d rub(const LawContact& contact, const Eigen::Vector3d& at,
                                    const Eigen::Vector3d& normal, const MemoryStep& weights,
                                    bool& sticks);

  std::string name_;
  PadShape shape_;
  std::shared_ptr<const PadChart> chart_;
  std::shared_ptr<const Shape> skin_;
  std::shared_ptr<const ContactLaw> law_;
  RigidObject object_;
  double reach_ = 0;  // no skin is farther from the pad's origin [m]
  State kept_, moved_;
};

}  // namespace thenar
