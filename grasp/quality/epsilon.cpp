#include "grasp/quality/epsilon.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

#include "base/error.h"
#include "base/numbers.h"
#include "base/stop_scope.h"
#include "grasp/quality/support_proof.h"
#include "solvers/incremental_hull.h"

namespace thenar {
namespace {

using internal::Hull;
using internal::span_of;
using internal::SupportFunction;
using internal::SupportPoint;
using internal::WrenchSpan;

constexpr double kUndecidedRatio =
    1e-9;  // epsilon over the size below which its sign is undecided [1]
// Number of facets at the first polish, doubled each time
constexpr int kPolishFacets = 400;
// Factor on the number of facets until the next proof, after a failed one
constexpr int kProofFactor = 64;
// Maximum number of parts of the sphere in a proof, in the search and at its end
constexpr int kSearchParts = 8, kMaxParts = 64;
constexpr int kLinfParts = 4;  // maximum parts of a proof for Linf, at 20 to 100 ms each
constexpr int kMaxProofAttempts =
    20;  // maximum number of attempts of a proof, with decreasing lower bounds
constexpr double kProvableGap = 1e-9;  // gap that proofs of two caps reach, over the size [1]
// Gap of distances from outside, where accuracy is cheap [1]
constexpr double kOutsideGap = 1e-10;

void require_options(const WrenchSet& set, const EpsilonOptions& options) {
  require(options.gap > 0 && options.gap < kInfinity, "the gap is {}, wanted > 0", options.gap);
  require(options.max_facets > 0, "the hull may have {} facets, wanted > 0", options.max_facets);
  for (std::size_t i = 0; i < set.caps.size(); ++i)
    require(set.caps[i].c.is_finite() && set.caps[i].A.allFinite(), "wrenches {} are not finite",
            i);
}

Epsilon nothing() {
  Epsilon out{};
  out.converged = true;
  out.has_missing_direction = true;
  out.missing_direction = ScaledWrench::unit(0);
  out.worst_wrench = -out.missing_direction;
  return out;
}

/// Computes the distance of the origin from a set that does not contain it in its interior.
Epsilon outside(const WrenchSet& set, const WrenchSpan& span, const EpsilonOptions& options) {
  // Wolfe's method bounds the distance from both sides.
  const SupportFunction support(set, ForceNorm::kL1);
  const auto nearest = internal::min_norm(support, std::min(options.gap, kOutsideGap));
  Epsilon out{};
  out.rank = span.rank;
  out.supports = nearest.supports;
  out.has_missing_direction = true;
  out.missing_direction = ScaledWrench::from_coordinates(nearest.direction);
  out.lower = -nearest.x.norm() - support.rounding();
  out.upper = nearest.support + support.rounding();
  // A flat set has no wrench across its span: epsilon is 0 unless the origin is clearly outside.
  if (span.rank < 6 && !(out.upper < -kUndecidedRatio * support.max_norm())) {
    out.missing_direction = ScaledWrench::from_coordinates(span.basis.col(5));
    out.upper = 0;
    if (out.lower > -kUndecidedRatio * support.max_norm()) out.lower = 0;
  }
  out.worst_wrench = -out.missing_direction;
  out.converged = out.upper - out.lower <= options.gap;
  return out;
}

/// Search for epsilon by a growing hull, with lower and upper bounds.
class EpsilonSearch {
 public:
  EpsilonSearch(const SupportFunction& support, const EpsilonOptions& options)
      : support_(support), options_(options) {}

  /// Grows the hull until its nearest facet is certified. @returns false if the set is flat
  bool run() {
    // Start from a simplex of support points; a flat set has none.
    const auto simplex = internal::first_simplex(support_, internal::kWrenchRankTolerance);
    supports_ += simplex.supports;
    if (!simplex.found) return false;
    Hull hull(simplex.points);
    lower_ = -support_.max_norm();
    grow(hull);
    // Descend once more, then prove the requested gap and the smallest provable one.
    facets_ = hull.facets();
    descend_support();
    for (const double gap : {needed_gap(), kProvableGap * support_.max_norm()})
      if (!settled() && prove(gap, linf() ? kLinfParts : kMaxParts)) break;
    return true;
  }

  [[nodiscard]] Epsilon result() const {
    Epsilon out{};
    out.lower = lower_;
    out.upper = upper_;
    out.rank = 6;
    out.force_closure = lower_ > 0;
    out.worst_wrench = -worst();
    out.converged = upper_ - lower_ <= options_.gap;
    out.supports = supports_;
    out.facets = facets_;
    return out;
  }

