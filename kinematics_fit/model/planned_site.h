#pragma once

/// Place of a load cell on a digit.

#include <vector>

#include <Eigen/Core>

#include "data/io/experiment.h"

namespace thenar {

/// ForceSite with its names resolved to indices.
struct PlannedSite {
  int link = -1;          // link that the cell holds; -1: the mount of the digit
  Eigen::Vector3d point;  // point of the cell at the reference posture; unused for a mount [m] (3)
  int axes_link = -1;     // link whose directions the force components use; -1: the base
  TendonExit leave;       // direction of the tendons at a mount
  std::vector<int> balanced;  // coordinates that move the held link
};

}  // namespace thenar
