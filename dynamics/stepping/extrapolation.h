#pragma once

/// Steps made of ever more substeps, extrapolated to substeps of length zero.

#include <array>

#include "dynamics/stepping/contact_step.h"

namespace thenar {

/// Neville's scheme on columns of 1, 2, .. n substeps of a method of first order, and the choice of
/// how many columns to make. With T_j1 the end of column j,
///   T_jk = T_j,k-1 + (T_j,k-1 - T_j-1,k-1) / (j / (j - k + 1) - 1),
/// of order k; the difference of T_nn and T_n,n-1 is the error, and falls with H^n. The number of
/// columns is the one that asks for the least substeps per time. Calls allocate nothing.
/// Source: [Deuflhard1983]; [Hairer1993] section II.9 for steps and orders.
class Extrapolation {
 public:
  static constexpr int kMostColumns = 8;

  /// Decision after a column: add another, accept the step, or reject it.
  enum class Verdict { kGoOn, kAccept, kReject };

  /// @param like  a state of the scene;  @param most  columns, 2..8
  Extrapolation(const SceneState& like, int most);

  /// A new step.
  void restart() { columns_ = 0; }
  /// The end of the next column.
  void add(const SceneState& column);

  [[nodiscard]] int columns() const { return columns_; }
  /// T_nn, quaternions as they come.
  [[nodiscard]] const SceneState& best() const { return rows_[index(columns_ - 1)]; }
  /// T_n,n-1, with two columns or more.
  [[nodiscard]] const SceneState& lower() const { return rows_[index(columns_ - 2)]; }

  /// @param error  of the last column over the tolerance, with two columns or more [1]
  [[nodiscard]] Verdict judge(double error);

  /// After a verdict: how long the next step is, and internally how many columns it aims at.
  /// @param length   of this step [s];  @param longest  of any [s]
  [[nodiscard]] double next_length(double length, double longest, Verdict verdict);

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  int most_, aim_;
  int columns_ = 0;
  bool was_rejected_ = false;                      // the step before
  std::array<SceneState, kMostColumns> rows_;      // T_n1 .. T_nn
  std::array<double, kMostColumns + 1> errors_{};  // by columns, over the tolerance [1]
};

}  // namespace thenar
