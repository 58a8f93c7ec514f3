#pragma once

/// Bounds of a segment's distance from a solid whose distance is known at both ends.

namespace thenar {

/// Balls without a point of the solid, about two points of a line.
///
/// Outside a solid d(x)^2 - |x|^2 is the least of linear functions,  |s|^2 - 2 x.s  over its points
/// s, hence concave: between two points it is nowhere less than in between, so that
///   d(t)^2 >= d_from^2 + s ((d_to^2 - d_from^2) / way + s - way),  s = t - from,  way = to - from.
/// Of equal balls that is  d^2 - way^2 / 4  in the middle: a loss of  way^2 / 8 d  only, nearly.
struct BallPair {
  double from, to;      // where on the line, from < to [m]
  double d_from, d_to;  // distances of the solid from there, exact; > 0 [m]

  /// Returns the place between `from` and `to` at which the bound is least [m].
  [[nodiscard]] double narrowest() const;

  /// Returns the bound at narrowest(): nothing of the solid is nearer to the segment [m]. It is
  /// negative where the balls do not meet, and then the least value of distances that change by no
  /// more than the way.
  [[nodiscard]] double least() const;
};

// Least value of a convex function on an interval, bracketed from both sides.

/// A convex function at one place.
struct Tangent {
  double t;      // where [m]
  double value;  // [m]
  double slope;  // [1]
};

/// Bracket of the minimum of a convex function by tangents on either side. The function is nowhere
/// below both tangents.
class ConvexBracket {
 public:
  /// Brackets the minimum on [low, high]. @param first  a tangent within
  ConvexBracket(double low, double high, const Tangent& first);

  /// Adds another tangent, at next().
  void add(const Tangent& tangent);

  /// Returns a lower bound of the function [m].
  [[nodiscard]] double lower() const;

  /// Returns the next place to evaluate: where the slope vanishes if it changes evenly; where the
  /// tangents meet if evaluations keep falling on the same side; while only one side is known, a
  /// step that grows, up to the end of the interval.
  /// @param step  way to go while there is but one side, a guess > 0 [m]
  [[nodiscard]] double next(double step) const;

 private:
  [[nodiscard]] bool closed() const { return seen_low_ && seen_high_; }
  [[nodiscard]] double meeting() const;

  Tangent low_, high_;  // the function falls at low, rises at high; those not seen are ends
  bool seen_low_ = false, seen_high_ = false;
  int same_side_ = 0;  // how often in turn the side of the last one
  bool last_low_ = false;
};

/// Finds the place in [0, 1] at which a convex function is least, to `tolerance` of its value, by
/// tangents from both sides.
/// @param tangent  its value and slope at a place, as a Tangent
template <typename Function>
[[nodiscard]] double least_place(const Function& tangent, double tolerance) {
  Tangent best = tangent(0.0);
  if (best.slope >= 0) return 0;
  const Tangent high = tangent(1.0);
  if (high.slope <= 0) return 1;
  ConvexBracket bracket(0, 1, best);
  bracket.add(high);
  if (high.value < best.value) best = high;
  for (int i = 0; i < 60 && best.value - bracket.lower() >= tolerance; ++i) {
    const Tangent next = tangent(bracket.next(0.5));
    if (next.value < best.value) best = next;
    if (next.slope == 0) break;
    bracket.add(next);
  }
  return best.t;
}

}  // namespace thenar
