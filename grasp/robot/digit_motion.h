#pragma once

/// Motion of a hand's digits: the drives that curl and that turn them, and the digits that oppose.

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "grasp/robot/approach_direction.h"
#include "grasp/robot/ball_grasp.h"
#include "grasp/robot/closing_options.h"
#include "grasp/robot/hand_digits.h"

namespace thenar {

/// Roles of the digits for a combination of closing directions.
struct DigitRoles {
  std::vector<bool> opposed;  // whether each digit faces the fingers
  bool row = false;   // true: three or more fingers, with objects approached along the normal
  bool palm = false;  // true: the fingers curl in the same direction, out of a palm
  Eigen::Vector3d normal{0, 0, 1};  // direction in which their tips start, unit (3)
  Eigen::Vector3d along{
      1, 0, 0};  // direction from their roots to their tips, perpendicular to the normal (3)
  Eigen::Vector3d root{0, 0, 0};  // mean of their roots [m] (3)
  double length = 0;              // their mean length [m]
};

/// Part of the palm on which a single digit closes.
struct FixedJaw {
  Eigen::Vector3d direction{0, 0, 1};          // approach direction, along both jaws, unit (3)
  Eigen::Vector3d opening_direction{1, 0, 0};  // from the fixed to the open jaw, unit (3)
  Eigen::Vector3d face{0, 0, 0};               // point of its face, at the end of the palm [m] (3)
  double opening = 0;  // distance from the face to the outer half of the open jaw [m]
};

/// Source of the directions in which a hand closes: the stated speeds of its drives, from its open
/// posture; or several directions and postures that are tried.
enum class ClosingSource { kStated, kInferred };

/// Motion of a hand's digits by its drives. Constant after construction; the grasp must outlive it.
class DigitMotion {
 public:
  DigitMotion(const BallGrasp& grip, ClosingSource closing);

  [[nodiscard]] const std::vector<std::string>& digits() const { return digits_.names(); }
  /// Returns the rest posture [rad] or [m] (coordinates): every coordinate at zero or the limit
  /// nearest to it, and digits that are curled there as straight as possible.
  [[nodiscard]] const Eigen::VectorXd& rest() const { return digits_.rest(); }
  /// Returns the mean distance from the root of a digit to its tip [m].
  [[nodiscard]] double mean_digit_length() const { return digits_.mean_digit_length(); }
  [[nodiscard]] const std::vector<SenseOption>& options() const { return options_; }
  [[nodiscard]] std::vector<Drive> drives(std::size_t option) const;
  [[nodiscard]] DigitRoles roles(std::size_t option) const;
  /// Returns postures in which closing may begin: closing drives open, opposed digits turned to all
  /// positions. A stated closing has only one.
  [[nodiscard]] std::vector<Eigen::VectorXd> opening_postures(std::size_t option,
                                                              const DigitRoles& roles) const;
  /// Computes the approach from the end of the palm's box, in the direction from its centre to the
  /// half-closed digit tips: perpendicular to the axes about which digits close, and along flat
  /// faces of sliding jaws or of the palm.
  [[nodiscard]] PalmApproach forward_approach(std::size_t option) const;
  /// Finds the part of the palm on which the only digit, a jaw, closes; nothing if it meets no part
  /// of the palm.
  /// @param open  posture at which closing begins (coordinates)
  [[nodiscard]] std::optional<FixedJaw> fixed_jaw(std::size_t option,
                                                  const Eigen::VectorXd& open) const;

 private:
  struct JawPath;

  [[nodiscard]] const HandLayout& layout() const { return digits_.grip().hand().layout(); }
  [[nodiscard]] Eigen::Vector3d last_tip_motion(std::size_t option, const Eigen::VectorXd& q) const;
  [[nodiscard]] std::optional<JawPath> jaw_path(std::size_t option, const Eigen::VectorXd& q) const;
  [[nodiscard]] Eigen::VectorXd posture_at_opening(std::size_t option,
                                                   const Eigen::VectorXd& others,
                                                   double farthest) const;
  [[nodiscard]] bool are_jaws() const;
  [[nodiscard]] std::vector<std::size_t> opposing_motors(const DigitRoles& roles) const;
  [[nodiscard]] std::vector<Eigen::VectorXd> motor_positions(const Eigen::VectorXd& before,
                                                             std::size_t motor,
                                                             int positions) const;
  [[nodiscard]] Eigen::VectorXd with_outer_joints_open(std::size_t option,
                                                       Eigen::VectorXd open) const;
  [[nodiscard]] Eigen::Matrix3Xd closing_axes(const HandDigit& digit, std::size_t option,
                                              const Eigen::VectorXd& q) const;
  [[nodiscard]] bool slides_only(const HandDigit& digit, std::size_t option) const;
  [[nodiscard]] Eigen::Vector3d approach_near(const Eigen::Vector3d& rough, std::size_t option,
                                              const ClosingAxes& axes,
                                              const std::vector<Pose<double>>& links) const;
  [[nodiscard]] Eigen::VectorXd half_closed_posture(std::size_t option) const;
  [[nodiscard]] Eigen::VectorXd closed_posture(std::size_t option) const;
  [[nodiscard]] std::vector<std::size_t> find_fingers(const std::vector<Eigen::Vector3d>& motions,
                                                      const std::vector<double>& turns) const;
  [[nodiscard]] Eigen::Vector3d curl_motion(const HandDigit& digit, std::size_t option) const;
  [[nodiscard]] double turn_range(const HandDigit& digit) const;
  HandDigits digits_;
  ClosingSource closing_;
  std::vector<SenseOption> options_;
};

}  // namespace thenar
