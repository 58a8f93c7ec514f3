#pragma once

/// Course of a band, for tables and pictures.

#include <vector>

#include "tendons/net/solve_net.h"

namespace thenar {

inline constexpr double kTautTension = 1e-6;  // Bands with less tension are called slack [N]

/// Course of a band in equilibrium.
struct BandCourse {
  bool bent = false;                    // true: it lies on the bone that it bends over
  std::vector<Eigen::Vector3d> points;  // points from end to end; along the bone in small steps [m]
};

/// Computes the course of a band.
/// @param state  pose of the links at the posture of the equilibrium
[[nodiscard]] BandCourse band_course(const Net& net, const TreeState<double>& state,
                                     const NetEquilibrium& rest, int band);

}  // namespace thenar
