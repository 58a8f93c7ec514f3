#include "grasp/yielding_approach.h"

#include <utility>

#include "base/error.h"

namespace thenar {
namespace {

constexpr double kStep = 0.05;   // by reach [1]
constexpr double kHeadOn = 0.2;  // sine of the least angle between normal and approach [1]

/// Where the object pushes the surface that met it, across the approach; zero: nowhere. (3)
Eigen::Vector3d push_across(const TouchingHand& hand, const Eigen::VectorXd& q, const Scene& scene,
                            const Approached& met, double accuracy) {
  const std::vector<LinkSurface>& surfaces = hand.hand->surfaces();
  if (!met.touches || met.body != scene.object.name) return Eigen::Vector3d::Zero();
  const PosedHand posed{hand, met.X_WH, hand.hand->pose(q)};
  const Eigen::Vector3d d = met.X_WH.R * hand.hand->layout().approach.direction;
  for (int s = 0; s < static_cast<int>(surfaces.size()); ++s) {
    if (surfaces[s].name != met.surface || surfaces[s].digit.empty()) continue;
    Gap gap{s, -1, &scene.object};
    const Eigen::Vector3d n = measure(gap, posed, accuracy / 4, 4 * accuracy).normal;
    const Eigen::Vector3d across = n - n.dot(d) * d;
    if (across.norm() >= kHeadOn) return across.normalized();
  }
  return Eigen::Vector3d::Zero();
}

}  // namespace

Approached yielding_approach(const TouchingHand& hand, const Pose<double>& X_WH,
                             const Eigen::VectorXd& q, const Scene& scene, double way, double most,
                             const CloseOptions& options) {
  require(most >= 0, "a hand gives way by 0 m or more, got {} m", most);
  Approached met = approach(hand, X_WH, q, scene, way, options);
  const Eigen::Vector3d d = X_WH.R * hand.hand->layout().approach.direction;
  const double step = kStep * scene.object.reach;
  for (double given = step; given <= most; given += step) {
    const Eigen::Vector3d across = push_across(hand, q, scene, met, options.accuracy);
    if (across.isZero(0)) break;
    Pose<double> aside = met.X_WH;
    aside.p += step * across;
    const double left = way - d.dot(aside.p - X_WH.p);
    Approached next = approach(hand, aside, q, scene, std::max(0.0, left), options);
    if (!next.overlaps.empty()) break;
    met = std::move(next);
  }
  return met;
}

}  // namespace thenar