  [[nodiscard]] double upper() const { return upper_; }
  [[nodiscard]] ScaledWrench worst() const { return ScaledWrench::from_coordinates(worst_); }

 private:
  /// Adds support points to the hull until its nearest facet decides epsilon, or there are too many
  /// facets.
  void grow(Hull& hull) {
    int next_polish = kPolishFacets;
    int next_proof = kPolishFacets;
    while (upper_ > 0 && hull.facets() <= options_.max_facets) {
      // The nearest facet bounds epsilon from below; facets beyond the bar cannot matter.
      end_if_stopped();
      hull.set_offset_limit(bar());
      const int facet = hull.pop_nearest();
      if (facet < 0) {  // all are beyond the bar
        lower_ = std::max(lower_, bar() - hull.error());
        return;
      }
      const Hull::Plane plane = hull.plane(facet);
      lower_ = std::max(lower_, plane.d - hull.error());
      if (settled()) return;
      // The support in its direction bounds epsilon from above and is the hull's next vertex.
      const SupportPoint reach = look(plane.n);
      if (settled() || !hull.insert(reach.p, facet)) return;
      // Now and then descend to a local minimum of the support, and try to prove it.
      if (hull.facets() < next_polish) continue;
      descend_support();
      if (hull.facets() >= next_proof) {
        if (prove(needed_gap(), linf() ? kLinfParts : kSearchParts)) return;
        next_proof *= kProofFactor;
      }
      next_polish *= 2;
    }
  }

  /// Lowers the upper bound to the local minimum.
  void descend_support() {
    if (upper_ > kUndecidedRatio * support_.max_norm())
      (void)look(internal::descend_support(support_, worst_));
  }

  /// Proves the lower bound without facets: two caps may be nearest along whole families of
  /// directions, for which the number of facets would grow with 1 / gap.
  bool prove(double gap, int max_parts) {
    for (int tries = 0; tries < kMaxProofAttempts; ++tries) {
      // Value to prove: just below the upper bound.
      const double r = upper_ - support_.rounding() - 0.9 * gap;
      if (upper_ <= kUndecidedRatio * support_.max_norm() || r <= lower_) return false;
      const internal::SupportProof proof = internal::prove_support(support_, r, max_parts);
      if (proof.found) {
        lower_ = r;
        return settled();
      }
      if (!proof.below) return false;
      // A direction below r refutes it and lowers the upper bound.
      (void)look(*proof.below);
    }
    return false;
  }

  SupportPoint look(const WrenchCoordinates& u) {
    SupportPoint reach = support_(u);
    ++supports_;
    if (reach.h + support_.rounding() < upper_) {
      upper_ = reach.h + support_.rounding();
      worst_ = u;
    }
    return reach;
  }

  [[nodiscard]] bool linf() const { return support_.limit() == ForceNorm::kLinf; }

  /// Returns the gap that also decides the sign.
  [[nodiscard]] double needed_gap() const {
    return std::min(options_.gap, std::max(0.99 * upper_, kUndecidedRatio * support_.max_norm()));
  }
  [[nodiscard]] double bar() const { return upper_ - 0.9 * needed_gap(); }
  [[nodiscard]] bool settled() const { return upper_ - lower_ <= needed_gap(); }

  const SupportFunction& support_;
  const EpsilonOptions& options_;
  double lower_ = 0, upper_ = kInfinity;
  WrenchCoordinates worst_ = WrenchCoordinates::Unit(0);
  int supports_ = 0, facets_ = 0;
};

/// Computes epsilon of kLinf without proven force closure as that of kL1. If kL1 has the proof, the
/// larger kLinf set has force closure, too.
// NOLINTNEXTLINE(misc-no-recursion): at most one call, with the other limit
Epsilon of_l1(const WrenchSet& set, EpsilonOptions options, Epsilon linf) {
  options.limit = ForceNorm::kL1;
  Epsilon l1 = epsilon(set, options);
  if (!l1.force_closure) return l1;
  linf.lower = l1.lower;
  linf.force_closure = true;
  linf.converged = linf.upper - linf.lower <= options.gap;
  return linf;
}

}  // namespace

// NOLINTNEXTLINE(misc-no-recursion): at most one call, with the other limit
Epsilon epsilon(const WrenchSet& set, const EpsilonOptions& options) {
  require_options(set, options);
  if (set.caps.empty()) return nothing();
  const WrenchSpan span = span_of(set);
  // Flat sets, and sets whose origin is not inside, are measured from outside.
  if (span.rank < 6) return outside(set, span, options);

  const SupportFunction support(set, options.limit);
  EpsilonSearch search(support, options);
  if (!search.run() || search.upper() <= support.rounding()) return outside(set, span, options);
  Epsilon out = search.result();
  // Force closure is certified, or the sign of the value decides.
  if (out.force_closure) return out;
  if (options.limit == ForceNorm::kLinf) return of_l1(set, options, out);
  // With the origin outside, facets give no lower bound: a thin set beside it may have all its
  // planes near the origin.
  Epsilon beside = outside(set, span, options);
  if (out.upper >= beside.upper) return beside;
  beside.upper = out.upper;
  beside.missing_direction = search.worst();
  beside.worst_wrench = -beside.missing_direction;
  beside.supports += out.supports;
  beside.facets = out.facets;
  beside.converged = beside.upper - beside.lower <= options.gap;
  return beside;
}

double min_gap(const WrenchSet& set, ForceNorm limit) {
  return 10 * SupportFunction(set, limit).rounding();
}

}  // namespace thenar

