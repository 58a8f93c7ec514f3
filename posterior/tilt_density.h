#pragma once

/// Prior density of an axis direction in terms of its two tilts.

#include <Eigen/Core>

#include "base/random_stream.h"

namespace thenar {

/// Log density of tilts t and its derivatives.
struct TiltDensity {
  double log_density = 0;           // [1]
  Eigen::Vector2d by_tilt;          // derivative by the tilt [1/rad] (2)
  Eigen::Vector2d by_centre;        // derivative by the centre [1/rad] (2)
  double by_log_concentration = 0;  // derivative by the logarithm of the concentration [1]
};

/// Computes the von Mises-Fisher density of a direction d(t) = (d0 + t_1 e1 + t_2 e2) / sqrt(1 +
/// |t|^2) about d(c), over the hemisphere covered by the gnomonic chart:
///   p(t) = k / (2 pi (1 - exp(-k))) exp(k (d(t).d(c) - 1)) (1 + |t|^2)^(-3/2),
/// where the last factor is the solid angle of dt. It integrates to one for c = 0, and to one
/// within exp(-k) for other centres.
/// @param concentration  k > 0, 1 / variance for small tilts [1/rad^2]
/// Source: [Mardia2000], section 9.3.2.
[[nodiscard]] TiltDensity tilt_density(const Eigen::Vector2d& tilt, const Eigen::Vector2d& centre,
                                       double concentration);

/// Draws tilts from this density [rad] (2).
[[nodiscard]] Eigen::Vector2d draw_tilt(const Eigen::Vector2d& centre, double concentration,
                                        RandomStream& random);

}  // namespace thenar
