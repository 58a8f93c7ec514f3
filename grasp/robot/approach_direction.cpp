#include "grasp/robot/approach_direction.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "base/lists.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// Fractions of squared axis components: minimum along the second direction of a plane, and maximum
// off the plane or the line that they span [1].
constexpr double kMinInPlaneFraction = 0.1, kMaxOffPlaneFraction = 0.02;
constexpr double kMaxCosineToLine = 0.02;  // cosine up to which a face is parallel to a line [1]
constexpr double kSameFaceAngle = 3e-3;    // angle up to which two directions are merged [rad]
constexpr double kMinFaceFraction = 0.05;  // minimum area of a face over the area of all faces [1]
// Area of the second direction over the first's above which the two contradict [1]
constexpr double kMaxAreaRatio = 0.5;
constexpr double kDirectionRounding = 1e-5;  // rounding error of directions in files [rad]
constexpr double kMinDirectionNorm = 1e-9;   // norm below which a vector has no direction [1]

/// A direction with the area of the faces oriented along it.
struct FacedDirection {
  Vector3d direction;  // unit (3)
  double area;         // [m^2]
};

/// Returns directions near the rough one that a face suggests: its normal and, for a line, its
/// side.
std::vector<FacedDirection> directions_of_face(const Vector3d& face, const Vector3d& rough,
                                               double cosine, const std::optional<Vector3d>& line) {
  const double area = face.norm();
  if (!(area > 0)) return {};
  std::vector<Vector3d> directions{face / area};
  if (line) {
    if (std::abs(directions[0].dot(*line)) > kMaxCosineToLine) return {};
    directions[0] = perpendicular_direction(directions[0], *line);
    directions.emplace_back(directions[0].cross(*line));
  }
  std::vector<FacedDirection> near;
  for (const Vector3d& direction : directions)
    if (std::abs(direction.dot(rough)) >= cosine)
      near.push_back({direction.dot(rough) < 0 ? Vector3d(-direction) : direction, area});
  return near;
}

/// Merges nearly equal directions into their mean weighted by area, and sorts them by area, largest
/// first.
std::vector<FacedDirection> merge_directions(std::vector<FacedDirection> all) {
  const auto larger = [](const FacedDirection& a, const FacedDirection& b) {
    return a.area > b.area;
  };
  std::stable_sort(all.begin(), all.end(), larger);
  // Each direction joins the first group that is near enough, or starts one.
  std::vector<FacedDirection> groups;
  for (const FacedDirection& one : all) {
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const FacedDirection& group) {
      return group.direction.cross(one.direction).norm() < kSameFaceAngle;
    });
    if (same == groups.end()) {
      groups.push_back(one);
      continue;
    }
    same->direction = (same->area * same->direction + one.area * one.direction).normalized();
    same->area += one.area;
  }
  // Areas of groups have changed their order.
  std::stable_sort(groups.begin(), groups.end(), larger);
  return groups;
}

}  // namespace

ClosingAxes find_closing_axes(const Matrix3Xd& axes) {
  if (axes.cols() == 0) return {};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(
      Eigen::Matrix3d(axes * axes.transpose()) / static_cast<double>(axes.cols()));
  const Vector3d fraction = spread.eigenvalues();  // ascending, of sum 1
  if (fraction[0] > kMaxOffPlaneFraction) return {};
  if (fraction[1] > kMinInPlaneFraction) return {Vector3d(spread.eigenvectors().col(0)), {}};
  if (fraction[1] > kMaxOffPlaneFraction) return {};
  return {{}, Vector3d(spread.eigenvectors().col(2))};
}

std::optional<Vector3d> facing_direction(const Matrix3Xd& faces, const Vector3d& rough,
                                         double cosine, const std::optional<Vector3d>& line) {
  // Directions of all faces near the rough one.
  std::vector<FacedDirection> near;
  for (Eigen::Index i = 0; i < faces.cols(); ++i)
    append_all(near, directions_of_face(faces.col(i), rough, cosine, line));
  const std::vector<FacedDirection> groups = merge_directions(std::move(near));
  // The largest group must be large enough, and no other of similar area.
  if (groups.empty() || groups[0].area < kMinFaceFraction * faces.colwise().norm().sum()) return {};
  if (groups.size() > 1 && groups[1].area > kMaxAreaRatio * groups[0].area) return {};
  return groups[0].direction;
}

Vector3d perpendicular_direction(const Vector3d& direction, const Vector3d& line) {
  const Vector3d rest = direction - direction.dot(line) * line;
  return rest.norm() > kMinDirectionNorm ? Vector3d(rest.normalized()) : direction;
}

Vector3d snap_to_axis(const Vector3d& direction) {
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  const Vector3d axis = (direction[largest] < 0 ? -1 : 1) * Vector3d::Unit(largest);
  return (direction - axis).norm() < kDirectionRounding ? axis : direction;
}

}  // namespace thenar
