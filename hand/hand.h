#pragma once

/// The interface of a hand, human or robot, as grasping sees it.

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
  Eigen::VectorXd lower;  // lower bounds of r: 0 if it acts one way, -infinity if both (reactions)
  Eigen::VectorXd upper;  // upper bounds of r (reactions)
  std::vector<int> non_backdrivable;  // coordinates whose drive cannot be driven back: worm gears
};

/// Reliability of the torques of a hand, from good to bad.
enum class ActuationStatus {
  kExact,       // torque is linear in the efforts
  kLinearised,  // torque is not linear in the efforts: B u is exact at u = 0 and at one effort,
                // which the class of the hand states
  kDoubtful,    // a tendon is outside the validity of its model: see `warning`
  kUnbalanced   // a part of the torque is not in equilibrium, and not to be used: see `warning`
};

/// The joint torques a hand can make at a posture:
///   { B u + R r + tau_0 : lower <= u <= upper, least <= r <= most }.
/// For tendons B is the transposed moment-arm matrix [m] and u are tensions [N]; for motors B is
/// the transmission [1] and u are motor torques [N m], of sliding joints forces [N]. No actuator
/// moves a coordinate whose row of B is zero.
struct Actuation {
  Eigen::MatrixXd B;      // (coordinates, actuators)
  Eigen::VectorXd tau_0;  // torque at u = 0: passive joints [N m] (coordinates)
  Eigen::VectorXd lower;  // bounds of u (actuators)
  Eigen::VectorXd upper;  // bounds of u, infinite if unknown (actuators)
  Reactions reactions{};  // none if empty
  ActuationStatus status = ActuationStatus::kExact;
  std::string warning{};  // what a status beyond kLinearised stands for, in words
};

/// The torque that one effort makes, exactly.
struct AppliedTorque {
  Eigen::VectorXd tau;                               // passive torque included [N m] (coordinates)
  Eigen::MatrixXd B;                                 // d tau/du there (coordinates, actuators)
  ActuationStatus status = ActuationStatus::kExact;  // never kLinearised
  std::string warning{};
};

/// A coordinate that a drive moves.
struct DrivenCoordinate {
  int coordinate;
  double ratio;  // coordinate speed [rad/s], of sliding joints [m/s], per drive speed
};

/// A drive that closes a hand: a motor, a tendon or a single joint, with the coordinates that it
/// moves, from the base outwards.
struct Drive {
  std::string name;
  DriveCoupling coupling = DriveCoupling::kRigid;
  std::vector<DrivenCoordinate> moves;
  double speed = 0;          // while closing, relative to other drives; its sign is the sense; 0:
                             // closing does not move it [1]
  double breakaway = 0;      // joint torque at which a clutch opens [N m], of sliding joints [N]
  bool backdrivable = true;  // false: a worm gear or brake, which holds against any load
};

/// Surface of a link, or of the base.
struct LinkSurface {
  int link = -1;      // that carries it; -1: the base
  std::string name;   // "DP2", "palm"
  std::string digit;  // "index", "finger 1"; empty: palm or arm
  std::string material;
  std::shared_ptr<const Solid> solid;  // hand frame, reference posture; shared by copies of a hand
};

/// Approach direction of the palm, in the hand's frame.
struct PalmApproach {
  Eigen::Vector3d point{0, 0, 0};      // [m] (3)
  Eigen::Vector3d direction{0, 0, 1};  // unit (3)
};

/// A fingertip.
struct HandTip {
  std::string digit;
  int link = -1;
  Eigen::Vector3d p{0, 0, 0};  // base frame, reference posture [m] (3)
};

/// Names and limits, constant for the life of a hand.
struct HandLayout {
  std::vector<std::string> coordinates;  // joint that owns each entry of q
  Eigen::VectorXd lower;                 // [rad], of sliding joints [m] (coordinates)
  Eigen::VectorXd upper;                 // [rad], of sliding joints [m] (coordinates)
  std::vector<std::string> actuators;    // tendons or motors
  std::vector<std::string> tips;         // digits that end in a tip
  std::vector<HandTip> tip_points;       // of the digits of `tips`, in the same order
  std::vector<Drive> drives;             // what closes it; empty: every coordinate by itself
  std::vector<int> parents;              // of each link, -1: the base; parents before children
  PalmApproach approach;
  Eigen::VectorXd open{};  // posture in which closing begins [rad], of sliding joints [m]
                           // (coordinates); empty: each coordinate that `drives` move is at the
                           // limit that closing leaves, any other at the value nearest to 0
};

/// Number of moving joints from the base to a link. @param link  -1: the base
[[nodiscard]] inline int joints_to(const HandLayout& layout, int link) {
  int joints = 0;
  for (; link >= 0; link = layout.parents[static_cast<std::size_t>(link)]) ++joints;
  return joints;
}

/// A hand of any kind. Laws of every implementation: shapes agree with layout(), lower <= upper,
/// rotations of poses are orthogonal, jacobian() is the derivative of pose(). In the sources,
/// tests/hand/hand_laws.h checks them.
class Hand {
 public:
  virtual ~Hand() = default;

  [[nodiscard]] virtual const HandLayout& layout() const = 0;

  /// Displacement X of every link from the reference posture, in the base frame: a point of the
  /// link is at  p_now = X p_reference.
  /// @param q  posture [rad], of sliding joints [m] (coordinates)
  [[nodiscard]] virtual std::vector<Pose<double>> pose(const Eigen::VectorXd& q) const = 0;

  /// Geometric Jacobian of a point of a link: its angular velocity above the velocity of the
  /// point, [omega; v] = J dq/dt, in the base frame. (6, coordinates)
  /// @param q     posture, as of pose() (coordinates)
  /// @param link  that carries the point; -1: the base
  /// @param p     the point at the reference posture, base frame [m] (3)
  [[nodiscard]] virtual Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(
      const Eigen::VectorXd& q, int link, const Eigen::Vector3d& p) const = 0;

  /// The joint torques that the hand can make at posture q.
  [[nodiscard]] virtual Actuation actuation(const Eigen::VectorXd& q) const = 0;

  /// The torque of the efforts u, without the linearisation that actuation() may have. A hand
  /// whose actuation() is linearised overrides it.
  /// @param u  efforts, as of Actuation (actuators)
  [[nodiscard]] virtual AppliedTorque applied_torque(const Eigen::VectorXd& q,
                                                     const Eigen::VectorXd& u) const;

  /// Surfaces that can touch; empty for a hand of bones without surfaces.
  [[nodiscard]] virtual const std::vector<LinkSurface>& surfaces() const = 0;
};

}  // namespace thenar
