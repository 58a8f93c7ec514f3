#pragma once

/// Stops of the joints of a human hand in a scene.

#include <string>
#include <vector>

#include "dynamics/stepping/force_element.h"
#include "tendons/muscle/joint_resistance.h"

namespace thenar {

/// Indices of the coordinates of a hand or digit in a scene.
struct CoordinateIndices {
  std::vector<int> q, v;  // entries of positions and of speeds (coordinates)
};

/// Stops at the ends of the joints' ranges, as JointResistance has them, and the ends of passive
/// moments; both store energy. Springs and dampers of the joints are the mechanism's.
class JointStops final : public ForceElement {
 public:
  JointStops(std::string name, Skeleton skeleton, CoordinateIndices places,
             const JointResistance& resistance = {});

  [[nodiscard]] std::unique_ptr<ForceElement> clone() const override;
  [[nodiscard]] std::string name() const override { return name_; }
  bool act(const ElementInput& at, ElementAction& out) override;
  [[nodiscard]] double energy(const ElementInput& at) override;

  /// Ranges of the coordinates, and where these stand in the scene.
  [[nodiscard]] const std::vector<CoordinateLimits>& ranges() const { return limits_.limits; }
  [[nodiscard]] const CoordinateIndices& places() const { return indices_; }

 private:
  std::string name_;
  Skeleton limits_;  // ranges and ends of passive moments alone
  CoordinateIndices indices_;
  JointResistance resistance_;
};

}  // namespace thenar
