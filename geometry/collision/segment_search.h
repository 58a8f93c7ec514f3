#pragma once

/// Bounds of the distance of a segment from a shape, searched along the segment.

#include "geometry/collision/distance_record.h"

namespace thenar::internal {

/// Bounds a segment beside a convex part of B by planes of B from both sides (ConvexBracket).
/// Returns the bound [m], kNoBound if a plane does not support B.
[[nodiscard]] double bound_by_planes(const TrianglePiece& piece, DistanceRecord& record);

/// Returns true if bound_by_balls() has an answer for segments outside of B: all of A counts, and
/// distances of B are exact.
[[nodiscard]] bool has_ball_bounds(const DistanceRecord& record);

/// Bounds a segment outside B by empty balls about its points (BallPair), placed where the bound is
/// least until it is enough: nothing between the balls is nearer. Returns the bound of the segment
/// [m], kNoBound if it goes into B or has_ball_bounds() is false.
[[nodiscard]] double bound_by_balls(const TrianglePiece& piece, DistanceRecord& record);

}  // namespace thenar::internal
