#pragma once

/// Hinges that give: ligaments and a capsule hold the bone, its axis is a law and no pin.

#include <array>
#include <limits>
#include <string>

#include "dynamics/ligament/bushing_law.h"
#include "dynamics/mechanism/mechanism.h"
#include "dynamics/stepping/force_element.h"

namespace thenar {

/// Compliance of a hinge. Directions of infinite stiffness stay rigid, and cost nothing. Flexion is
/// the coordinate of the hinge, counted from its value 0.
struct JointCompliance {
  BushingLaw law;                 // its flexion adds to what the hinge has
  Eigen::Vector3d bone{0, 0, 0};  // direction of the distal bone, body's frame; any length; zero:
                                  // from the hinge to the body's centre of mass (3)
};

/// The coordinates of a compliant joint.
struct CompliantJoint {
  std::string name;                            // of the hinge
  BushingLaw law;                              // rigid ways have none
  std::array<int, kBushingWays> coordinate{};  // of the mechanism; -1: rigid
};

/// Gives a hinge up to five more freedoms. Where one joint was there is a chain of joints between
/// the two bones, without mass in between:
///   slides across, along and axial; the hinge; abduction; twist,
/// those of infinite stiffness left out. The hinge keeps its name, coordinate, limits and drives;
/// the others have coordinates of their own at the end of the list, "HINGE/twist" and so on, all 0
/// at the start. Bodies after it move back by the number of joints added.
///
/// As all freedoms are coordinates, efforts are exact gradients and stiffness is exact; and the
/// mass matrix is regular up to 90 deg of abduction, as every joint moves the distal bone.
/// @param mechanism  changed
/// @param joint      entry of its joints
/// @throws InputError if the joint is no hinge, shares its coordinate or does not turn by just
/// that, as check_law(), or if the bone has no direction across the axis, or none is stated of a
/// body without mass.
[[nodiscard]] CompliantJoint make_compliant(Mechanism& mechanism, int joint,
                                            const JointCompliance& compliance);

/// Index of a joint. @throws InputError if there is none, with the nearest name.
[[nodiscard]] int joint_named(const Mechanism& mechanism, const std::string& name);

/// The force element of a compliant joint.
class CapsuleElement : public ForceElement {
 public:
  /// @param mechanism  the whole scene's;  @param joint  its coordinates there
  CapsuleElement(const Mechanism& mechanism, CompliantJoint joint);

  [[nodiscard]] std::unique_ptr<ForceElement> clone() const override;
  [[nodiscard]] std::string name() const override { return joint_.name; }
  /// @return false beyond kMostAbduction
  bool add_action(const ElementInput& at, ElementAction& out) override;
  [[nodiscard]] double energy(const ElementInput& at) override;
  [[nodiscard]] bool is_passive() const override { return true; }

 private:
  [[nodiscard]] BushingVector coordinates(const ElementInput& at) const;
  [[nodiscard]] BushingAction action(const ElementInput& at) const;

  CompliantJoint joint_;
  std::array<int, kBushingWays> q_{}, v_{};  // entries of the coordinates; -1: rigid
};

}  // namespace thenar
