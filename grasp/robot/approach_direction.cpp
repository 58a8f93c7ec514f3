#include "grasp/robot/approach_direction.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// Shares of squared components of axes: least along the second direction of a plane, and most
// across the plane or the line that they span [1].
constexpr double kInPlane = 0.1, kOffPlane = 0.02;
constexpr double kAcrossCosine = 0.02;  // Largest cosine to a line of a direction across it [1]
constexpr double kSameFace = 3e-3;      // Directions within this angle are one [rad]
constexpr double kLeastFace = 0.05;     // Least share of a face in the area of all faces [1]
// The second direction disagrees if its area over the first's exceeds this [1]
constexpr double kAreaRatio = 0.5;
constexpr double kDirectionRounding = 1e-5;  // Rounding of directions in files [rad]
constexpr double kNoDirection = 1e-9;        // Shorter vectors have no direction [1]

/// A direction with the area of the faces that look there.
struct FacedDirection {
  Vector3d direction;  // unit (3)
  double area;         // [m^2]
};

/// Directions near the rough one that a face suggests: its normal and, across a line, its side.
std::vector<FacedDirection> suggested(const Vector3d& face, const Vector3d& rough, double cosine,
                                      const std::optional<Vector3d>& line) {
  const double area = face.norm();
  if (!(area > 0)) return {};
  std::vector<Vector3d> ways{face / area};
  if (line) {
    if (std::abs(ways[0].dot(*line)) > kAcrossCosine) return {};
    ways[0] = across(ways[0], *line);
    ways.emplace_back(ways[0].cross(*line));
  }
  std::vector<FacedDirection> near;
  for (const Vector3d& way : ways)
    if (std::abs(way.dot(rough)) >= cosine)
      near.push_back({way.dot(rough) < 0 ? Vector3d(-way) : way, area});
  return near;
}

/// Directions that are one are joined to their mean by area; the largest first.
std::vector<FacedDirection> joined(std::vector<FacedDirection> all) {
  std::stable_sort(all.begin(), all.end(), [](const FacedDirection& a, const FacedDirection& b) {
    return a.area > b.area;
  });
  std::vector<FacedDirection> groups;
  for (const FacedDirection& one : all) {
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const FacedDirection& group) {
      return group.direction.cross(one.direction).norm() < kSameFace;
    });
    if (same == groups.end()) {
      groups.push_back(one);
      continue;
    }
    same->direction = (same->area * same->direction + one.area * one.direction).normalized();
    same->area += one.area;
  }
  std::stable_sort(
      groups.begin(), groups.end(),
      [](const FacedDirection& a, const FacedDirection& b) { return a.area > b.area; });
  return groups;
}

}  // namespace

ClosingAxes find_closing_axes(const Matrix3Xd& axes) {
  if (axes.cols() == 0) return {};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(
      Eigen::Matrix3d(axes * axes.transpose()) / static_cast<double>(axes.cols()));
  const Vector3d share = spread.eigenvalues();  // ascending, of sum 1
  if (share[0] > kOffPlane) return {};
  if (share[1] > kInPlane) return {Vector3d(spread.eigenvectors().col(0)), {}};
  if (share[1] > kOffPlane) return {};
  return {{}, Vector3d(spread.eigenvectors().col(2))};
}

std::optional<Vector3d> facing_direction(const Matrix3Xd& faces, const Vector3d& rough,
                                         double cosine, const std::optional<Vector3d>& line) {
  std::vector<FacedDirection> near;
  for (Eigen::Index i = 0; i < faces.cols(); ++i)
    for (const FacedDirection& one : suggested(faces.col(i), rough, cosine, line))
      near.push_back(one);
  const std::vector<FacedDirection> groups = joined(std::move(near));
  // Faces that are large, and not contradicted.
  if (groups.empty() || groups[0].area < kLeastFace * faces.colwise().norm().sum()) return {};
  if (groups.size() > 1 && groups[1].area > kAreaRatio * groups[0].area) return {};
  return groups[0].direction;
}

Vector3d across(const Vector3d& direction, const Vector3d& line) {
  const Vector3d rest = direction - direction.dot(line) * line;
  return rest.norm() > kNoDirection ? Vector3d(rest.normalized()) : direction;
}

Vector3d without_rounding(const Vector3d& direction) {
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  const Vector3d axis = (direction[largest] < 0 ? -1 : 1) * Vector3d::Unit(largest);
  return (direction - axis).norm() < kDirectionRounding ? axis : direction;
}

}  // namespace thenar
