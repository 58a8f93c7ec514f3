#pragma once

/// Motion of the digits of a hand: which drives curl and which turn them, and which digits oppose.

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

/// Roles of the digits in a way of closing.
struct DigitRoles {
  std::vector<bool> opposed;        // whether each digit faces the fingers
  bool row = false;                 // three or more fingers: objects come along the normal
  bool palm = false;                // fingers curl the same way, out of a palm:
  Eigen::Vector3d normal{0, 0, 1};  //   direction in which their tips start, unit (3)
  Eigen::Vector3d along{1, 0, 0};   //   from their roots to their tips, across the normal (3)
  Eigen::Vector3d root{0, 0, 0};    //   mean of their roots [m] (3)
  double length = 0;                //   their mean length [m]
};

/// A part of the palm on which an only digit closes.
struct FixedJaw {
  Eigen::Vector3d direction{0, 0, 1};  // of approach: along both jaws, unit (3)
  Eigen::Vector3d out{1, 0, 0};        // from it to the open jaw, unit (3)
  Eigen::Vector3d face{0, 0, 0};       // on its face, at the palm's end [m] (3)
  double opening = 0;                  // from the face to the outer half of the open jaw [m]
};

/// Motion of a hand's digits by its drives. Constant once built; the grasp must outlive it.
class DigitMotion {
 public:
  /// @param closing  whether the speeds of the hand's drives state how it closes
  DigitMotion(const BallGrasp& grip, bool closing);

  [[nodiscard]] const std::vector<std::string>& digits() const { return digits_.names(); }
  /// Every coordinate at zero or the nearest limit, digits that are curled there as straight as
  /// they go [rad] or [m] (coordinates)
  [[nodiscard]] const Eigen::VectorXd& rest() const { return digits_.rest(); }
  /// Mean distance from the root of a digit to its tip [m].
  [[nodiscard]] double mean_digit_length() const { return digits_.mean_digit_length(); }
  [[nodiscard]] const std::vector<SenseOption>& options() const { return options_; }
  [[nodiscard]] std::vector<Drive> drives(std::size_t option) const;
  [[nodiscard]] DigitRoles roles(std::size_t option) const;
  /// Postures in which closing may begin: closing drives open, opposed digits turned in all ways.
  [[nodiscard]] std::vector<Eigen::VectorXd> openings(std::size_t option, const DigitRoles& roles,
                                                      bool only_one) const;
  /// Approach from the end of the palm's box, from its centre to the half-closed ends: across the
  /// axes about which digits close, and along flat faces of jaws that slide or of the palm.
  [[nodiscard]] PalmApproach ahead(std::size_t option) const;
  /// The part of the palm on which the only digit, a jaw, closes. None: it meets no part of it.
  /// @param open  where it begins (coordinates)
  [[nodiscard]] std::optional<FixedJaw> fixed_jaw(std::size_t option,
                                                  const Eigen::VectorXd& open) const;

 private:
  struct JawWay;

  [[nodiscard]] Eigen::Vector3d last_way(std::size_t option, const Eigen::VectorXd& q) const;
  [[nodiscard]] std::optional<JawWay> jaw_way(std::size_t option, const Eigen::VectorXd& q) const;
  [[nodiscard]] Eigen::VectorXd open_at(std::size_t option, const Eigen::VectorXd& others,
                                        double farthest) const;
  [[nodiscard]] bool are_jaws() const;
  [[nodiscard]] std::vector<std::size_t> opposing_motors(const DigitRoles& roles) const;
  [[nodiscard]] std::vector<Eigen::VectorXd> motor_positions(const Eigen::VectorXd& before,
                                                             std::size_t motor,
                                                             int positions) const;
  [[nodiscard]] Eigen::VectorXd outer_open(std::size_t option, Eigen::VectorXd open) const;
  [[nodiscard]] Eigen::Matrix3Xd closing_axes(const HandDigit& digit, std::size_t option,
                                              const Eigen::VectorXd& q) const;
  [[nodiscard]] bool slides_only(const HandDigit& digit, std::size_t option) const;
  [[nodiscard]] Eigen::Vector3d approach_near(const Eigen::Vector3d& rough, std::size_t option,
                                              const ClosingAxes& axes,
                                              const std::vector<Pose<double>>& links) const;
  [[nodiscard]] Eigen::VectorXd half_closed(std::size_t option) const;
  [[nodiscard]] Eigen::VectorXd closed(std::size_t option) const;
  [[nodiscard]] std::vector<std::size_t> find_fingers(const std::vector<Eigen::Vector3d>& ways,
                                                      const std::vector<double>& turns) const;
  [[nodiscard]] Eigen::Vector3d curl_way(const HandDigit& digit, std::size_t option) const;
  [[nodiscard]] double turn_range(const HandDigit& digit) const;
  HandDigits digits_;
  std::vector<SenseOption> options_;
};

}  // namespace thenar
