#pragma once

/// Normal prior truncated at bounds, as the smooth image of an unbounded one.

namespace thenar {

/// Returns Phi(z), the standard normal distribution function, with full relative accuracy in the
/// lower tail.
[[nodiscard]] double normal_probability(double z);

/// The map z(x) with  F(z) = Phi(x),  F the distribution of a standard normal z within bounds:
///   Phi(z) = Phi(l) + (Phi(h) - Phi(l)) Phi(x).
/// If x is standard normal, z has the bounded prior: the density of x needs no other Jacobian, has
/// light tails whatever pushes z against a bound, and z = x for distant bounds.
class BoundedNormal {
 public:
  /// @param lower, upper  [prior sds]; may be infinite
  /// @throws InputError unless lower <= 0 <= upper and lower < upper.
  BoundedNormal(double lower, double upper);

  /// Value z and its derivatives [1].
  struct Image {
    double z, by_x, by_lower, by_upper;
  };
  /// Computes z(x) and its derivatives.
  [[nodiscard]] Image evaluate(double x) const;

  /// Returns x with z(x) = z. First z is moved inside the bounds by `margin` prior sds, or by that
  /// share of the distance between them if it is less, as x is infinite at the bounds.
  [[nodiscard]] double inverse(double z, double margin = 1e-3) const;

 private:
  double lower_, upper_;
  double below_, above_, within_;         // Phi(l), 1 - Phi(h), Phi(h) - Phi(l) [1]
  double density_lower_, density_upper_;  // exp(-l^2 / 2), exp(-h^2 / 2) [1]
};

}  // namespace thenar
