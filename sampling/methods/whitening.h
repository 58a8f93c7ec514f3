#pragma once

/// Coordinates in which a target is nearly standard normal, for Hamiltonian samplers.

#include <Eigen/Core>

#include "sampling/methods/sampler.h"
#include "sampling/methods/triangle_products.h"

namespace thenar::internal {

/// Quadratic bend of coordinates, driven by the first K of them:
///   z = y + q(y),   q(y) = sum_{j <= k < K} a_jk (y_j y_k - [j = k]),
/// where a_jk moves only entries behind k. So dq/dy is strictly lower triangular: the bend keeps
/// volume, and entry by entry it is undone.
struct Bend {
  static constexpr int kMaxDrivers = 4, kMaxPairs = kMaxDrivers * (kMaxDrivers + 1) / 2;
  using Pairs = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxPairs, 1>;

  int drivers = 0;           // K; 0: straight
  Eigen::MatrixXd strength;  // a_jk, pairs in the order 00 01 11 02 12 22 .. (n, K (K + 1) / 2)

  /// y_j y_k - [j = k] of all pairs, from the drivers of y.
  [[nodiscard]] Pairs products(const Eigen::VectorXd& y) const;
  /// z of y.
  [[nodiscard]] Eigen::VectorXd bent(const Eigen::VectorXd& y) const;
  /// y of z.
  [[nodiscard]] Eigen::VectorXd straight(const Eigen::VectorXd& z) const;
  /// Turns a gradient by z into that by y, in place.
  void pull_back(const Eigen::VectorXd& y, Eigen::VectorXd& gradient) const;
};

/// A map  x = c + F (y + q(y))  from whitened coordinates y, with a constant determinant. The
/// inverse mass matrix of a chain is  Sigma = F F';  in whitened units momentum r is standard
/// normal, kinetic energy is |r|^2 / 2 and velocity dy/dt is r.
class Whitening {
 public:
  /// Straight, F lower triangular or diagonal, c = `centre`.
  /// @param covariance  F F' to start from; kDiagonal takes its diagonal; empty: identity (n, n)
  /// @throws InputError if it is not n x n, finite, symmetric and positive definite.
  Whitening(Metric metric, const Eigen::VectorXd& centre, const Eigen::MatrixXd& covariance = {});

  [[nodiscard]] int size() const { return static_cast<int>(centre_.size()); }
  [[nodiscard]] bool dense() const { return metric_ == Metric::kDense; }
  [[nodiscard]] bool bends() const { return bend_.drivers > 0; }
  /// Returns whether, between gradients, y runs along an orbit of the standard normal density
  /// instead of a straight line.
  [[nodiscard]] bool orbits() const { return orbits_; }

  /// F and its inverse; of dense coordinates (n, n).
  [[nodiscard]] const Eigen::MatrixXd& factor() const { return factor_; }
  [[nodiscard]] const Eigen::MatrixXd& inverse() const { return inverse_; }

  /// x(y), into `x`  (n)
  void place(const Eigen::VectorXd& y, Eigen::VectorXd& x) const;
  /// y(x)  (n)
  [[nodiscard]] Eigen::VectorXd whitened(const Eigen::VectorXd& x) const;
  /// Gradient by y, into `slope`; where orbits(), that over the gradient -y of a standard normal.
  void whiten_gradient(const Eigen::VectorXd& y, const Eigen::VectorXd& gradient,
                       Eigen::VectorXd& slope) const;

  /// Sigma: all of it (n, n), or its diagonal (n, 1).
  [[nodiscard]] Eigen::MatrixXd covariance() const;

  /// Sets another Sigma of the same shape, straight, without orbits. Returns false and changes
  /// nothing unless it is finite and positive definite.
  bool set(const Eigen::MatrixXd& covariance);
  /// Sets another centre, factor (n, n) and bend. Returns false and changes nothing unless all are
  /// finite and the factor has an inverse. Dense only.
  bool set(const Eigen::VectorXd& centre, const Eigen::MatrixXd& factor, const Bend& bend,
           bool orbits);

  void save(StateWriter& to) const;
  void restore(StateReader& from);

 private:
  Metric metric_;
  Eigen::VectorXd centre_;       // c (n)
  Eigen::MatrixXd factor_;       // F (n, n), or its diagonal (n, 1)
  Shape shape_ = Shape::kLower;  // of a dense F
  Eigen::MatrixXd inverse_;      // of F; empty if diagonal (n, n)
  Bend bend_;
  Eigen::MatrixXd bent_;  // F a (n, pairs)
  bool orbits_ = false;
};

}  // namespace thenar::internal
