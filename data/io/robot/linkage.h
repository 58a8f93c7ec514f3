#pragma once

/// Bars and joints that a motor moves, held together by loops.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/robot/close_loops.h"

namespace thenar::internal {

/// Loops that share motors or passive joints.
struct LoopGroup {
  std::vector<LoopClosure> closures;
  std::set<std::string> dofs;
};

/// A passive degree of freedom.
struct PassiveJoint {
  std::string name;
  double lower, upper, stiffness, rest;  // stiffness 0: no spring
};

/// What a passive joint rests on.
enum class ActiveLimit { kNone, kLower, kUpper };

/// Closes the loops of one group at values of its motor. The robot and the group must outlive it.
class Linkage {
 public:
  Linkage(const RobotSpec& robot, const LoopGroup& group, std::string motor);

  [[nodiscard]] const std::vector<PassiveJoint>& passives() const { return passives_; }

  /// How far places that are one lie apart; of welds their turn by 50 mm, too [m].
  [[nodiscard]] Eigen::VectorXd loop_residual(double u, const Eigen::VectorXd& y) const;
  [[nodiscard]] Eigen::VectorXd loop_residual(const std::vector<Pose<double>>& links) const;

  /// Goes from a posture to the closed one of least spring energy near it, by sequential quadratic
  /// programming: joints that meet a limit rest on it until springs pull them off.
  /// @return none if the search does not get there, or springs leave a freedom
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
