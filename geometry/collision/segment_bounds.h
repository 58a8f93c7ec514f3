#pragma once

/// Bounds of a segment's distance from a solid whose distance is known at both ends.

namespace thenar {

/// Empty balls about two points of a line, which hold no part of a solid.
///
/// Outside a solid d(x)^2 - |x|^2 is the minimum of linear functions,  |s|^2 - 2 x.s  over its
/// points s, hence concave. Between two points of a line therefore
///   d(t)^2 >= d_from^2 + s ((d_to^2 - d_from^2) / way + s - way),  s = t - from,  way = to - from.
/// For equal balls this is  d^2 - way^2 / 4  in the middle: a loss of only about  way^2 / 8 d.
struct BallPair {
  double from, to;      // positions on the line, from < to [m]
  double d_from, d_to;  // exact distances of the solid at these positions, > 0 [m]

  /// Returns the position between `from` and `to` at which the bound is smallest [m].
  [[nodiscard]] double narrowest_position() const;

  /// Returns the bound at narrowest_position(): no point of the solid is nearer to the segment [m].
  /// It is negative if the balls do not meet, and then follows from a distance that changes by at
  /// most the distance moved.
  [[nodiscard]] double min_bound() const;
};

// Minimum of a convex function on an interval, bracketed from both sides.

/// Value and slope of a convex function at one position.
struct Tangent {
  double t;      // position [m]
  double value;  // [m]
  double slope;  // [1]
};

/// Bracket of the minimum of a convex function by tangents on either side. The function is nowhere
/// below both tangents.
class ConvexBracket {
 public:
  /// Brackets the minimum on [low, high]. @param first  a tangent in the interval
  ConvexBracket(double low, double high, const Tangent& first);

  /// Adds a tangent at next_position().
  void add(const Tangent& tangent);

  /// Returns a lower bound of the function [m].
  [[nodiscard]] double lower() const;

  /// Returns the position of the next evaluation: where the slope vanishes if it changes linearly;
  /// where the tangents intersect if evaluations keep falling on the same side; while only one side
  /// is known, a growing step, up to the end of the interval.
  /// @param step  step while only one side is known, > 0 [m]
  [[nodiscard]] double next_position(double step) const;

 private:
  [[nodiscard]] bool is_closed() const { return has_low_ && has_high_; }
  [[nodiscard]] double intersection() const;

  Tangent low_,
      high_;  // the function falls at low_ and rises at high_; without a tangent: the ends
  bool has_low_ = false, has_high_ = false;
  int same_side_count_ = 0;    // consecutive tangents on the side of the last one
  bool last_was_low_ = false;  // side of the last tangent
};

/// Finds the position in [0, 1] of the minimum of a convex function, to `tolerance` of its value,
/// by tangents from both sides.
/// @param tangent  function that returns the Tangent at a position
template <typename Function>
[[nodiscard]] double minimum_position(const Function& tangent, double tolerance) {
  constexpr int kMaxTangents = 60;  // maximum number of tangents
  Tangent best = tangent(0.0);
  if (best.slope >= 0) return 0;
  const Tangent high = tangent(1.0);
  if (high.slope <= 0) return 1;
  ConvexBracket bracket(0, 1, best);
  bracket.add(high);
  if (high.value < best.value) best = high;
  for (int i = 0; i < kMaxTangents && best.value - bracket.lower() >= tolerance; ++i) {
    const Tangent next = tangent(bracket.next_position(0.5));
    if (next.value < best.value) best = next;
    if (next.slope == 0) break;
    bracket.add(next);
  }
  return best.t;
}

}  // namespace thenar
