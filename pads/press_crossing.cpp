#include "pads/press_crossing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// Normals on two sides of an object have a cosine below this [1]
constexpr double kOppositeCosine = -0.5;
// Largest depth of the object under springs, over the distance of nodes [1]
constexpr double kSpringDepth = 0.2;

/// Returns whether a node touches a side of the object that faces away from the one where it was:
/// steps of a press are too short to go around it.
bool changed_sides(const PressIterate& at, std::size_t k, const Pose<double>& X_OP) {
  const Vector3d was = at.surface.places.col(static_cast<Eigen::Index>(k)) +
                       at.start.x.segment<3>(3 * at.surface.nodes[k]);
  const Shape& shape = *at.object.shape;
  return shape.nearest(X_OP * at.place_of(k))
             .normal.dot(shape.nearest(at.start.X_PO.inverse() * was).normal) < kOppositeCosine;
}

/// Describes the place of a node inside the object; "" if none is.
/// @param allowed  depth of free nodes [m] (free nodes)
std::string find_inside(const PressIterate& at, const Matrix3Xd& u, const Pose<double>& X_OP,
                        const std::vector<double>& allowed) {
  for (const int node : at.body.nodes()) {
    const Vector3d p = at.body.place(node) + u.col(node);
    const int free = at.body.free_place(node);
    const double most =
        free >= 0 ? allowed[static_cast<std::size_t>(free)] : at.options.gap_tolerance;
    if (!at.body.hangs(node) && at.object.shape->distance(X_OP * p) < -most)
      return fmt::format("the object is inside the tissue at ({:g}, {:g}, {:g}) mm", p[0] * 1e3,
                         p[1] * 1e3, p[2] * 1e3);
  }
  // A small one may be all under the skin, where it meets no node and no face.
  const Vector3d middle = at.object.shape->bounds().center();
  if (at.object.shape->distance(middle) < 0 && at.body.contains(at.now.X_PO * middle, u))
    return "the object is inside the tissue";
  return "";
}

}  // namespace

std::string find_crossing(const PressIterate& at, const Matrix3Xd& u) {
  // Nodes and springs on the far side of the object.
  const Pose<double> X_OP = at.now.X_PO.inverse();
  for (std::size_t k = 0; k < at.contacts.size(); ++k)
    if (at.contacts[k].push > 0 && changed_sides(at, k, X_OP))
      return "the object jumped through skin";
  // Springs give way by a part of the distance of nodes.
  const double gives = at.springs ? kSpringDepth * std::sqrt(at.surface.area.mean()) : 0;
  if (at.springs && at.springs->deepest() > gives) return "the skin is inside the object";
  if (at.springs && at.springs->changed_sides(*at.object.shape, at.start.X_PO, at.now.X_PO,
                                              at.start.x, kOppositeCosine))
    return "the object jumped through skin";
  // Nodes inside, deeper than the mean over the surface around them lets them be.
  std::vector<double> allowed(at.body.free_nodes().size(), at.options.gap_tolerance + gives);
  for (std::size_t k = 0; k < at.contacts.size(); ++k)
    allowed[static_cast<std::size_t>(at.surface.nodes[k])] += std::max(0.0, at.gaps.more(k));
  return find_inside(at, u, X_OP, allowed);
}

}  // namespace thenar
