#pragma once

/// Robot hands, arms, and trees of both as a Hand.

#include <string>
#include <vector>

#include "data/io/robot/robot.h"
#include "hand/hand.h"

namespace thenar {

/// A robot as a Hand.
///
/// Coordinates: one for each rigid degree of freedom, which its joints follow (`ratio`, `offset`);
/// one for each joint of breakaway and compliant degrees of freedom, whose joints can move apart;
/// and one for each undriven joint: its value less its offset. In the reference posture, q = 0,
/// every degree of freedom is zero and every joint at its offset; it may violate the limits. Links
/// of the Hand are the bodies that moving joints carry, in the order of the robot's joints; links
/// behind fixed joints belong to the link that carries them. The hand's frame is the base link's.
///
/// Motors: u is the effort on a degree of freedom [N m] or [N]; drive_torques() defines how it acts
/// on independent joints, and what clutches and worm gears support.
class RobotHand final : public Hand {
 public:
  /// @throws InputError as check_robot() and build_solid(), or if no value of a degree of freedom
  /// is within the limits of all its joints.
  explicit RobotHand(const RobotSpec& robot);

  [[nodiscard]] const HandLayout& layout() const override { return layout_; }
  [[nodiscard]] std::vector<Pose<double>> pose(const Eigen::VectorXd& q) const override;
  [[nodiscard]] Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(
      const Eigen::VectorXd& q, int link, const Eigen::Vector3d& p) const override;
  /// Returns the actuation; limits are infinite where the effort of a motor is unknown or nominal.
  [[nodiscard]] Actuation actuation(const Eigen::VectorXd& q) const override;
  [[nodiscard]] const std::vector<LinkSurface>& surfaces() const override { return surfaces_; }

  /// Returns the posture in which every degree of freedom has a given value. @param dofs  [rad] or
  /// [m] (dofs)
  [[nodiscard]] Eigen::VectorXd posture(const Eigen::VectorXd& dofs) const;

  /// Returns the pose of every link's frame in the base link, for mounts and drawings.
  [[nodiscard]] std::vector<Pose<double>> link_frames(const Eigen::VectorXd& q) const;

  /// Returns the names of the robot's links.
  [[nodiscard]] const std::vector<std::string>& links() const { return links_; }

  /// Returns the axis of the joint that carries a link of the Hand, unit; zero for a slide. (3)
  [[nodiscard]] Eigen::Vector3d axis(const Eigen::VectorXd& q, int link) const;

  /// Returns a point of that axis, at the reference posture [m] (3)
  [[nodiscard]] Eigen::Vector3d axis_point(int link) const { return movers_[link].point; }
  [[nodiscard]] bool is_prismatic(int link) const { return movers_[link].is_prismatic; }

  /// Returns the entry of q that moves the joint that carries a link of the Hand.
  [[nodiscard]] int coordinate_of(int link) const { return movers_[link].coordinate; }

  /// Returns the link of the Hand to which a link of the robot belongs; -1: the base.
  [[nodiscard]] int mover_of(std::size_t link) const { return mover_of_[link]; }

 private:
  /// A moving joint, in the frame of the base link at the reference posture.
  struct Mover {
    int parent;      // mover of the parent link; -1: the base
    int coordinate;  // entry of q that drives it
    int dof;         // degree of freedom of the robot; -1: none
    bool is_prismatic;
    bool shared;                // whether its coordinate belongs to a rigid degree of freedom
    double ratio;               // motion per unit of its coordinate, without the curve
    double dof_ratio;           // motion per unit of its degree of freedom
    Eigen::Vector3d direction;  // unit (3)
    Eigen::Vector3d point;      // point of the axis [m] (3)
    double stiffness;           // stiffness of its spring [N m/rad] or [N/m]
    double stretch;             // rest - offset: motion at which the spring rests [rad] or [m]
    std::vector<double> curve;  // RobotJoint::curve of a rigid degree of freedom

    [[nodiscard]] double motion(double q) const;
    [[nodiscard]] double slope(double q) const;  // d motion / d q
  };

  void add_movers(const RobotSpec& robot);
  void add_coordinates(const RobotSpec& robot);
  void add_drives(const RobotSpec& robot);
  void add_surfaces(const RobotSpec& robot);
  void set_open_posture(const RobotSpec& robot);
  void require_posture(const Eigen::VectorXd& q) const;

  std::vector<Mover> movers_;
  std::vector<std::string> links_;       // names of the robot's links
  std::vector<int> mover_of_;            // mover of each link of the robot; -1: the base
  std::vector<Pose<double>> reference_;  // pose of each link of the robot, in the reference posture
  Eigen::VectorXd max_effort_;           // (actuators)
  int dofs_ = 0;                         // number of degrees of freedom of the robot
  HandLayout layout_;
  std::vector<LinkSurface> surfaces_;
};

}  // namespace thenar
