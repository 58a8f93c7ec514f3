#pragma once

/// Slip distance of bodies in contact between two instants.

#include <map>
#include <utility>
#include <vector>

#include "base/spatial.h"
#include "data/io/scene/scene.h"
#include "dynamics/stepping/contact_sample.h"

namespace thenar {

/// Contacts and motion of all bodies at one instant of a run.
struct SlipInstant {
  double t = 0;                         // time [s]
  std::vector<ContactSample> contacts;  // closed contacts
  std::vector<Pose<double>> X_WB;       // poses (bodies)
  std::vector<Eigen::Vector3d> centre;  // centres of mass, world [m] (bodies)
  std::vector<SceneVelocity> velocity;  // velocities of the centres of mass (bodies)
};

/// Returns the speed at which the bodies of a contact slide on each other at its point [m/s].
[[nodiscard]] double sliding_speed(const SlipInstant& at, const ContactSample& contact);

/// Returns the distance that each pair (a, b) slides between two instants [m], the largest of its
/// contact points.
///
/// A contact is tracked if both instants have its id, or if its point moved with one of the bodies.
/// Its path over a body is the chord between its two points in that body. Where the normal on the
/// body rotates by theta, the part d of the chord across the rotation axis is replaced by the arc
/// d (theta / 2) / sin(theta / 2).  The slip is the difference of the paths over both bodies,
/// tangential to the contact. It is exact for straight rolling and sliding over flat or round
/// faces, and has an error of third order in the rotation otherwise. For rotations above 2 rad, of
/// a normal or of the relative motion of the bodies, it is the mean sliding speed times the
/// duration.
[[nodiscard]] std::map<std::pair<int, int>, double> slips_between(const SlipInstant& from,
                                                                  const SlipInstant& to);

}  // namespace thenar
