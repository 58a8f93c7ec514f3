#include "data/io/dh.h"

#include <cmath>

#include "base/error.h"
#include "data/io/toml_table.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// Sine of the angle below which axes count as parallel: nearer to parallel, the feet of the common
/// normal are so far away that rounding costs more than the neglected angle.
constexpr double kSameDirection = 1e-8;

/// The common normal of two lines.
struct Normal {
  Vector3d x;     // unit, perpendicular to both
  Vector3d from;  // foot on the first line  [m]
  Vector3d to;    // foot on the second line [m]
};

Vector3d project(const Vector3d& p, const AxisLine& line) {
  return line.point + line.direction * line.direction.dot(p - line.point);
}

/// Normal of parallel lines: of all perpendiculars the one at `origin`, which makes d = 0.
Normal normal_of_parallels(const AxisLine& line, const Vector3d& origin, const Vector3d& x) {
  const Vector3d to = project(origin, line);
  const double distance = (to - origin).norm();
  return {distance > 1e-12 ? Vector3d((to - origin) / distance) : x, origin, to};
}

/// @param origin  on the first line;  @param x  normal to use if the lines coincide, unit (3)
Normal common_normal(const AxisLine& first, const AxisLine& second, const Vector3d& origin,
                     const Vector3d& x) {
  const Vector3d n = first.direction.cross(second.direction);
  const double s = n.norm();
  if (s < kSameDirection) return normal_of_parallels(second, origin, x);
  // Feet of the common normal, by Cramer's rule.
  const Vector3d between = second.point - first.point;
  const double along_first = between.cross(second.direction).dot(n) / (s * s);
  const double along_second = between.cross(first.direction).dot(n) / (s * s);
  return {n / s, first.point + along_first * first.direction,
          second.point + along_second * second.direction};
}

double signed_angle(const Vector3d& from, const Vector3d& to, const Vector3d& about) {
  return std::atan2(about.dot(from.cross(to)), from.dot(to));
}

Pose<double> frame(const Vector3d& x, const Vector3d& z, const Vector3d& origin) {
  Pose<double> X;
  X.R << x, z.cross(x), z;
  X.p = origin;
  return X;
}

/// DH row from `before` (its z is the axis) over `normal` to an axis of direction `z_next`.
DhRow row_between(const Pose<double>& before, const Normal& normal, const Vector3d& z_next) {
  const Vector3d x = before.R.col(0), z = before.R.col(2);
  return {signed_angle(x, normal.x, z), z.dot(normal.from - before.p),
          normal.x.dot(normal.to - normal.from), signed_angle(z, z_next, normal.x)};
}

}  // namespace

Pose<double> dh_motion(const DhRow& row) {
  const Vector3d x = Vector3d::UnitX(), z = Vector3d::UnitZ();
  const Pose<double> about_z{rotation_about(z, row.theta), row.d * z};
  const Pose<double> about_x{rotation_about(x, row.alpha), row.a * x};
  return about_z * about_x;
}

DhRow read_dh_row(TomlTable& table) {
  return {table.number_or(Dimension::kAngle, "theta", 0),
          table.number_or(Dimension::kLength, "d", 0), table.number_or(Dimension::kLength, "a", 0),
          table.number_or(Dimension::kAngle, "alpha", 0)};
}

DhChain dh_from_axes(const std::vector<AxisLine>& axes, const Pose<double>& tip) {
  require(!axes.empty(), "a Denavit-Hartenberg table needs at least one axis, got {}", axes.size());

  // The tip is reached over a last axis, parallel to the true last one, through the tip point.
  std::vector<AxisLine> lines = axes;
  lines.push_back({tip.p, axes.back().direction});

  DhChain chain;
  // The base stands at the first common normal.
  const Normal first = common_normal(lines[0], lines[1], project(lines[1].point, lines[0]),
                                     tangents(lines[0].direction).e1);
  chain.base = frame(first.x, lines[0].direction, first.from);
  Pose<double> X = chain.base;
  // One row a joint; the last one ends at the tip point.
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const bool last = i + 1 == axes.size();
    const Vector3d origin = last ? project(tip.p, lines[i]) : Vector3d(X.p);
    const Normal normal = common_normal(lines[i], lines[i + 1], origin, X.R.col(0));
    chain.rows.push_back(row_between(X, normal, lines[i + 1].direction));
    X = frame(normal.x, lines[i + 1].direction, normal.to);
  }
  // What is left is a rotation.
  chain.tool = X.inverse() * tip;
  return chain;
}

}  // namespace thenar
