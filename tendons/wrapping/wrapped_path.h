#pragma once

/// Tendon paths as points fixed in bones with surfaces between them, the input of PathSolver.

#include <string>
#include <vector>

#include "hand/skeleton.h"
#include "tendons/wrapping/bone_surface.h"

namespace thenar {

/// Point that a tendon runs through.
struct WrapPoint {
  int link = -1;               // link that carries it; -1: the base
  Eigen::Vector3d p{0, 0, 0};  // position at the reference posture [m] (3)
};

/// Surface that a tendon may bend over.
struct PathWrap {
  int surface = 0;         // index in PathSet::surfaces
  Eigen::Vector3d side_S;  // point that defines the side of the surface on which the tendon passes,
                           // frame S [m] (3)
};

/// Path of one strand, from insertion to origin.
struct WrappedPath {
  std::string name;
  std::vector<WrapPoint> points;  // at least two; none if the strand crosses no kept joint
  std::vector<std::vector<PathWrap>> bends;  // surfaces between points k and k + 1 (points - 1)
  int carrier = -1;  // path that the origin rides on; -1: the origin is fixed
  double ride = 0;   // distance of that origin from the carrier's insertion, along it [m]
};

/// Strands of a skeleton with the surfaces that they meet. Carriers precede their riders.
struct PathSet {
  std::vector<BoneSurface> surfaces;
  std::vector<WrappedPath> paths;
};

/// Returns the subject's surfaces on the kept links, in file order.
[[nodiscard]] std::vector<BoneSurface> place_surfaces(const Subject& subject,
                                                      const Skeleton& skeleton);

/// Builds the paths of all strands that cross a joint of the skeleton, in file order.
/// @throws InputError if a point next to a surface lies inside it (naming strand, point, surface
/// and depth) or can go round the far side of a cylinder within its joints' ranges, a run has more
/// than kMaxWraps surfaces or no length across a joint, or an origin rides on a strand that is
/// absent or farther than 1 mm off.
[[nodiscard]] PathSet build_paths(const Subject& subject, const Skeleton& skeleton);

/// Builds the paths of the named strands and of the strands on which they ride.
[[nodiscard]] PathSet build_paths(const Subject& subject, const Skeleton& skeleton,
                                  const std::vector<std::string>& strands);

}  // namespace thenar
