#pragma once

/// Grasp of a ball by sampled surfaces of a robot hand, fast enough to try many ways of closing.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "grasp/robot/robot_hand.h"

namespace thenar {

/// Joins the columns of several matrices in one (3, columns).
[[nodiscard]] Eigen::Matrix3Xd join_columns(const std::vector<Eigen::Matrix3Xd>& parts);

/// A ball to close on, in the hand's frame.
struct ProbeBall {
  Eigen::Vector3d centre{0, 0, 0};  // [m] (3)
  double radius = 0;                // [m]
};

/// Contact of a link with the ball.
struct BallContact {
  int surface = 0;         // entry of BallGrasp::surfaces()
  Eigen::Vector3d normal;  // unit, into the ball (3)
};

/// Sample points on the surface of a link.
struct SampledSurface {
  int link = -1;           // link of the hand; -1: the base
  std::string name;        // name of the robot's link
  std::string digit;       // digit of the link; empty: palm or arm
  Eigen::Matrix3Xd p;      // sample points, hand frame, reference posture [m] (3, points)
  Eigen::Matrix3Xd faces;  // outward normals times areas of flat faces and of facets of rounded
                           // ones, hand frame, reference posture [m^2] (3, faces)
  Eigen::Vector3d centre{0, 0, 0};  // centre of a bounding ball of the points [m] (3)
  double radius = 0;                // radius of this ball [m]
  std::vector<int> moved_by;        // coordinates that move the link
};

/// A robot hand with point-sampled surfaces, about 150 points for each link. It builds no solids,
/// so that meshes need not be closed.
class BallGrasp {
 public:
  /// @throws InputError as RobotHand for a robot without shapes.
  explicit BallGrasp(const RobotSpec& robot);

  [[nodiscard]] const RobotHand& hand() const { return hand_; }
  [[nodiscard]] const std::vector<SampledSurface>& surfaces() const { return surfaces_; }

  /// Sphere cast: moves a ball against the direction of a ray until it meets the hand, with its
  /// centre at  origin + distance * direction,  and returns this distance [m]; -infinity if it
  /// meets nothing.
  /// @param links  RobotHand::pose()
  [[nodiscard]] double sphere_cast(const std::vector<Pose<double>>& links,
                                   const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                   double radius) const;

  /// Finds the contacts of all surfaces with the ball, within 1 mm.
  /// @param links  RobotHand::pose()
  [[nodiscard]] std::vector<BallContact> contacts(const std::vector<Pose<double>>& links,
                                                  const ProbeBall& ball) const;

  /// Closes from a posture in equal steps, each drive at its speed. A link that meets the ball
  /// stops the coordinates that move it, and the rest of its drive according to Drive::coupling. If
  /// `self` is not empty, surfaces of these digits and all others stop each other within about the
  /// spacing of their points.
  /// @param drives  drives of RobotHand::layout(), with the speeds to try
  /// @returns the contacts at the end
  [[nodiscard]] std::vector<BallContact> close(const std::vector<Drive>& drives, Eigen::VectorXd q,
                                               const ProbeBall& ball, int steps,
                                               const std::vector<std::string>& self = {}) const;

 private:
  class Closing;

  [[nodiscard]] static bool collide(const SampledSurface& a, const SampledSurface& b,
                                    const std::vector<Pose<double>>& links);
  [[nodiscard]] bool are_adjacent(const SampledSurface& a, const SampledSurface& b) const;

  RobotHand hand_;
  std::vector<SampledSurface> surfaces_;
};

}  // namespace thenar
