#pragma once

/// Sweep of a net from posture to posture, for tests of nets.

#include <algorithm>
#include <utility>
#include <vector>

#include "tendons/net/build_tendons.h"
#include "tendons/net/net_continuation.h"
#include "tendons/net/posture_sweep.h"

namespace thenar {

/// State of a net at one posture of a sweep.
struct SweepPoint {
  Eigen::VectorXd q;  // [rad] (coordinates)
  NetEquilibrium rest;
  SlipTension slips;     // [N]
  Eigen::VectorXd tau;   // joint torque of all tendons [N m] (coordinates)
  double moved = 0;      // largest displacement of a floating node since the previous point [m]
  double carried = 0;    // largest displacement of a bone point that holds the net [m]
  int mover = -1;        // node that moved farthest; -1: none
  bool snapped = false;  // true: the net has snapped since the previous point, see follow_net()
};

/// Sets the displacements of nodes and bones between two points.
inline void set_displacements(const Net& net, const SweepPoint& before, SweepPoint& point) {
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
inline SweepPoint point_at(const NetTendons& tendons, const Eigen::VectorXd& q,
                           const Eigen::VectorXd& t, NetEquilibrium rest) {
  SweepPoint point;
  point.q = q;
  point.rest = std::move(rest);
  point.slips = slip_tension(tendons.net(), point.rest);
  point.tau = tendons.torque(q, t, point.rest);
  return point;
}

/// Computes the next point of a sweep.
/// @param before  previous point; null: the net starts where its links carry it
/// @param t       tension of each muscle [N] (muscles)
inline SweepPoint next_sweep_point(const NetTendons& tendons, const SweepPoint* before,
                                   const Eigen::VectorXd& q, const Eigen::VectorXd& t) {
  if (before == nullptr) return point_at(tendons, q, t, tendons.rest(q, t, {}));
  // Follow the net from the previous point.
  NetContinuation walk = follow_net(tendons, before->rest, {before->q, t}, {q, t});
  SweepPoint point = point_at(tendons, q, t, std::move(walk.rest));
  point.snapped = !walk.snaps.empty();
  set_displacements(tendons.net().net, *before, point);
  return point;
}

/// Solves a net at one posture after another by follow_net() from the previous one: neither the
/// equilibrium nor the snaps of a finger moved this way depend on the spacing of the postures.
inline std::vector<SweepPoint> sweep_net(const NetTendons& tendons,
                                         const std::vector<Eigen::VectorXd>& postures,
                                         const Eigen::VectorXd& t) {
  std::vector<SweepPoint> points;
  points.reserve(postures.size());
  for (const Eigen::VectorXd& q : postures)
    points.push_back(next_sweep_point(tendons, points.empty() ? nullptr : &points.back(), q, t));
  return points;
}

}  // namespace thenar
