#pragma once

/// Mass matrix of Hamiltonian samplers as a whitening map, and its estimate from draws.

#include <Eigen/Core>

#include "sampling/methods/sampler.h"

namespace thenar::internal {

/// Inverse mass matrix  Sigma = F F',  an estimate of the target's covariance; F is lower
/// triangular, or diagonal. In whitened units x = F y, momentum r = F' p is standard normal, so
/// kinetic energy is |r|^2 / 2 and velocity dy/dt is r.
class MassMatrix {
 public:
  /// @param covariance  to start from; kDiagonal takes its diagonal; empty: identity (n, n)
  /// @throws InputError if it is not n x n, finite, symmetric and positive definite.
  MassMatrix(Metric metric, int n, const Eigen::MatrixXd& covariance = {});

  [[nodiscard]] int size() const { return static_cast<int>(factor_.rows()); }
  [[nodiscard]] bool dense() const { return metric_ == Metric::kDense; }

  /// x += time F r  (n)
  void drift(Eigen::VectorXd& x, const Eigen::VectorXd& r, double time) const;
  /// F' gradient, into `slope`: the gradient by y  (n)
  void whiten_gradient(const Eigen::VectorXd& gradient, Eigen::VectorXd& slope) const;

  /// Sigma: all of it (n, n), or its diagonal (n, 1).
  [[nodiscard]] Eigen::MatrixXd covariance() const;
  /// Takes another Sigma of that shape. Returns false and changes nothing unless it is finite and
  /// positive definite.
  bool set(const Eigen::MatrixXd& covariance);

  void save(StateWriter& to) const { to.put(factor_); }
  void restore(StateReader& from) { factor_ = from.matrix(); }

 private:
  Metric metric_;
  Eigen::MatrixXd factor_;  // F (n, n), or its diagonal (n, 1)
};

/// Running covariance of points, by Welford's updates. Source: [Welford1962].
class CovarianceEstimate {
 public:
  CovarianceEstimate(Metric metric, int n);

  void add(const Eigen::VectorXd& x);
  void clear();
  [[nodiscard]] long count() const { return count_; }

  /// Shrinks the sample covariance C of N points towards a small multiple of the one before:
  ///   Sigma = N / (N + 5) C + 5 / (N + 5) 0.001 before.
  /// Stan shrinks towards 0.001 I in the unit of x; this estimate has no unit, so that it works for
  /// sds of 1e-4 and of 1e4 as for those near one.
  /// @param before  of the shape that MassMatrix::covariance() has; count() must be at least 2
  /// Source: [Carpenter2017] for the weights.
  [[nodiscard]] Eigen::MatrixXd shrunk(const Eigen::MatrixXd& before) const;

  void save(StateWriter& to) const;
  void restore(StateReader& from);

 private:
  long count_ = 0;
  Eigen::VectorXd mean_;    // (n)
  Eigen::MatrixXd square_;  // sum of products of deviations (n, n), or its diagonal (n, 1)
};

}  // namespace thenar::internal
