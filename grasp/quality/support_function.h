#pragma once

/// Support function of a wrench set, laid out for many evaluations.

#include <array>

#include "grasp/contact/wrench_set.h"

namespace thenar::internal {

/// Support in a direction, and the point of the set that attains it.
struct SupportPoint {
  double h;             // support h(u)
  WrenchCoordinates p;  // a point of the set with p' u = h
};

/// Evaluates h(u) and its point for one set and one norm:
///   L1:    the best cap, c + A A'u / |A'u|;
///   Linf:  the sum over contacts of their best caps, where these are positive.
class SupportFunction {
 public:
  /// A cap { c + A z : |z| <= 1 } and the contact that it belongs to.
  struct Cap {
    WrenchCoordinates c;
    Eigen::Matrix<double, 6, 3> A;
    int axes;              // columns of A in use; the others are 0
    int contact;           // number of the contact, 0, 1, ..
    bool last_of_contact;  // last of the caps that share one limit
  };

  SupportFunction(const WrenchSet& set, ForceNorm limit);

  [[nodiscard]] SupportPoint operator()(const WrenchCoordinates& u) const;

  [[nodiscard]] double size() const { return size_; }          // no point is farther from 0 [1]
  [[nodiscard]] double rounding() const { return rounding_; }  // of a computed h(u), |u| = 1 [1]
  [[nodiscard]] ForceNorm limit() const { return limit_; }
  [[nodiscard]] const std::vector<Cap>& caps() const { return caps_; }  // grouped by contact

 private:
  [[nodiscard]] static double reach(const Cap& cap, const WrenchCoordinates& u);
  static void add_point(const Cap& cap, const WrenchCoordinates& u, WrenchCoordinates& sum);

  std::vector<Cap> caps_;  // grouped by contact
  ForceNorm limit_;
  double size_ = 0, rounding_ = 0;
};

/// Linear span of the wrenches of a set.
struct Span {
  int rank;                           // dimension: singular values above 1e-10 of the largest
  Eigen::Matrix<double, 6, 6> basis;  // orthonormal columns, the spanning ones first
};
/// Span of all centres and semi-axes of a set.
[[nodiscard]] Span span_of(const WrenchSet& set);

/// Seven support points that span all six dimensions.
struct FirstSimplex {
  std::array<WrenchCoordinates, 7> points;
  bool found;    // false: the set is flatter than `flat`
  int supports;  // number of support points computed
};

/// Finds the simplex point by point: each is the farthest across the affine hull of those before.
/// @param flat  smallest width, as a share of the size [1]
[[nodiscard]] FirstSimplex first_simplex(const SupportFunction& support, double flat);

/// Finds a direction of locally least support near u by Newton's method on the sphere; returns u
/// itself if nothing better is met.
///
///   L1:    minimise t with h_i(u) = t for the active caps;
///   Linf:  minimise the sum of positive h_i with h_k(u) = 0 for contacts about to lose contact.
/// The active set follows from the signs of multipliers and from caps that exceed the value on the
/// way. Steps are split into a part along the constraints and a part within them, where negative
/// curvatures of the Hessian are turned round. Caps with A'u about 0, where h has a kink, are held
/// at A'u = 0 in a second attempt.
/// @param u  unit (6)
[[nodiscard]] WrenchCoordinates descend_support(const SupportFunction& support,
                                                const WrenchCoordinates& u);

}  // namespace thenar::internal
