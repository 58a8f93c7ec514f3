#pragma once

/// Tendons as points fixed in bones and surfaces between them, ready to be solved.

#include <string>
#include <vector>

#include "hand/skeleton.h"
#include "tendons/wrapping/bone_surface.h"

namespace thenar {

/// A point that a tendon runs through.
struct WrapPoint {
  int link = -1;               // that carries it; -1: the base
  Eigen::Vector3d p{0, 0, 0};  // at the reference posture [m] (3)
};

/// A surface that a tendon bends over where it must.
struct PathWrap {
  int surface;             // of the set
  Eigen::Vector3d side_S;  // point on whose side of the surface it passes, frame S [m] (3)
};

/// The path of one strand, from insertion to origin.
struct WrappedPath {
  std::string name;
  std::vector<WrapPoint> points;             // at least two; none if it crosses no kept joint
  std::vector<std::vector<PathWrap>> bends;  // between points k and k + 1 (points - 1)
  int carrier = -1;                          // path that the origin rides on; -1: it is fixed
  double ride = 0;                           // from the carrier's insertion to that origin [m]
};

/// All strands of a skeleton with all surfaces that they meet. Carriers stand before their riders.
struct PathSet {
  std::vector<BoneSurface> surfaces;
  std::vector<WrappedPath> paths;
};

/// The subject's surfaces on the kept links, in file order; others are left out.
[[nodiscard]] std::vector<BoneSurface> place_surfaces(const Subject& subject,
                                                      const Skeleton& skeleton);

/// Paths of all strands that cross a joint of the skeleton, in file order.
/// @throws InputError if a point next to a surface lies inside it (naming strand, point, surface
/// and depth) or can go round the far side of a cylinder within its joints' ranges, a run has more
/// than kMaxWraps surfaces or no length across a joint, or an origin
/// rides on a strand that is absent or farther than 1 mm off.
[[nodiscard]] PathSet build_paths(const Subject& subject, const Skeleton& skeleton);

/// Builds the paths of the named strands and of the strands on which they ride.
[[nodiscard]] PathSet build_paths(const Subject& subject, const Skeleton& skeleton,
                                  const std::vector<std::string>& strands);

}  // namespace thenar
