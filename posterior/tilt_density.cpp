#include "posterior/tilt_density.h"

#include <cmath>

#include <Eigen/Geometry>

#include "base/units.h"

namespace thenar {

TiltDensity tilt_density(const Eigen::Vector2d& tilt, const Eigen::Vector2d& centre,
                         double concentration) {
  const double k = concentration, outside = std::exp(-k);
  const double w = 1 + tilt.squaredNorm(), w_c = 1 + centre.squaredNorm();
  const double root = std::sqrt(w * w_c), dot = 1 + tilt.dot(centre);

  // 1 - cos of the small angle between both, by Lagrange's identity.
  const double cross = tilt.x() * centre.y() - tilt.y() * centre.x();
  const double away = ((tilt - centre).squaredNorm() + cross * cross) / (root * (root + dot));

  // Log density with the solid angle of the chart, and its derivatives.
  TiltDensity out;
  out.log_density = std::log(k / (2 * kPi)) - std::log1p(-outside) - k * away - 1.5 * std::log(w);
  out.by_tilt = k / root * (centre - dot / w * tilt) - 3 / w * tilt;
  out.by_centre = k / root * (tilt - dot / w_c * centre);
  out.by_log_concentration = 1 - k * outside / (1 - outside) - k * away;
  return out;
}

Eigen::Vector2d draw_tilt(const Eigen::Vector2d& centre, double concentration,
                          RandomStream& random) {
  const Eigen::Vector3d mean = Eigen::Vector3d(1, centre.x(), centre.y()).normalized();
  const Eigen::Vector3d across = mean.unitOrthogonal();
  for (;;) {
    // Draw the height along the mean direction by its inverse distribution.
    const double spread = -std::expm1(-concentration);
    const double height = 1 + std::log1p(-random.uniform() * spread) / concentration;
    const double turn = 2 * kPi * random.uniform();
    const Eigen::Vector3d aside = std::cos(turn) * across + std::sin(turn) * mean.cross(across);
    const Eigen::Vector3d d = height * mean + std::sqrt(std::max(0.0, 1 - height * height)) * aside;
    if (d.x() > 0) return {d.y() / d.x(), d.z() / d.x()};  // otherwise beyond the chart: draw again
  }
}

}  // namespace thenar
