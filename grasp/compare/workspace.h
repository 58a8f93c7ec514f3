#pragma once

/// Workspaces of the digits of a hand.

#include <random>

#include "grasp/compare/comparison.h"

namespace thenar {

/// Workspaces of the tips: postures are sampled and the tips counted in voxels of a grid. The
/// workspace of a tip that moves in fewer than three dimensions (principal extent below two voxels,
/// or fewer coordinates that move it) is measured in these dimensions only. The estimate is the
/// number of occupied voxels less half of those at the boundary (with an empty neighbour), +- that
/// half. Of voxels of 1/4, 1/2, 1, 2 and 4 times `voxel`, the size with the smallest relative error
/// is used for each tip: large voxels have a thick boundary, small ones holes.
struct Workspaces {
  std::vector<DigitAbility> digits;  // abilities of the digits, without forces
  double overlap = 0;  // overlap of the thumb's (or first digit's) workspace with all others, in
                       // voxels of 2 `voxel` [m^3]; NaN: fewer than two tips fill a volume
};

/// Measures the workspaces of all tips.
/// @param draws  number of postures;  @param voxel  edge [m]
[[nodiscard]] Workspaces measure_workspaces(const Hand& hand, int draws, double voxel,
                                            std::mt19937& random, const Progress& progress = {});

}  // namespace thenar