namespace thenar::internal {
namespace {

constexpr int kMaxSupports = 2000;    // maximum number of support evaluations
constexpr double kZeroRatio = 1e-14;  // norm over the size below which x counts as zero [1]

/// Computes the weights of the least-norm point in the affine hull of the columns.
Eigen::VectorXd affine_weights(const Eigen::Matrix<double, 6, Eigen::Dynamic>& points) {
  const Eigen::Index edges = points.cols() - 1;
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(points.cols());
  if (edges == 0) return weights;
  const WrenchCoordinates last = points.rightCols<1>();
  const Eigen::MatrixXd D = points.leftCols(edges).colwise() - last;
  weights.head(edges) = D.completeOrthogonalDecomposition().solve(-last);
  weights(edges) = 1 - weights.head(edges).sum();
  return weights;
}

/// Points with the convex weights of the point of their hull nearest to the origin.
struct Corral {
  Eigen::Matrix<double, 6, Eigen::Dynamic> points;
  Eigen::VectorXd weights;  // >= 0, sum 1

  void add(const WrenchCoordinates& p) {
    append_column(points, p);
    append_entry(weights, 0);
  }

  void drop(Eigen::Index i) {
    const Eigen::Index last = points.cols() - 1;
    points.col(i) = points.col(last);
    weights(i) = weights(last);
    points.conservativeResize(6, last);
    weights.conservativeResize(last);
  }

  /// Wolfe's minor cycle: finds the nearest point of the hull and drops points with weight 0.
  void settle() {
    for (;;) {
      // The nearest point of the affine hull is the answer if it lies in the convex hull.
      const Eigen::VectorXd wanted = affine_weights(points);
      if (wanted.minCoeff() >= 0) {
        weights = wanted;
        return;
      }
      // Otherwise go towards it until the first weight is 0, and drop that point.
      double step = 1;
      Eigen::Index leaving = 0;
      for (Eigen::Index i = 0; i < wanted.size(); ++i) {
        if (wanted(i) >= 0) continue;
        const double to_zero = weights(i) / (weights(i) - wanted(i));
        if (to_zero <= step) {
          step = to_zero;
          leaving = i;
        }
      }
      weights += step * (wanted - weights);
      drop(leaving);
    }
  }
};

}  // namespace

MinNorm min_norm(const SupportFunction& support, double gap) {
  // Start from any support point.
  const WrenchCoordinates start = WrenchCoordinates::Constant(1 / std::sqrt(6.0));
  MinNorm out{support(start).p, start, kInfinity, 1};
  Corral corral;
  corral.add(out.x);
  corral.weights(0) = 1;
  WrenchCoordinates x = out.x;
  while (out.supports < kMaxSupports) {
    end_if_stopped();
    const double length = x.norm();
    if (length < out.x.norm()) out.x = x;
    // x is 0 to rounding: the set contains the origin.
    if (length <= kZeroRatio * support.max_norm()) break;
    // Support point against x: its plane bounds the distance from below.
    const WrenchCoordinates u = -x / length;
    const SupportPoint reach = support(u);
    ++out.supports;
    if (reach.h < out.support) {
      out.support = reach.h;
      out.direction = u;
    }
    // Stop if both bounds agree, or rounding prevents progress.
    if (out.x.norm() + out.support <= std::max(gap, support.rounding())) break;
    if (length + reach.h <= support.rounding()) break;  // no progress left
    // Major cycle: add the point, then find the nearest point again.
    corral.add(reach.p);
    corral.settle();
    x = corral.points * corral.weights;
  }
  return out;
}

}  // namespace thenar::internal
