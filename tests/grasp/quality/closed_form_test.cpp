// Epsilon of grasps whose value is a formula, derived here.
//
// Two opposed soft fingers at distance r from the centre, friction mu, torsion e, scale s, with
// rho = r / s:  h(u) = max(f_x + |A - B|, -f_x + |A + B|),  A = (mu f_y, mu f_z, e t_x / s),
// B = mu rho (t_z, -t_y, 0). With 2 m = |A - B| + |A + B| the point A is on an ellipse with foci
// +-B; 1 = |u|^2 is bilinear in the squares of its eccentricity and of the place along its axis,
// so extreme at the ends of both:  epsilon = min(e / s, 1 / sqrt(1 + 1/mu^2 + 1/(mu rho)^2)).

#include "grasp/quality/epsilon.h"

#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "grasp/quality/volume.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kExact = 1e-9;        // where the value is 0, negative, or that of a polytope
constexpr double kTorqueScale = 0.04;  // torques are divided by it [m]
constexpr double kBodyRadius = 0.03;   // of the disc or sphere, half an edge of the cube [m]

Epsilon epsilon_of(const std::vector<Contact>& contacts, double gap = 1e-11,
                   ForceNorm limit = ForceNorm::kL1) {
  EpsilonOptions options;
  options.gap = gap;
  options.limit = limit;
  return epsilon(wrench_set(contacts, {0, 0, 0}, kTorqueScale), options);
}

void expect_value(const Epsilon& found, double expected) {
  EXPECT_NEAR(found.lower, expected, kExact);
  EXPECT_NEAR(found.upper, expected, kExact);
}

/// Curved sets in six dimensions: both bounds enclose the value, and the upper one is it.
void expect_enclosed(const Epsilon& found, double expected, double gap) {
  EXPECT_LE(found.lower, expected + 1e-12);
  EXPECT_GE(found.upper, expected - 1e-12);
  EXPECT_NEAR(found.upper, expected, kExact);
  EXPECT_LE(found.upper - found.lower, gap);
  EXPECT_TRUE(found.force_closure);
}

void expect_missing(const Epsilon& found, const ScaledWrench& direction) {
  EXPECT_FALSE(found.force_closure);
  ASSERT_TRUE(found.has_missing_direction);
  EXPECT_NEAR(std::abs(found.missing_direction.dot(direction)), 1, 1e-9);
}

Contact on_sphere(const Vector3d& outward, double friction, double torsion = 0) {
  return {kBodyRadius * outward.normalized(), -outward.normalized(), friction, torsion};
}

std::vector<Contact> opposed_fingers(double friction, double torsion) {
  return {on_sphere({-1, 0, 0}, friction, torsion), on_sphere({1, 0, 0}, friction, torsion)};
}

double friction_bound(double mu) {
  return 1 / std::sqrt(1 + 1 / (mu * mu) + std::pow(kTorqueScale / (mu * kBodyRadius), 2));
}

// At the end where one finger's friction pays for the other's: A = B, f_x = |A|.
TEST(ClosedForm, TwoSoftFingersLimitedByFriction) {
  for (const double mu : {0.2, 0.5, 1.0}) {
    const double gap = 1e-3, expected = friction_bound(mu);
    expect_enclosed(epsilon_of(opposed_fingers(mu, 2 * kTorqueScale), gap), expected, gap);
    const ScaledWrench worst{{mu, 1, 0}, {0, 0, kTorqueScale / kBodyRadius}};
    const WrenchSet set =
        wrench_set(opposed_fingers(mu, 2 * kTorqueScale), {0, 0, 0}, kTorqueScale);
    EXPECT_NEAR(support(set, (1 / worst.norm()) * worst, ForceNorm::kL1), expected, kExact);
  }
}

TEST(ClosedForm, TwoSoftFingersLimitedByTorsion) {
  const double torsion = 0.1 * kTorqueScale, gap = 1e-3;
  ASSERT_LT(0.1, friction_bound(0.5));
  expect_enclosed(epsilon_of(opposed_fingers(0.5, torsion), gap), 0.1, gap);
}

// With each force at most 1, squeezing is free: 2 m = |A - B| + |A + B| is the support wherever
// -|A - B| <= f_x <= |A + B|. For rho = 1 extremes are again at the ends:
// 2 / sqrt(4 + 2 / mu^2), or 2 e / sqrt(s^2 + e^2) where torsion is the weaker.
TEST(ClosedForm, TwoSoftFingersOfUnitForceEach) {
  const double gap = 1e-3;
  const auto at_scale = [&](double mu, double torsion) {
    std::vector<Contact> contacts = opposed_fingers(mu, torsion);
    for (Contact& contact : contacts) contact.p *= kTorqueScale / kBodyRadius;
    return epsilon_of(contacts, gap, ForceNorm::kLinf);
  };
  expect_enclosed(at_scale(0.5, 2 * kTorqueScale), 2 / std::sqrt(4 + 2 / 0.25), gap);
  expect_enclosed(at_scale(0.5, 0.1 * kTorqueScale), 0.2 / std::sqrt(1.01), gap);
}

