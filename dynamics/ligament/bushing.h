#pragma once

/// Bushings and ligaments between any two bodies of a scene.

#include <memory>
#include <string>

#include "dynamics/ligament/bushing_law.h"
#include "dynamics/stepping/force_element.h"

namespace thenar {

/// A place in a body, or in the world.
struct BodyFrame {
  int body = -1;      // of the mechanism; -1: the world
  Pose<double> X_BF;  // of the frame in the body's
};

/// Six springs between two frames, by the pose of one in the other: BushingLaw on the coordinates
/// of bushing_pose(). Holds a body on a free joint, whatever its parent, or closes a loop.
///
/// Efforts are J' force with the exact Jacobian J of the coordinates. Its stiffness J' K J leaves
/// out what the turn of J adds under load, which costs steps of stiff scenes, not accuracy.
class BushingElement : public ForceElement {
 public:
  /// @throws InputError as check_law()
  BushingElement(std::string name, BodyFrame proximal, BodyFrame distal, const BushingLaw& law);

  [[nodiscard]] std::unique_ptr<ForceElement> clone() const override;
  [[nodiscard]] std::string name() const override { return name_; }
  /// @return false beyond kMostAbduction
  bool add_action(const ElementInput& at, ElementAction& out) override;
  [[nodiscard]] double energy(const ElementInput& at) override;
  [[nodiscard]] bool is_passive() const override { return true; }

 private:
  std::string name_;
  BodyFrame proximal_, distal_;
  BushingLaw law_;
  Eigen::MatrixXd J_;  // rates of the coordinates by the speeds, as columns (v, 6)
};

/// A point of a body, or of the world.
struct BodyPoint {
  int body = -1;               // of the mechanism; -1: the world
  Eigen::Vector3d p{0, 0, 0};  // body's frame [m] (3)
};

/// A ligament on a straight line between two points; several of them are a capsule. Its stiffness
/// has that along the line and the tension's across it, but not what the turn of bodies adds.
class LigamentElement : public ForceElement {
 public:
  /// @throws InputError as check_law()
  LigamentElement(std::string name, const BodyPoint& from, const BodyPoint& to,
                  const LigamentLaw& law);

  [[nodiscard]] std::unique_ptr<ForceElement> clone() const override;
  [[nodiscard]] std::string name() const override { return name_; }
  /// Adds the ligament's force; if both points coincide, the ligament is slack and adds nothing.
  /// @return true: its law holds at every length
  bool add_action(const ElementInput& at, ElementAction& out) override;
  [[nodiscard]] double energy(const ElementInput& at) override;
  [[nodiscard]] bool is_passive() const override { return true; }

 private:
  std::string name_;
  BodyPoint from_, to_;
  LigamentLaw law_;
  Eigen::MatrixXd J_;  // rows of the three axes of the world between the points (v, 3)
};

}  // namespace thenar
