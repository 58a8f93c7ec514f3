#include "api/pads/press_object.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/error.h"
#include "base/file_io.h"
#include "base/nearest_name.h"
#include "base/units.h"
#include "data/io/mesh/mesh_file.h"
#include "geometry/primitives.h"
#include "geometry/rounded_shape.h"
#include "geometry/shape_union.h"
#include "geometry/solid.h"
#include "geometry/tessellate.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kEndlessLength = 1;    // Length of an object without an end [m]
constexpr double kUsualRadius = 10e-3;  // Radius of sphere and cylinder without a stated one [m]
constexpr double kEdgeRadius = 0.5e-3;  // Radius of an edge without a stated one [m]
// Largest angle of a pad; beyond, the nail's rim touches [deg]
constexpr double kSteepestPress = 60;
constexpr int kSkinSamples = 50;        // Samples of the skin along a radius of the chart's disc
constexpr double kTouchingGap = 1e-9;   // Gap below which object and pad touch [m]
constexpr int kMaxMarches = 2000;       // largest number of steps of a search for the touch
constexpr double kPictureError = 5e-5;  // Largest error of the picture of a rounded edge [m]

TriangleMesh placed(TriangleMesh mesh, const Pose<double>& X) {
  mesh.vertices = (X.R * mesh.vertices).colwise() + X.p;
  return mesh;
}

TriangleMesh picture_of(ShapeKind kind, const Vector3d& size) {
  ShapeSpec spec;
  spec.kind = kind;
  spec.size = size;
  return build_solid({spec}).visual;
}

Pose<double> below(double depth, const Eigen::Matrix3d& R = Eigen::Matrix3d::Identity()) {
  return {R, {0, 0, -depth}};
}

PressObject open_plane(double size) {
  const double plate = 0.1 * size;
  return {
      "plane",
      place(build_box({kEndlessLength, kEndlessLength, kEndlessLength}), below(kEndlessLength / 2)),
      placed(box_mesh({2 * size, 2 * size, plate}), below(plate / 2)),
      {}};
}

PressObject open_sphere(double radius) {
  return {fmt::format("sphere of {:g} mm", radius / kMm),
          place(build_sphere(radius), below(radius)),
          placed(picture_of(ShapeKind::kSphere, {radius, 0, 0}), below(radius)),
          {}};
}

PressObject open_cylinder(double radius, double size) {
  const Eigen::Matrix3d along_y = rotation_about<double>({1, 0, 0}, -kPi / 2);
  return {fmt::format("cylinder of {:g} mm", radius / kMm),
          place(build_cylinder(radius, kEndlessLength), below(radius, along_y)),
          placed(picture_of(ShapeKind::kCylinder, {radius, 2 * size, 0}), below(radius, along_y)),
          {}};
}

/// Two faces at right angles, 45 degrees to either side of the ridge, which is rounded.
PressObject open_edge(double radius, double size) {
  const Eigen::Matrix3d on_edge = rotation_about<double>({0, 1, 0}, kPi / 4);
  const auto wedge = [&](double edge) { return below(radius + edge * std::sqrt(0.5), on_edge); };
  // The contact geometry is a box that never ends; the picture shows a piece of it.
  const double seen = 0.5 * size;
  return {
      fmt::format("edge of {:g} mm", radius / kMm),
      place(build_rounded(build_box({kEndlessLength, kEndlessLength, kEndlessLength}), radius),
            wedge(kEndlessLength)),
      placed(tessellate(*build_rounded(build_box({seen, 2 * size, seen}), radius), kPictureError),
             wedge(seen)),
      {}};
}

