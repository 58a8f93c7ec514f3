// Tests for grasp/quality/volume.cpp: volumes known in closed form.

#include "grasp/quality/volume.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "grasp/contact/friction_pyramid.h"
#include "tests/grasp/quality/known_sets.h"
#include "tests/grasp/quality/random_grasps.h"

namespace thenar {
namespace {

Volume volume_of(const WrenchSet& set, ForceNorm limit, int edges = 8) {
  VolumeOptions options;
  options.limit = limit;
  options.edges = edges;
  return volume(set, options);
}

void expect_exact(const Volume& v, double known) {
  constexpr double kRelative = 1e-12;
  EXPECT_TRUE(v.complete);
  EXPECT_NEAR(v.lower, known, kRelative * known);
  EXPECT_NEAR(v.upper, known, kRelative * known);
  EXPECT_NEAR(v.estimate, known, kRelative * known);
}

TEST(Volume, OfACrossPolytopeAndItsBox) {
  const double box = (2 * kHalfAxes).prod();
  expect_exact(volume_of(cross_polytope(), ForceNorm::kL1), box / 720);
  expect_exact(volume_of(cross_polytope(), ForceNorm::kLinf), box);
}

// (n + 1)^((n + 1) / 2) / (n! n^(n / 2)) for circumradius 1, n = 6.
TEST(Volume, OfARegularSimplex) {
  expect_exact(volume_of(regular_simplex(), ForceNorm::kL1), std::pow(7, 3.5) / (720 * 216));
}

// The hull of bodies in orthogonal spaces about 0 of dimensions a, b, ..: a! b!
// .. / n! times the product of their volumes.
TEST(Volume, OfOrthogonalDiscsIsEnclosed) {
  const double known = std::pow(M_PI, 3) * 8 / 720;
  const Volume v = volume_of(orthogonal_discs(), ForceNorm::kL1);
  EXPECT_TRUE(v.complete);
  EXPECT_LE(v.lower, known);
  EXPECT_GE(v.upper, known);
  EXPECT_NEAR(v.estimate, known, 0.06 * known);
}

// The product of m-gons, in closed form: (m / 2 sin(2 pi / m))^3 and (m tan(pi
// / m))^3.
TEST(Volume, OfOrthogonalDiscsIsThatOfTheirPolygons) {
  const double weight = 8.0 / 720;
  const Volume v = volume_of(orthogonal_discs(), ForceNorm::kL1, 6);
  EXPECT_NEAR(v.lower, weight * std::pow(3 * std::sin(M_PI / 3), 3), 1e-12);
  EXPECT_NEAR(v.upper, weight * std::pow(6 * std::tan(M_PI / 6), 3), 1e-12);
}

TEST(Volume, OfFlatSetsIsZero) {
  for (const ForceNorm limit : {ForceNorm::kL1, ForceNorm::kLinf}) {
    expect_exact(volume_of(two_soft_fingers(0.5, 0), limit), 0);
    expect_exact(volume_of({}, limit), 0);
  }
}

TEST(Volume, IsEnclosedTheTighterTheMoreEdges) {
  std::mt19937 rng(3);
  const WrenchSet set = wrench_set(random_contacts(rng, 4), Eigen::Vector3d::Zero(), 1);
  const Volume few = volume_of(set, ForceNorm::kL1, 8), many = volume_of(set, ForceNorm::kL1, 16);
  EXPECT_LE(few.lower, many.lower);
  EXPECT_LE(many.upper, few.upper);
}

TEST(Volume, EstimatesWithinOnePercentOfManyEdges) {
  std::mt19937 rng(4);
  for (int contacts = 3; contacts <= 5; ++contacts) {
    const WrenchSet set = wrench_set(random_contacts(rng, contacts), Eigen::Vector3d::Zero(), 1);
    const Volume v = volume_of(set, ForceNorm::kL1, 12);
    const Volume fine = volume_of(set, ForceNorm::kL1, 32);  // bounds 2 % apart
    EXPECT_GE(v.estimate, 0.99 * fine.lower);
    EXPECT_LE(v.estimate, 1.01 * fine.upper);
  }
}

std::vector<Contact> soft_fingers_at(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  Contact one;
  one.p = a;
  one.n = Eigen::Vector3d::UnitX();
  one.friction = 0.5;
  one.torsion = 0.004;
  Contact other = one;
  other.p = b;
  other.n = -one.n;
  return {one, other};
}

// Torques about another centre are a shear of all wrenches, which keeps volumes. From far away the
// set is as narrow as its wrenches are rounded: then its volume is not known, but its bounds hold.
TEST(Volume, IsTheSameAboutAnyCentre) {
  const auto fingers = soft_fingers_at({-0.03, 0, 0}, {0.03, 0, 0});
  const auto about = [&](const Eigen::Vector3d& centre) {
    return volume_of(wrench_set(fingers, centre, 0.05), ForceNorm::kL1);
  };
  const Volume near = about({0, 0, 0});
  for (const Eigen::Vector3d& centre :
       {Eigen::Vector3d(0.1, 0.2, 0.3), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(1, -3, 2)}) {
    const Volume v = about(centre);
    EXPECT_TRUE(v.complete) << centre.transpose();
    EXPECT_NEAR(v.estimate / near.estimate, 1, 1e-4) << centre.transpose();
  }
  for (const Eigen::Vector3d& centre : {Eigen::Vector3d(0, 100, 0), Eigen::Vector3d(3, 40, -100)}) {
    const Volume v = about(centre);
    EXPECT_LE(v.lower, near.upper) << centre.transpose();
    EXPECT_GE(v.upper, near.lower) << centre.transpose();
    EXPECT_TRUE(!v.complete || std::abs(v.estimate / near.estimate - 1) < 1e-2);
  }
}

// Each point of a hull is put in a few times, however far its planes are rounded.
TEST(Volume, OfAFingerFarAwayEnds) {
  for (const double d : {1.0, 10.0, 100.0, 1e4}) {
    const Volume v = volume_of(
        wrench_set(soft_fingers_at({-0.03, d, 0}, {0.03, 0, 0}), Eigen::Vector3d::Zero(), 0.05),
        ForceNorm::kL1);
    EXPECT_TRUE(v.complete || d > 10) << d;
    EXPECT_GE(v.lower, 0) << d;
    EXPECT_LE(v.lower, v.upper) << d;
    EXPECT_LT(v.facets, 20000) << d;
  }
}

// The join of balls: (3!)^2 / 6! of the product of their volumes 4 pi / 3.
TEST(Volume, OfOrthogonalBallsComesAsNearAsThatOfDiscs) {
  const double known = 36.0 / 720 * std::pow(4 * M_PI / 3, 2);
  const Volume few = volume_of(orthogonal_balls(), ForceNorm::kL1, 8);
  const Volume many = volume_of(orthogonal_balls(), ForceNorm::kL1, 16);
  for (const Volume& v : {few, many}) {
    EXPECT_TRUE(v.complete);
    EXPECT_LE(v.lower, known);
    EXPECT_GE(v.upper, known);
  }
  EXPECT_LT(many.upper / many.lower - 1, (few.upper / few.lower - 1) / 4);  // d^2 is a quarter
  EXPECT_NEAR(many.estimate, known, 0.03 * known);
}

// Neither with the edges asked for nor with half as many: bounds, but no number to quote.
TEST(Volume, GivesUpAndSaysSo) {
  VolumeOptions options;
  options.max_facets = 20;
  const Volume v = volume(orthogonal_discs(), options);
  EXPECT_FALSE(v.complete);
  EXPECT_TRUE(std::isinf(v.upper));
  EXPECT_TRUE(std::isnan(v.estimate));
  EXPECT_LE(v.lower, std::pow(M_PI, 3) * 8 / 720);
}

TEST(Volume, OfThreeEdgesNobodyAskedForIsNoEstimate) {
  VolumeOptions options;
  options.max_facets = 120;  // 3^3 facets of triangles, 12^3 of those asked for
  const Volume v = volume(orthogonal_discs(), options);
  EXPECT_EQ(v.edges, 3);
  EXPECT_FALSE(v.complete);
  EXPECT_TRUE(std::isnan(v.estimate));
  EXPECT_GE(v.upper, std::pow(M_PI, 3) * 8 / 720);
}

// A stop comes through as if the hull had grown too large: at the tenth question here.
TEST(Volume, IsGivenUpWhenAskedToStop) {
  for (const ForceNorm limit : {ForceNorm::kL1, ForceNorm::kLinf}) {
    int asked = 0;
    VolumeOptions options;
    options.limit = limit;
    options.edges = 100;
    options.progress.stop_requested = [&] { return ++asked >= 10; };
    const Volume v = volume(orthogonal_discs(), options);
    EXPECT_FALSE(v.complete);
    EXPECT_TRUE(std::isnan(v.estimate));
    EXPECT_LT(asked, 100);
  }
}

// Soft fingers span four dimensions each: nothing but the hull has their volume.
TEST(Volume, OfTooManyPointsIsNone) {
  std::mt19937 rng(5);
  VolumeOptions options;
  options.limit = ForceNorm::kLinf;
  options.max_facets = 1000;
  std::vector<Contact> contacts = random_contacts(rng, 4);
  for (Contact& contact : contacts) contact.torsion = 0.1;
  const WrenchSet set = wrench_set(contacts, Eigen::Vector3d::Zero(), 1);
  const Volume v = volume(friction_pyramids(set, 8), options);
  EXPECT_FALSE(v.complete);
  EXPECT_TRUE(std::isnan(v.estimate));
  EXPECT_TRUE(std::isinf(v.upper));
}

TEST(Volume, OfHardPointsIsHadWithoutAHullThatIsTooLarge) {
  std::mt19937 rng(5);
  VolumeOptions options;
  options.limit = ForceNorm::kLinf;
  const WrenchSet set =
      friction_pyramids(wrench_set(random_contacts(rng, 4), Eigen::Vector3d::Zero(), 1), 4);
  const Volume hull = volume(set, options);
  ASSERT_GT(hull.facets, 100);
  options.max_facets = 100;
  const Volume sum = volume(set, options);
  EXPECT_TRUE(sum.complete);
  EXPECT_EQ(sum.facets, 0);
  EXPECT_NEAR(sum.estimate / hull.estimate, 1, 1e-7);
  EXPECT_LE(sum.lower, hull.lower);
  EXPECT_GE(sum.upper, hull.upper);
}

// Volume is affine: a set pressed flat along a direction has the share of it that is left.
TEST(Volume, OfNearlyFlatSetsIsThatOfTheWideOnesPressed) {
  std::mt19937 rng(6);
  const WrenchSet wide =
      friction_pyramids(wrench_set(random_contacts(rng, 4), Eigen::Vector3d::Zero(), 1), 4);
  for (const ForceNorm limit : {ForceNorm::kL1, ForceNorm::kLinf}) {
    const double whole = volume_of(wide, limit).estimate;
    for (const double left : {1e-3, 1e-6, 1e-8}) {
      WrenchSet flat = wide;
      for (WrenchCap& cap : flat.caps) cap.c.moment_over_length.z() *= left;
      EXPECT_NEAR(volume_of(flat, limit).estimate / (whole * left), 1, 1e-6) << left;
    }
  }
}

TEST(Volume, WantsThreeEdges) {
  EXPECT_THROW((void)volume_of(orthogonal_discs(), ForceNorm::kL1, 2), InputError);
}

}  // namespace
}  // namespace thenar
