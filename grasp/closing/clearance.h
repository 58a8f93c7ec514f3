#pragma once

/// Lower bounds of the clearances between everything that may meet while a hand moves.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "geometry/collision/signed_distance.h"
#include "grasp/closing/collision_hand.h"
#include "grasp/closing/scene.h"

namespace thenar {

/// A surface of the hand and what it may meet.
struct Clearance {
  int surface;                      // of Hand::surfaces()
  int other = -1;                   // another surface; -1: `body`
  const SceneBody* body = nullptr;  // null: `other`
  double bound = 0;                 // the clearance is at least this [m]
  int nearest = -1;                 // triangle of the surface that was nearest; -1: unknown
  double yield = 0;                 // they touch when they are this deep in each other [m]
  double stick = 0;                 // SurfacePair::stick

  /// What is left until they touch, at least [m].
  [[nodiscard]] double margin() const { return bound + yield; }
};

/// A posed hand.
struct PosedCollisionHand {
  const CollisionHand& touching;
  Pose<double> X_WH;
  std::vector<Pose<double>> links;  // displacements, as Hand::pose() gives them

  /// From a surface's points at the reference posture to the world.
  [[nodiscard]] Pose<double> of_surface(int surface) const;
};

/// Measures a clearance at a pose, to a fifth of it or to the tolerance, and notes its bound.
/// @param tolerance, cutoff  as of signed_distance() [m]
SignedDistance measure_clearance(Clearance& clearance, const PosedCollisionHand& posed,
                                 double tolerance, double cutoff);

/// A bound from one distance, by the balls around the surfaces [m].
[[nodiscard]] double ball_bound(const Clearance& clearance, const PosedCollisionHand& posed);

/// Every surface with every body of the scene, bounded by balls.
[[nodiscard]] std::vector<Clearance> scene_clearances(const PosedCollisionHand& posed,
                                                      const Scene& scene);

/// Two things that are in each other.
struct Overlap {
  std::string surface;
  std::string other;
  double depth;  // [m]
};

/// Surfaces of a hand that may meet.
struct SelfClearances {
  std::vector<Clearance> clearances;  // bounded from below, with margin left
  std::vector<Overlap> overlaps;      // of the others, those deeper in each other than they yield
};
[[nodiscard]] SelfClearances self_clearances(const PosedCollisionHand& posed, double accuracy);

/// Which surfaces are in bodies of the scene.
[[nodiscard]] std::vector<Overlap> find_overlaps(const PosedCollisionHand& posed,
                                                 const Scene& scene, double accuracy);

}  // namespace thenar
