#pragma once

/// Course of a band, for tables and pictures.

#include <vector>

#include "tendons/net/solve_net.h"

namespace thenar {

inline constexpr double kTaut = 1e-6;  // Bands with less tension are called slack [N]

/// A band at equilibrium.
struct BandCourse {
  bool bent;                            // lies on the bone that it bends over
  std::vector<Eigen::Vector3d> points;  // from end to end; along the bone in small steps [m]
};

/// @param state  links, of the posture at which the net rests
[[nodiscard]] BandCourse band_course(const Net& net, const TreeState<double>& state,
                                     const NetEquilibrium& rest, int band);

}  // namespace thenar