/// Pairs of opposed fingers on a sphere (or on the faces of what is about it).
std::vector<Contact> pairs(const std::vector<Vector3d>& directions, double mu, double torsion) {
  std::vector<Contact> contacts;
  for (const Vector3d& d : directions)
    for (const double side : {1.0, -1.0}) contacts.push_back(on_sphere(side * d, mu, torsion));
  return contacts;
}

// A pair along d has h = -+f'd + |(mu (a +- b), g t'd)|, a = f - d d'f, b = rho t x d, g = e / s.
// The larger of both is at least sqrt(mu^2 (|a|^2 + |b|^2) + g^2 (t'd)^2). Where the mean of d d'
// is I / 3, the mean of these squares is (2 mu^2 |f|^2 + (2 mu^2 rho^2 + g^2) |t|^2) / 3, and the
// largest is no less. For rho <= 1 and small g the factor of |t|^2 is the smaller one, and the
// bound is met by f = 0 and a t with all (t'd)^2 = 1 / 3:
//   epsilon = sqrt((2 mu^2 rho^2 + g^2) / 3).
void expect_of_pairs(const std::vector<Vector3d>& directions) {
  const double rho = kBodyRadius / kTorqueScale, gap = 3e-2;
  for (const double mu : {0.4, 0.9})
    for (const double g : {0.0, 0.2}) {
      ASSERT_LT(2 * mu * mu * rho * rho + g * g, 2 * mu * mu);
      expect_enclosed(epsilon_of(pairs(directions, mu, g * kTorqueScale), gap),
                      std::sqrt((2 * mu * mu * rho * rho + g * g) / 3), gap);
    }
}

TEST(ClosedForm, SixFingersOnTheFacesOfACube) {  // t = (1, 1, 1) / sqrt 3
  expect_of_pairs({Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()});
}

TEST(ClosedForm, EightFingersOnASphereTowardsTheCornersOfACube) {  // t = (1, 0, 0)
  expect_of_pairs({{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}});
}

// Hard points leave the twist about the line between them free.
TEST(ClosedForm, TwoHardFingersMissATwist) {
  const Epsilon found = epsilon_of(opposed_fingers(0.5, 0));
  expect_value(found, 0);
  EXPECT_EQ(found.rank, 5);
  expect_missing(found, ScaledWrench::unit(3));
}

TEST(ClosedForm, CollinearHardPointsMissATwist) {
  std::vector<Contact> contacts = opposed_fingers(0.8, 0);
  contacts.push_back({{0.01, 0, 0}, {0, 0.6, 0.8}, 0.8, 0});
  const Epsilon found = epsilon_of(contacts);
  expect_value(found, 0);
  EXPECT_EQ(found.rank, 5);
  expect_missing(found, ScaledWrench::unit(3));
}

// On a sphere, p and n are parallel: its wrench is the normal, friction is across it.
TEST(ClosedForm, OneContactOnASphereIsOneOff) {
  const Epsilon found = epsilon_of({on_sphere({1, 2, 2}, 0.7)});
  expect_value(found, -1);
  EXPECT_FALSE(found.force_closure);
}

// Pressing a cube's flange level with its centre, l beside it: the wrench (n, l t1 x n / s) is
// across both friction axes, mu (t1, 0) and mu (t2, l n / s).
TEST(ClosedForm, OneContactBesideTheCentre) {
  expect_value(epsilon_of({{{kBodyRadius, 0, 0}, {0, 0, -1}, 0.7, 0}}),
               -std::hypot(1, kBodyRadius / kTorqueScale));
}

TEST(ClosedForm, ParallelNormalsAreOneOff) {
  expect_value(epsilon_of({{{kBodyRadius, 0, kBodyRadius}, {0, 0, -1}, 0.7, 0},
                           {{-kBodyRadius, 0, kBodyRadius}, {0, 0, -1}, 0.7, 0}}),
               -1);
}

