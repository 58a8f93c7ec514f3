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

  /// Where between them the bound is least [m].
  [[nodiscard]] double narrowest() const;

  /// The bound there: nothing of the solid is nearer to the segment; negative where the balls do
  /// not meet, and then the least that distances can be that change by no more than the way [m].
  [[nodiscard]] double least() const;
};

// Least value of a convex function on an interval, bracketed from both sides.

/// A convex function at one place.
struct Tangent {
  double t;      // where [m]
  double value;  // [m]
  double slope;  // [1]
};

/// Knows a convex function by its tangents on either side of its least: nowhere is it below both.
class ConvexBracket {
 public:
  /// On [low, high]. @param first  a tangent within
  ConvexBracket(double low, double high, const Tangent& first);

  /// Takes notice of another tangent, at next().
  void add(const Tangent& tangent);

  /// The function is nowhere less.
  [[nodiscard]] double lower() const;

  /// Where to look next: where the slope vanishes if it changes evenly; where the tangents meet if
  /// that keeps falling to the same side; the end, beyond steps that grow, while there is but one.
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

/// Where a convex function is least on [0, 1], to `tolerance` of its value, by tangents from both
/// sides.
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
