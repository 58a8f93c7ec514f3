#include "tendons/net/band_course.h"

#include <cmath>

#include "base/error.h"
#include "tendons/wrapping/wrapped_string.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr int kCourseSteps = 12;  // number of pieces of a band's arc on the bone

/// Computes a point of the arc between the touch points, in the surface's frame: on a helix over
/// `side`, or a great circle. @param part  0..1
Vector3d arc_point(const BoneSurface& surface, const Vector3d& side, const WrappedString& chord,
                   double part) {
  const Vector3d &a = chord.touch_a, &b = chord.touch_b;
  if (surface.shape == SurfaceShape::kCylinder) {
    const double from = angle_from(side, a), to = angle_from(side, b);
    const double turn = part * (to - from), c = std::cos(turn), s = std::sin(turn);
    return {c * a.x() - s * a.y(), s * a.x() + c * a.y(), a.z() + part * (b.z() - a.z())};
  }
  return surface.size[0] * (a + part * (b - a)).normalized();
}

}  // namespace

BandCourse band_course(const Net& net, const TreeState<double>& state, const NetEquilibrium& rest,
                       int band) {
  // Return the ends of a straight band.
  require(band >= 0 && band < static_cast<int>(net.bands.size()), "net '{}' has no band {}",
          net.name, band);
  const NetBand& wanted = net.bands[band];
  const Vector3d a = rest.x.col(wanted.a), b = rest.x.col(wanted.b);
  if (wanted.over < 0) return {false, {a, b}};
  // Wrap the string over the bone, which it may miss.
  const BoneSurface& surface = net.surfaces[wanted.over];
  const Pose<double> X_WS = surface_pose(surface, state), X_SW = X_WS.inverse();
  const WrappedString chord = wrap_string(surface, X_SW * a, X_SW * b, wanted.side);
  if (!chord.bent) return {false, {a, b}};
  // Sample points along the arc.
  BandCourse course{true, {a}};
  for (int k = 0; k <= kCourseSteps; ++k)
    course.points.push_back(
        X_WS * arc_point(surface, wanted.side, chord, static_cast<double>(k) / kCourseSteps));
  course.points.push_back(b);
  return course;
}

}  // namespace thenar
