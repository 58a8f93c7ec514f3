#pragma once

/// Clearances between everything that may meet while a hand moves, bounded from below.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "geometry/collision/signed_distance.h"
#include "grasp/closing/collision_hand.h"
#include "grasp/closing/setup.h"

namespace thenar {

/// Clearance of a surface of the hand from another surface or a body; `body` must outlive it.
struct Clearance {
  int surface;                      // of Hand::surfaces()
  int other = -1;                   // another surface; -1: `body`
  const GraspBody* body = nullptr;  // null: against `other`
  double bound = 0;                 // lower bound of the clearance [m]
  int nearest = -1;                 // nearest triangle of the surface; -1: unknown
  double yield = 0;                 // overlap at which the two touch: depth of soft layers [m]
  double sticking_cosine = 0;       // SurfacePair::sticking_cosine

  /// Lower bound of the distance until contact [m].
  [[nodiscard]] double margin() const { return bound + yield; }
};

/// A hand in a posture. The collision hand must outlive it.
struct PosedCollisionHand {
  const CollisionHand& collision_hand;
  Pose<double> X_WH;
  std::vector<Pose<double>> links;  // displacements from the reference posture, as Hand::pose()

  /// Displacement of a surface from the reference posture to the world.
  [[nodiscard]] Pose<double> of_surface(int surface) const;
};

/// Measures a clearance, to a fifth of it or to the tolerance, and updates its bound.
/// @param tolerance, cutoff  as of signed_distance() [m]
SignedDistance measure_clearance(Clearance& clearance, const PosedCollisionHand& posed,
                                 double tolerance, double cutoff);

/// Lower bound of a clearance by the balls around the surfaces: one distance evaluation [m].
[[nodiscard]] double ball_bound(const Clearance& clearance, const PosedCollisionHand& posed);

/// Clearances of every surface from every body of the setup, bounded by balls.
[[nodiscard]] std::vector<Clearance> find_clearances(const PosedCollisionHand& posed,
                                                     const GraspSetup& setup);

/// Two things that overlap.
struct Overlap {
  std::string surface;
  std::string other;
  double depth;  // [m]
};

/// Pairs of surfaces of a hand that may meet.
struct SelfClearances {
  std::vector<Clearance> clearances;  // with a margin left
  std::vector<Overlap> overlaps;      // of the other pairs, those deeper than they yield
};
/// Clearances between the surfaces of a hand. @param accuracy  of contact [m]
[[nodiscard]] SelfClearances self_clearances(const PosedCollisionHand& posed, double accuracy);

/// Overlaps of surfaces with bodies of the setup. @param accuracy  of the depths [m]
[[nodiscard]] std::vector<Overlap> find_overlaps(const PosedCollisionHand& posed,
                                                 const GraspSetup& setup, double accuracy);

}  // namespace thenar
