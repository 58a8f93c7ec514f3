#pragma once

/// Grasp of a ball by sampled surfaces of a robot hand: fast enough to try many ways of closing.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "grasp/robot/robot_hand.h"

namespace thenar {

/// All columns in one matrix (3, columns).
[[nodiscard]] Eigen::Matrix3Xd side_by_side(const std::vector<Eigen::Matrix3Xd>& parts);

/// A ball to close on, in the hand's frame.
struct ProbeBall {
  Eigen::Vector3d centre{0, 0, 0};  // [m] (3)
  double radius = 0;                // [m]
};

/// Contact of a link with the ball.
struct BallContact {
  int surface;             // of BallGrasp::surfaces()
  Eigen::Vector3d normal;  // unit, into the ball (3)
};

/// Sample points on the surface of a link.
struct SampledSurface {
  int link = -1;                    // link of the hand; -1: the base
  std::string name;                 // of the robot's link
  std::string digit;                // empty: palm or arm
  Eigen::Matrix3Xd p;               // hand frame, reference posture [m] (3, points)
  Eigen::Matrix3Xd faces;           // outward normals times areas, of flat faces and of pieces of
                                    // rounded ones, hand frame, reference posture [m^2] (3, faces)
  Eigen::Vector3d centre{0, 0, 0};  // of a ball around the points [m] (3)
  double radius = 0;                // of this ball [m]
  std::vector<int> moved_by;        // coordinates that move the link
};

/// A robot hand whose shapes are points, about 150 for each link. No solids are built, so that
/// meshes need not be closed.
class BallGrasp {
 public:
  /// @throws InputError as RobotHand for a robot without shapes.
  explicit BallGrasp(const RobotSpec& robot);

  [[nodiscard]] const RobotHand& hand() const { return hand_; }
  [[nodiscard]] const std::vector<SampledSurface>& surfaces() const { return surfaces_; }

  /// Sphere cast: a ball comes against the direction of a ray and stops where it meets the hand,
  /// with its centre at  origin + way * direction  [m]; -infinity if it meets nothing.
  /// @param links  RobotHand::pose()
  [[nodiscard]] double sphere_cast(const std::vector<Pose<double>>& links,
                                   const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                   double radius) const;

  /// Contacts of all surfaces with the ball, within 1 mm.
  /// @param links  RobotHand::pose()
  [[nodiscard]] std::vector<BallContact> contacts(const std::vector<Pose<double>>& links,
                                                  const ProbeBall& ball) const;

  /// Closes from a posture in equal steps, each drive at its speed. A link that meets the ball
  /// stops the coordinates that move it, and the rest of its drive as Drive::coupling says. If
  /// `self` is not empty, surfaces of these digits and all others stop each other within about a
  /// spacing of their points.
  /// @param drives  with their speeds, of RobotHand::layout()
  /// @returns the contacts at the end
  [[nodiscard]] std::vector<BallContact> close(const std::vector<Drive>& drives, Eigen::VectorXd q,
                                               const ProbeBall& ball, int steps,
                                               const std::vector<std::string>& self = {}) const;

 private:
  class Closing;

  [[nodiscard]] static bool collide(const SampledSurface& a, const SampledSurface& b,
                                    const std::vector<Pose<double>>& links);
  [[nodiscard]] bool side_by_side(const SampledSurface& a, const SampledSurface& b) const;

  RobotHand hand_;
  std::vector<SampledSurface> surfaces_;
};

}  // namespace thenar
