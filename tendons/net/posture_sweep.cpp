#include "tendons/net/posture_sweep.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "tendons/net/build_tendons.h"

namespace thenar {
namespace {

/// Sets the displacements of nodes and bones between two points.
void set_displacements(const Net& net, const SweepPoint& before, SweepPoint& point) {
  const auto& undetermined = point.rest.undetermined;
  for (std::size_t i = 0; i < net.nodes.size(); ++i) {
    const auto node = static_cast<Eigen::Index>(i);
    const double way = (point.rest.x.col(node) - before.rest.x.col(node)).norm();
    // Measure bones by fixed nodes; ignore undetermined ones.
    if (!net.nodes[i].free) {
      point.carried = std::max(point.carried, way);
    } else if (way > point.moved && std::find(undetermined.begin(), undetermined.end(),
                                              static_cast<int>(i)) == undetermined.end()) {
      point.moved = way;
      point.mover = static_cast<int>(i);
    }
  }
}

/// Builds a point from an equilibrium.
SweepPoint point_at(const NetTendons& tendons, const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                    NetEquilibrium rest) {
  SweepPoint point;
  point.q = q;
  point.rest = std::move(rest);
  point.slips = slip_tension(tendons.net(), point.rest);
  point.tau = tendons.torque(q, t, point.rest);
  return point;
}

}  // namespace

std::vector<Eigen::VectorXd> postures_between(const Eigen::VectorXd& from,
                                              const Eigen::VectorXd& to, int steps) {
  require(steps > 0, "a sweep needs at least one step, got {}", steps);
  require(from.size() == to.size(), "postures have {} and {} angles", from.size(), to.size());
  std::vector<Eigen::VectorXd> postures;
  for (int k = 0; k <= steps; ++k) postures.emplace_back(from + (to - from) * k / steps);
  return postures;
}

std::vector<SweepPoint> sweep_net(const NetTendons& tendons,
                                  const std::vector<Eigen::VectorXd>& postures,
                                  const Eigen::VectorXd& t, const NetContinuationOptions& options,
                                  const Eigen::Matrix3Xd& start) {
  std::vector<SweepPoint> points;
  points.reserve(postures.size());
  for (const Eigen::VectorXd& q : postures)
    points.push_back(points.empty() ? point_at(tendons, q, t, tendons.rest(q, t, start))
                                    : next_sweep_point(tendons, &points.back(), q, t, options));
  return points;
}

SweepPoint next_sweep_point(const NetTendons& tendons, const SweepPoint* before,
                            const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                            const NetContinuationOptions& options) {
  if (before == nullptr) return point_at(tendons, q, t, tendons.rest(q, t, {}));
  // Follow the net from the previous point.
  NetContinuation walk = follow_net(tendons, before->rest, {before->q, t}, {q, t}, options);
  SweepPoint point = point_at(tendons, q, t, std::move(walk.rest));
  point.snapped = !walk.snaps.empty();
  set_displacements(tendons.net().net, *before, point);
  return point;
}

Eigen::Matrix3Xd start_from_straight(const DigitTendons& tendons, const Eigen::VectorXd& q,
                                     const Eigen::VectorXd& t) {
  const auto* with_net = dynamic_cast<const NetTendons*>(&tendons);
  if (with_net == nullptr) return {};
  return follow_from_straight(*with_net, q, t).rest.x;
}

}  // namespace thenar
