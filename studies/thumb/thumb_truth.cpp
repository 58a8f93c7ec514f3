#include "studies/thumb/thumb_truth.h"

#include <cmath>

#include <Eigen/Geometry>

#include "base/error.h"
#include "base/spatial.h"

namespace thenar {

TendonDigit in_frame_of(const TendonDigit& start, const TendonDigit& digit) {
  require(start.names.hinges == digit.names.hinges, "the true thumb has {} hinges, this one {}",
          digit.names.hinges.size(), start.names.hinges.size());
  // Rotation that brings the tip's directions together.
  TendonDigit turned = digit;
  TendonModel<double>& model = turned.model;
  const Eigen::Matrix3d R = start.model.tip_axes * model.tip_axes.transpose();
  const Eigen::Vector3d from = model.tip;
  // Axes are turned about the tip and shifted with it.
  for (Hinge<double>& hinge : model.tree) {
    hinge.direction = (R * hinge.direction).normalized();
    hinge.point = start.model.tip + R * (hinge.point - from);
  }
  for (const TendonPath<double>& path : model.paths)
    require(path.empty(), "a tendon of the true thumb has a path; wanted constant arms");
  model.tip = start.model.tip;
  model.tip_axes = start.model.tip_axes;
  return turned;
}

std::optional<double> true_value(const Parameter& parameter, const TendonDigit& start,
                                 const TendonDigit& truth) {
  // Arms are values; axes have two tilts and two shifts.
  if (parameter.kind == ParameterKind::kArm)
    return truth.model.constant_arms(parameter.item, parameter.component);
  const bool tilts = parameter.kind == ParameterKind::kAxisDirection;
  if (!tilts && (parameter.kind != ParameterKind::kAxisPoint || parameter.component > 1))
    return std::nullopt;
  // The true axis in the chart of the start's tangents.
  const auto item = static_cast<std::size_t>(parameter.item);
  const Hinge<double>&from = start.model.tree.at(item), &to = truth.model.tree.at(item);
  const Tangents tangent = tangents(from.direction);
  const Eigen::Vector3d e = parameter.component == 0 ? tangent.e1 : tangent.e2;
  const double along = from.direction.dot(to.direction);
  require(std::abs(along) > 1e-9, "the true axis of hinge {} is square to the one at the start",
          item);
  if (tilts) return e.dot(to.direction) / along;
  const Eigen::Vector3d apart = to.point - from.point;
  return e.dot(apart - from.direction.dot(apart) / along * to.direction);
}

}  // namespace thenar
