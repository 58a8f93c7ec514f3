#pragma once

/// Estimation of whitened coordinates of a target from draws and their gradients.

#include "sampling/methods/whitening.h"

namespace thenar::internal {

/// Draws of a warm-up window, with their gradients.
class WindowDraws {
 public:
  explicit WindowDraws(int n) : x_(n, 0), gradient_(n, 0) {}

  /// Adds a draw. @param gradient  gradient of the log density at x (n)
  void add(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient);
  void clear() { count_ = 0; }

  [[nodiscard]] long count() const { return count_; }
  [[nodiscard]] auto x() const { return x_.leftCols(count_); }                // (n, count)
  [[nodiscard]] auto gradient() const { return gradient_.leftCols(count_); }  // (n, count)

  void save(StateWriter& to) const;
  void restore(StateReader& from);

 private:
  Eigen::MatrixXd x_, gradient_;  // columns beyond count_ are spare capacity
  long count_ = 0;
};

/// Shrinks the sample covariance C of N draws towards a small multiple of the previous covariance:
///   Sigma = N / (N + 5) C + 5 / (N + 5) 0.001 before.
/// Stan shrinks towards 0.001 I in the unit of x; this estimate is independent of units, and works
/// for sds of 1e-4 and of 1e4 as well as for those near one.
/// @param x       at least two draws (n, N)
/// @param before  previous covariance (n, n), or variances only (n, 1)
/// @return shrunk covariance (shape of `before`)
/// Source: [Carpenter2017] for the weights.
[[nodiscard]] Eigen::MatrixXd shrunk_covariance(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                                const Eigen::MatrixXd& before);

/// Updates `whitening` from a window of draws. Returns false and changes nothing if there are fewer
/// than two draws or they do not span the space.
///
/// Diagonal metric: variances. Dense metric: F and c minimise the mean of |F' g + F^-1 (x - c)|^2
/// over the draws, which vanishes for a normal target and any draws,
///   F F' = Sigma # C_g^-1,   c = mean x + F F' mean g,
/// where # is the geometric mean of positive matrices, Sigma is shrunk_covariance() and C_g the
/// covariance of the gradients [Seyboldt2026]. With fewer than 2 n draws, or if the previous F
/// leaves less on held-out draws, the previous F is kept with rescaled columns. No variance is more
/// than twice that of the draws. Next, the bend with the smallest residual gradients is adopted if
/// on held-out draws it leaves less than nine tenths of the residual without it. Finally,
/// follows_orbits() is set if less than half of the gradients remains.
bool learn_whitening(const WindowDraws& draws, Whitening& whitening);

}  // namespace thenar::internal
