#pragma once

/// Point contact law under a moving object: soft finger, power law.

#include <array>

#include "pad_laws/contact_law.h"
#include "pads/motion/moving_pad.h"
#include "pads/press_step.h"
#include "pads/skin_gap.h"

namespace thenar {

/// Pad whose contact is a law at the point where the undeformed skin lies deepest in the object.
/// The patch sticks, slips and twists as a whole. Friction and torsion are those of springs, with
/// stiffness k = LawContact::shear and k a b (which holds for circles on an incompressible half
/// space). The object's motion at the patch stretches the springs step by step, so that rolling is
/// not slip. They relax like the normal force, and are scaled back to the ellipsoid
///   |f_t|^2 + (torque / e)^2 <= (mu f_n)^2
/// with e mu the torsion of the law. A shrinking patch loses the friction that it cannot hold, so
/// that friction returns no more energy than it stored.
/// Sources: [Howe1996] for the ellipsoid, [Elata1996].
class LawPad final : public MovingPad {
 public:
  /// @param name  name of the level of detail
  /// @throws InputError as PadChart, or if law or object are missing, or the law has no tangential
  ///         stiffness.
  LawPad(std::string name, const PadShape& shape, std::shared_ptr<const ContactLaw> law,
         RigidObject object, const Pose<double>& X_PO);

  [[nodiscard]] std::unique_ptr<MovingPad> clone() const override;
  [[nodiscard]] std::string rung() const override { return name_; }
  [[nodiscard]] PadContact try_step(const Pose<double>& X_PO, double seconds) override;
  void accept_step() override;
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
    Eigen::Vector2d disc{0, 0};  // deepest or nearest point of the skin on the disc [1] (2)
    Pose<double> X_searched;     // pose of the object at the last search of the whole skin
    double lead = 0;             // DeepestSkin::lead of that search [m]
    bool touched = false;
    ExponentialMemory normal;                   // history of the normal force [N]
    std::array<ExponentialMemory, 4> friction;  // friction along x, y, z [N]; torque [N m]
    std::array<double, 2> spring{0, 0};  // stiffness that stores friction [N/m], torque [N m/rad]
    double energy = 0;                   // LawPad::energy() [J]
  };
  struct Friction {
    Eigen::Vector4d force;  // friction [N] (3), torque about the normal [N m]
    bool sticks;
  };
  /// Finds the deepest skin at the pose of `moved_`, with only an upper bound of the overlap of a
  /// distant object. Stores the point on the disc, and the pose of a search of the whole skin.
  [[nodiscard]] DeepestSkin find_deepest(const Pose<double>& X_OP);
  /// Computes friction and torsion of a step and advances their history.
  /// @param at  centre of the patch [m] (3)
  [[nodiscard]] Friction update_friction(const LawContact& contact, const Eigen::Vector3d& at,
                                         const Eigen::Vector3d& normal, const MemoryStep& weights);
  /// Returns LawPad::energy() of `moved_` [J].
  /// @param slope  derivative of the elastic normal force by depth [N/m]
  [[nodiscard]] double stored_energy(double depth, double slope) const;

  std::string name_;
  PadShape shape_;
  std::shared_ptr<const PadChart> chart_;
  std::shared_ptr<const Shape> skin_;
  std::shared_ptr<const ContactLaw> law_;
  RigidObject object_;
  double reach_ = 0;  // bound of the distance of the skin from the pad's origin [m]
  State kept_, moved_;
};

}  // namespace thenar
