#pragma once

/// Time of the first contact of two moving bodies.

#include "base/spatial.h"
#include "geometry/manifold/collision_pair.h"

namespace thenar {

/// Motion of a body whose origin has a constant velocity, while it rotates about it at a constant
/// rate:  p(t) = p + v t,  R(t) = exp(omega t) R.
struct BodyMotion {
  Pose<double> X_WB{};             // pose at t = 0
  Eigen::Vector3d omega{0, 0, 0};  // angular velocity [rad/s] (3)
  Eigen::Vector3d v{0, 0, 0};      // velocity of the body's origin [m/s] (3)

  [[nodiscard]] Pose<double> pose_at(double t) const;
};

/// Accuracy of first_contact().
struct FirstContactOptions {
  double gap = 1e-5;     // gap at which bodies count as touching, > 0 [m]
  int max_steps = 2000;  // maximum number of steps
};

/// First contact of two bodies, if any.
struct [[nodiscard]] FirstContact {
  bool found = false;  // whether the gap is at most `gap` at `time`
  /// Time of the contact; without one, time until which the bodies are certainly apart [s]
  double time = 0;
  bool complete = false;  // false: `max_steps` reached; what happens after `time` is unknown
  int steps = 0;          // number of steps
};

/// Finds the first contact by conservative advancement. The distance d of two bodies decreases at
/// most by
///   |v_A - v_B| + |omega_A| rho_A + |omega_B| rho_B,   rho a body's radius about its origin,
/// per time, and for convex bodies at most by the component of the first term along the direction n
/// of their nearest points, so that they can advance by  d / speed  without an evaluation in
/// between. No body is too thin to be hit. At `time` the gap is in (0, options.gap], and it was
/// larger before; bodies that touch or overlap at the start touch at 0.
///
/// Limitations: bodies that slide along each other at a distance just above the gap take many
/// steps, as `complete` shows. Rotation and sliding inside a cavity are bounded by the first
/// formula only.
///
/// @param pair      pair of bodies A and B; its manifold is afterwards that of `time`, including
///                  ids: use a separate pair
/// @param duration  >= 0 [s]
/// @throws InputError if a motion or the duration is not finite, or the gap not positive.
/// Source: [MirtichCanny1995].
FirstContact first_contact(CollisionPair& pair, const BodyMotion& a, const BodyMotion& b,
                           double duration, const FirstContactOptions& options = {});

/// Returns a bounding box of a body during a motion, for the broad phase: that of its boxes at both
/// ends, enlarged by  |omega|^2 rho duration^2 / 8,  the largest deviation of a path from its
/// chord.
[[nodiscard]] Eigen::AlignedBox3d swept_box(const CollisionBody& body, const BodyMotion& motion,
                                            double duration, double margin);

}  // namespace thenar
