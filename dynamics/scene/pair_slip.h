#pragma once

/// Slip of bodies in contact from one instant to the next.

#include <map>
#include <utility>
#include <vector>

#include "base/spatial.h"
#include "data/io/scene/scene.h"
#include "dynamics/stepping/contact_sample.h"

namespace thenar {

/// An instant of a run.
struct SlipInstant {
  double t = 0;                         // [s]
  std::vector<ContactSample> contacts;  // that do not open
  std::vector<Pose<double>> X_WB;       // (bodies)
  std::vector<Eigen::Vector3d> centre;  // of mass, world [m] (bodies)
  std::vector<SceneVelocity> velocity;  // of the centres of mass (bodies)
};

/// Speed at which the bodies of a contact slide on each other at it [m/s].
[[nodiscard]] double sliding_speed(const SlipInstant& at, const ContactSample& contact);

/// Way that each pair (a, b) slides between two instants [m]; of its contact points the largest.
///
/// A contact is followed if both instants have its id, or if it moved with one of the bodies. Its
/// way over a body is the chord between its two places there; where the body's normal turns by
/// theta, the part of the chord d across the axis of this turn stands for the arc
/// d (theta / 2) / sin(theta / 2).  The slip is the difference of the ways over both bodies, across
/// the normal: exact where a pair rolls and slides straight on over flat or round faces, and off by
/// the third order of the turn elsewhere. Where a normal, or one body against the other by its
/// speed at either instant, turns by more than 2 rad, ends do not tell arcs, and the way is the
/// mean of both sliding speeds times the time between.
[[nodiscard]] std::map<std::pair<int, int>, double> slips_between(const SlipInstant& from,
                                                                  const SlipInstant& to);

}  // namespace thenar
