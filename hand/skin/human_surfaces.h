#pragma once

/// Contact surfaces of a human hand: skin, or the bones within it.

#include <map>
#include <string>
#include <vector>

#include "base/progress.h"
#include "geometry/triangle_mesh.h"
#include "hand/hand.h"
#include "hand/skeleton.h"
#include "hand/skin/implicit_body.h"

namespace thenar {

/// Resolution of the skin, and meshes that replace it.
struct SkinOptions {
  int triangles = 800;  // largest number of triangles of each link; twice as many for the palm
  int drawn = 0;  // largest number of triangles of each link's picture, likewise: 2500 look smooth,
                  // at no cost in distance queries; 0: the contact mesh is drawn
  bool capsules = false;  // true: each link of a digit is the tapered capsule nearest to its skin,
                          // which has no edges; the palm stays a mesh
  std::string material = "skin";            // see Materials
  std::map<std::string, TriangleMesh> own;  // segment -> its surface in the subject's reference
                                            // posture, as segmented from CT or MRI [m]
  Progress progress;                        // reports every segment
};

/// Builds the watertight skin of every segment that the skeleton keeps, in the hand's frame at the
/// reference posture: skin_bodies() as triangles, or the user's own meshes.
/// @throws InputError as find_anatomy(); for an own mesh of a segment that does not exist, or
/// naming the segment whose mesh is not watertight.
[[nodiscard]] std::vector<LinkSurface> human_surfaces(const Subject& subject,
                                                      const Skeleton& skeleton,
                                                      const SkinOptions& options = {});

/// Distance between the skin and the capsules that replace it, over all links [m].
struct SkinError {
  double largest = 0, rms = 0;  // distances at the corners of the skin's triangles
  std::string worst;            // link with the largest distance; empty: no skin is a capsule
};

/// Computes the distance between skin and capsules.
/// @param surfaces  from human_surfaces(); their pictures are the skin
[[nodiscard]] SkinError capsule_error(const std::vector<LinkSurface>& surfaces);

/// Meshes the skin of one body, with `triangles` at most. @throws InputError below 100.
[[nodiscard]] TriangleMesh skin_mesh(const ImplicitBody& body, int triangles);

/// Builds the bones of every segment, of material "bone": shafts of 0.45 of the flesh's radius that
/// widen to two condyles at the distal end and one base at the proximal, 0.6 of it. These ratios
/// are assumptions, chosen by eye. Bones of the palm run from the carpus to the knuckles. The bone
/// of a fingertip ends in a tuft two thirds of its radius before the skin.
[[nodiscard]] std::vector<LinkSurface> bone_surfaces(const Subject& subject,
                                                     const Skeleton& skeleton);

}  // namespace thenar
