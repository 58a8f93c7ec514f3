#pragma once

/// Largest force or moment of a fingertip, its limits, and the whole set, as text, JSON and rows.

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
  int more_decimals;      // additional decimals compared with newtons
  FieldUnit si;           // unit of numbers
  FieldUnit per_degree;   // unit of changes
};
[[nodiscard]] LoadWords words_of(TipLoad load);
/// Returns the other load: moments for a force, forces for a moment.
[[nodiscard]] TipLoad other_load(TipLoad load);

/// Returns the bound on the other load in words: "moments beside it free", "of at most 0.1 N m
/// each"; "" if it is zero.
[[nodiscard]] std::string other_words(TipLoad load, double max_other);

/// Returns true if the posture has a largest force or moment above rounding errors; false if it is
/// unbounded.
[[nodiscard]] bool makes_force(const FeasibleForcePoint& point);

/// Returns true if a result has the whole set at some posture.
[[nodiscard]] bool with_whole(const FeasibleForceResult& answer);

/// Returns the limits of the force in words, the highest price first, and the effect of degenerate
/// limits: "limited by FDP: the force rises by 0.12 N per additional newton of its F0; then LU
/// 0.03"; "" if no muscle limits the force, or prices did not pass their checks.
[[nodiscard]] std::string limit_words(const FeasibleForceResult& answer,
                                      const FeasibleForcePoint& point);

/// Returns the paralysed and weak muscles in words: "Without EPL, EPB, with 44.6 N of FPL"; "" if
/// there are none.
[[nodiscard]] std::string weak_words(const FeasibleForceResult& answer);

/// Returns a table with a row for each muscle at the largest force of a posture: activation,
/// tension, F0, price of F0.
[[nodiscard]] Table limit_table(const FeasibleForceResult& answer, const FeasibleForcePoint& point);

/// Returns the indices of the muscles that limit the force, the highest price first.
[[nodiscard]] std::vector<Eigen::Index> limiting_muscles(const FeasibleForcePoint& point);

/// Returns a warning about the result at a posture; may be empty.
[[nodiscard]] std::string note_of(const FeasibleForceResult& answer,
                                  const FeasibleForcePoint& point);

/// Model of the tip: a digit whose joints are in balance, or a published map alone.
enum class TipModel { kJoints, kMap };

/// Returns the meaning of a status for a largest force; "" if solved.
[[nodiscard]] std::string force_status_words(Status status, TipLoad load = TipLoad::kForce,
                                             TipModel model = TipModel::kJoints);

/// Returns the name of the k-th of six directions along the axes: "+dorsal" or "-x".
[[nodiscard]] std::string axis_direction(const ForceAxes& axes, std::size_t k);

}  // namespace thenar
