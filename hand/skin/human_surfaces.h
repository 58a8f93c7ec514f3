#pragma once

/// Surfaces of a human hand that can touch: skin, or the bones within it.

#include <map>
#include <string>
#include <vector>

#include "base/progress.h"
#include "geometry/triangle_mesh.h"
#include "hand/hand.h"
#include "hand/skeleton.h"
#include "hand/skin/implicit_body.h"

namespace thenar {

/// Resolution of the skin, and meshes to use instead.
struct SkinOptions {
  int triangles = 800;            // of each link, at most, of the palm twice as many
  int drawn = 0;                  // of its picture, likewise: 2500 look smooth, and take no time
                                  // where distances are asked; 0: what touches is drawn
  bool capsules = false;          // of digits each link is the tapered capsule nearest to its skin,
                                  // which has no edges for contacts to pass; the palm stays
  std::string material = "skin";  // see Materials
  std::map<std::string, TriangleMesh> own;  // segment -> its surface in the subject's reference
                                            // posture, as segmented from CT or MRI [m]
  Progress progress;                        // hears of every segment
};

/// Watertight skin of every segment that the skeleton keeps, in the hand's frame at the reference
/// posture: skin_bodies() as triangles, or the user's own meshes.
/// @throws InputError as find_anatomy(); for an own mesh of a segment that is not there, or naming
/// the segment whose mesh leaks.
[[nodiscard]] std::vector<LinkSurface> human_surfaces(const Subject& subject,
                                                      const Skeleton& skeleton,
                                                      const SkinOptions& options = {});

/// Distance between the skin and the capsules in its place, over all links [m].
struct SkinError {
  double largest = 0, rms = 0;  // of the corners of the skin's triangles
  std::string worst;            // the link of the largest; empty: no skin is a capsule
};

/// @param surfaces  as human_surfaces() makes them; their pictures are the skin
[[nodiscard]] SkinError capsule_error(const std::vector<LinkSurface>& surfaces);

/// The skin of one body as triangles, `triangles` at most. @throws InputError below 100.
[[nodiscard]] TriangleMesh skin_mesh(const ImplicitBody& body, int triangles);

/// Bones of every segment, of material "bone": shafts of 0.45 of the flesh's radius that swell to
/// two condyles at the distal end and one base at the proximal, 0.6 of it: priors, chosen by eye.
/// Those of the palm run from the carpus to the knuckles. A fingertip's ends in a tuft two thirds
/// of its radius before the skin.
[[nodiscard]] std::vector<LinkSurface> bone_surfaces(const Subject& subject,
                                                     const Skeleton& skeleton);

}  // namespace thenar
