// Tests of limits of patches: how a patch is cut into points changes nothing.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/spatial.h"
#include "grasp/contact/contact.h"
#include "grasp/limits/force_set.h"
#include "grasp/limits/grasp_force.h"
#include "grasp/limits/wrench_support.h"
#include "grasp/quality/epsilon.h"
#include "grasp/quality/robustness.h"
#include "grasp/quality/volume.h"
#include "tests/grasp/quality/random_grasps.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// Corners of a rectangle at a distance from the middle of a jaw box, pressed towards it.
std::vector<Contact> face(const Vector3d& outward, double friction, int patch) {
  const Tangents t = tangents(outward);
  std::vector<Contact> corners;
  for (const auto& [y, z] : {std::pair(1.0, 1.0), {1.0, -1.0}, {-1.0, -1.0}, {-1.0, 1.0}})
    corners.push_back({outward + 0.4 * y * t.e1 + 0.3 * z * t.e2, -outward, friction, 0, patch});
  return corners;
}

std::vector<Contact> jaws(double friction) {
  std::vector<Contact> contacts = face({1, 0, 0}, friction, 0);
  const std::vector<Contact> other = face({-1, 0, 0}, friction, 1);
  contacts.insert(contacts.end(), other.begin(), other.end());
  return contacts;
}

/// A point between all of a patch, by random shares; the same normal and friction.
Contact between(const std::vector<Contact>& contacts, int patch, std::mt19937& rng) {
  Contact mixed;
  Vector3d sum(0, 0, 0);
  double shares = 0;
  for (const Contact& each : contacts) {
    if (each.patch != patch) continue;
    const double share = uniform(rng, 0, 1);
    sum += share * each.p;
    shares += share;
    mixed = each;
  }
  mixed.p = sum / shares;
  return mixed;
}

WrenchSet set_of(const std::vector<Contact>& contacts) {
  return wrench_set(contacts, {0, 0, 0}, 1);
}

Epsilon epsilon_of(const std::vector<Contact>& contacts, ForceNorm limit, double gap = 1e-3) {
  EpsilonOptions options;
  options.limit = limit;
  options.gap = gap;
  return epsilon(set_of(contacts), options);
}

std::vector<Contact> twice(const std::vector<Contact>& contacts) {
  std::vector<Contact> doubled;
  for (const Contact& contact : contacts) doubled.insert(doubled.end(), 2, contact);
  return doubled;
}

std::vector<Contact> subdivided(std::vector<Contact> contacts, std::mt19937& rng) {
  const std::vector<Contact> corners = contacts;
  for (int i = 0; i < 6; ++i) contacts.push_back(between(corners, i % 2, rng));
  std::shuffle(contacts.begin(), contacts.end(), rng);
  return contacts;
}

// Two opposed rigid faces press with 1 N each. A push along y by u_y alone: both faces give
// mu |u_y|, h = 2 mu + 0 along x, and so on; the value is checked against directions below.
TEST(PatchLimit, SupportIsThatOfTheCorners) {
  std::mt19937 rng(1);
  const std::vector<Contact> contacts = jaws(0.5);
  const WrenchSet set = set_of(contacts);
  for (int i = 0; i < 200; ++i) {
    WrenchCoordinates u;
    for (double& x : u) x = uniform(rng, -1, 1);
    // By hand: the better of 0 and the best corner, of each face by itself.
    double sum = 0;
    for (const int patch : {0, 1}) {
      double best = 0;
      for (const Contact& c : contacts) {
        if (c.patch != patch) continue;
        const Vector3d at = u.head<3>() + u.tail<3>().cross(c.p);  // velocity of the point
        const double normal = at.dot(c.n);
        best = std::max(best, normal + c.friction * (at - normal * c.n).norm());
      }
      sum += best;
    }
    EXPECT_NEAR(support(set, ScaledWrench::from_coordinates(u), ForceNorm::kLinf), sum, 1e-12);
  }
}

