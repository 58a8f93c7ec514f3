#include "grasp/closing/approach.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/numbers.h"

namespace thenar {
ApproachResult approach(const CollisionHand& hand, const Pose<double>& X_WH,
                        const Eigen::VectorXd& q, const GraspSetup& setup, double distance,
                        const CloseOptions& options) {
  require_start(*hand.hand, q);
  require(distance >= 0 && distance < kInfinity, "the distance of an approach is {} m", distance);
  ApproachResult result;
  result.X_WH = X_WH;
  // A hand that starts inside something is not moved.
  PosedCollisionHand posed{hand, X_WH, hand.hand->pose(q)};
  result.overlaps = find_overlaps(posed, setup, options.accuracy);
  if (!result.overlaps.empty()) return result;
  const Eigen::Vector3d direction = X_WH.R * hand.hand->layout().approach.direction;
  std::vector<Clearance> clearances = find_clearances(posed, setup);

  // Conservative advancement of a pure translation: nothing moves faster than the hand.
  double gone = 0;
  for (int steps = 0; gone < distance && steps < options.max_steps; ++steps) {
    double step = distance - gone;
    // The step ends before the nearest body could be touched.
    for (Clearance& clearance : clearances) {
      if (clearance.bound - options.accuracy / 2 >= step) continue;
      const SignedDistance found =
          measure_clearance(clearance, posed, options.accuracy / 4, step + 2 * options.accuracy);
      // Measured: still clear, in contact, or sliding along.
      if (found.distance > options.accuracy) {
        step = std::min(step, clearance.bound - options.accuracy / 2);
      } else if (found.normal.dot(direction) < 0) {
        result.touches = true;
        result.surface = hand.hand->surfaces()[clearance.surface].name;
        result.body = clearance.body->name;
        result.clearance = clearance.bound;
        return result;
      } else {
        step = std::min(step, options.accuracy / 4);  // slides along
      }
    }
    // All bounds shrink by the step.
    gone += step;
    for (Clearance& clearance : clearances) clearance.bound -= step;
    posed.X_WH.p = result.X_WH.p = X_WH.p + gone * direction;
  }
  return result;
}

namespace {

constexpr double kSideStep = 0.05;  // Length of a side step, over the object's radius [1]
constexpr double kHeadOn = 0.2;     // smallest sine of the angle between normal and approach [1]

/// Direction in which the object pushes the digit that met it, across the approach; zero: none. (3)
Eigen::Vector3d push_across(const CollisionHand& hand, const Eigen::VectorXd& q,
                            const GraspSetup& setup, const ApproachResult& met, double accuracy) {
  const std::vector<LinkSurface>& surfaces = hand.hand->surfaces();
  if (!met.touches || met.body != setup.object.name) return Eigen::Vector3d::Zero();
  const PosedCollisionHand posed{hand, met.X_WH, hand.hand->pose(q)};
  const Eigen::Vector3d d = met.X_WH.R * hand.hand->layout().approach.direction;
  // Only a digit gives way; its contact normal tells the direction.
  for (int s = 0; s < static_cast<int>(surfaces.size()); ++s) {
    if (surfaces[s].name != met.surface || surfaces[s].digit.empty()) continue;
    Clearance clearance{s, -1, &setup.object};
    const Eigen::Vector3d n =
        measure_clearance(clearance, posed, accuracy / 4, 4 * accuracy).normal;
    const Eigen::Vector3d across = n - n.dot(d) * d;
    if (across.norm() >= kHeadOn) return across.normalized();
  }
  return Eigen::Vector3d::Zero();
}

}  // namespace

ApproachResult yielding_approach(const CollisionHand& hand, const Pose<double>& X_WH,
                                 const Eigen::VectorXd& q, const GraspSetup& setup,
                                 const ApproachReach& most, const CloseOptions& options) {
  require(most.aside >= 0, "a hand gives way by 0 m or more, got {} m", most.aside);
  ApproachResult met = approach(hand, X_WH, q, setup, most.distance, options);
  const Eigen::Vector3d d = X_WH.R * hand.hand->layout().approach.direction;
  const double step = kSideStep * setup.object.torque_scale;
  // Step aside, and approach again by the distance that is left.
  for (double given = step; given <= most.aside; given += step) {
    const Eigen::Vector3d across = push_across(hand, q, setup, met, options.accuracy);
    if (across.isZero(0)) break;
    Pose<double> aside = met.X_WH;
    aside.p += step * across;
    const double left = most.distance - d.dot(aside.p - X_WH.p);
    ApproachResult next = approach(hand, aside, q, setup, std::max(0.0, left), options);
    if (!next.overlaps.empty() || (met.touches && !next.touches)) break;
    met = std::move(next);
  }
  return met;
}

}  // namespace thenar
