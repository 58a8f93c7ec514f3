#pragma once

/// Linkages: bars and joints moved by a motor and constrained by closed loops.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/robot/close_loops.h"

namespace thenar::internal {

/// Closed loops that share motors or passive joints.
struct LoopGroup {
  std::vector<LoopClosure> closures;
  std::set<std::string> dofs;
};

/// A passive degree of freedom with a spring.
struct PassiveJoint {
  std::string name;
  double lower, upper, stiffness, rest;  // [rad] or [m]; [N m/rad] or [N/m], 0: no spring
};

/// Limit on which a passive joint rests.
enum class ActiveLimit { kNone, kLower, kUpper };

/// Closes the loops of one group at values of its motor. The robot and the group must outlive it.
class Linkage {
 public:
  Linkage(const RobotSpec& robot, const LoopGroup& group, std::string motor);

  [[nodiscard]] const std::vector<PassiveJoint>& passives() const { return passives_; }

  /// Returns the residual of the closures: distances of places that coincide, and for welds
  /// rotations times 50 mm [m]. @param u  value of the motor;  @param y  values of passive joints
  [[nodiscard]] Eigen::VectorXd loop_residual(double u, const Eigen::VectorXd& y) const;
  [[nodiscard]] Eigen::VectorXd loop_residual(const std::vector<Pose<double>>& links) const;

  /// Finds the closed posture of least spring energy near y by sequential quadratic programming;
  /// joints that meet a limit rest on it until springs pull them off.
  /// @returns nothing if the search fails, or springs leave a freedom
  [[nodiscard]] std::optional<Eigen::VectorXd> close(double u, Eigen::VectorXd y) const;

 private:
  [[nodiscard]] Eigen::MatrixXd slopes(double u, const Eigen::VectorXd& y) const;
  void go(Eigen::VectorXd& y, const Eigen::VectorXd& d, std::vector<ActiveLimit>& stops) const;
  [[nodiscard]] bool release(const Eigen::MatrixXd& J, const Eigen::VectorXd& y,
                             std::vector<ActiveLimit>& stops) const;
  [[nodiscard]] Eigen::VectorXd free_step(const Eigen::VectorXd& c, const Eigen::MatrixXd& J,
                                          const Eigen::VectorXd& y,
                                          const std::vector<ActiveLimit>& stops,
                                          bool& decided) const;

  const RobotSpec& robot_;
  const LoopGroup& group_;
  std::string motor_;
  std::vector<PassiveJoint> passives_;
  std::map<std::string, std::size_t> index_;
};

}  // namespace thenar::internal