TEST(PatchLimit, CutsOfAPatchChangeNothing) {
  std::mt19937 rng(2);
  for (const double mu : {0.3, 0.9})
    for (const ForceNorm limit : {ForceNorm::kL1, ForceNorm::kLinf}) {
      const Epsilon plain = epsilon_of(jaws(mu), limit);
      ASSERT_TRUE(plain.force_closure);
      for (const Epsilon& cut :
           {epsilon_of(twice(jaws(mu)), limit), epsilon_of(subdivided(jaws(mu), rng), limit)}) {
        EXPECT_TRUE(cut.converged);
        EXPECT_NEAR(cut.upper, plain.upper, 1e-3);
        EXPECT_LE(cut.lower, plain.upper + 1e-12);
        EXPECT_GE(cut.upper, plain.lower - 1e-12);
      }
    }
}

// A grasp of points without patches has two limits for two points, but one for one point written
// down twice: with two limits the sum would reach twice as far.
TEST(PatchLimit, OnePlaceIsOneContact) {
  std::mt19937 rng(3);
  const std::vector<Contact> contacts = random_contacts(rng, 4);
  std::vector<Contact> again = twice(contacts);
  for (std::size_t i = 1; i < again.size(); i += 2)
    again[i].p += 1e-12 * random_direction(rng);  // written with other last digits
  const Epsilon once = epsilon_of(contacts, ForceNorm::kLinf, 1e-2);
  const Epsilon doubled = epsilon_of(again, ForceNorm::kLinf, 1e-2);
  ASSERT_TRUE(once.force_closure);
  EXPECT_LE(doubled.lower, once.upper + 1e-9);
  EXPECT_GE(doubled.upper, once.lower - 1e-9);
  EXPECT_EQ(contact_regions(again), (std::vector<int>{0, 0, 1, 1, 2, 2, 3, 3}));
}

TEST(PatchLimit, PointsWithoutPatchesHaveLimitsOfTheirOwn) {
  std::vector<Contact> contacts = jaws(0.5);
  const double one = epsilon_of(contacts, ForceNorm::kLinf).lower;
  for (Contact& contact : contacts) contact.patch = -1;
  EXPECT_GT(epsilon_of(contacts, ForceNorm::kLinf, 1e-2).lower, 2 * one);
}

// Two rigid faces at x = +-1, mu, corners at (+-a, +-b). Torque about x: the twist (0 | 1, 0, 0)
// moves a corner along its face by r = sqrt(a^2 + b^2), so h = 2 mu r; force along y h = 2 mu;
// along x one face alone, h = 1; torque about y with arms b and 1, h of one face is max(0, b + mu)
// and of the other the same, 2 (b + mu). With mu = 0.3, r = 0.5 the twist bounds epsilon by 0.3.
TEST(PatchLimit, ClosedForms) {
  const WrenchSet set = set_of(jaws(0.3));
  const auto along = [&](int axis) {
    return support(set, ScaledWrench::unit(axis), ForceNorm::kLinf);
  };
  EXPECT_NEAR(along(0), 1, 1e-12);
  EXPECT_NEAR(along(1), 0.6, 1e-12);
  EXPECT_NEAR(along(2), 0.6, 1e-12);
  EXPECT_NEAR(along(3), 2 * 0.3 * 0.5, 1e-12);
  const Epsilon found = epsilon_of(jaws(0.3), ForceNorm::kLinf);
  EXPECT_LE(found.upper, 0.3);
  EXPECT_TRUE(found.converged);
}

