#pragma once

/// Digits of a hand: what belongs to them, and how its drives move them.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "grasp/robot/ball_grasp.h"
#include "grasp/robot/closing_options.h"

namespace thenar {

/// A digit with its ends, and the drives that move it.
struct HandDigit {
  std::string name;
  std::size_t first = 0, last = 0;  // surfaces: innermost and outermost
  Eigen::Vector3d root, tip;        // at rest [m] (3)
  std::vector<int> curls, turns;    // drives that curl and that turn it
};

/// The digits of a hand at rest, where they are as straight as they go, and which of its drives
/// curl them. Constant once built; the grasp must outlive it.
class HandDigits {
 public:
  explicit HandDigits(const BallGrasp& grip);

  [[nodiscard]] const BallGrasp& grip() const { return grip_; }
  [[nodiscard]] const std::vector<Drive>& drives() const { return drives_; }
  [[nodiscard]] const std::vector<HandDigit>& all() const { return digits_; }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// Every coordinate at zero or the nearest limit, digits that are curled there as straight as
  /// they go [rad] or [m] (coordinates)
  [[nodiscard]] const Eigen::VectorXd& rest() const { return rest_; }
  /// Signs of drives that curl digits, and which belong together.
  [[nodiscard]] const DriveGroups& groups() const { return groups_; }

  /// Mean distance from the root of a digit to its tip [m].
  [[nodiscard]] double mean_digit_length() const;
  /// Rotation of a digit's tip per unit of a drive, at rest [rad] (3).
  [[nodiscard]] Eigen::Vector3d spin(std::size_t drive, const HandDigit& digit) const;
  /// Motion of a digit's tip per unit of a drive, at rest [m] (3).
  [[nodiscard]] Eigen::Vector3d way(std::size_t drive, const HandDigit& digit) const;
  /// Range of a drive [rad] or [m].
  [[nodiscard]] double range(std::size_t drive) const;
  /// Whether a drive rotates any digit, rather than only sliding it.
  [[nodiscard]] bool turns(std::size_t drive) const;
  /// Whether a drive turns other digits about as far as this one. @param digit  one of all()
  [[nodiscard]] bool spreads(std::size_t drive, const HandDigit& digit) const;
  /// Posture at a share of the range from rest in the given senses; senses of 0 stay (coordinates).
  [[nodiscard]] Eigen::VectorXd moved(const std::vector<double>& senses, double share) const;
  /// Sum of distances between tips; of an only digit from the palm, which may be a fixed jaw [m].
  [[nodiscard]] double apart(const Eigen::VectorXd& q) const;

 private:
  void find_digits();
  void sort_drives();
  void orient();
  void straighten();
  void turn_by(int coordinate, double angle);
  void join_rows();
  void join_groups(int one, int other, bool reversed);
  [[nodiscard]] int group_of(const HandDigit& digit) const;
  [[nodiscard]] std::vector<int> hinges_of(const HandDigit& digit) const;
  // Twist of a digit's tip per unit of a drive, at rest: rotation [rad], then translation [m] (6).
  [[nodiscard]] Eigen::Matrix<double, 6, 1> twist(std::size_t drive, const HandDigit& digit) const;
  [[nodiscard]] bool moves_alike(std::size_t drive) const;
  [[nodiscard]] Eigen::Vector3d last_axis(const HandDigit& digit) const;
  [[nodiscard]] double sign_against(std::size_t outer, std::size_t drive,
                                    const HandDigit& digit) const;
  [[nodiscard]] double from_palm(const std::vector<Pose<double>>& links) const;

  const BallGrasp& grip_;
  std::vector<Drive> drives_;
  Eigen::VectorXd rest_;
  std::vector<HandDigit> digits_;
  std::vector<std::string> names_;
  DriveGroups groups_;
};

}  // namespace thenar
