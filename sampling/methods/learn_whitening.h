#pragma once

/// Whitened coordinates of a target, learnt from draws and the gradients there.

#include "sampling/methods/whitening.h"

namespace thenar::internal {

/// Draws of a window of warm-up.
class WindowDraws {
 public:
  explicit WindowDraws(int n) : x_(n, 0), gradient_(n, 0) {}

  /// @param gradient  of the log density at x (n)
  void add(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient);
  void clear() { count_ = 0; }

  [[nodiscard]] long count() const { return count_; }
  [[nodiscard]] auto x() const { return x_.leftCols(count_); }                // (n, count)
  [[nodiscard]] auto gradient() const { return gradient_.leftCols(count_); }  // (n, count)

  void save(StateWriter& to) const;
  void restore(StateReader& from);

 private:
  Eigen::MatrixXd x_, gradient_;  // with room for more columns
  long count_ = 0;
};

/// Shrinks the sample covariance C of N draws towards a small multiple of the one before:
///   Sigma = N / (N + 5) C + 5 / (N + 5) 0.001 before.
/// Stan shrinks towards 0.001 I in the unit of x; this estimate has no unit, so that it works for
/// sds of 1e-4 and of 1e4 as for those near one.
/// @param x       at least two draws (n, N)
/// @param before  n x n, or n x 1: variances alone
/// @return of the shape of `before`.
/// Source: [Carpenter2017] for the weights.
[[nodiscard]] Eigen::MatrixXd shrunk_covariance(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                                const Eigen::MatrixXd& before);

/// Learns `whitening` anew from a window of draws; false, and nothing changes, if they are less
/// than two or do not span the space.
///
/// Diagonal: variances. Dense: F and c minimise the mean of |F' g + F^-1 (x - c)|^2 over the draws,
/// which is zero for a normal target, whatever the draws,
///   F F' = Sigma # C_g^-1,   c = mean x + F F' mean g,
/// # being the geometric mean of positive matrices, Sigma as shrunk_covariance() and C_g the
/// covariance of gradients [Seyboldt2026]. Of less than 2 n draws, or where it leaves less at draws
/// that were not used for it, the F before is kept, with columns of other lengths. No
/// variance is more than twice that of the draws. Then the bend whose gradients leave the least, if
/// on draws that were not used for it less than nine tenths are left of what is left without it. At
/// last, a point orbits() if less than half of the gradients is left.
bool learn_whitening(const WindowDraws& draws, Whitening& whitening);

}  // namespace thenar::internal
