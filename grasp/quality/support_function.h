#pragma once

/// Support function of a wrench set, prepared for many evaluations.

#include <array>

#include "grasp/contact/wrench_set.h"

namespace thenar::internal {

/// Support in a direction, with a point of the set that attains it.
struct SupportPoint {
  double h = 0;         // support h(u)
  WrenchCoordinates p;  // a point of the set with p' u = h
};

/// Evaluates h(u) and its point for one set and one norm:
///   L1:    the maximum over caps, c + A A'u / |A'u|;
///   Linf:  the sum over contacts of the maximum of their caps, where positive.
class SupportFunction {
 public:
  /// A cap { c + A z : |z| <= 1 } and the contact to which it belongs.
  struct Cap {
    WrenchCoordinates c;
    Eigen::Matrix<double, 6, 3> A;
    int axes;              // number of used columns of A; the others are 0
    int contact;           // number of the contact, 0, 1, ..
    bool last_of_contact;  // true: last of the caps that share one limit
  };

  SupportFunction(const WrenchSet& set, ForceNorm limit);

  [[nodiscard]] SupportPoint operator()(const WrenchCoordinates& u) const;

  /// Returns the maximum norm of a point of the set [1].
  [[nodiscard]] double max_norm() const { return max_norm_; }
  /// Returns the rounding error of a computed h(u), |u| = 1 [1].
  [[nodiscard]] double rounding() const { return rounding_; }
  [[nodiscard]] ForceNorm limit() const { return limit_; }
  [[nodiscard]] const std::vector<Cap>& caps() const { return caps_; }  // grouped by contact

 private:
  [[nodiscard]] static double reach(const Cap& cap, const WrenchCoordinates& u);
  static void add_point(const Cap& cap, const WrenchCoordinates& u, WrenchCoordinates& sum);

  std::vector<Cap> caps_;  // grouped by contact
  ForceNorm limit_;
  double max_norm_ = 0, rounding_ = 0;
};

/// Linear span of the wrenches of a set.
struct WrenchSpan {
  int rank = 0;                       // dimension: singular values above 1e-10 of the largest
  Eigen::Matrix<double, 6, 6> basis;  // orthonormal columns, the spanning ones first
};
/// Computes the span of all centres and semi-axes of a set.
[[nodiscard]] WrenchSpan span_of(const WrenchSet& set);

/// Seven support points that span all six dimensions.
struct FirstSimplex {
  std::array<WrenchCoordinates, 7> points;
  bool found = false;  // false: the set is flatter than the given width
  int supports = 0;    // number of support points computed
};

/// Finds a simplex point by point: each is the farthest from the affine hull of those before.
/// @param flat  minimum width of the set, over its size [1]
[[nodiscard]] FirstSimplex first_simplex(const SupportFunction& support, double flat);

/// Finds a direction of locally minimal support near u by Newton's method on the sphere; returns u
/// itself if no better one is found.
///
///   L1:    minimise t with h_i(u) = t for the active caps;
///   Linf:  minimise the sum of positive h_i with h_k(u) = 0 for contacts whose force is about to
///   vanish.
/// The active set follows from the signs of multipliers and from caps that exceed the value on the
/// way. Steps have a part along the constraints and a part within them, in which negative
/// curvatures of the Hessian are reversed. Caps with A'u about 0, where h has a kink, are held at
/// A'u = 0 in a second attempt.
/// @param u  unit (6)
[[nodiscard]] WrenchCoordinates descend_support(const SupportFunction& support,
                                                const WrenchCoordinates& u);

}  // namespace thenar::internal
