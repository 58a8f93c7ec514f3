#pragma once

/// How a robot hand closes on a ball, by points of its surfaces alone: quick enough to try many
/// ways of closing.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "grasp/robot/robot_hand.h"

namespace thenar {

/// A ball in the hand's frame.
struct ProbeBall {
  Eigen::Vector3d centre{0, 0, 0};  // [m] (3)
  double radius = 0;                // [m]
};

/// A link that touches the ball.
struct BallContact {
  int surface;             // of BallGrasp::surfaces()
  Eigen::Vector3d normal;  // unit, into the ball (3)
};

/// Points on the surface of a link.
struct SampledSurface {
  int link = -1;                    // of the hand that carries it; -1: the base
  std::string name;                 // of the robot's link
  std::string digit;                // empty: palm or arm
  Eigen::Matrix3Xd p;               // hand frame, reference posture [m] (3, points)
  Eigen::Vector3d centre{0, 0, 0};  // of a ball that holds them [m] (3)
  double radius = 0;                // of it [m]
  std::vector<int> moved_by;        // coordinates
};

/// A robot whose shapes are points, about 150 a link. No solids are built: meshes need not be
/// closed.
class BallGrasp {
 public:
  /// @throws InputError as RobotHand does of a robot without shapes.
  explicit BallGrasp(const RobotSpec& robot);

  [[nodiscard]] const RobotHand& hand() const { return hand_; }
  [[nodiscard]] const std::vector<SampledSurface>& surfaces() const { return surfaces_; }

  /// How far before the ray's origin a ball that comes against the direction of the ray meets the
  /// hand: its centre is at  origin + way * direction  then. -infinity if it meets nothing.
  /// @param links  RobotHand::pose()
  [[nodiscard]] double meets(const std::vector<Pose<double>>& links, const Eigen::Vector3d& origin,
                             const Eigen::Vector3d& direction, double radius) const;

  /// Closes from a posture in equal steps, each drive at its speed; a link that meets the ball
  /// stops what moves it, and the rest of its drive as Drive::coupled says. Where `self` is not
  /// empty, surfaces of those digits and the others stop each other within about a spacing of their
  /// points.
  /// @param drives  with their speeds, of RobotHand::layout()
  /// @return the contacts at the end
  [[nodiscard]] std::vector<BallContact> close(const std::vector<Drive>& drives, Eigen::VectorXd q,
                                               const ProbeBall& ball, int steps,
                                               const std::vector<std::string>& self = {}) const;

 private:
  [[nodiscard]] bool meet(const SampledSurface& a, const SampledSurface& b,
                          const std::vector<Pose<double>>& links) const;
  [[nodiscard]] bool side_by_side(const SampledSurface& a, const SampledSurface& b) const;

  RobotHand hand_;
  std::vector<SampledSurface> surfaces_;
};

}  // namespace thenar
