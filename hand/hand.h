#pragma once

/// The interface of a hand, human or robot, as grasping sees it.

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/solid.h"

namespace thenar {

/// Reaction torques that need no effort: joint limits, locks and clutches.
struct Reactions {
  Eigen::MatrixXd R;                  // torque per reaction (coordinates, reactions)
  Eigen::VectorXd lower;              // of each: 0 is one-sided, -infinity both ways (reactions)
  Eigen::VectorXd upper;              // of each (reactions)
  std::vector<int> non_backdrivable;  // coordinates whose drive cannot be driven back: worm gears
};

/// How far the torques of a hand can be trusted, from good to bad.
enum class ActuationStatus {
  kExact,       // torque is linear in the efforts
  kLinearised,  // it is not: B is exact at u = 0 and at one working effort, see the hand
  kDoubtful,    // a tendon is outside the validity of its model: see `warning`
  kUnbalanced   // a part of the torque is not in equilibrium, and not to be used: see `warning`
};

/// The joint torques a hand can make at a posture:
///   { B u + R r + tau_0 : lower <= u <= upper, least <= r <= most }.
/// For tendons B is the transposed moment-arm matrix and u are tensions; for motors B is the
/// transmission and u are motor torques. A coordinate that has a row of zeros is free.
struct Actuation {
  Eigen::MatrixXd B;      // (coordinates, actuators)
  Eigen::VectorXd tau_0;  // torque at u = 0: passive joints [N m] (coordinates)
  Eigen::VectorXd lower;  // of u (actuators)
  Eigen::VectorXd upper;  // of u, infinite if unknown (actuators)
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

/// Motion of a drive's other coordinates when one is blocked by a contact.
enum class DriveCoupling {
  kRigid,      // all stop
  kBreakaway,  // more distal ones go on
  kCompliant   // all others go on
};

/// A coordinate that a drive moves.
struct DrivenCoordinate {
  int coordinate;
  double ratio;  // coordinate speed per drive speed
};

/// A drive that closes a hand: a motor, a tendon or a single joint, with the coordinates that it
/// moves, from the base outwards.
struct Drive {
  std::string name;
  DriveCoupling coupled = DriveCoupling::kRigid;
  std::vector<DrivenCoordinate> moves;
  double speed = 0;          // in closing; 0: it stays where it is [1/s]
  double breakaway = 0;      // effort at which a clutch opens [N m]
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
  Eigen::Vector3d p{0, 0, 0};  // reference posture [m] (3)
};

/// Names and limits, constant for the life of a hand.
struct HandLayout {
  std::vector<std::string> coordinates;  // joint that owns each entry of q
  Eigen::VectorXd lower;                 // [rad], of sliding joints [m] (coordinates)
  Eigen::VectorXd upper;                 // [rad], of sliding joints [m] (coordinates)
  std::vector<std::string> actuators;    // tendons or motors
  std::vector<std::string> tips;         // digits that end in a tip
  std::vector<HandTip> tip_points;       // of each of `tips`
  std::vector<Drive> drives;             // what closes it; empty: every coordinate by itself
  std::vector<int> parents;              // of each link, -1: the base; parents before children
  PalmApproach approach;
  Eigen::VectorXd open{};  // posture in which closing begins [rad] or [m] (coordinates); empty:
                           // what `drives` move at the limit it comes from, the rest next to 0
};

/// A hand of any kind; every implementation obeys the laws in tests/hand/skeleton_hand_test.cpp.
class Hand {
 public:
  virtual ~Hand() = default;

  [[nodiscard]] virtual const HandLayout& layout() const = 0;

  /// Displacement of every link from the reference posture. @param q (coordinates) [rad]
  [[nodiscard]] virtual std::vector<Pose<double>> pose(const Eigen::VectorXd& q) const = 0;

  /// Spatial Jacobian, rotation above translation, of a point of a link. (6, coordinates)
  /// @param p  the point at the reference posture [m] (3)
  [[nodiscard]] virtual Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(
      const Eigen::VectorXd& q, int link, const Eigen::Vector3d& p) const = 0;

  [[nodiscard]] virtual Actuation actuation(const Eigen::VectorXd& q) const = 0;

  /// The torque of one effort, without the linearisation that actuation() may have.
  /// @param u  (actuators)
  [[nodiscard]] virtual AppliedTorque effort(const Eigen::VectorXd& q,
                                             const Eigen::VectorXd& u) const {
    Actuation actuation = this->actuation(q);
    return {actuation.B * u + actuation.tau_0, actuation.B, actuation.status, actuation.warning};
  }

  /// Surfaces that can touch; empty for a hand of bones without surfaces.
  [[nodiscard]] virtual const std::vector<LinkSurface>& surfaces() const = 0;
};

}  // namespace thenar
