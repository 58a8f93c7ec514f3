#pragma once

/// One place where a hand touches an object.

#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"

namespace thenar {

/// A contact as force closure sees it: point, normal, friction.
struct Contact {
  Eigen::Vector3d p{0, 0, 0};  // [m] (3)
  Eigen::Vector3d n{0, 0, 1};  // unit, into the object: the direction a finger pushes (3)
  double friction = 0;         // Coulomb's coefficient [1]
  double torsion = 0;          // torque about n per normal force, soft fingers [m]; 0: a hard point
  int patch = -1;  // points of one number >= 0 are one region of contact; -1: a region of its own
};

/// A contact of a hand.
struct HandContact {
  Contact contact;   // in the object's frame
  int surface = -1;  // entry of Hand::surfaces()
  double depth = 0;  // how far the two were in each other when it was found [m]
};

/// The contacts without what they say of the hand.
[[nodiscard]] std::vector<Contact> contacts_without_hand(const std::vector<HandContact>& contacts);

/// A contact seen from another frame, or moved. @param X_AB  (B: the frame it is given in)
[[nodiscard]] Contact seen_from(const Pose<double>& X_AB, const Contact& contact_B);

// Which points of contact belong together.

/// Numbers of contact_regions, 0, 1, .. in the order of their first points: points with one `patch`
/// >= 0 share a number, and so do points without one that stand at one place (within 1e-9 of the
/// farthest point's distance from the first) with one normal (within 1e-9).
[[nodiscard]] std::vector<int> contact_regions(const std::vector<Contact>& contacts);

}  // namespace thenar