PressObject open_mesh(const PressObjectRequest& request) {
  require_field("scale", request.scale > 0 && std::isfinite(request.scale),
                "wanted a mesh's scale above 0 m per unit, got {}", request.scale);
  // Place the mesh so that its highest point touches the origin, midway between its sides.
  ShapeSpec spec;
  spec.kind = ShapeKind::kMesh;
  spec.mesh = read_mesh(request.name, request.scale);
  const Vector3d low = spec.mesh.vertices.rowwise().minCoeff();
  const Vector3d high = spec.mesh.vertices.rowwise().maxCoeff();
  spec.X_BS.p = -Vector3d((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, high[2]);
  const Solid solid = build_solid({spec});
  return {request.name, solid.shape, solid.visual, digests_of({request.name})};
}

double radius_of(const PressObjectRequest& request, double usual) {
  const double radius = request.radius.value_or(usual);
  require_field("radius", radius > 0 && radius <= kEndlessLength,
                "wanted a radius above 0, of at most {:g} m, got {:g} m", kEndlessLength, radius);
  return radius;
}

/// Points of the skin all over the chart's disc.
std::vector<Vector3d> sampled_skin(const PadShape& shape) {
  const PadChart chart(shape);
  std::vector<Vector3d> points;
  for (int i = -kSkinSamples; i <= kSkinSamples; ++i)
    for (int j = -kSkinSamples; j <= kSkinSamples; ++j) {
      const double a = static_cast<double>(i) / kSkinSamples,
                   b = static_cast<double>(j) / kSkinSamples;
      if (std::hypot(a, b) <= 1) points.push_back(chart.place({a, b, 1}));
    }
  return points;
}

/// Least way along which the object's surface meets one of the points [m].
double way_to_touch(const std::vector<Vector3d>& points, const Shape& object,
                    const Pose<double>& X_PO, const Vector3d& along) {
  // Sphere tracing: each march goes as far as is safe in every direction.
  Pose<double> X = X_PO;
  double way = 0;
  for (int k = 0; k < kMaxMarches; ++k) {
    // No point is nearer than the smallest gap: so far the object may go.
    const Pose<double> X_OP = X.inverse();
    double gap = std::numeric_limits<double>::infinity();
    for (const Vector3d& p : points) gap = std::min(gap, object.distance(X_OP * p));
    if (gap < kTouchingGap) return way;
    way += gap;
    X.p += gap * along;
    // An object that leaves the pad behind would march on for ever.
    require(way < kEndlessLength, "the object passes the pad by");
  }
  throw InputError("the object grazes the pad, and does not come to touch it");
}

}  // namespace

const std::vector<std::string>& press_object_names() {
  static const std::vector<std::string> names{"plane", "sphere", "cylinder", "edge"};
  return names;
}

PressObject open_press_object(const PressObjectRequest& request, double size) {
  if (request.name == "sphere") return open_sphere(radius_of(request, kUsualRadius));
  if (request.name == "cylinder") return open_cylinder(radius_of(request, kUsualRadius), size);
  if (request.name == "edge") return open_edge(radius_of(request, kEdgeRadius), size);
  require_field("radius", !request.radius, "an object '{}' has no radius", request.name);
  if (request.name == "plane") return open_plane(size);
  const std::string meant = did_you_mean(request.name, press_object_names());
  require_field("object", is_file(request.name), "there is no object '{}'{} {}, or a mesh file",
                request.name, meant.empty() ? ": wanted" : meant + " Wanted",
                listed(press_object_names()));
  return open_mesh(request);
}

PadTouch touch_pad(const PadShape& shape, const Shape& object, double angle, double turn) {
  // Beyond this angle the object meets the rim of the nail before the skin.
  require_field("angle", std::abs(angle) <= radians(kSteepestPress),
                "wanted an angle of the pad within {:g} deg either way, got {:g} deg",
                kSteepestPress, degrees(angle));
  require_field("turn", std::isfinite(turn), "wanted a finite turn of the object, got {} rad",
                turn);
  PadTouch touch;
  touch.along = -Vector3d(std::sin(angle), 0, std::cos(angle));
  // The object's z goes into the pad, its y across the finger before the turn.
  Eigen::Matrix3d R;
  R.col(2) = touch.along;
  R.col(1) = Vector3d::UnitY();
  R.col(0) = R.col(1).cross(R.col(2));
  touch.X_PO.R = R * rotation_about<double>({0, 0, 1}, turn);
  // Start from the point of the skin that is farthest against the motion.
  const std::vector<Vector3d> skin = sampled_skin(shape);
  touch.X_PO.p = *std::min_element(skin.begin(), skin.end(), [&](const auto& p, const auto& q) {
    return p.dot(touch.along) < q.dot(touch.along);
  });
  touch.X_PO.p -= 1e-6 * touch.along;
  touch.X_PO.p += way_to_touch(skin, object, touch.X_PO, touch.along) * touch.along;
  return touch;
}

}  // namespace thenar
