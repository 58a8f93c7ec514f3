#pragma once

/// Force element of the joint stops of a human hand.

#include <string>
#include <vector>

#include "dynamics/stepping/force_element.h"
#include "tendons/muscle/joint_resistance.h"

namespace thenar {

/// Indices of the coordinates of a hand or digit in a scene.
struct CoordinateIndices {
  std::vector<int> q, v;  // indices in the positions and in the speeds (coordinates)
};

/// Elastic stops at the ends of the joint ranges, see JointResistance, and passive moments near
/// these ends. Both store energy. Springs and dampers of the joints belong to the mechanism.
class JointStops final : public ForceElement {
 public:
  /// @param skeleton  skeleton whose joint ranges and passive moments are used
  /// @param indices   indices of its coordinates in the scene
  /// @throws InputError if their numbers differ from that of the joints.
  JointStops(std::string name, Skeleton skeleton, CoordinateIndices indices,
             const JointResistance& resistance = {});

  [[nodiscard]] std::unique_ptr<ForceElement> clone() const override {
    return std::make_unique<JointStops>(*this);
  }
  [[nodiscard]] std::string name() const override { return name_; }
  bool add_action(const ElementInput& at, ElementAction& out) override;
  [[nodiscard]] double energy(const ElementInput& at) override;

  /// Returns the ranges of the coordinates [rad].
  [[nodiscard]] const std::vector<CoordinateLimits>& ranges() const { return limits_.limits; }
  /// Returns the indices of the coordinates in the scene.
  [[nodiscard]] const CoordinateIndices& indices() const { return indices_; }

 private:
  std::string name_;
  Skeleton limits_;  // skeleton of which only ranges and passive end moments are used
  CoordinateIndices indices_;
  JointResistance resistance_;
};

}  // namespace thenar
