#pragma once

/// A normal prior cut off at bounds, as the smooth image of an unbounded one.

namespace thenar {

/// Returns Phi(z), with full relative accuracy in the lower tail.
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

  /// x with z(x) = z. z is first brought within the bounds by `margin` prior sds, or that share of
  /// their distance if it is less: x is infinite on them.
  [[nodiscard]] double inverse(double z, double margin = 1e-3) const;

 private:
  double lower_, upper_;
  double below_, above_, within_;         // Phi(l), 1 - Phi(h) and what is left [1]
  double density_lower_, density_upper_;  // exp(-l^2 / 2), exp(-h^2 / 2) [1]
};

}  // namespace thenar
