#pragma once

/// Coordinates in which a target is nearly standard normal, for Hamiltonian samplers.

#include <Eigen/Core>

#include "sampling/methods/sampler.h"
#include "sampling/methods/triangle_products.h"

namespace thenar::internal {

/// Quadratic bend of coordinates, driven by the first K of them:
///   z = y + q(y),   q(y) = sum_{j <= k < K} a_jk (y_j y_k - [j = k]),
/// where a_jk only moves entries after k. So dq/dy is strictly lower triangular: the bend preserves
/// volume and is inverted entry by entry.
struct Bend {
  static constexpr int kMaxDrivers = 4, kMaxPairs = kMaxDrivers * (kMaxDrivers + 1) / 2;
  using Pairs = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxPairs, 1>;

  int drivers = 0;           // K, number of driving coordinates; 0: no bend
  Eigen::MatrixXd strength;  // a_jk of pairs in the order 00 01 11 02 12 22 .. (n, K (K + 1) / 2)

  /// Returns y_j y_k - [j = k] of all pairs of drivers.
  [[nodiscard]] Pairs products(const Eigen::VectorXd& y) const;
  /// Returns z(y).
  [[nodiscard]] Eigen::VectorXd apply(const Eigen::VectorXd& y) const;
  /// Returns y(z).
  [[nodiscard]] Eigen::VectorXd invert(const Eigen::VectorXd& z) const;
  /// Transforms a gradient by z into the gradient by y, in place.
  void pull_back_gradient(const Eigen::VectorXd& y, Eigen::VectorXd& gradient) const;
};

/// Map  x = c + F (y + q(y))  from whitened coordinates y, with constant determinant. The inverse
/// mass matrix of a chain is  Sigma = F F';  in whitened units momentum r is standard normal,
/// kinetic energy is |r|^2 / 2 and velocity dy/dt is r.
class Whitening {
 public:
  /// Constructs a map without bend, with F lower triangular or diagonal and c = `centre`.
  /// @param covariance  initial F F'; kDiagonal uses its diagonal; empty: identity (n, n)
  /// @throws InputError if it is not n x n, finite, symmetric and positive definite.
  Whitening(Metric metric, const Eigen::VectorXd& centre, const Eigen::MatrixXd& covariance = {});

  [[nodiscard]] int size() const { return static_cast<int>(centre_.size()); }
  [[nodiscard]] bool is_dense() const { return metric_ == Metric::kDense; }
  [[nodiscard]] bool is_bent() const { return bend_.drivers > 0; }
  /// Returns whether, between gradients, y follows an orbit of the standard normal density instead
  /// of a straight line.
  [[nodiscard]] bool follows_orbits() const { return orbits_; }

  /// Return F and its inverse; only for a dense metric (n, n).
  [[nodiscard]] const Eigen::MatrixXd& factor() const { return factor_; }
  [[nodiscard]] const Eigen::MatrixXd& inverse() const { return inverse_; }

  /// Computes x(y) (n).
  void to_position(const Eigen::VectorXd& y, Eigen::VectorXd& x) const;
  /// Returns y(x) (n).
  [[nodiscard]] Eigen::VectorXd to_whitened(const Eigen::VectorXd& x) const;
  /// Computes the gradient by y (n). If follows_orbits(), the gradient -y of a standard normal is
  /// subtracted.
  void whiten_gradient(const Eigen::VectorXd& y, const Eigen::VectorXd& gradient,
                       Eigen::VectorXd& slope) const;

  /// Returns Sigma (n, n), or its diagonal (n, 1).
  [[nodiscard]] Eigen::MatrixXd covariance() const;

  /// Sets another Sigma of the same shape, without bend and orbits. Returns false and changes
  /// nothing unless it is finite and positive definite.
  bool set_covariance(const Eigen::MatrixXd& covariance);
  /// Sets another centre, factor (n, n) and bend. Returns false and changes nothing unless all are
  /// finite and the factor is invertible. Dense metric only.
  bool set_map(const Eigen::VectorXd& centre, const Eigen::MatrixXd& factor, const Bend& bend,
               bool orbits);

  void save(StateWriter& to) const;
  void restore(StateReader& from);

 private:
  Metric metric_;
  Eigen::VectorXd centre_;       // c (n)
  Eigen::MatrixXd factor_;       // F (n, n), or its diagonal (n, 1)
  Shape shape_ = Shape::kLower;  // structure of a dense F
  Eigen::MatrixXd inverse_;      // inverse of F; empty if diagonal (n, n)
  Bend bend_;
  Eigen::MatrixXd bent_;  // F a, the effect of the bend on x (n, pairs)
  bool orbits_ = false;
};

}  // namespace thenar::internal
