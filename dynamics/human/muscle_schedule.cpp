#include "dynamics/human/muscle_schedule.h"

#include <algorithm>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Index;

SchedulePiece constant_piece(double begin, double value) {
  SchedulePiece piece;
  piece.begin = begin;
  piece.value = piece.last = value;
  return piece;
}

}  // namespace

void check_schedules(const std::vector<MuscleSchedule>& schedules,
                     const std::vector<std::string>& muscles, double most, const std::string& owner,
                     const char* what) {
  // Each schedule is of a muscle of its own, with knots in order and values in range.
  for (std::size_t i = 0; i < schedules.size(); ++i) {
    const MuscleSchedule& each = schedules[i];
    require(each.muscle >= 0 && each.muscle < static_cast<int>(muscles.size()),
            "'{}' has no muscle {}", owner, each.muscle);
    const std::string& name = muscles[static_cast<std::size_t>(each.muscle)];
    require(each.time.size() > 0 && each.time.size() == each.value.size(),
            "{} of '{}' has {} instants and {} values", what, name, each.time.size(),
            each.value.size());
    for (Index k = 1; k < each.time.size(); ++k)
      require(each.time[k] >= each.time[k - 1], "{} of '{}' goes back in time", what, name);
    require((each.value.array() >= 0).all() && (each.value.array() <= most).all(),
            "{} of '{}' must be 0 to {:g}", what, name, most);
    // Two schedules of a muscle must not act at once.
    for (std::size_t j = 0; j < i; ++j)
      require(schedules[j].muscle != each.muscle || schedules[j].when.from >= each.when.to ||
                  schedules[j].when.to <= each.when.from,
              "two drives give '{}' its {} at once", name, what);
  }
}

double SchedulePiece::at(double t) const {
  if (value == last) return value;
  const double part = std::clamp((t - begin) / (end - begin), 0.0, 1.0);
  return part < 1 ? std::clamp(value + part * (last - value), std::min(value, last),
                               std::max(value, last))
                  : last;
}

SchedulePiece piece_at(const MuscleSchedule& schedule, double from) {
  const Index last = schedule.time.size() - 1;
  // Constant before the first knot and behind the last, otherwise the line between two.
  if (from < schedule.time[0]) return constant_piece(from, schedule.value[0]);
  Index k = 0;
  while (k < last && schedule.time[k + 1] <= from) ++k;
  if (k == last) return constant_piece(schedule.time[k], schedule.value[k]);
  return {schedule.time[k], schedule.time[k + 1], schedule.value[k], schedule.value[k + 1]};
}

void ActingPieces::find(const std::vector<MuscleSchedule>& schedules, double acting) {
  if (acting_ == acting) return;
  for (SchedulePiece& piece : pieces_) piece = {};
  for (const MuscleSchedule& schedule : schedules)
    if (schedule.when.holds(acting))
      pieces_[static_cast<std::size_t>(schedule.muscle)] = piece_at(schedule, acting);
  // What is set by hand holds in place of schedules.
  for (std::size_t m = 0; m < set_.size(); ++m)
    if (set_[m]) pieces_[m] = constant_piece(0, *set_[m]);
  acting_ = acting;
}

void ActingPieces::set(std::size_t muscle, double value) {
  set_[muscle] = value;
  acting_ = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace thenar
