#pragma once

/// Workspaces of the digits of a hand.

#include <random>

#include "grasp/compare/comparison.h"

namespace thenar {

/// Workspaces of the tips: postures are sampled and the tips counted in voxels of a grid. A tip
/// that moves in fewer than three dimensions (principal extent below two voxels) is measured in
/// these only, and in no more than coordinates move it. The estimate is the number of voxels met
/// less half of those at the rim (with a neighbour not met), +- that half. Of voxels of 1/4, 1/2,
/// 1, 2 and 4 times `voxel`, the size with the smallest relative error serves each tip: large
/// voxels have a thick rim, small ones holes.
struct Workspaces {
  std::vector<DigitAbility> digits;  // without forces
  double overlap = 0;  // of the thumb (or first digit) with all others, voxels of 2 `voxel` [m^3];
                       // NaN: no two tips fill a volume
};

/// Measures the workspaces of all tips.
/// @param draws  number of postures;  @param voxel  edge [m]
[[nodiscard]] Workspaces workspaces(const Hand& hand, int draws, double voxel, std::mt19937& random,
                                    const Progress& progress = {});

}  // namespace thenar
