#pragma once

/// How near a segment can be to a solid whose distance is known at both its ends.

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

}  // namespace thenar
