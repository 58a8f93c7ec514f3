// Tests for grasp/contact/friction_pyramid.cpp, and of epsilon and volume on polytopes
// against qhull; THENAR_GRASPS set for all 1,000 sets.

#include "grasp/contact/friction_pyramid.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "base/error.h"
#include "grasp/quality/epsilon.h"
#include "grasp/quality/volume.h"
#include "tests/grasp/quality/qhull_hull.h"
#include "tests/grasp/quality/random_grasps.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

TEST(Pyramids, StartAlongTheFirstTangent) {
  Contact contact;
  contact.friction = 0.5;
  const WrenchSet set = wrench_set({contact}, Eigen::Vector3d::Zero(), 1);
  const WrenchSet cut = friction_pyramids(set, 4);
  ASSERT_EQ(cut.caps.size(), 4U);
  WrenchCoordinates first;
  first << 0.5 * tangents(contact.n).e1 + contact.n, 0, 0, 0;
  EXPECT_TRUE(matrix_near(cut.caps[0].c.vector(), first, 1e-15));
}

TEST(Pyramids, OfSoftFingersHavePoles) {
  Contact contact;
  contact.friction = 0.5;
  contact.torsion = 0.1;
  const WrenchSet cut = friction_pyramids(wrench_set({contact}, Eigen::Vector3d::Zero(), 1), 6);
  ASSERT_EQ(cut.caps.size(), 8U);
  EXPECT_DOUBLE_EQ(std::abs(cut.caps[6].c.moment_over_length.z()), 0.1);
  EXPECT_DOUBLE_EQ(cut.caps[6].c.moment_over_length.z(), -cut.caps[7].c.moment_over_length.z());
}

TEST(Pyramids, LieInTheConesAndThoseAboutContainThem) {
  std::mt19937 rng(5);
  std::vector<Contact> contacts = random_contacts(rng, 4);
  contacts[0].torsion = 0.2;
  contacts[1].friction = 0;
  const WrenchSet set = wrench_set(contacts, Eigen::Vector3d::Zero(), 1);
  const WrenchSet in = friction_pyramids(set, 6), even = inscribed_polytopes(set, 6),
                  about = circumscribed_polytopes(set, 6);
  for (int i = 0; i < 1000; ++i) {
    const ScaledWrench u = ScaledWrench::from_coordinates(
        WrenchCoordinates::NullaryExpr([&] { return uniform(rng, -1, 1); }));
    for (const ForceNorm limit : {ForceNorm::kL1, ForceNorm::kLinf}) {
      EXPECT_LE(support(in, u, limit), support(set, u, limit) + 1e-12);
      EXPECT_LE(support(even, u, limit), support(set, u, limit) + 1e-12);
      EXPECT_GE(support(about, u, limit), support(set, u, limit) - 1e-12);
    }
  }
}

TEST(Pyramids, HaveThreeEdgesOrMore) { EXPECT_THROW((void)friction_pyramids({}, 2), InputError); }

struct Case {
  ForceNorm limit;
  int contacts, edges, sets;
};

/// Compares with the whole hull by qhull; counts what was compared.
int compare_with_qhull(const Case& c, std::mt19937& rng) {
  constexpr double kRelative = 1e-9;
  int inside = 0;
  const int sets = std::getenv("THENAR_GRASPS") == nullptr ? (c.sets + 7) / 8 : c.sets;
  for (int i = 0; i < sets; ++i) {
    const WrenchSet polytope = friction_pyramids(
        wrench_set(random_contacts(rng, c.contacts), Eigen::Vector3d::Zero(), 1), c.edges);
    const QhullHull theirs = qhull_hull(vertices_of(polytope, c.limit), "qhull Qt Pp", true);
    EXPECT_TRUE(theirs.ok);
    EpsilonOptions options;
    options.limit = c.limit;
    options.gap = 1e-11;
    const Epsilon ours = epsilon(polytope, options);
    EXPECT_TRUE(ours.converged) << ours.upper - ours.lower;
    if (theirs.nearest > 1e-9) {
      EXPECT_NEAR(ours.lower, theirs.nearest, kRelative * theirs.nearest + 2e-11);
      EXPECT_NEAR(ours.upper, theirs.nearest, kRelative * theirs.nearest + 2e-11);
      ++inside;
    } else {
      EXPECT_LE(ours.upper,
                1e-12);  // the sign agrees; the distance is not a facet's offset
    }
    VolumeOptions volume_options;
    volume_options.limit = c.limit;
    const Volume v = volume(polytope, volume_options);
    EXPECT_TRUE(v.complete);
    EXPECT_NEAR(v.estimate, theirs.volume, kRelative * theirs.volume);
  }
  return inside;
}

TEST(Pyramids, OfTheL1SetHaveTheEpsilonAndVolumeOfQhullsHull) {
  std::mt19937 rng(1);
  int inside = 0;
  for (const Case& c : {Case{ForceNorm::kL1, 3, 4, 250},
                        {ForceNorm::kL1, 4, 6, 250},
                        {ForceNorm::kL1, 5, 3, 410},
                        {ForceNorm::kL1, 3, 8, 50}})
    inside += compare_with_qhull(c, rng);
  EXPECT_GT(inside, 20);
}

TEST(Pyramids, OfTheLinfSetHaveTheEpsilonAndVolumeOfQhullsHull) {
  std::mt19937 rng(2);
  int inside = 0;
  for (const Case& c : {Case{ForceNorm::kLinf, 3, 3, 36}, {ForceNorm::kLinf, 3, 4, 4}})
    inside += compare_with_qhull(c, rng);
  EXPECT_GT(inside, 0);
}

}  // namespace
}  // namespace thenar
