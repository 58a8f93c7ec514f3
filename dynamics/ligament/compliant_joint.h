#pragma once

/// Compliant hinges: a capsule law, in place of an ideal axis, holds the distal bone.

#include <array>
#include <string>

#include "dynamics/ligament/bushing_law.h"
#include "dynamics/mechanism/mechanism.h"
#include "dynamics/stepping/force_element.h"

namespace thenar {

/// Compliance of a hinge. Coordinates of infinite stiffness stay rigid and add no joint. Flexion is
/// the coordinate of the hinge, measured from its value 0.
struct JointCompliance {
  BushingLaw law;                 // capsule laws; that of flexion adds to the hinge's own spring
  Eigen::Vector3d bone{0, 0, 0};  // direction of the distal bone, body's frame, any length; zero:
                                  // from the hinge to the body's centre of mass (3)
};

/// Coordinates and law of a joint that has been made compliant.
struct CompliantJoint {
  std::string name;                                   // name of the hinge
  BushingLaw law;                                     // capsule laws; zero for rigid coordinates
  std::array<int, kBushingCoordinates> coordinate{};  // indices in the mechanism; -1: rigid
};

/// Gives a hinge up to five more degrees of freedom: replaces it by a chain of joints with massless
/// bodies in between,
///   slides across, along and axial; the hinge; abduction; twist,
/// without those of infinite stiffness. The hinge keeps its name, coordinate, limits and drives;
/// the other joints get coordinates at the end of the list, "HINGE/twist" and so on, which are 0 at
/// the start. The indices of later bodies increase by the number of added joints.
///
/// Since all degrees of freedom are coordinates, the generalized forces are exact gradients and the
/// stiffness is exact. The mass matrix is regular up to 90 deg of abduction, as every joint moves
/// the distal bone.
/// @param mechanism  mechanism to change
/// @param joint      index of the hinge in it
/// @throws InputError if the joint is not a hinge, if its angle is not its own coordinate alone, if
/// the law is invalid, if the bone has no component across the axis, or if no bone direction is
/// given for a body without mass.
[[nodiscard]] CompliantJoint make_compliant(Mechanism& mechanism, int joint,
                                            const JointCompliance& compliance);

/// Returns the index of a joint by its name.
/// @throws InputError with the nearest name if there is no such joint.
[[nodiscard]] int joint_index(const Mechanism& mechanism, const std::string& name);

/// Force element of a compliant joint.
class CapsuleElement : public ForceElement {
 public:
  /// @param mechanism  mechanism of the whole scene
  /// @param joint      compliant joint, with coordinate indices of that mechanism
  CapsuleElement(const Mechanism& mechanism, CompliantJoint joint);

  [[nodiscard]] std::unique_ptr<ForceElement> clone() const override {
    return std::make_unique<CapsuleElement>(*this);
  }
  [[nodiscard]] std::string name() const override { return joint_.name; }
  /// Adds the force of the capsule.
  /// @return false if the abduction exceeds kMaxAbduction
  bool add_action(const ElementInput& at, ElementAction& out) override;
  [[nodiscard]] double energy(const ElementInput& at) override { return action(at).energy; }
  [[nodiscard]] bool is_passive() const override { return true; }

 private:
  [[nodiscard]] BushingVector coordinates(const ElementInput& at) const;
  [[nodiscard]] BushingAction action(const ElementInput& at) const;

  CompliantJoint joint_;
  std::array<int, kBushingCoordinates> q_{}, v_{};  // indices of position and speed; -1: rigid
};

}  // namespace thenar
