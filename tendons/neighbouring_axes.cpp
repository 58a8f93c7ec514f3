#include "tendons/neighbouring_axes.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace thenar {

AxisOffset axis_offset(const Hinge<double>& first, const Hinge<double>& second,
                       const Eigen::Vector3d& distal) {
  // Sine of the angle below which axes are parallel [1]
  constexpr double kParallelSine = 1e-12;
  const Eigen::Vector3d& a = first.direction;
  const Eigen::Vector3d apart = second.point - first.point, n = a.cross(second.direction);
  const double angle = std::atan2(n.norm(), std::abs(a.dot(second.direction)));
  // Compute the common normal; that of parallel axes is perpendicular to both.
  const Eigen::Vector3d normal = n.norm() < kParallelSine
                                     ? Eigen::Vector3d(apart - a * a.dot(apart))
                                     : Eigen::Vector3d(n * (apart.dot(n) / n.squaredNorm()));
  return {angle, normal.norm(), normal.dot(distal)};
}

std::vector<NeighbouringAxes> neighbouring_axes(const TendonDigit& digit) {
  const TendonModel<double>& model = digit.model;
  std::vector<NeighbouringAxes> pairs;
  for_each_hinge_to_base(model.tree, model.tip_link, [&](int second) {
    const int first = model.tree[second].parent;
    if (first < 0) return;
    const auto name = [&](int hinge) { return digit.names.hinges[hinge]; };
    pairs.push_back({first, second, name(first) + "-" + name(second)});
  });
  std::reverse(pairs.begin(), pairs.end());
  return pairs;
}

AxisOffset axis_offset(const TendonModel<double>& model, const NeighbouringAxes& axes) {
  return axis_offset(model.tree[axes.first], model.tree[axes.second], -model.tip_axes.col(0));
}

std::vector<Eigen::Vector3d> axis_points(const TendonModel<double>& model,
                                         const TreeState<double>& state) {
  std::vector<Eigen::Vector3d> points;
  for (const LinkState<double>& link : state) points.push_back(link.point);
  const std::vector<Eigen::Vector3d> given = points;
  const Eigen::Vector3d tip = moved(state, model.tip_link, model.tip);
  // Number of rounds in which each point slides towards the midpoint of its neighbours
  constexpr int kSlideRounds = 50;
  for (int round = 0; round < kSlideRounds; ++round)
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d& next = i + 1 < points.size() ? points[i + 1] : tip;
      const Eigen::Vector3d wanted = i > 0 ? Eigen::Vector3d((points[i - 1] + next) / 2) : given[0];
      points[i] = given[i] + state[i].axis * state[i].axis.dot(wanted - given[i]);
    }
  return points;
}

}  // namespace thenar
