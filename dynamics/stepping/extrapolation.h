#pragma once

/// Richardson extrapolation of a step to substeps of length zero, with order and step size control.

#include <array>
#include <optional>

#include "base/numbers.h"
#include "dynamics/stepping/contact_step.h"

namespace thenar {

/// Neville's scheme on columns of 1, 2, .. n substeps of a first-order method, and the choice of
/// the number of columns. With T_j1 the end of column j,
///   T_jk = T_j,k-1 + (T_j,k-1 - T_j-1,k-1) / (j / (j - k + 1) - 1)
/// is of order k; the difference of T_nn and T_n,n-1 estimates the error, which falls as H^n. The
/// number of columns minimises the number of substeps per unit of time. No call allocates memory.
/// Source: [Deuflhard1983]; [Hairer1993] section II.9 for step size and order.
///
/// Each trial of a step makes these calls in this order; another order throws InputError:
///   1. restart();
///   2. add_column(end, n) for n = 1, 2, .., and judge() after each column from the second on,
///      until judge() returns a verdict. The trial may end earlier, without a verdict; a column
///      that was not judged counts as one of infinite error;
///   3. plan_next(), at most once and only after a verdict.
class Extrapolation {
 public:
  static constexpr int kMaxColumns = 8;  // largest number of columns that an option may ask for

  /// Verdict on a step after its last column.
  enum class Verdict { kAccept, kReject };

  /// @param like  any state of the scene, for the sizes
  /// @param max_columns  2..8
  Extrapolation(const SceneState& like, int max_columns);

  /// Starts a new step or trial: discards columns, their errors and the verdict.
  void restart() { columns_ = 0, verdict_.reset(), errors_.fill(kInfinity); }
  /// Adds the state at the end of the next column and extrapolates.
  /// @param substeps  number of substeps of the column: column_count() + 1
  void add_column(const SceneState& column, int substeps);

  [[nodiscard]] int column_count() const { return columns_; }
  /// Returns T_nn; its quaternions are not normalised.
  [[nodiscard]] const SceneState& highest_order() const { return rows_[index(columns_ - 1)]; }
  /// Returns T_n,n-1; needs two columns.
  [[nodiscard]] const SceneState& lower_order() const { return rows_[index(columns_ - 2)]; }

  /// Decides after a column; needs two columns. @param error  of T_nn over the tolerance [1]
  /// @return empty: the step needs another column
  std::optional<Verdict> judge(double error);
  /// Returns what judge() returned last since restart(); empty after plan_next().
  [[nodiscard]] std::optional<Verdict> verdict() const { return verdict_; }

  /// Sets the target number of columns of the next step, or of the next trial after kReject, and
  /// returns its length [s]. @param length  of this step [s];  @param max_length  of any step [s]
  [[nodiscard]] double plan_next(double length, double max_length);

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  int max_columns_;     // largest number of columns
  int target_columns_;  // number of columns at which the next step should be accepted
  int columns_ = 0;
  std::optional<Verdict> verdict_;
  bool was_rejected_ = false;                     // the previous trial that was planned from
  std::array<SceneState, kMaxColumns> rows_;      // T_n1 .. T_nn
  std::array<double, kMaxColumns + 1> errors_{};  // error over the tolerance by number of columns;
                                                  // infinite: not judged [1]
};

}  // namespace thenar
