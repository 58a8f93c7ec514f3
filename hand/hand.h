#pragma once

/// Interface of a hand, human or robot, as grasping uses it.

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "data/io/robot/drive_coupling.h"
#include "geometry/solid.h"

namespace thenar {

/// Reaction torques R r that need no effort: joint limits, locks and clutches.
struct Reactions {
  Eigen::MatrixXd R;      // torque [N m], of sliding joints force [N], per unit of r (coordinates,
                          // reactions)
  Eigen::VectorXd lower;  // lower bounds of r: 0 for unilateral reactions, -infinity for bilateral
                          // ones (reactions)
  Eigen::VectorXd upper;  // upper bounds of r (reactions)
  std::vector<int> non_backdrivable;  // coordinates whose drive is not backdrivable: worm gears
};

/// Reliability of the torques of a hand, from good to bad.
enum class ActuationStatus {
  kExact,       // torque is linear in the efforts
  kLinearised,  // torque is not linear in the efforts: B u is exact at u = 0 and at one effort,
                // which the class of the hand states
  kDoubtful,    // a tendon is outside the validity of its model: see `warning`
  kUnbalanced   // part of the torque is not in equilibrium and must not be used: see `warning`
};

/// Joint torques that a hand can exert at a posture:
///   { B u + R r + tau_0 : lower <= u <= upper, reactions.lower <= r <= reactions.upper }.
/// For tendons B is the transposed moment-arm matrix [m] and u are tensions [N]; for motors B is
/// the transmission [1] and u are motor torques [N m], of sliding joints forces [N]. No actuator
/// moves a coordinate whose row of B is zero.
struct Actuation {
  Eigen::MatrixXd B;      // (coordinates, actuators)
  Eigen::VectorXd tau_0;  // torque at u = 0: passive joints [N m] (coordinates)
  Eigen::VectorXd lower;  // lower bounds of u (actuators)
  Eigen::VectorXd upper;  // upper bounds of u, infinite if unknown (actuators)
  Reactions reactions{};  // none if empty
  ActuationStatus status = ActuationStatus::kExact;
  std::string warning{};  // explanation of a status beyond kLinearised, in words
};

/// Exact torque of one vector of efforts.
struct AppliedTorque {
  Eigen::VectorXd tau;  // torque, passive torque included [N m] (coordinates)
  Eigen::MatrixXd B;    // d tau/du at these efforts (coordinates, actuators)
  ActuationStatus status = ActuationStatus::kExact;  // never kLinearised
  std::string warning{};
};

/// Coordinate that a drive moves.
struct DrivenCoordinate {
  int coordinate;
  double ratio;  // coordinate speed [rad/s], of sliding joints [m/s], per drive speed
};

/// Drive that closes a hand: a motor, a tendon or a single joint, with the coordinates that it
/// moves, from the base outwards.
struct Drive {
  std::string name;
  DriveCoupling coupling = DriveCoupling::kRigid;
  std::vector<DrivenCoordinate> moves;
  double speed = 0;  // closing speed relative to other drives, its sign the sense; 0: closing does
                     // not move it [1]
  double breakaway = 0;      // joint torque at which a clutch opens [N m], of sliding joints [N]
  bool backdrivable = true;  // false: a worm gear or brake, which holds against any load
};

/// Surface of a link, or of the base.
struct LinkSurface {
  int link = -1;      // link that carries it; -1: the base
  std::string name;   // "DP2", "palm"
  std::string digit;  // "index", "finger 1"; empty: palm or arm
  std::string material;
  /// Shape in the hand frame, reference posture; shared by copies of a hand.
  std::shared_ptr<const Solid> solid;
};

/// Approach direction of the palm, in the hand's frame.
struct PalmApproach {
  Eigen::Vector3d point{0, 0, 0};      // [m] (3)
  Eigen::Vector3d direction{0, 0, 1};  // unit (3)
};

/// Fingertip of a digit.
struct HandTip {
  std::string digit;
  int link = -1;
  Eigen::Vector3d p{0, 0, 0};  // position in the base frame, reference posture [m] (3)
};

/// Names and limits of a hand, constant for its life.
struct HandLayout {
  std::vector<std::string> coordinates;  // joint that owns each entry of q
  Eigen::VectorXd lower;                 // [rad], of sliding joints [m] (coordinates)
  Eigen::VectorXd upper;                 // [rad], of sliding joints [m] (coordinates)
  std::vector<std::string> actuators;    // names of tendons or motors
  std::vector<std::string> tips;         // digits that end in a tip
  std::vector<HandTip> tip_points;       // fingertips of `tips`, in the same order
  std::vector<Drive> drives;  // drives that close the hand; empty: each coordinate closes alone
  std::vector<int> parents;   // parent of each link, -1: the base; parents before children
  PalmApproach approach;
  Eigen::VectorXd open{};  // open posture, where closing starts [rad], of sliding joints [m]
                           // (coordinates); empty: each coordinate of `drives` at the limit
                           // opposite to closing, any other at the value nearest to 0
};

/// Counts the moving joints from the base to a link. @param link  -1: the base
[[nodiscard]] inline int joints_to(const HandLayout& layout, int link) {
  int joints = 0;
  for (; link >= 0; link = layout.parents[static_cast<std::size_t>(link)]) ++joints;
  return joints;
}

/// Hand of any kind. Every implementation satisfies: shapes agree with layout(), lower <= upper,
/// rotations of poses are orthogonal, jacobian() is the derivative of pose(). In the sources,
/// tests/hand/hand_laws.h checks them.
class Hand {
 public:
  virtual ~Hand() = default;

  /// Returns names and limits.
  [[nodiscard]] virtual const HandLayout& layout() const = 0;

  /// Computes the displacement X of every link from the reference posture, in the base frame: a
  /// point of the link is at  p_now = X p_reference.
  /// @param q  posture [rad], of sliding joints [m] (coordinates)
  [[nodiscard]] virtual std::vector<Pose<double>> pose(const Eigen::VectorXd& q) const = 0;

  /// Computes the geometric Jacobian of a point of a link: its angular velocity above the velocity
  /// of the point, [omega; v] = J dq/dt, in the base frame. (6, coordinates)
  /// @param q     posture, as in pose() (coordinates)
  /// @param link  link that carries the point; -1: the base
  /// @param p     position of the point at the reference posture, base frame [m] (3)
  [[nodiscard]] virtual Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(
      const Eigen::VectorXd& q, int link, const Eigen::Vector3d& p) const = 0;

  /// Computes the joint torques that the hand can exert at posture q.
  [[nodiscard]] virtual Actuation actuation(const Eigen::VectorXd& q) const = 0;

  /// Computes the exact torque of the efforts u, without the linearisation of actuation(). A hand
  /// whose actuation() is linearised overrides it.
  /// @param u  efforts, as in Actuation (actuators)
  [[nodiscard]] virtual AppliedTorque applied_torque(const Eigen::VectorXd& q,
                                                     const Eigen::VectorXd& u) const;

  /// Returns the contact surfaces; empty for a hand of bones without surfaces.
  [[nodiscard]] virtual const std::vector<LinkSurface>& surfaces() const = 0;
};

}  // namespace thenar
