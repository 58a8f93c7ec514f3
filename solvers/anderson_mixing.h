#pragma once

/// Fixed-point iterations that shrink slowly, made to arrive.

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Anderson's mixing of an iteration  x -> x + m(x):  the combination of the last motions m that is
/// least says where they vanish. Source: [WalkerNi2011].
class AndersonMixing {
 public:
  /// @param window  motions that are combined with the last, at most
  explicit AndersonMixing(std::size_t window) : window_(window) {}

  /// Forgets all: the next step is the motion itself.
  void clear();
  /// The step to take, which the caller takes. @param motion  m where the last step led (n)
  [[nodiscard]] Eigen::VectorXd next(const Eigen::VectorXd& motion);

 private:
  std::size_t window_;
  std::vector<Eigen::VectorXd> steps_, changes_;  // of x, and of motions by them
  Eigen::VectorXd motion_, step_;                 // the last ones; empty: there are none
};

}  // namespace thenar
