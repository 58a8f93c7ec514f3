#pragma once

/// Digits of a hand: their surfaces, and the drives that move them.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "grasp/robot/ball_grasp.h"
#include "grasp/robot/closing_options.h"

namespace thenar {

/// A digit with its ends, and the drives that move it.
struct HandDigit {
  std::string name;
  std::size_t first = 0, last = 0;  // innermost and outermost surface
  Eigen::Vector3d root, tip;        // root and tip at rest [m] (3)
  std::vector<int> curls, turns;    // drives that curl and drives that turn it
};

/// Digits of a hand at rest, where they are as straight as possible, and the drives that curl them.
/// Constant after construction; the grasp must outlive it.
class HandDigits {
 public:
  explicit HandDigits(const BallGrasp& grip);

  [[nodiscard]] const BallGrasp& grip() const { return grip_; }
  [[nodiscard]] const std::vector<Drive>& drives() const { return drives_; }
  [[nodiscard]] const std::vector<HandDigit>& digits() const { return digits_; }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// Returns the rest posture [rad] or [m] (coordinates): every coordinate at zero or the limit
  /// nearest to it, and digits that are curled there as straight as possible.
  [[nodiscard]] const Eigen::VectorXd& rest() const { return rest_; }
  /// Returns the signs of drives that curl digits, and their groups.
  [[nodiscard]] const DriveGroups& groups() const { return groups_; }

  /// Returns the mean distance from the root of a digit to its tip [m].
  [[nodiscard]] double mean_digit_length() const;
  /// Computes the rotation of a digit's tip per unit of a drive, at rest [rad] (3).
  [[nodiscard]] Eigen::Vector3d tip_rotation(std::size_t drive, const HandDigit& digit) const;
  /// Computes the translation of a digit's tip per unit of a drive, at rest [m] (3).
  [[nodiscard]] Eigen::Vector3d tip_translation(std::size_t drive, const HandDigit& digit) const;
  /// Returns the moving links of a digit and of what carries it, from the tip inwards.
  [[nodiscard]] std::vector<int> links_of(const HandDigit& digit) const;
  /// Returns the range of a drive [rad] or [m].
  [[nodiscard]] double range(std::size_t drive) const;
  /// Returns whether a drive rotates any digit, rather than only translating it.
  [[nodiscard]] bool rotates_digits(std::size_t drive) const;
  /// Returns whether a drive moves the tip of another digit about as far as that of this one.
  /// @param digit  one of digits()
  [[nodiscard]] bool spreads(std::size_t drive, const HandDigit& digit) const;
  /// Returns the posture at a fraction of the range from rest in the given directions; drives of
  /// direction 0 do not move (coordinates).
  [[nodiscard]] Eigen::VectorXd posture_at(const std::vector<double>& senses, double share) const;
  /// Returns the sum of distances between tips; for a single digit its distance from the palm,
  /// which may be a fixed jaw [m].
  [[nodiscard]] double tip_separation(const Eigen::VectorXd& q) const;

 private:
  void find_digits();
  void sort_drives();
  void orient_drives();
  void straighten();
  void turn_in_range(int coordinate, double angle);
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
  [[nodiscard]] double distance_from_palm(const std::vector<Pose<double>>& links) const;

  const BallGrasp& grip_;
  std::vector<Drive> drives_;
  Eigen::VectorXd rest_;
  std::vector<HandDigit> digits_;
  std::vector<std::string> names_;
  DriveGroups groups_;
};

}  // namespace thenar