// n fingers around an axis, each phi off it: friction helps by mu sin phi of the cos phi that all
// press one way. In the mean everything else cancels, and along the axis nothing reaches further.
TEST(ClosedForm, FingersOnOneSideArePartlyHelpedByFriction) {
  for (const int n : {2, 3, 4, 5, 6}) {
    std::vector<Contact> contacts;
    const double phi = 0.9, mu = 0.4;
    for (int i = 0; i < n; ++i) {
      const double turn = 2 * M_PI * i / n;
      contacts.push_back(on_sphere(
          {std::sin(phi) * std::cos(turn), std::sin(phi) * std::sin(turn), std::cos(phi)}, mu));
    }
    const Epsilon found = epsilon_of(contacts);
    expect_value(found, -(std::cos(phi) - mu * std::sin(phi)));
    expect_missing(found, ScaledWrench::unit(2));
  }
}

// Antipodal within friction: |phi| beyond atan(1 / mu) turns the sign, but three dimensions need
// more than two hard points.
TEST(ClosedForm, FrictionlessSphereCanAlwaysTurn) {
  std::vector<Contact> contacts;
  for (int i = 0; i < 3; ++i)
    for (const double sign : {1.0, -1.0})
      contacts.push_back(on_sphere(sign * Vector3d::Unit(i), 0));
  const Epsilon found = epsilon_of(contacts);
  expect_value(found, 0);
  EXPECT_EQ(found.rank, 3);
  EXPECT_LT(found.missing_direction.force.norm(), kExact);
}

TEST(ClosedForm, FrictionlessDiscMissesAllButTwoForces) {
  std::vector<Contact> contacts;
  for (int i = 0; i < 3; ++i)
    contacts.push_back(on_sphere({std::cos(2 * i * M_PI / 3), std::sin(2 * i * M_PI / 3), 0}, 0));
  const Epsilon found = epsilon_of(contacts);
  expect_value(found, 0);
  EXPECT_EQ(found.rank, 2);
}

// Four frictionless fingers on a square plate, each off the middle of its side, stop all motion in
// the plane, but none across it.
TEST(ClosedForm, CoplanarNormalsMissTheirNormal) {
  const double l = 0.01, h = kBodyRadius;
  const Epsilon found = epsilon_of({{{h, l, 0}, {-1, 0, 0}, 0, 0},
                                    {{-h, -l, 0}, {1, 0, 0}, 0, 0},
                                    {{l, h, 0}, {0, -1, 0}, 0, 0},
                                    {{-l, -h, 0}, {0, 1, 0}, 0, 0}});
  expect_value(found, 0);
  EXPECT_EQ(found.rank, 3);
  EXPECT_NEAR(found.missing_direction.vector().segment<3>(2).norm(), 1, 1e-9);
}

/// Four fingers on the faces across axis i, d off the middle along axis j: wrenches (+-1 along i,
/// +-d / s about k).
void add_square(std::vector<Contact>& contacts, int i, int j, double d) {
  for (const double face : {1.0, -1.0})
    for (const double side : {1.0, -1.0})
      contacts.push_back({kBodyRadius * face * Vector3d::Unit(i) + d * side * Vector3d::Unit(j),
                          -face * Vector3d::Unit(i), 0, 0});
}

// Twelve frictionless fingers on a cube: three rectangles, 2 by 2 d / s, in three planes of the
// wrench space that share no direction. Their hull is a direct sum, whose support is the largest
// of theirs: 1 / epsilon^2 is the sum of 1 / min(1, d / s)^2. Its volume is the product of areas
// by (2!)^3 / 6!.
TEST(ClosedForm, FrictionlessFormClosureOfACube) {
  for (const double d : {0.01, 0.02, 0.03}) {
    std::vector<Contact> contacts;
    for (int i = 0; i < 3; ++i) add_square(contacts, i, (i + 1) % 3, d);
    const Epsilon found = epsilon_of(contacts);
    expect_value(found, std::min(1.0, d / kTorqueScale) / std::sqrt(3.0));
    EXPECT_TRUE(found.force_closure);
    EXPECT_EQ(found.rank, 6);
    const double volume_expected = std::pow(4 * d / kTorqueScale, 3) * 8 / 720;
    EXPECT_NEAR(volume(wrench_set(contacts, {0, 0, 0}, kTorqueScale)).estimate, volume_expected,
                kExact * volume_expected);
  }
}

// Without the fingers of one axis its force is missing, and the turn that goes with it.
TEST(ClosedForm, FrictionlessFingersOnTwoAxesMissTheThird) {
  std::vector<Contact> contacts;
  for (int i = 0; i < 2; ++i) add_square(contacts, i, (i + 1) % 3, 0.02);
  const Epsilon found = epsilon_of(contacts);
  expect_value(found, 0);
  EXPECT_EQ(found.rank, 4);
}

}  // namespace
}  // namespace thenar
