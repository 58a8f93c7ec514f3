#include "grasp/closing/approach.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/numbers.h"

namespace thenar {
ApproachResult approach(const CollisionHand& hand, const Pose<double>& X_WH,
                        const Eigen::VectorXd& q, const GraspSetup& setup, double distance,
                        const CloseOptions& options) {
  require_valid_start(*hand.hand, q);
  require(distance >= 0 && distance < kInfinity, "the distance of an approach is {} m", distance);
  ApproachResult result;
  result.X_WH = X_WH;
  // A hand that starts in overlap is not moved.
  PosedCollisionHand posed{hand, X_WH, hand.hand->pose(q)};
  result.overlaps = find_overlaps(posed, setup, options.accuracy);
  if (!result.overlaps.empty()) return result;
  const Eigen::Vector3d direction = X_WH.R * hand.hand->layout().approach.direction;
  std::vector<Clearance> clearances = find_clearances(posed, setup);

  // Conservative advancement of a pure translation: no point moves farther than the hand.
  double travelled = 0;
  for (int steps = 0; travelled < distance && steps < options.max_steps; ++steps) {
    double step = distance - travelled;
    // Limit the step by every clearance, measured if its bound is too small.
    for (Clearance& clearance : clearances) {
      if (clearance.bound - options.accuracy / 2 >= step) continue;
      const SignedDistance found =
          measure_clearance(clearance, posed, options.accuracy / 4, step + 2 * options.accuracy);
      // Still clear, in contact, or sliding along the other body.
      if (found.distance > options.accuracy) {
        step = std::min(step, clearance.bound - options.accuracy / 2);
      } else if (found.normal.dot(direction) < 0) {
        result.touches = true;
        result.surface = hand.hand->surfaces()[clearance.surface].name;
        result.body = clearance.body->name;
        result.clearance = clearance.bound;
        return result;
      } else {
        step = std::min(step, options.accuracy / 4);
      }
    }
    // Reduce all bounds by the step.
    travelled += step;
    for (Clearance& clearance : clearances) clearance.bound -= step;
    posed.X_WH.p = result.X_WH.p = X_WH.p + travelled * direction;
  }
  return result;
}

namespace {

constexpr double kSidestepRatio = 0.05;  // length of a sidestep over the object's radius [1]
constexpr double kMinContactSine = 0.2;  // sine between normal and approach: less is head-on [1]

/// Returns the direction in which the object pushes the digit that met it, across the approach;
/// zero: it pushes none. (3)
Eigen::Vector3d sidestep_direction(const CollisionHand& hand, const Eigen::VectorXd& q,
                                   const GraspSetup& setup, const ApproachResult& met,
                                   double accuracy) {
  const std::vector<LinkSurface>& surfaces = hand.hand->surfaces();
  if (!met.touches || met.body != setup.object.name) return Eigen::Vector3d::Zero();
  const PosedCollisionHand posed{hand, met.X_WH, hand.hand->pose(q)};
  const Eigen::Vector3d d = met.X_WH.R * hand.hand->layout().approach.direction;
  // Only a contact of a digit gives a direction, by its normal.
  for (int s = 0; s < static_cast<int>(surfaces.size()); ++s) {
    if (surfaces[s].name != met.surface || surfaces[s].digit.empty()) continue;
    Clearance clearance{s, -1, &setup.object};
    const Eigen::Vector3d n =
        measure_clearance(clearance, posed, accuracy / 4, 4 * accuracy).normal;
    const Eigen::Vector3d across = n - n.dot(d) * d;
    if (across.norm() >= kMinContactSine) return across.normalized();
  }
  return Eigen::Vector3d::Zero();
}

}  // namespace

ApproachResult yielding_approach(const CollisionHand& hand, const Pose<double>& X_WH,
                                 const Eigen::VectorXd& q, const GraspSetup& setup,
                                 const ApproachLimits& limits, const CloseOptions& options) {
  require(limits.sidestep >= 0, "a hand gives way by 0 m or more, got {} m", limits.sidestep);
  ApproachResult met = approach(hand, X_WH, q, setup, limits.distance, options);
  const Eigen::Vector3d d = X_WH.R * hand.hand->layout().approach.direction;
  const double step = kSidestepRatio * setup.object.torque_scale;
  // Step aside, and approach again by the remaining distance.
  for (double total = step; total <= limits.sidestep; total += step) {
    const Eigen::Vector3d across = sidestep_direction(hand, q, setup, met, options.accuracy);
    if (across.isZero(0)) break;
    Pose<double> moved = met.X_WH;
    moved.p += step * across;
    const double remaining = limits.distance - d.dot(moved.p - X_WH.p);
    ApproachResult next = approach(hand, moved, q, setup, std::max(0.0, remaining), options);
    if (!next.overlaps.empty() || (met.touches && !next.touches)) break;
    met = std::move(next);
  }
  return met;
}

}  // namespace thenar
