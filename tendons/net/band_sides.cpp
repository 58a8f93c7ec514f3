#include "tendons/net/band_sides.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.h"
#include "tendons/wrapping/wrapped_string.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

// Number of steps through a joint's range; no end turns by half a turn in one of them
constexpr int kSideSteps = 12;

/// Range of angles about a cylinder's axis, counted from a side [rad].
struct AngleSpan {
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();
  void add(double angle) {
    min = std::min(min, angle);
    max = std::max(max, angle);
  }
};

/// Finger, and a cylinder with the side that angles are counted from.
struct SideView {
  const Skeleton& skeleton;
  const VectorXd& straight;
  const BoneSurface& surface;
  Vector3d side;

  [[nodiscard]] double angle_of(const NetNode& node, const VectorXd& q) const {
    const TreeState<double> state = pose_tree(skeleton.tree, q);
    const Vector3d p = surface_pose(surface, state).inverse() * moved(state, node.link, node.p);
    return angle_from(side, p);
  }
};

/// Adds the angles of a node while one coordinate moves from the straight finger to an end of its
/// range, in steps so that no turn is lost.
void add_turn(const SideView& view, const NetNode& node, int coordinate, double end,
              AngleSpan& span) {
  VectorXd q = view.straight;
  double angle = view.angle_of(node, q);
  for (int step = 1; step <= kSideSteps; ++step) {
    q[coordinate] =
        view.straight[coordinate] + (end - view.straight[coordinate]) * step / kSideSteps;
    angle += std::remainder(view.angle_of(node, q) - angle, 2 * kPi);
    span.add(angle);
  }
}

/// Adds the angles of a node in the straight finger, and through the ranges of the joints between
/// it and the cylinder. Joints without a range do not move.
void add_angles(const SideView& view, const NetNode& node, AngleSpan& span) {
  span.add(view.angle_of(node, view.straight));
  const Tree<double>& tree = view.skeleton.tree;
  for_each_hinge_between(tree, node.link, view.surface.link, [&](int i, bool /*on_surface*/) {
    const CoordinateLimits& limits = view.skeleton.limits[tree[i].coordinate];
    if (limits.upper - limits.lower < 2 * kPi - 1e-9)
      for (const double end : {limits.lower, limits.upper})
        add_turn(view, node, tree[i].coordinate, end, span);
  });
}

}  // namespace

void centre_sides(const Skeleton& skeleton, const VectorXd& straight, Net& net) {
  for (NetBand& band : net.bands) {
    if (band.over < 0) continue;
    const BoneSurface& surface = net.surfaces[band.over];
    if (surface.shape != SurfaceShape::kCylinder) continue;
    // Turn the side to the middle of the angles of both ends.
    AngleSpan span;
    const SideView view{skeleton, straight, surface, band.side};
    for (const int end : {band.a, band.b}) add_angles(view, net.nodes[end], span);
    if (span.max - span.min < 2 * kPi)
      band.side =
          rotation_about(Vector3d(Vector3d::UnitZ()), 0.5 * (span.min + span.max)) * band.side;
  }
}

}  // namespace thenar
