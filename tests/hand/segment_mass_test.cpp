// Tests for hand/segment_mass.cpp.

#include "hand/segment_mass.h"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include "base/units.h"
#include "tests/hand/sample_subjects.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

struct SegmentMoments {
  double mass = 0, along = 0, across = 0;  // [kg], [kg m^2]
};

/// A capsule of length h and radius r about the origin, cut into thin discs across its axis.
/// Midpoint rule: the error falls with 1 / discs^2.
SegmentMoments sum_of_discs(double h, double r) {
  const int discs = 200000;
  const double dz = (h + 2 * r) / discs;
  SegmentMoments sum;
  for (int i = 0; i < discs; ++i) {
    const double z = -h / 2 - r + (i + 0.5) * dz;
    const double beyond = std::max(std::abs(z) - h / 2, 0.0);
    const double radius2 = r * r - beyond * beyond;
    const double mass = kHandDensity * kPi * radius2 * dz;
    sum.mass += mass;
    sum.along += mass * radius2 / 2;
    sum.across += mass * (radius2 / 4 + z * z);
  }
  return sum;
}

TEST(SegmentMass, CapsuleIsTheSumOfItsDiscs) {
  for (const double h : {0.0, 0.01, 0.05}) {
    const double r = 0.008;
    const LinkMass body = segment_mass(sample::bone("x", {0, 0, -h / 2}, {0, 0, h / 2}, r));
    const SegmentMoments expected = sum_of_discs(h, r);
    EXPECT_NEAR(body.mass / expected.mass, 1, 1e-9);
    EXPECT_NEAR(body.inertia(0, 0) / (h > 0 ? expected.across : expected.along), 1, 1e-9);
    EXPECT_NEAR(body.inertia(1, 1) / expected.across, 1, 1e-9);
    EXPECT_NEAR(body.inertia(2, 2) / (h > 0 ? expected.along : expected.across), 1, 1e-9);
  }
}

TEST(SegmentMass, CapsuleIsCentredAndTurnsWithItsBone) {
  const Eigen::Vector3d a(0.01, 0.02, 0.03), b(0.04, 0.01, 0.05);
  const LinkMass body = segment_mass(sample::bone("x", a, b, 0.008));
  const LinkMass upright =
      segment_mass(sample::bone("x", {0, 0, 0}, {0, 0, (b - a).norm()}, 0.008));
  EXPECT_TRUE(matrix_near(body.com, (a + b) / 2, 1e-17));
  const Eigen::Vector3d d = (b - a).normalized();
  EXPECT_NEAR(d.dot(body.inertia * d), upright.inertia(2, 2), 1e-20);
  EXPECT_NEAR(body.inertia.trace(), upright.inertia.trace(), 1e-20);
}

// No rigid body breaks it: each principal moment is at most the sum of the other two.
TEST(SegmentMass, CapsuleObeysTheTriangleInequality) {
  sample::Draw draw(41);
  for (int i = 0; i < 100; ++i) {
    const LinkMass body = segment_mass(
        sample::bone("x", draw.vector(0.05), draw.vector(0.05), draw.number(0.001, 0.02)));
    const Eigen::Vector3d m =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(body.inertia).eigenvalues();
    EXPECT_GT(m[0], 0);
    EXPECT_LE(m[2], (m[0] + m[1]) * (1 + 1e-12));
  }
}

TEST(SegmentMass, MeasuredValuesWin) {
  Segment segment = sample::bone("x", {0, 0, 0}, {0.05, 0, 0}, 0.01);
  segment.mass = 0.02;
  segment.com = {0.02, 0.001, 0};
  EXPECT_EQ(segment_mass(segment).mass, 0.02);
  EXPECT_EQ(segment_mass(segment).com, segment.com);
}

TEST(SegmentMass, MeasuredMassTakesTheSpreadOfTheCapsule) {
  Segment segment = sample::bone("x", {0, 0, 0}, {0.05, 0, 0}, 0.01);
  const LinkMass capsule = segment_mass(segment);
  segment.mass = 3 * capsule.mass;
  segment.com = {0.02, 0.001, 0};
  const LinkMass body = segment_mass(segment);
  EXPECT_TRUE(matrix_near(body.inertia, 3 * capsule.inertia, 1e-18));
  EXPECT_EQ(body.com, segment.com);
  EXPECT_EQ(body.no_inertia, "");
}

TEST(SegmentMass, MassOfUnknownSpreadSaysSo) {
  Segment segment = sample::bone("x", {0, 0, 0}, {0.05, 0, 0}, 0);
  segment.mass = 0.02;
  const LinkMass body = segment_mass(segment),
                 known{0.1, {0, 0, 0}, Eigen::Matrix3d::Identity(), {}};
  EXPECT_EQ(body.no_inertia, "x");
  EXPECT_EQ(combine(known, displace({}, body)).no_inertia, "x");
  EXPECT_EQ(combine(body, known).no_inertia, "x");
}

TEST(SegmentMass, UnknownIsZero) {
  const LinkMass body = segment_mass(sample::bone("x", {0, 0, 0}, {0.05, 0, 0}, 0));
  EXPECT_EQ(body.mass, 0);
  EXPECT_TRUE(body.inertia.isZero(0));
}

/// Point masses as one body, from the definitions.
LinkMass cloud(const std::vector<std::pair<double, Eigen::Vector3d>>& points) {
  LinkMass body;
  for (const auto& [mass, p] : points) {
    body.mass += mass;
    body.com += mass * p;
  }
  body.com /= body.mass;
  for (const auto& [mass, p] : points) {
    const Eigen::Vector3d r = p - body.com;
    body.inertia += mass * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
  }
  return body;
}

std::vector<std::pair<double, Eigen::Vector3d>> points(sample::Draw& draw, int count) {
  std::vector<std::pair<double, Eigen::Vector3d>> list;
  for (int i = 0; i < count; ++i) {
    const double mass = draw.number(0.1, 1);
    list.emplace_back(mass, draw.vector(1));
  }
  return list;
}

TEST(Combine, EqualsTheSumOverAllPoints) {
  sample::Draw draw(42);
  const auto a = points(draw, 5), b = points(draw, 7);
  auto both = a;
  both.insert(both.end(), b.begin(), b.end());
  const LinkMass combined = combine(cloud(a), cloud(b)), expected = cloud(both);
  EXPECT_NEAR(combined.mass, expected.mass, 1e-14);
  EXPECT_TRUE(matrix_near(combined.com, expected.com, 1e-14));
  EXPECT_TRUE(matrix_near(combined.inertia, expected.inertia, 1e-14));
}

TEST(Combine, WithNothingChangesNothing) {
  sample::Draw draw(43);
  const LinkMass body = cloud(points(draw, 5));
  const LinkMass combined = combine({}, body);
  EXPECT_TRUE(matrix_near(combined.com, body.com, 1e-16));
  EXPECT_TRUE(matrix_near(combined.inertia, body.inertia, 1e-16));
  EXPECT_EQ(combine({}, {}).mass, 0);
}

TEST(Displace, EqualsMovingEveryPoint) {
  sample::Draw draw(44);
  const auto before = points(draw, 6);
  const Pose<double> X = screw_motion<double>(draw.direction(), draw.vector(1), 0.9);
  auto after = before;
  for (auto& [mass, p] : after) p = X * p;
  const LinkMass displaced = displace(X, cloud(before)), expected = cloud(after);
  EXPECT_TRUE(matrix_near(displaced.com, expected.com, 1e-14));
  EXPECT_TRUE(matrix_near(displaced.inertia, expected.inertia, 1e-14));
}

}  // namespace
}  // namespace thenar
