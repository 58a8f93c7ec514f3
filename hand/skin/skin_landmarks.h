#pragma once

/// Landmarks of the skin: pads, nails, and the targets of thumb opposition.

#include <string>
#include <vector>

#include "hand/skeleton.h"
#include "hand/skin/hand_anatomy.h"
#include "hand/skin/skin_body.h"

namespace thenar {

/// Point of the skin, at the reference posture in the hand's frame.
struct SkinLandmark {
  std::string digit;  // empty: palm
  std::string segment;
  int link = -1;            // link of the skeleton
  Eigen::Vector3d p;        // position [m] (3)
  Eigen::Vector3d outward;  // unit outward normal of the skin (3)
};

/// Part of a fingertip.
enum class PatchKind { kPad, kNail };

/// Oval patch of the skin of a fingertip.
struct SkinPatch {
  PatchKind kind;
  SkinLandmark middle;
  Eigen::Vector3d along;  // unit direction towards the tip (3)
  double half_length;     // half length along that direction [m]
  double half_breadth;    // half breadth across it [m]
};

/// Builds pad and nail of every digit that the skeleton keeps. The centre of the pad is four tenths
/// of the distal phalanx before the tip, with a half length of a third of it; that of the nail
/// three tenths before the tip, with a half length of a quarter; breadths are in proportion to the
/// fingertip. These ratios are assumptions, chosen by eye.
[[nodiscard]] std::vector<SkinPatch> skin_patches(const HandAnatomy& hand,
                                                  const Skeleton& skeleton);

/// Returns whether a point of the link's skin lies on a patch. @param p  reference posture [m] (3)
[[nodiscard]] bool on_patch(const SkinPatch& patch, const Eigen::Vector3d& p);

/// Returns the point of a digit's pad that meets objects, from patches.
/// @throws InputError if there is none.
[[nodiscard]] const SkinLandmark& pad_of(const std::vector<SkinPatch>& patches,
                                         const std::string& digit);

/// Returns the direction in which the pad of a digit faces, across the bone of its segment: unit,
/// at the reference posture in the hand's frame (3).
/// @throws InputError if the skeleton keeps no pad of it.
[[nodiscard]] Eigen::Vector3d pad_normal(const Subject& subject, const Skeleton& skeleton,
                                         const std::string& digit);

/// Landmark that the tip of the thumb should reach.
struct OppositionTarget {
  int score;         // 1 .. 10, the score for reaching it
  std::string name;  // "tip of the ring finger"
  SkinLandmark mark;
};

/// Builds the ten landmarks of Kapandji's opposition score, for those digits that the skeleton
/// keeps:
///   1, 2   radial side of the index finger's proximal and middle phalanx
///   3 - 6  tips of index, middle, ring and little finger
///   7 - 9  creases of the little finger over the DIP, PIP and MCP joints
///   10     the distal crease of the palm below the little finger
/// A score of 0 means none of them. Source: [Kapandji1986].
[[nodiscard]] std::vector<OppositionTarget> kapandji_targets(const HandAnatomy& hand,
                                                             const Skeleton& skeleton);

}  // namespace thenar