// One frictionless patch of three points has the sum of normal forces 1: with 0 a tetrahedron in
// (f_x, t_y, t_z) of volume |det| / 6. Two of them in complementary axes: the volumes multiply,
// as a direct sum of sets in orthogonal spaces.
TEST(PatchLimit, VolumeIsOfThePatch) {
  WrenchSet set;
  double expected = 1;
  std::mt19937 rng(4);
  for (const int patch : {0, 1}) {
    Eigen::Matrix3d columns;
    for (int k = 0; k < 3; ++k) {
      WrenchCoordinates w = WrenchCoordinates::Zero();
      for (int i = 0; i < 3; ++i) columns(i, k) = w(3 * patch + i) = uniform(rng, -1, 1);
      set.caps.push_back({ScaledWrench::from_coordinates(w), {}, patch});
    }
    expected *= std::abs(columns.determinant()) / 6;
  }
  VolumeOptions options;
  options.limit = ForceNorm::kLinf;
  EXPECT_NEAR(volume(set, options).estimate, expected, 1e-9 * expected);
}

// The largest load along y by cone programmes: 2 mu with one limit a face, however cut.
TEST(PatchLimit, LoadsHaveTheSameLimit) {
  for (const std::vector<Contact>& contacts : {jaws(0.5), twice(jaws(0.5))}) {
    const WrenchSupport reach =
        load_margin(unit_forces(set_of(contacts), ForceNorm::kLinf), ScaledWrench::unit(1));
    EXPECT_NEAR(reach.value, 1, 1e-8);
  }
}

// A weight of 1 N across: each face bears half of it by friction, and so presses 1 N, however it is
// cut; point by point its corners share that, 0.25 N each.
TEST(PatchLimit, HoldsNeedTheSameForceOfAPatch) {
  std::mt19937 rng(6);
  for (const std::vector<Contact>& contacts :
       {jaws(0.5), twice(jaws(0.5)), subdivided(jaws(0.5), rng)}) {
    const GraspForce hold = minimum_grasp_force(
        free_forces(set_of(contacts)), ScaledWrench::unit(1), GraspForceObjective::kLargest);
    EXPECT_NEAR(hold.objective, 1, 1e-8);
  }
}

// Whatever forces of at most 1 N withstand k times a load, 1 / k of them withstand the load: the
// least objective and the largest load are two programmes for one number, of points and of patches.
TEST(PatchLimit, HoldsAndLoadsAreOneNumber) {
  std::mt19937 rng(7);
  for (const std::vector<Contact>& contacts :
       {jaws(0.5), subdivided(jaws(0.8), rng), random_contacts(rng, 5)})
    for (int i = 0; i < 10; ++i) {
      const WrenchSet set = set_of(contacts);
      const ScaledWrench load = ScaledWrench::from_coordinates(
          WrenchCoordinates::NullaryExpr([&] { return uniform(rng, -1, 1); }));
      for (const auto& [limit, objective] :
           {std::pair(ForceNorm::kL1, GraspForceObjective::kSum),
            std::pair(ForceNorm::kLinf, GraspForceObjective::kLargest)}) {
        const WrenchSupport most = load_margin(unit_forces(set, limit), load);
        const GraspForce hold = minimum_grasp_force(free_forces(set), load, objective);
        if (most.value < 1e-6) continue;  // not held at all
        ASSERT_EQ(hold.status, Status::kSolved);
        EXPECT_NEAR(hold.objective * most.value, 1, 1e-7);
      }
    }
}

// A rigid face that is off is off as a whole.
TEST(PatchLimit, DisturbancesMoveAFaceAsOne) {
  std::mt19937 rng(5);
  const std::vector<Contact> contacts = jaws(0.5);
  const std::vector<Contact> moved = disturb_contacts(contacts, {0.1, 0.01, 0.1}, rng);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const std::size_t first = i < 4 ? 0 : 4;
    EXPECT_EQ(moved[i].n, moved[first].n);
    EXPECT_EQ(moved[i].friction, moved[first].friction);
    EXPECT_LT((moved[i].p - contacts[i].p - (moved[first].p - contacts[first].p)).norm(), 1e-15);
  }
  EXPECT_NE(moved[0].friction, moved[4].friction);
  EXPECT_GT((moved[0].n - contacts[0].n).norm(), 1e-3);
}

}  // namespace
}  // namespace thenar
