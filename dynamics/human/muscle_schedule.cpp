#include "dynamics/human/muscle_schedule.h"

#include <algorithm>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Index;

SchedulePiece constant_piece(double begin, double value) {
  SchedulePiece piece;
  piece.begin = begin;
  piece.begin_value = piece.end_value = value;
  return piece;
}

}  // namespace

void check_schedules(const std::vector<MuscleSchedule>& schedules,
                     const std::vector<std::string>& muscles, double max_value,
                     const std::string& owner, const char* what) {
  // Check muscle, times and values of each schedule.
  for (std::size_t i = 0; i < schedules.size(); ++i) {
    const MuscleSchedule& each = schedules[i];
    require(each.muscle >= 0 && each.muscle < static_cast<int>(muscles.size()),
            "'{}' has no muscle {}", owner, each.muscle);
    const std::string& name = muscles[each.muscle];
    require(each.time.size() > 0 && each.time.size() == each.value.size(),
            "{} of '{}' has {} instants and {} values", what, name, each.time.size(),
            each.value.size());
    for (Index k = 1; k < each.time.size(); ++k)
      require(each.time[k] >= each.time[k - 1], "{} of '{}' goes back in time", what, name);
    require((each.value.array() >= 0).all() && (each.value.array() <= max_value).all(),
            "{} of '{}' must be 0 to {:g}", what, name, max_value);
    // Check that it does not overlap earlier schedules of the muscle.
    for (std::size_t j = 0; j < i; ++j)
      require(schedules[j].muscle != each.muscle || schedules[j].when.from >= each.when.to ||
                  schedules[j].when.to <= each.when.from,
              "two drives give '{}' its {} at once", name, what);
  }
}

double SchedulePiece::value_at(double t) const {
  if (begin_value == end_value) return begin_value;
  const double part = std::clamp((t - begin) / (end - begin), 0.0, 1.0);
  return part < 1 ? std::clamp(begin_value + part * (end_value - begin_value),
                               std::min(begin_value, end_value), std::max(begin_value, end_value))
                  : end_value;
}

SchedulePiece piece_at(const MuscleSchedule& schedule, double instant) {
  const Index last = schedule.time.size() - 1;
  // Constant before the first knot and after the last one, otherwise linear between two knots.
  if (instant < schedule.time[0]) return constant_piece(instant, schedule.value[0]);
  Index k = 0;
  while (k < last && schedule.time[k + 1] <= instant) ++k;
  if (k == last) return constant_piece(schedule.time[k], schedule.value[k]);
  return {schedule.time[k], schedule.time[k + 1], schedule.value[k], schedule.value[k + 1]};
}

void ActiveSchedulePieces::select(const std::vector<MuscleSchedule>& schedules, double acting) {
  if (acting_ == acting) return;
  for (SchedulePiece& piece : pieces_) piece = {};
  for (const MuscleSchedule& schedule : schedules)
    if (schedule.when.contains(acting)) pieces_[schedule.muscle] = piece_at(schedule, acting);
  // Values that are set override the schedules.
  for (std::size_t m = 0; m < set_values_.size(); ++m)
    if (set_values_[m]) pieces_[m] = constant_piece(0, *set_values_[m]);
  acting_ = acting;
}

void ActiveSchedulePieces::set_value(std::size_t muscle, double value) {
  set_values_[muscle] = value;
  acting_ = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace thenar
