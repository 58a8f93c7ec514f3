#pragma once

/// What grasping needs to know of any hand, human or robot.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"

namespace thenar {

/// The joint torques a hand can make at a posture: { B u + tau_0 : lower <= u <= upper }.
/// For tendons B is the transposed moment-arm matrix and u are tensions; for motors B is the
/// transmission and u are motor torques.
struct Actuation {
  Eigen::MatrixXd B;      // (coordinates, actuators)
  Eigen::VectorXd tau_0;  // torque at u = 0: passive joints [N m] (coordinates)
  Eigen::VectorXd lower;  // of u (actuators)
  Eigen::VectorXd upper;  // of u (actuators)
};

/// Names and limits, constant for the life of a hand.
struct HandLayout {
  std::vector<std::string> coordinates;  // joint that owns each entry of q
  Eigen::VectorXd lower;                 // [rad] (coordinates)
  Eigen::VectorXd upper;                 // [rad] (coordinates)
  std::vector<std::string> actuators;    // tendons or motors
  std::vector<std::string> tips;         // digits that end in a tip
};

/// A hand of any kind; every implementation obeys the laws in tests/hand/hand_laws_test.cpp.
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
};

}  // namespace thenar
