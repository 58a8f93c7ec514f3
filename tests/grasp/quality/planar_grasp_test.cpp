// Tests for grasp/quality/planar_grasp.cpp.

#include "grasp/quality/planar_grasp.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/grasp/quality/random_grasps.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

Contact on_disc(double angle, double friction) {
  const Vector3d outward(std::cos(angle), std::sin(angle), 0);
  return {outward, -outward, friction, 0};
}

Epsilon disc_epsilon(const std::vector<Contact>& contacts, ForceNorm limit = ForceNorm::kL1) {
  return planar_epsilon(planar_wrench_set(contacts, {0, 0, 0}, 1), limit);
}

// Two opposed fingers on a disc of radius 1: wrenches (-+1, +-mu, -+mu) etc., a rectangle of
// corners (1, s, -s), (-1, s, s), s = +-mu. They span a tetrahedron; by symmetry a nearest facet
// through (1, mu, -mu), (1, -mu, mu), (-1, mu, mu) has the normal (mu, 1, 1) / sqrt(2 + mu^2) and
// the offset mu / sqrt(2 + mu^2).
TEST(Planar, TwoFingersOnADisc) {
  for (const double mu : {0.2, 0.5, 1.0}) {
    const Epsilon found = disc_epsilon({on_disc(0, mu), on_disc(M_PI, mu)});
    EXPECT_TRUE(found.force_closure);
    EXPECT_EQ(found.rank, 3);
    EXPECT_NEAR(found.lower, mu / std::sqrt(2 + mu * mu), 1e-11);
    EXPECT_LE(found.lower, found.upper);
  }
}

// Frictionless fingers on a disc make no torque; those on three sides of a triangle make forces.
TEST(Planar, FrictionlessDiscMissesTheTorque) {
  const Epsilon found = disc_epsilon({on_disc(0, 0), on_disc(2.1, 0), on_disc(4.2, 0)});
  EXPECT_FALSE(found.force_closure);
  EXPECT_EQ(found.rank, 2);
  EXPECT_EQ(found.upper, 0);
  EXPECT_NEAR(std::abs(found.missing_direction.moment_over_length.z()), 1, 1e-9);
}

TEST(Planar, OneFingerIsAsFarAsItsNormal) {
  const Epsilon found = disc_epsilon({on_disc(0, 0.5)});
  EXPECT_FALSE(found.force_closure);
  EXPECT_NEAR(found.upper, -1, 1e-9);
}

// Four frictionless fingers at d off the middles of a square's sides, wrenches (+-1, 0, -d) and
// (0, +-1, d). The facet of both of the first and (0, 1, d) has the normal (0, 2 d, -1) /
// sqrt(1 + 4 d^2) and the offset d over the same; the other three are alike.
TEST(Planar, FormClosureOfASquare) {
  const double d = 0.3;
  const Epsilon found = disc_epsilon({{{-1, d, 0}, {1, 0, 0}, 0, 0},
                                      {{1, -d, 0}, {-1, 0, 0}, 0, 0},
                                      {{d, -1, 0}, {0, 1, 0}, 0, 0},
                                      {{-d, 1, 0}, {0, -1, 0}, 0, 0}});
  EXPECT_TRUE(found.force_closure);
  EXPECT_NEAR(found.lower, d / std::sqrt(1 + 4 * d * d), 1e-11);
}

double support_of(const WrenchSet& set, double azimuth, double height, ForceNorm limit) {
  const double r = std::sqrt(1 - height * height);
  const ScaledWrench u{{r * std::cos(azimuth), r * std::sin(azimuth), 0}, {0, 0, height}};
  return support(set, u, limit);
}

// The sphere of directions searched on a grid: never below, and near.
TEST(Planar, IsTheLeastOverAGrid) {
  std::mt19937 rng(2);
  int closed = 0;
  for (int i = 0; i < 40; ++i) {
    std::vector<Contact> contacts;
    for (int k = 0; k < 2 + i % 4; ++k) {
      Contact contact = on_disc(uniform(rng, 0, 2 * M_PI), uniform(rng, 0, 1));
      contact.patch = i % 3 == 0 ? k / 2 : -1;
      contacts.push_back(contact);
    }
    const WrenchSet set = planar_wrench_set(contacts, {0.1, 0, 0}, 0.8);
    for (const ForceNorm limit : {ForceNorm::kL1, ForceNorm::kLinf}) {
      const Epsilon found = planar_epsilon(set, limit);
      if (!found.force_closure) continue;
      ++closed;
      double least = 1e300;
      for (int a = 0; a < 240; ++a)
        for (int b = 0; b <= 120; ++b)
          least = std::min(least, support_of(set, 2 * M_PI * a / 240, b / 60.0 - 1, limit));
      EXPECT_LE(found.lower, least);
      EXPECT_GE(found.upper, least - 0.1);
      EXPECT_NEAR(support(set, -found.worst_wrench, limit), found.upper, 1e-11);
    }
  }
  EXPECT_GT(closed, 20);
}

TEST(Planar, RefusesWhatIsOffThePlane) {
  EXPECT_THROW((void)planar_wrench_set({{{0, 0, 1}, {1, 0, 0}, 0, 0}}, {0, 0, 0}, 1), InputError);
  EXPECT_THROW((void)planar_wrench_set({{{0, 0, 0}, {1, 0, 0}, 0, 1}}, {0, 0, 0}, 1), InputError);
}

}  // namespace
}  // namespace thenar
