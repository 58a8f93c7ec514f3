// Tests for grasp/quality/epsilon.cpp: values known in closed form, and what
// has no closure.

#include "grasp/quality/epsilon.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/grasp/quality/known_sets.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

constexpr double kTol = 1e-9;

Epsilon epsilon_of(const WrenchSet& set, ForceNorm limit, double gap) {
  EpsilonOptions options;
  options.limit = limit;
  options.gap = gap;
  return epsilon(set, options);
}

void expect_polytope(const WrenchSet& set, ForceNorm limit, double known) {
  const Epsilon e = epsilon_of(set, limit, 1e-11);
  EXPECT_TRUE(e.converged);
  EXPECT_NEAR(e.lower, known, kTol);
  EXPECT_NEAR(e.upper, known, kTol);
}

/// Curved sets: the bounds hold the known value, at the given gap.
void expect_enclosed(const WrenchSet& set, ForceNorm limit, double known, double gap) {
  const Epsilon e = epsilon_of(set, limit, gap);
  EXPECT_TRUE(e.converged);
  EXPECT_LE(e.lower, known);
  EXPECT_GE(e.upper, known);
  EXPECT_LE(e.upper - e.lower, gap);
}

// {+-a_i e_i}: facets sum |x_i| / a_i = 1, at distance 1 / |1 / a|.
TEST(EpsilonKnown, OfACrossPolytope) {
  expect_polytope(cross_polytope(), ForceNorm::kL1, 1 / kHalfAxes.cwiseInverse().norm());
}

// The sum of segments [-a_i, a_i] e_i is a box.
TEST(EpsilonKnown, OfABox) {
  expect_polytope(cross_polytope(), ForceNorm::kLinf, kHalfAxes.minCoeff());
}

// A regular simplex of n dimensions has an insphere n times smaller than its
// circumsphere.
TEST(EpsilonKnown, OfARegularSimplex) {
  expect_polytope(regular_simplex(), ForceNorm::kL1, 1.0 / 6);
}

// Four frictionless contacts (+-a, +-a) on each face of a cube of half side 1.
// With forces f and torques t of u,  h = max_k |f_k| + a sum_{j != k} |t_j|.
// |u| is largest at h = 1 at a vertex: f = (1, 1, 1): 3; f_k = 1, t_k = 1 / a:
// 1 + 1 / a^2; the others are smaller.
TEST(EpsilonKnown, OfFormClosureOfACube) {
  for (const double a : {0.1, 0.5, 0.7, 0.9})
    expect_polytope(cube_without_friction(a), ForceNorm::kL1,
                    1 / std::sqrt(std::max(3.0, 1 + 1 / (a * a))));
}

// Discs in the planes 12, 34, 56: h = max of three norms, least where they are
// equal; as a Minkowski sum, the sum of three norms, least where one has all.
TEST(EpsilonKnown, OfDiscsInOrthogonalPlanes) {
  expect_enclosed(orthogonal_discs(), ForceNorm::kL1, 1 / std::sqrt(3), 0.1);
  expect_enclosed(orthogonal_discs(), ForceNorm::kLinf, 1, 0.1);
}

// Balls of forces and of torques: h = max(|f|, |t|).
TEST(EpsilonKnown, OfOrthogonalBalls) {
  expect_enclosed(orthogonal_balls(), ForceNorm::kL1, 1 / std::sqrt(2), 0.2);
}

// Soft fingers at +-x, with P, Q the norms of the ellipsoids, h = max(P - f_x,
// Q + f_x). Where both are equal to S: S^2 + D^2 = m^2 (1 - D^2 - t_x^2) + g^2
// t_x^2 with D = f_x, Q = S - D >= g |t_x|. On the boundary of that this is an
// ellipse in (S, t_x), so S is least at an end: t_x = 0: m / sqrt(2 + m^2), or
// t_x = 1: g.
TEST(EpsilonKnown, OfTwoSoftFingers) {
  for (const double friction : {0.3, 0.8}) {
    for (const double torsion : {0.1, 0.6}) {
      const double known = std::min(friction / std::sqrt(2 + friction * friction), torsion);
      expect_enclosed(two_soft_fingers(friction, torsion), ForceNorm::kL1, known, 1e-3);
    }
  }
}

// The same with both limited: h = max(0, P - f_x) + max(0, Q + f_x), least
// where the first is just 0: all in P: sqrt(2) m / sqrt(1 + 2 m^2), or all in
// torsion: 2 g / sqrt(1 + g^2).
TEST(EpsilonKnown, OfTwoSoftFingersEachLimited) {
  for (const double friction : {0.3, 0.8}) {
    for (const double torsion : {0.1, 0.6}) {
      const double known =
          std::min(std::sqrt(2) * friction / std::sqrt(1 + 2 * friction * friction),
                   2 * torsion / std::sqrt(1 + torsion * torsion));
      expect_enclosed(two_soft_fingers(friction, torsion), ForceNorm::kLinf, known, 1e-3);
    }
  }
}

TEST(EpsilonKnown, OfOneContactWithoutFrictionIsMinusItsWrench) {
  const WrenchSet set = wrench_set({{{0.3, 0, 0}, {0, 0, 1}, 0, 0}}, Eigen::Vector3d::Zero(), 0.1);
  const Epsilon e = epsilon(set);
  EXPECT_NEAR(e.lower, -std::sqrt(1 + 9.0), kTol);
  EXPECT_NEAR(e.upper, -std::sqrt(1 + 9.0), kTol);
  EXPECT_EQ(e.rank, 1);
}

