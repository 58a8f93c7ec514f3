#pragma once

/// Clearances between surfaces of a hand and of other bodies, with lower bounds that are updated as
/// the hand moves.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "geometry/collision/signed_distance.h"
#include "grasp/closing/collision_hand.h"
#include "grasp/closing/setup.h"

namespace thenar {

/// Clearance of a surface of the hand from another surface or from a body, which must outlive it.
struct Clearance {
  int surface = 0;                  // entry of Hand::surfaces()
  int other = -1;                   // entry of Hand::surfaces() of the other surface; -1: `body`
  const GraspBody* body = nullptr;  // the other body; null: `other`
  double bound = 0;                 // lower bound of the clearance [m]
  int nearest = -1;                 // triangle of the surface nearest to the other; -1: unknown
  double yield_depth = 0;      // overlap at which the two stop each other: depth of soft layers [m]
  double sticking_cosine = 0;  // SurfacePair::sticking_cosine

  /// Returns a lower bound of the distance until contact [m].
  [[nodiscard]] double margin() const { return bound + yield_depth; }
};

/// Collision model of a hand in a posture; the CollisionHand must outlive it.
struct PosedCollisionHand {
  const CollisionHand& collision_hand;
  Pose<double> X_WH;
  std::vector<Pose<double>> links;  // displacements from the reference posture: Hand::pose()

  /// Returns the displacement of a surface from the reference posture to the world.
  [[nodiscard]] Pose<double> surface_pose(int surface) const;
};

/// Measures a clearance, within 1/5 of its value or the tolerance, and updates its bound.
/// @param tolerance, cutoff  settings of signed_distance() [m]
SignedDistance measure_clearance(Clearance& clearance, const PosedCollisionHand& posed,
                                 double tolerance, double cutoff);

/// Returns a lower bound of a clearance [m] from bounding balls, at the cost of one distance.
[[nodiscard]] double bounding_ball_clearance(const Clearance& clearance,
                                             const PosedCollisionHand& posed);

/// Finds the clearances of every surface from every body of the setup, bounded by balls.
[[nodiscard]] std::vector<Clearance> find_clearances(const PosedCollisionHand& posed,
                                                     const GraspSetup& setup);

/// Overlap of a surface of a hand with another surface or a body.
struct Overlap {
  std::string surface;
  std::string other;
  double depth = 0;  // penetration [m]
};

/// Clearances and overlaps between surfaces of one hand.
struct SelfClearances {
  std::vector<Clearance> clearances;  // pairs that have a positive margin
  std::vector<Overlap> overlaps;      // other pairs, if they overlap by more than their soft layers
};
/// Finds the clearances between the surfaces of a hand. @param accuracy  of contact [m]
[[nodiscard]] SelfClearances find_self_clearances(const PosedCollisionHand& posed, double accuracy);

/// Finds overlaps of surfaces with bodies of the setup. @param accuracy  of the depths [m]
[[nodiscard]] std::vector<Overlap> find_overlaps(const PosedCollisionHand& posed,
                                                 const GraspSetup& setup, double accuracy);

}  // namespace thenar
