#pragma once

/// Random contact lists, the same on every machine.

#include <cmath>
#include <random>
#include <vector>

#include "grasp/contact/contact.h"

namespace thenar {

/// Uniform in [low, high), by our own arithmetic.
inline double uniform(std::mt19937& rng, double low, double high) {
  return low + (high - low) * (static_cast<double>(rng()) / 4294967296.0);
}

/// Uniform over directions.
inline Eigen::Vector3d random_direction(std::mt19937& rng) {
  const double z = uniform(rng, -1, 1), angle = uniform(rng, 0, 2 * M_PI), r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

/// Contacts on a ball of 1 m, normals inward but up to some 20 deg off,
/// friction 0.2 to 1.
inline std::vector<Contact> random_contacts(std::mt19937& rng, int count) {
  std::vector<Contact> contacts(static_cast<std::size_t>(count));
  for (Contact& contact : contacts) {
    contact.p = random_direction(rng);
    contact.n = (-contact.p + 0.35 * random_direction(rng)).normalized();
    contact.friction = uniform(rng, 0.2, 1);
  }
  return contacts;
}

}  // namespace thenar
