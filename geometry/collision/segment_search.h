#pragma once

/// Lower bounds of the distance of a segment from a shape, by a search along the segment.

#include "geometry/collision/distance_record.h"

namespace thenar::internal {

/// Bounds a segment beside a convex part of B by planes of B from both sides (ConvexBracket).
/// Returns the bound [m], kNoBound if a plane does not support B.
[[nodiscard]] double bound_by_planes(const TrianglePiece& piece, DistanceRecord& record);

/// Returns whether bound_by_balls() can bound segments outside of B: the search covers all of A,
/// and distances of B are exact.
[[nodiscard]] bool has_ball_bounds(const DistanceRecord& record);

/// Bounds a segment outside B by empty balls about its points (BallPair), which are placed where
/// the bound is smallest until it suffices. Returns the bound of the segment [m], kNoBound if it
/// enters B or has_ball_bounds() is false.
[[nodiscard]] double bound_by_balls(const TrianglePiece& piece, DistanceRecord& record);

}  // namespace thenar::internal
