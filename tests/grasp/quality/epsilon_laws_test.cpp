// Laws of epsilon, and grasps that make warning.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "base/error.h"
#include "grasp/contact/friction_pyramid.h"
#include "grasp/quality/epsilon.h"
#include "tests/grasp/quality/random_grasps.h"

namespace thenar {
namespace {

constexpr int kGrasps = 60;
constexpr double kRounding = 1e-12;

Epsilon epsilon_at_scale(const std::vector<Contact>& contacts, double scale = 1,
                         ForceNorm limit = ForceNorm::kL1) {
  EpsilonOptions options;
  options.limit = limit;
  return epsilon(wrench_set(contacts, Eigen::Vector3d::Zero(), scale), options);
}

void expect_sound(const Epsilon& e, const WrenchSet& set, ForceNorm limit) {
  EXPECT_LE(e.lower, e.upper);
  EXPECT_NEAR(e.worst_wrench.norm(), 1, kRounding);
  EXPECT_EQ(e.force_closure, e.lower > 0);
  EXPECT_EQ(e.has_missing_direction, !e.force_closure);
  const ForceNorm meant = e.force_closure ? limit : ForceNorm::kL1;
  double size = 0;
  for (const WrenchCap& cap : set.caps) size += cap.c.norm() + cap.A.norm();
  EXPECT_LE(support(set, -e.worst_wrench, meant), e.upper + 1e-12 * size);
  if (e.has_missing_direction) {
    EXPECT_LE(support(set, e.missing_direction, ForceNorm::kL1), std::max(e.upper, 1e-9 * size));
  }
}

// True values obey v <= w; of what is certified, lower(v) <= upper(w) follows.
TEST(EpsilonLaws, AnotherContactNeverLowersIt) {
  std::mt19937 rng(1);
  for (int i = 0; i < kGrasps; ++i) {
    std::vector<Contact> contacts = random_contacts(rng, 6);
    std::vector<Contact> fewer(contacts.begin(), contacts.end() - 1);
    for (const ForceNorm limit : {ForceNorm::kL1, ForceNorm::kLinf})
      EXPECT_LE(epsilon_at_scale(fewer, 1, limit).lower,
                epsilon_at_scale(contacts, 1, limit).upper);
  }
}

TEST(EpsilonLaws, MoreFrictionNeverLowersIt) {
  std::mt19937 rng(2);
  for (int i = 0; i < kGrasps; ++i) {
    std::vector<Contact> contacts = random_contacts(rng, 4);
    double before = -std::numeric_limits<double>::infinity();
    for (const double friction : {0.0, 0.1, 0.3, 0.5, 0.51, 0.9}) {
      for (Contact& contact : contacts) contact.friction = friction;
      const Epsilon e = epsilon_at_scale(contacts);
      EXPECT_GE(e.upper, before);
      before = e.lower;
    }
  }
}

TEST(EpsilonLaws, EachLimitedIsNoLessThanAllTogether) {
  std::mt19937 rng(3);
  for (int i = 0; i < kGrasps; ++i) {
    const std::vector<Contact> contacts = random_contacts(rng, 4);
    EXPECT_GE(epsilon_at_scale(contacts, 1, ForceNorm::kLinf).upper,
              epsilon_at_scale(contacts).lower);
  }
}

TEST(EpsilonLaws, PyramidsInConesAreNoBetterThanTheCones) {
  std::mt19937 rng(4);
  for (int i = 0; i < kGrasps; ++i) {
    const WrenchSet set = wrench_set(random_contacts(rng, 4), Eigen::Vector3d::Zero(), 1);
    const Epsilon cone = epsilon(set);
    EXPECT_LE(epsilon(friction_pyramids(set, 8)).lower, cone.upper);
    EXPECT_GE(epsilon(circumscribed_polytopes(set, 8)).upper, cone.lower);
  }
}

// Moving points, normals and centre together turns forces and torques alike: no distance changes.
TEST(EpsilonLaws, RigidMotionsDoNotChangeIt) {
  std::mt19937 rng(5);
  for (int i = 0; i < kGrasps; ++i) {
    const std::vector<Contact> contacts = random_contacts(rng, 4);
    const Pose<double> X{rotation_about<double>(random_direction(rng), uniform(rng, 0, 6)),
                         10 * random_direction(rng)};
    std::vector<Contact> moved = contacts;
    for (Contact& contact : moved) {
      contact.p = X * contact.p;
      contact.n = X.R * contact.n;
    }
    EpsilonOptions fine;
    fine.gap = 1e-4;
    const Epsilon a = epsilon(wrench_set(contacts, Eigen::Vector3d::Zero(), 1), fine);
    const Epsilon b = epsilon(wrench_set(moved, X.p, 1), fine);
    EXPECT_LE(a.lower, b.upper);
    EXPECT_LE(b.lower, a.upper);
  }
}

TEST(EpsilonLaws, LengthsAndTorqueScaleTogetherDoNotChangeIt) {
  std::mt19937 rng(6);
  for (int i = 0; i < kGrasps; ++i) {
    std::vector<Contact> contacts = random_contacts(rng, 4);
    contacts[0].torsion = 0.1;
    const Epsilon a = epsilon_at_scale(contacts);
    for (Contact& contact : contacts) {
      contact.p *= 0.0078125;  // a power of 2: no rounding
      contact.torsion *= 0.0078125;
    }
    const Epsilon b = epsilon_at_scale(contacts, 0.0078125);
    EXPECT_EQ(a.lower, b.lower);
    EXPECT_EQ(a.upper, b.upper);
  }
}

TEST(EpsilonStability, TorqueScalesFromMillimetresToKilometres) {
  std::mt19937 rng(7);
  int closures = 0;
  for (int i = 0; i < kGrasps; ++i) {
    const std::vector<Contact> contacts = random_contacts(rng, 5);
    for (const double scale : {1e-3, 1e-2, 1.0, 1e2, 1e3}) {
      const WrenchSet set = wrench_set(contacts, Eigen::Vector3d::Zero(), scale);
      for (const ForceNorm limit : {ForceNorm::kL1, ForceNorm::kLinf}) {
        EpsilonOptions options;
        options.limit = limit;
        const Epsilon e = epsilon(set, options);
        expect_sound(e, set, limit);
        EXPECT_TRUE(e.converged);
        EXPECT_EQ(e.rank, 6);
        // Whether the origin is inside does not depend on the scale.
        EXPECT_EQ(e.force_closure, epsilon_at_scale(contacts).force_closure) << i << " " << scale;
      }
    }
    closures += epsilon_at_scale(contacts).force_closure ? 1 : 0;
  }
  EXPECT_GT(closures, kGrasps / 4);
}

TEST(EpsilonStability, DuplicatesChangeNothing) {
  std::mt19937 rng(8);
  for (int i = 0; i < kGrasps; ++i) {
    std::vector<Contact> contacts = random_contacts(rng, 4);
    const Epsilon once = epsilon_at_scale(contacts);
    const std::vector<Contact> copies = contacts;
    for (int k = 0; k < 3; ++k) contacts.insert(contacts.end(), copies.begin(), copies.end());
    const Epsilon often = epsilon_at_scale(contacts);
    EXPECT_TRUE(often.converged);
    EXPECT_LE(often.lower, once.upper);
    EXPECT_LE(once.lower, often.upper);
  }
}

// Six contacts at the face centres of a cube, and eight at its corners: everything is coplanar with
// something.
TEST(EpsilonStability, SymmetricGraspsConverge) {
  std::vector<Contact> faces, corners;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {1.0, -1.0}) {
      const Eigen::Vector3d out = side * Eigen::Vector3d::Unit(axis);
      faces.push_back({out, -out, 0.5, 0});
    }
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d out(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    corners.push_back({out, -out.normalized(), 0.5, 0});
  }
  for (const auto& contacts : {faces, corners}) {
    const WrenchSet set = wrench_set(contacts, Eigen::Vector3d::Zero(), 1);
    const Epsilon e = epsilon(set);
    expect_sound(e, set, ForceNorm::kL1);
    EXPECT_TRUE(e.converged);
    EXPECT_TRUE(e.force_closure);
    for (const int edges : {4, 6, 8}) {
      EpsilonOptions exact;
      exact.gap = 1e-10;
      const Epsilon p = epsilon(friction_pyramids(set, edges), exact);
      EXPECT_TRUE(p.converged) << edges;
      EXPECT_LE(p.lower, e.upper);
    }
  }
}

TEST(EpsilonStability, RandomTroubleIsSound) {
  std::mt19937 rng(9);
  for (int i = 0; i < 300; ++i) {
    std::vector<Contact> contacts = random_contacts(rng, 1 + static_cast<int>(uniform(rng, 0, 8)));
    for (Contact& contact : contacts) {
      if (uniform(rng, 0, 1) < 0.3) contact.friction = 0;
      if (uniform(rng, 0, 1) < 0.3) contact.n = contacts[0].n;
      if (uniform(rng, 0, 1) < 0.3) contact.p = contacts[0].p;
      if (uniform(rng, 0, 1) < 0.3) contact.n = (-contact.n).eval();
      if (uniform(rng, 0, 1) < 0.3) contact.p.z() = 0;
      if (uniform(rng, 0, 1) < 0.2) contact.torsion = 0.1;
    }
    for (const ForceNorm limit : {ForceNorm::kL1, ForceNorm::kLinf}) {
      const WrenchSet set = wrench_set(contacts, Eigen::Vector3d::Zero(), 1);
      EpsilonOptions options;
      options.limit = limit;
      const Epsilon e = epsilon(set, options);
      expect_sound(e, set, limit);
      EXPECT_TRUE(e.converged) << i;
    }
  }
}

// Points within 0.25 <= x <= 1 that leave three dimensions by 1e-9 only: their hull is a needle
// whose planes all pass close to the origin, which is 0.25 away.
TEST(EpsilonStability, NeedlesBesideTheOriginAreAsFarAsTheyAre) {
  std::mt19937 rng(12);
  for (int i = 0; i < 100; ++i) {
    WrenchSet set;
    for (int k = 0; k < 12; ++k) {
      WrenchCoordinates w;
      for (double& x : w) x = uniform(rng, -1, 1) * 1e-9;
      w.head<3>() += Eigen::Vector3d(k < 4 ? 0.25 : 1, k & 1 ? 1 : -1, k & 2 ? 1 : -1);
      set.caps.push_back({ScaledWrench::from_coordinates(w), decltype(WrenchCap::A)(6, 0), -1});
    }
    const Epsilon e = epsilon(set);
    EXPECT_EQ(e.rank, 6);
    EXPECT_NEAR(e.lower, -0.25, 1e-8);
    EXPECT_NEAR(e.upper, -0.25, 1e-8);
    EXPECT_FALSE(e.force_closure);
  }
}

TEST(EpsilonStability, NoNumberPasses) {
  std::mt19937 rng(10);
  std::vector<Contact> contacts = random_contacts(rng, 3);
  contacts[1].p.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)epsilon_at_scale(contacts), InputError);
  contacts = random_contacts(rng, 3);
  contacts[2].friction = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)epsilon_at_scale(contacts), InputError);
}

}  // namespace
}  // namespace thenar
