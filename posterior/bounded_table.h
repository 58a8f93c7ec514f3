#pragma once

/// A normal prior cut off at bounds, as the smooth image of one that is not.

#include <vector>

#include "posterior/lane_loops.h"

namespace thenar {

/// Phi(z), with full relative accuracy in the lower tail.
[[nodiscard]] double normal_probability(double z);

/// The map z(x) with  F(z) = Phi(x),  F the distribution of a standard normal z within bounds:
///   Phi(z) = Phi(l) + (Phi(h) - Phi(l)) Phi(x).
/// If x is standard normal, z has the bounded prior: the density of x needs no other Jacobian, has
/// light tails whatever pushes z against a bound, and z = x where bounds are far.
class BoundedNormal {
 public:
  /// @param lower, upper  [prior sds]; may be infinite
  /// @throws InputError unless lower <= 0 <= upper and lower < upper.
  BoundedNormal(double lower, double upper);

  /// z and its derivatives [1].
  struct Image {
    double z, by_x, by_lower, by_upper;
  };
  [[nodiscard]] Image at(double x) const;

  /// x with z(x) = z. z is first brought within the bounds by a thousandth of a prior sd, or of
  /// their distance if that is less: x is infinite on them.
  [[nodiscard]] double inverse(double z) const;

 private:
  double lower_, upper_;
  double below_, above_, within_;         // Phi(l), 1 - Phi(h) and what is left [1]
  double density_lower_, density_upper_;  // exp(-l^2 / 2), exp(-h^2 / 2) [1]
};

/// The same map from a table: polynomials of degree 5 in cells of 1/64, which meet with equal
/// value, slope and curvature. Off by less than 1e-10 [prior sds]; beyond |x| = 8.5 exact.
class BoundedTable {
 public:
  explicit BoundedTable(const BoundedNormal& exact);

  struct Image {
    double z, by_x;
  };
  [[nodiscard]] Image at(double x) const;
  /// scale z and scale dz/dx of eight points.
  void at_lanes(const double* x, double scale, double* y, double* by_x) const;
  [[nodiscard]] double inverse(double z) const;

 private:
  BoundedNormal exact_;
  std::vector<double> coefficients_;
};

}  // namespace thenar
