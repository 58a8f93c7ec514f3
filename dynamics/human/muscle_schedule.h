#pragma once

/// Prescribed tensions and excitations of muscles over time.

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "dynamics/stepping/moving_scene.h"

namespace thenar {

/// Tension or excitation of one muscle over time: linear between knots, constant before the first
/// and after the last. Two knots at one time define a jump.
struct MuscleSchedule {
  int muscle = 0;         // index in the group
  TimeSpan when{};        // time span in which the schedule acts
  Eigen::VectorXd time;   // times, not decreasing [s] (knots)
  Eigen::VectorXd value;  // tension [N], or excitation 0..1 [1] (knots)
};

/// Checks the schedules of a group's muscles.
/// @param max_value  largest value [N] or [1]
/// @param owner      name of the owner of the muscles, for messages
/// @param what       name of the quantity, for messages: "tension"
/// @throws InputError if a muscle does not exist, a schedule is empty, times decrease, a value is
///         below 0 or above max_value, or two schedules of a muscle overlap.
void check_schedules(const std::vector<MuscleSchedule>& schedules,
                     const std::vector<std::string>& muscles, double max_value,
                     const std::string& owner, const char* what);

/// Linear piece of a schedule. It is constant before its start and after its end, where trial steps
/// may evaluate it.
struct SchedulePiece {
  double begin = 0, end = std::numeric_limits<double>::infinity();  // time span [s]
  double begin_value = 0, end_value = 0;                            // values there [N] or [1]

  /// Returns the slope of the piece [N/s] or [1/s].
  [[nodiscard]] double slope() const { return (end_value - begin_value) / (end - begin); }
  /// Returns the value at t [N] or [1]. It never leaves the range of the end values, not even by
  /// rounding, so that tensions stay >= 0.
  [[nodiscard]] double value_at(double t) const;
};

/// Returns the last piece of a schedule that begins at or before an instant [s].
[[nodiscard]] SchedulePiece piece_at(const MuscleSchedule& schedule, double instant);

/// Schedule pieces of all muscles that act in a step; zero for muscles without an active schedule.
/// A value that is set by a control overrides the schedules.
class ActiveSchedulePieces {
 public:
  explicit ActiveSchedulePieces(std::size_t muscles) : set_values_(muscles), pieces_(muscles) {}

  /// Selects the pieces that act at an instant, unless it is that of the last call.
  void select(const std::vector<MuscleSchedule>& schedules, double acting);
  /// Overrides the schedules of a muscle from the next select() on.
  void set_value(std::size_t muscle, double value);

  /// Returns the selected piece of a muscle.
  [[nodiscard]] const SchedulePiece& piece_of(int muscle) const { return pieces_[muscle]; }
  /// Returns the value that overrides the schedules of a muscle, if any.
  [[nodiscard]] const std::optional<double>& value_set(std::size_t muscle) const {
    return set_values_[muscle];
  }

 private:
  std::vector<std::optional<double>> set_values_;             // overrides [N] or [1] (muscles)
  std::vector<SchedulePiece> pieces_;                         // selected pieces (muscles)
  double acting_ = std::numeric_limits<double>::quiet_NaN();  // instant of the selection [s]
};

}  // namespace thenar
