#pragma once

/// Force elements between any two bodies of a scene: bushings and ligaments.

#include <memory>
#include <string>

#include "dynamics/ligament/bushing_law.h"
#include "dynamics/stepping/force_element.h"

namespace thenar {

/// Frame fixed to a body or to the world.
struct BodyFrame {
  int body = -1;      // index in the mechanism; -1: the world
  Pose<double> X_BF;  // pose of the frame in the body
};

/// Six springs between two frames: a BushingLaw on the coordinates of bushing_pose(). It can hold
/// a body that has a free joint, or close a loop.
///
/// The generalized force is J' force with the exact Jacobian J of the coordinates. The stiffness
/// J' K J leaves out the geometric stiffness, the derivative of J under load; stiff scenes may
/// therefore need more steps, but stay as accurate.
class BushingElement : public ForceElement {
 public:
  /// @throws InputError if the law is invalid, see check_law()
  BushingElement(std::string name, BodyFrame proximal, BodyFrame distal, const BushingLaw& law);

  [[nodiscard]] std::unique_ptr<ForceElement> clone() const override {
    return std::make_unique<BushingElement>(*this);
  }
  [[nodiscard]] std::string name() const override { return name_; }
  /// Adds the force of the bushing.
  /// @return false if the abduction exceeds kMaxAbduction
  bool add_action(const ElementInput& at, ElementAction& out) override;
  [[nodiscard]] double energy(const ElementInput& at) override;
  [[nodiscard]] bool is_passive() const override { return true; }

 private:
  std::string name_;
  BodyFrame proximal_, distal_;
  BushingLaw law_;
  Eigen::MatrixXd J_;  // Jacobian of the coordinates, transposed (v, 6)
};

/// Point fixed to a body or to the world.
struct BodyPoint {
  int body = -1;               // index in the mechanism; -1: the world
  Eigen::Vector3d p{0, 0, 0};  // position in the body's frame [m] (3)
};

/// Ligament along the straight line between two points; several ligaments can form a capsule. The
/// stiffness has the law's part along the line and the tension's part across it, but leaves out the
/// effect of the rotation of the bodies.
class LigamentElement : public ForceElement {
 public:
  /// @throws InputError if the law is invalid, see check_law()
  LigamentElement(std::string name, BodyPoint from, BodyPoint to, const LigamentLaw& law);

  [[nodiscard]] std::unique_ptr<ForceElement> clone() const override {
    return std::make_unique<LigamentElement>(*this);
  }
  [[nodiscard]] std::string name() const override { return name_; }
  /// Adds the force of the ligament; a slack ligament adds nothing.
  /// @return true, as the law is valid at every length
  bool add_action(const ElementInput& at, ElementAction& out) override;
  [[nodiscard]] double energy(const ElementInput& at) override;
  [[nodiscard]] bool is_passive() const override { return true; }

 private:
  std::string name_;
  BodyPoint from_, to_;
  LigamentLaw law_;
  Eigen::MatrixXd J_;  // velocity of `to` relative to `from`, world axes, transposed (v, 3)
};

}  // namespace thenar
