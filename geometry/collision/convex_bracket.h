#pragma once

/// The least of a convex function on an interval, closed in from both sides.

namespace thenar {

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

}  // namespace thenar
