#pragma once

/// The largest force or moment of a fingertip, what limits it, and all of them, as words, JSON and
/// rows.

#include <string>

#include "api/feasible_force.h"
#include "report/fields.h"

namespace thenar {

[[nodiscard]] std::string text_of(const FeasibleForceResult& answer);
[[nodiscard]] Fields fields_of(const FeasibleForceResult& answer);
/// Returns a table with a row for each posture.
[[nodiscard]] Table table_of(const FeasibleForceResult& answer);

/// Words, unit and suffix of a load.
struct LoadWords {
  std::string one, many;  // "force", "forces"
  std::string unit;       // "N" or "N m"
  std::string suffix;     // suffix of keys and columns: "_N" or "_Nm"
  int more_decimals;      // than newtons need
  FieldUnit si;           // unit of numbers
  FieldUnit per_degree;   // unit of changes
};
[[nodiscard]] LoadWords words_of(TipLoad load);
/// Returns the load that is not asked for: moments beside a force.
[[nodiscard]] TipLoad other_load(TipLoad load);

/// Returns "moments beside it free", "of at most 0.1 N m each"; "" if there are none.
[[nodiscard]] std::string other_words(TipLoad load, double most_other);

/// Returns true if the posture has a largest force or moment above rounding errors; false if it is
/// unbounded.
[[nodiscard]] bool makes_force(const FeasibleForcePoint& point);

/// Returns true if an answer has the whole set at some posture.
[[nodiscard]] bool with_whole(const FeasibleForceResult& answer);

/// Returns "limited by FDP: the force rises by 0.12 N per additional newton of its F0; then LU
/// 0.03": the dearest limit first, and what degenerate limits do. "" if no muscle limits the force,
/// or prices did not pass their checks.
[[nodiscard]] std::string limit_words(const FeasibleForceResult& answer,
                                      const FeasibleForcePoint& point);

/// Returns "Without EPL, EPB, with 44.6 N of FPL": muscles that are paralysed and weak; "" if none
/// is.
[[nodiscard]] std::string weak_words(const FeasibleForceResult& answer);

/// Returns a table with a row for each muscle at the largest force of a posture: activation,
/// tension, F0, price of F0.
[[nodiscard]] Table limit_table(const FeasibleForceResult& answer, const FeasibleForcePoint& point);

/// Returns muscles that limit the force, the dearest first, as indices.
[[nodiscard]] std::vector<Eigen::Index> limiting_muscles(const FeasibleForcePoint& point);

/// Returns a warning about the answer at a posture; may be empty.
[[nodiscard]] std::string note_of(const FeasibleForceResult& answer,
                                  const FeasibleForcePoint& point);

/// Model of the tip: a digit with joints that must be in balance, or a published map alone.
enum class TipModel { kJoints, kMap };

/// Returns the meaning of a status for the question of a force; "" if solved.
[[nodiscard]] std::string force_status_words(Status status, TipLoad load = TipLoad::kForce,
                                             TipModel model = TipModel::kJoints);

/// Returns "+dorsal" or "-x": the k-th of six directions along the axes.
[[nodiscard]] std::string axis_direction(const ForceAxes& axes, std::size_t k);

}  // namespace thenar
