#pragma once

/// Anderson acceleration of slowly converging fixed-point iterations.

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Anderson acceleration of a fixed-point iteration  x -> x + m(x).  The next step goes to where
/// the linear combination of the last increments m with the smallest norm lies. Source:
/// [WalkerNi2011].
class AndersonMixing {
 public:
  /// @param window  maximum number of earlier increments that are combined with the latest one
  explicit AndersonMixing(std::size_t window) : window_(window) {}

  /// Clears the history: the next step is the plain increment.
  void clear();
  /// Returns the accelerated step, to be added to x by the caller (n).
  /// @param increment  increment m at the current x (n)
  [[nodiscard]] Eigen::VectorXd next_step(const Eigen::VectorXd& increment);

 private:
  std::size_t window_;
  // Steps in x, and the changes of the increment that they caused
  std::vector<Eigen::VectorXd> steps_, increment_changes_;
  Eigen::VectorXd increment_, step_;  // latest increment and step; empty at first
};

}  // namespace thenar