// Normals a either side of z through the centre, friction m: the nearest point
// pulls both tangents back along z: -(cos a - m sin a).
TEST(EpsilonKnown, OfTwoContactsOnOneSide) {
  const double a = 0.5, friction = 0.4;
  std::vector<Contact> contacts(2);
  for (int i = 0; i < 2; ++i) {
    Contact& contact = contacts[static_cast<std::size_t>(i)];
    contact.n = {(i == 0 ? 1 : -1) * std::sin(a), 0, std::cos(a)};
    contact.p = -contact.n;
    contact.friction = friction;
  }
  const Epsilon e = epsilon(wrench_set(contacts, Eigen::Vector3d::Zero(), 1));
  const double known = -(std::cos(a) - friction * std::sin(a));
  EXPECT_NEAR(e.lower, known, kTol);
  EXPECT_NEAR(e.upper, known, kTol);
  EXPECT_TRUE(matrix_near(e.missing_direction.vector(), -WrenchCoordinates::Unit(2), 1e-4));
}

// Any number of contacts that push along z: -1.
TEST(EpsilonKnown, OfParallelNormalsIsMinusOne) {
  std::vector<Contact> contacts;
  for (const double x : {-1.0, 0.0, 1.0})
    for (const double y : {-1.0, 1.0}) contacts.push_back({{x, y, 0}, {0, 0, 1}, 0.5, 0});
  const Epsilon e = epsilon(wrench_set(contacts, Eigen::Vector3d::Zero(), 1));
  EXPECT_EQ(e.rank, 6);
  EXPECT_FALSE(e.force_closure);
  EXPECT_NEAR(e.upper, -1, kTol);
  EXPECT_NEAR(e.lower, -1, kTol);
}

TEST(EpsilonFlat, TwoHardFingersLackTorqueAboutTheirLine) {
  for (const ForceNorm limit : {ForceNorm::kL1, ForceNorm::kLinf}) {
    const Epsilon e = epsilon_of(two_soft_fingers(0.5, 0), limit, 1e-3);
    EXPECT_EQ(e.rank, 5);
    EXPECT_EQ(e.lower, 0);
    EXPECT_EQ(e.upper, 0);
    EXPECT_FALSE(e.force_closure);
    ASSERT_TRUE(e.has_missing_direction);
    EXPECT_NEAR(std::abs(e.missing_direction.moment_over_length.x()), 1, kTol);
  }
}

TEST(EpsilonFlat, ContactsOnALineLackTorqueAboutIt) {
  std::vector<Contact> contacts;
  for (const double x : {-1.0, 0.0, 1.0, 2.0}) {
    contacts.push_back({{x, 0, 0}, {0, 0, 1}, 0.5, 0});
    contacts.push_back({{x, 0, 0}, {0, 0, -1}, 0.5, 0});
  }
  const Epsilon e = epsilon(wrench_set(contacts, Eigen::Vector3d::Zero(), 1));
  EXPECT_EQ(e.rank, 5);
  EXPECT_NEAR(std::abs(e.missing_direction.moment_over_length.x()), 1, kTol);
  EXPECT_EQ(e.upper, 0);
}

// Frictionless on a circle in a plane: forces in it, and no torque.
TEST(EpsilonFlat, FrictionlessDiscHasRankTwo) {
  std::vector<Contact> contacts;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d out(std::cos(2 * M_PI * i / 3), std::sin(2 * M_PI * i / 3), 0);
    contacts.push_back({out, -out, 0, 0});
  }
  const Epsilon e = epsilon(wrench_set(contacts, Eigen::Vector3d::Zero(), 1));
  EXPECT_EQ(e.rank, 2);
  EXPECT_EQ(e.lower, 0);
  EXPECT_EQ(e.upper, 0);
}

TEST(EpsilonFlat, OfNothingIsZeroAndLacksAllDirections) {
  const Epsilon e = epsilon({});
  EXPECT_EQ(e.rank, 0);
  EXPECT_EQ(e.upper, 0);
  EXPECT_TRUE(e.has_missing_direction);
}

// All of x_1 <= 0: the origin lies on a facet of a set of full rank.
TEST(EpsilonFlat, TheOriginOnTheBoundaryIsNoClosure) {
  WrenchSet set = cross_polytope();
  for (WrenchCap& cap : set.caps)
    if (cap.c.force.x() > 0) cap.c.force.x() = 0;
  const Epsilon e = epsilon(set);
  EXPECT_EQ(e.rank, 6);
  EXPECT_FALSE(e.force_closure);
  EXPECT_NEAR(e.lower, 0, kTol);
  EXPECT_NEAR(e.upper, 0, kTol);
  EXPECT_TRUE(matrix_near(e.missing_direction.vector(), WrenchCoordinates::Unit(0), 1e-9));
}

TEST(Epsilon, RefusesWhatIsNotANumber) {
  WrenchSet set = cross_polytope();
  set.caps[3].c.force.z() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)epsilon(set), InputError);
  EXPECT_THROW((void)epsilon_of(cross_polytope(), ForceNorm::kL1, 0), InputError);
}

TEST(Epsilon, SaysSoWhenItGivesUp) {
  EpsilonOptions options;
  options.gap = 1e-9;
  options.max_facets = 500;
  WrenchSet three = orthogonal_balls();  // of two caps there would be a proof without facets
  three.caps.push_back(three.caps[0]);
  three.caps[2].A /= 2;  // within the first
  const Epsilon e = epsilon(three, options);
  EXPECT_FALSE(e.converged);
  EXPECT_LE(e.lower, 1 / std::sqrt(2));
  EXPECT_GE(e.upper, 1 / std::sqrt(2));
}

}  // namespace
}  // namespace thenar
