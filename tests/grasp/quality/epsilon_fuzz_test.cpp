// Odd wrench sets by the thousand: bounds that hold, and an end in time.
// THENAR_GRASPS=10000 for all 20,000.

#include <cmath>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "base/spatial.h"
#include "grasp/contact/friction_pyramid.h"
#include "grasp/quality/epsilon.h"
#include "tests/grasp/quality/brute_epsilon.h"

namespace thenar {
namespace {

constexpr int kMaxFacets = 200000;

int sets() {
  const char* all = std::getenv("THENAR_GRASPS");
  return all == nullptr ? 150 : 2 * std::stoi(all);
}

/// 10^low .. 10^high.
double magnitude(std::mt19937& rng, double low, double high) {
  return std::pow(10, uniform(rng, low, high));
}

using Contacts = std::vector<Contact>;

Contacts nearly_parallel(std::mt19937& rng) {
  Contacts contacts = random_contacts(rng, 2 + static_cast<int>(uniform(rng, 0, 5)));
  const double off = magnitude(rng, -12, -1);
  for (Contact& contact : contacts)
    contact.n = (Eigen::Vector3d::UnitZ() + off * random_direction(rng)).normalized();
  if (uniform(rng, 0, 1) < 0.7) contacts.back().n = -contacts.front().n;
  return contacts;
}

Contacts nearly_flat(std::mt19937& rng) {
  Contacts contacts = random_contacts(rng, 2 + static_cast<int>(uniform(rng, 0, 5)));
  const double height = magnitude(rng, -14, -2);
  for (Contact& contact : contacts) {
    contact.p.z() *= height;
    contact.n.z() *= height;
    contact.n.normalize();
    contact.friction = uniform(rng, 0, 1) < 0.5 ? 0 : height;
  }
  return contacts;
}

Contacts slippery_and_sticky(std::mt19937& rng) {
  Contacts contacts = random_contacts(rng, 2 + static_cast<int>(uniform(rng, 0, 5)));
  for (Contact& contact : contacts) {
    contact.friction = magnitude(rng, -6, 1);
    contact.torsion = uniform(rng, 0, 3) < 1 ? 0 : magnitude(rng, -9, 0);
  }
  return contacts;
}

Contacts coincident(std::mt19937& rng) {
  Contacts contacts = random_contacts(rng, 2 + static_cast<int>(uniform(rng, 0, 3)));
  const double apart = uniform(rng, 0, 1) < 0.5 ? 0 : magnitude(rng, -16, -3);
  const Contacts copies = contacts;
  for (Contact contact : copies) {
    contact.p += apart * random_direction(rng);
    contacts.push_back(contact);
  }
  return contacts;
}

/// On the corners of a prism, or of a tetrahedron, octahedron or cube, turned anyhow.
Contacts symmetric(std::mt19937& rng) {
  Contacts contacts;
  const auto add = [&](const Eigen::Vector3d& p) {
    contacts.push_back({p.normalized(), -p.normalized(), 0, 0});
  };
  const int kind = static_cast<int>(uniform(rng, 0, 4)),
            sides = 2 + static_cast<int>(uniform(rng, 0, 4));
  for (int i = 0; kind == 0 && i < sides; ++i)
    for (const double z : {0.5, -0.5})
      add({std::cos(2 * M_PI * i / sides), std::sin(2 * M_PI * i / sides), z});
  for (int i = 0; kind == 1 && i < 6; ++i) add((i % 2 ? 1 : -1) * Eigen::Vector3d::Unit(i / 2));
  for (int i = 0; kind > 1 && i < 8; ++i) {
    const Eigen::Vector3d corner(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    if (kind == 3 || corner.prod() > 0) add(corner);
  }
  const Eigen::Matrix3d R = rotation_about<double>(random_direction(rng), uniform(rng, 0, 3));
  const double friction = magnitude(rng, -2, 1), torsion = uniform(rng, -1, 0.5);
  for (Contact& contact : contacts) {
    contact.p = R * contact.p;
    contact.n = (R * contact.n).normalized();
    contact.friction = friction;
    contact.torsion = std::max(0.0, torsion);
  }
  return contacts;
}

/// One after the other of every kind; some as pyramids.
WrenchSet odd_set(std::mt19937& rng, int i) {
  const Contacts contacts = i % 5 == 0   ? nearly_parallel(rng)
                            : i % 5 == 1 ? nearly_flat(rng)
                            : i % 5 == 2 ? slippery_and_sticky(rng)
                            : i % 5 == 3 ? coincident(rng)
                                         : symmetric(rng);
  const double scale = uniform(rng, 0, 1) < 0.7 ? 1 : magnitude(rng, -3, 3);
  const WrenchSet set = wrench_set(contacts, Eigen::Vector3d::Zero(), scale);
  if (i % 4 != 3) return set;
  WrenchSet cut = friction_pyramids(set, 3 + static_cast<int>(uniform(rng, 0, 6)));
  for (WrenchCap& cap : cut.caps) cap.contact = -1;  // one cap a contact, as the search wants
  return cut;
}

TEST(EpsilonFuzz, BoundsHoldTheLeastSupport) {
  std::mt19937 rng(14);
  int inside = 0, flat = 0, open = 0;
  for (int i = 0; i < sets(); ++i) {
    const WrenchSet set = odd_set(rng, i);
    for (const ForceNorm limit : {ForceNorm::kL1, ForceNorm::kLinf}) {
      if (limit == ForceNorm::kLinf && set.caps.size() > 12) continue;
      EpsilonOptions options;
      options.limit = limit;
      options.max_facets = kMaxFacets;
      const Epsilon e = epsilon(set, options);
      EXPECT_LE(e.lower, e.upper) << i;
      EXPECT_NEAR(e.worst_wrench.norm(), 1, 1e-9) << i;
      const ForceNorm meant = e.force_closure ? limit : ForceNorm::kL1;
      double size = 0;
      for (const WrenchCap& cap : set.caps) size += cap.c.norm() + cap.A.norm();
      // Of flat sets a value within rounding of 0 is called 0.
      const double slack = 1e-9 * size;
      EXPECT_LE(support(set, -e.worst_wrench, meant), e.upper + slack) << i;
      EXPECT_GE(BruteEpsilon(set, meant)(rng, 0, 0), e.lower - slack) << i;
      inside += e.force_closure ? 1 : 0;
      flat += e.rank < 6 ? 1 : 0;
      open += e.converged ? 0 : 1;
      EXPECT_TRUE(e.converged || e.facets > kMaxFacets) << i;
    }
  }
  EXPECT_GT(inside, sets() / 5);
  EXPECT_GT(flat, sets() / 20);
  // Many contacts in symmetry with friction far beyond 1, at gaps of 1e-4 of the value.
  EXPECT_LT(open, sets() / 10);
}

}  // namespace
}  // namespace thenar
