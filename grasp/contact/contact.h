#pragma once

/// Contacts of a hand with an object: points, normals, friction, and the regions that they form.

#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"

namespace thenar {

/// A point contact with Coulomb friction, and with torsion if the finger is soft.
struct Contact {
  Eigen::Vector3d p{0, 0, 0};  // [m] (3)
  Eigen::Vector3d n{0, 0, 1};  // unit, into the object: the direction a finger pushes (3)
  double friction = 0;         // Coulomb's coefficient [1]
  double torsion = 0;          // torque about n per normal force, soft fingers [m]; 0: a hard point
  int patch = -1;  // points with the same number >= 0 are one region of contact; -1: its own region
};

/// A contact of one surface of a hand.
struct HandContact {
  Contact contact;   // in the object's frame
  int surface = -1;  // entry of Hand::surfaces()
  double depth = 0;  // overlap of hand and object when the contact was found [m]
};

/// The contacts alone, without surface and depth.
[[nodiscard]] std::vector<Contact> contacts_without_hand(const std::vector<HandContact>& contacts);

/// The contact in frame A, or moved by X_AB. @param X_AB  pose of the contact's frame B in A
[[nodiscard]] Contact seen_from(const Pose<double>& X_AB, const Contact& contact_B);

/// Region of each contact: 0, 1, .. in the order of their first points. Points with the same
/// `patch`
/// >= 0 share a region; so do points without a patch that have the same place (within 1e-9 of the
/// grasp's extent, the farthest distance from the first point) and the same normal (within 1e-9).
[[nodiscard]] std::vector<int> contact_regions(const std::vector<Contact>& contacts);

}  // namespace thenar
