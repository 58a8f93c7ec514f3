#include "pads/press_crossing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// Largest cosine of two normals on opposite sides of an object [1]
constexpr double kOppositeCosine = -0.5;
// Largest depth of the object under springs over the distance of nodes [1]
constexpr double kMaxSpringDepthRatio = 0.2;

/// Returns whether a node touches the side of the object opposite to that at the start of the step;
/// steps are too short to go around the object.
bool has_changed_sides(const PressIterate& iterate, std::size_t k, const Pose<double>& X_OP) {
  const Vector3d before = iterate.surface.rest_positions.col(k) +
                          iterate.start.x.segment<3>(3 * iterate.surface.nodes[k]);
  const Shape& shape = *iterate.object.shape;
  return shape.nearest(X_OP * iterate.node_position(k))
             .normal.dot(shape.nearest(iterate.start.X_PO.inverse() * before).normal) <
         kOppositeCosine;
}

/// Returns a description of the first node inside the object; "" if there is none.
/// @param allowed  depth up to which free nodes are accepted [m] (free nodes)
std::string describe_inside_node(const PressIterate& iterate, const Matrix3Xd& u,
                                 const Pose<double>& X_OP, const std::vector<double>& allowed) {
  for (const int node : iterate.body.nodes()) {
    const Vector3d p = iterate.body.rest_position(node) + u.col(node);
    const int free = iterate.body.free_index(node);
    const double most = free >= 0 ? allowed[free] : iterate.options.gap_tolerance;
    if (!iterate.body.is_hanging(node) && iterate.object.shape->distance(X_OP * p) < -most)
      return fmt::format("the object is inside the tissue at ({:g}, {:g}, {:g}) mm", p[0] * 1e3,
                         p[1] * 1e3, p[2] * 1e3);
  }
  // A small object may be wholly under the skin, where it meets no node and no face.
  const Vector3d middle = iterate.object.shape->bounds().center();
  if (iterate.object.shape->distance(middle) < 0 &&
      iterate.body.contains(iterate.state.X_PO * middle, u))
    return "the object is inside the tissue";
  return "";
}

}  // namespace

std::string describe_crossing(const PressIterate& iterate, const Matrix3Xd& u) {
  // Check nodes on the far side of the object.
  const Pose<double> X_OP = iterate.state.X_PO.inverse();
  for (std::size_t k = 0; k < iterate.contacts.size(); ++k)
    if (iterate.contacts[k].normal_force > 0 && has_changed_sides(iterate, k, X_OP))
      return "the object jumped through skin";
  // Check springs, which may be as deep as a part of the distance of nodes.
  const double spring_depth =
      iterate.springs ? kMaxSpringDepthRatio * std::sqrt(iterate.surface.area.mean()) : 0;
  if (iterate.springs && iterate.springs->max_depth() > spring_depth)
    return "the skin is inside the object";
  if (iterate.springs &&
      iterate.springs->has_changed_sides(*iterate.object.shape, iterate.start.X_PO,
                                         iterate.state.X_PO, iterate.start.x, kOppositeCosine))
    return "the object jumped through skin";
  // Check nodes inside, deeper than the mean gap over the surface around them allows.
  std::vector<double> allowed(iterate.body.free_nodes().size(),
                              iterate.options.gap_tolerance + spring_depth);
  for (std::size_t k = 0; k < iterate.contacts.size(); ++k)
    allowed[iterate.surface.nodes[k]] += std::max(0.0, iterate.gaps.mean_offset(k));
  return describe_inside_node(iterate, u, X_OP, allowed);
}

}  // namespace thenar
