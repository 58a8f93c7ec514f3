#pragma once

/// Time at which two moving bodies first touch.

#include "base/spatial.h"
#include "geometry/manifold/collision_pair.h"

namespace thenar {

/// A body whose origin moves straight at a constant speed while it turns about it at a constant
/// rate:  p(t) = p + v t,  R(t) = exp(omega t) R.
struct BodyMotion {
  Pose<double> X_WB{};             // at t = 0
  Eigen::Vector3d omega{0, 0, 0};  // [rad/s] (3)
  Eigen::Vector3d v{0, 0, 0};      // of the body's origin [m/s] (3)

  [[nodiscard]] Pose<double> at(double t) const;
};

/// Accuracy of first_contact().
struct FirstContactOptions {
  double gap = 1e-5;  // at which bodies count as touching, > 0 [m]
  int max_steps = 2000;
};

/// The first contact of two bodies, if any.
struct [[nodiscard]] FirstContact {
  bool found = false;     // the gap is at most `gap` at `time`
  double time = 0;        // until here they are apart for certain; of the contact if found [s]
  bool complete = false;  // false: out of steps; nothing is known of what comes after `time`
  int steps = 0;
};

/// Conservative advancement. The distance d of two bodies shrinks no faster than
///   |v_A - v_B| + |omega_A| rho_A + |omega_B| rho_B,   rho a body's reach from its origin,
/// and of convex bodies no faster than the first term's part along the direction n of their nearest
/// points, so that they may move on by  d / speed  without a look in between. So nothing is too
/// thin to be hit. At `time` the gap is in (0, options.gap], and it was larger before; bodies
/// that touch or overlap at the start touch at 0.
///
/// Fails: bodies that slide along each other at a distance just above the gap take many steps;
/// `complete` tells. What turns and slides within a cavity is bounded by the first formula only.
///
/// @param pair      of bodies A and B; its manifold, its ids included, is afterwards that of
/// `time`:
///                  give it a pair of its own
/// @param duration  >= 0 [s]
/// @throws InputError if a motion or the duration is not finite, or the gap not positive.
/// Source: [MirtichCanny1995].
FirstContact first_contact(CollisionPair& pair, const BodyMotion& a, const BodyMotion& b,
                           double duration, const FirstContactOptions& options = {});

/// A box around all that a body sweeps in a motion, for the broad phase: that around its boxes at
/// both ends, grown by  |omega|^2 rho duration^2 / 8,  by which a path may leave its chord.
[[nodiscard]] Eigen::AlignedBox3d swept_box(const CollisionBody& body, const BodyMotion& motion,
                                            double duration, double margin);

}  // namespace thenar
