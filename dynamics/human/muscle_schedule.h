#pragma once

/// Tensions and excitations that muscles of a scene are given over time.

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "dynamics/stepping/moving_scene.h"

namespace thenar {

/// Tension or excitation of one muscle over time: linear between knots, constant before the first
/// and after the last. Two knots of one time are a jump.
struct MuscleSchedule {
  int muscle = 0;  // of the group
  TimeSpan when{};
  Eigen::VectorXd time;   // never falling [s] (knots)
  Eigen::VectorXd value;  // tension [N], or excitation 0..1 [1] (knots)
};

/// Checks schedules of a group's muscles.
/// @param most   largest value [N] or [1]
/// @param owner  of the muscles, for messages
/// @param what   a value is, for messages: "tension"
/// @throws InputError if there is no such muscle, a schedule is empty or falls in time, a value is
///         below 0 or too large, or two of one muscle act at once.
void check_schedules(const std::vector<MuscleSchedule>& schedules,
                     const std::vector<std::string>& muscles, double most, const std::string& owner,
                     const char* what);

/// The straight piece of a schedule that begins at or before an instant. Before its begin and after
/// its end, where trial steps may look, it is constant.
struct SchedulePiece {
  double begin = 0, end = std::numeric_limits<double>::infinity();  // [s]
  double value = 0, last = 0;                                       // at begin and end

  [[nodiscard]] double slope() const { return (last - value) / (end - begin); }  // [1/s]
  /// Returns the value at t, between those of both ends to the last bit: tensions that end at 0 are
  /// never below it.
  [[nodiscard]] double at(double t) const;
};

/// Finds the piece that begins last at or before an instant [s].
[[nodiscard]] SchedulePiece piece_at(const MuscleSchedule& schedule, double from);

/// The pieces of all muscles that act in a step; zero where no schedule acts. A value that is set
/// by hand takes the place of schedules.
class ActingPieces {
 public:
  explicit ActingPieces(std::size_t muscles) : set_(muscles), pieces_(muscles) {}

  /// Finds the pieces that act at an instant, unless they are those of the last call.
  void find(const std::vector<MuscleSchedule>& schedules, double acting);
  /// Sets the value of a muscle from the next find() on.
  void set(std::size_t muscle, double value);

  [[nodiscard]] const SchedulePiece& of(int muscle) const {
    return pieces_[static_cast<std::size_t>(muscle)];
  }
  [[nodiscard]] const std::optional<double>& set_value(std::size_t muscle) const {
    return set_[muscle];
  }

 private:
  std::vector<std::optional<double>> set_;                    // [N] or [1] (muscles)
  std::vector<SchedulePiece> pieces_;                         // (muscles)
  double acting_ = std::numeric_limits<double>::quiet_NaN();  // of the pieces [s]
};

}  // namespace thenar
