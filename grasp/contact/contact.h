#pragma once

/// Contacts of a hand with an object: points, normals, friction, and their regions.

#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"

namespace thenar {

/// A point contact with Coulomb friction, and with torsion if the finger is soft.
struct Contact {
  Eigen::Vector3d p{0, 0, 0};  // [m] (3)
  Eigen::Vector3d n{0, 0, 1};  // unit, into the object: direction in which a finger pushes (3)
  double friction = 0;         // Coulomb's coefficient [1]
  double torsion = 0;  // torque about n per normal force of a soft finger [m]; 0: a hard point
  int patch = -1;  // points with one number >= 0 form one contact region; -1: a region of its own
};

/// A contact of one surface of a hand.
struct HandContact {
  Contact contact;   // in the object's frame
  int surface = -1;  // entry of Hand::surfaces()
  double depth = 0;  // overlap of hand and object when the contact was found [m]
};

/// Returns the contacts without surfaces and depths.
[[nodiscard]] std::vector<Contact> contacts_without_hand(const std::vector<HandContact>& contacts);

/// Returns the contact in frame A, or moved by X_AB. @param X_AB  pose of the contact's frame B in
/// A
[[nodiscard]] Contact transform_contact(const Pose<double>& X_AB, const Contact& contact_B);

/// Returns the region of each contact: 0, 1, .. in the order of their first points. Points with one
/// `patch` number >= 0 share a region; so do points without a number that have the same position
/// (within 1e-9 of the grasp's extent, the maximum distance from the first point) and the same
/// normal (within 1e-9).
[[nodiscard]] std::vector<int> contact_regions(const std::vector<Contact>& contacts);

}  // namespace thenar
