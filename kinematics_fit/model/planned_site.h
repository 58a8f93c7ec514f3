#pragma once

/// Place of a load cell on a digit.

#include <vector>

#include <Eigen/Core>

#include "data/io/experiment.h"

namespace thenar {

/// A ForceSite with its names resolved.
struct PlannedSite {
  int link;                   // that the cell holds; -1: the mount on which the digit stands
  Eigen::Vector3d point;      // where, at the reference posture; unused of a mount [m] (3)
  int axes_link;              // link whose directions the components use; -1: the base
  TendonExit leave;           // of a mount
  std::vector<int> balanced;  // coordinates that move the held link
};

}  // namespace thenar
