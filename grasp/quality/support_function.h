#pragma once

/// The support function of a wrench set, laid out for being asked very often.

#include <array>

#include "grasp/contact/wrench_set.h"

namespace thenar::internal {

/// How far a set reaches in a direction, and where.
struct SupportPoint {
  double h;        // support h(u)
  ScaledWrench p;  // a point of the set with p' u = h
};

/// h(u) and its point for one set and limit:
///   L1:    the best cap, c + A A'u / |A'u|;
///   Linf:  the sum over contacts of their best caps, where these reach beyond 0.
class SupportFunction {
 public:
  struct Cap {
    ScaledWrench c;
    Eigen::Matrix<double, 6, 3> A;
    int axes;              // columns of A in use; the others are 0
    int contact;           // number, 0, 1, ..
    bool last_of_contact;  // of the caps that share one limit
  };

  SupportFunction(const WrenchSet& set, ForceNorm limit);

  [[nodiscard]] SupportPoint operator()(const ScaledWrench& u) const;

  [[nodiscard]] double size() const { return size_; }          // no point is further off than this
  [[nodiscard]] double rounding() const { return rounding_; }  // of a computed h(u), |u| = 1
  [[nodiscard]] ForceNorm limit() const { return limit_; }
  [[nodiscard]] const std::vector<Cap>& caps() const { return caps_; }  // of a contact together

 private:
  [[nodiscard]] static double reach(const Cap& cap, const ScaledWrench& u);
  static void add_point(const Cap& cap, const ScaledWrench& u, ScaledWrench& sum);

  std::vector<Cap> caps_;  // those of one contact side by side
  ForceNorm limit_;
  double size_ = 0, rounding_ = 0;
};

// Where the hull of a wrench set starts.

/// Directions of the wrenches with 0.
struct Span {
  int rank;                           // how many of the basis span them: singular values above
                                      // 1e-10 of the largest
  Eigen::Matrix<double, 6, 6> basis;  // orthonormal columns, the spanning ones first
};
[[nodiscard]] Span span_of(const WrenchSet& set);

/// Seven support points that span all six dimensions.
struct FirstSimplex {
  std::array<ScaledWrench, 7> points;
  bool found;    // false: the set is flatter than asked
  int supports;  // asked for
};

/// One after the other the point furthest across the affine hull of those before.
/// @param flat  least width, in parts of the size [1]
[[nodiscard]] FirstSimplex first_simplex(const SupportFunction& support, double flat);

// Directions of least support, to rounding, from directions near them.

/// A direction with the least support near u, found by Newton's method on the sphere; u itself if
/// nothing better was met.
///
///   L1:    minimise t with h_i(u) = t of the caps that take part;
///   Linf:  minimise the sum of positive h_i with h_k(u) = 0 of the contacts about to let go.
/// Which ones take part follows from the signs of multipliers and from what overtakes on the way.
/// Steps are split into those along constraints and those within, where the Hessian's negative
/// curvatures are turned about. Caps with A'u about 0, where h has a kink, are held at A'u = 0 in a
/// second attempt.
/// @param u  unit (6)
[[nodiscard]] ScaledWrench descend_support(const SupportFunction& support, const ScaledWrench& u);

}  // namespace thenar::internal
