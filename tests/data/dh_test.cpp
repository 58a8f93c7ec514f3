// Tests for data/io/dh.cpp.

#include "data/io/dh.h"

#include <random>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "tests/data/axes_from_dh.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

// Chains are 0.1 m big; skew axes lose a few digits in the feet of their common normals.
constexpr double kExact = 1e-12;  // [m], [1]

Vector3d random_vector(std::mt19937& rng) {
  std::normal_distribution<double> normal(0, 1);
  const double x = normal(rng), y = normal(rng), z = normal(rng);
  return {x, y, z};
}

Pose<double> random_pose(std::mt19937& rng) {
  return {rotation_about<double>(random_vector(rng).normalized(), 1.3), 0.1 * random_vector(rng)};
}

/// The same lines, and the same end frame, come back.
void expect_round_trip(const std::vector<AxisLine>& axes, const Pose<double>& tip,
                       double tolerance = kExact) {
  const DhChain chain = dh_from_axes(axes, tip);
  const DhAxes back = axes_from_dh(chain.base, chain.rows);
  ASSERT_EQ(back.axes.size(), axes.size());
  for (std::size_t i = 0; i < axes.size(); ++i) {
    EXPECT_TRUE(matrix_near(back.axes[i].direction, axes[i].direction, tolerance)) << "axis " << i;
    const Vector3d off = (back.axes[i].point - axes[i].point).cross(axes[i].direction);
    EXPECT_LE(off.norm(), tolerance) << "axis " << i;
  }
  const Pose<double> end = back.frames.back() * chain.tool;
  EXPECT_TRUE(matrix_near(end.p, tip.p, tolerance));
  EXPECT_TRUE(matrix_near(end.R, tip.R, tolerance));
}

TEST(Dh, RoundTripOfSkewAxes) {
  std::mt19937 rng(1);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<AxisLine> axes(5);
    for (AxisLine& axis : axes) axis = {0.1 * random_vector(rng), random_vector(rng).normalized()};
    // Two random axes may be nearly parallel: the feet are then metres away.
    expect_round_trip(axes, random_pose(rng), 1e-10);
  }
}

TEST(Dh, RoundTripOfParallelAxes) {
  std::mt19937 rng(2);
  const Vector3d d = random_vector(rng).normalized();
  std::vector<AxisLine> axes;
  for (const double sign : {1.0, 1.0, -1.0, 1.0})
    axes.push_back({0.1 * random_vector(rng), sign * d});
  expect_round_trip(axes, random_pose(rng));
}

TEST(Dh, RoundTripOfIntersectingAxes) {
  std::mt19937 rng(3);
  const Vector3d p = 0.1 * random_vector(rng);
  std::vector<AxisLine> axes;
  for (int i = 0; i < 4; ++i) axes.push_back({p, random_vector(rng).normalized()});
  expect_round_trip(axes, random_pose(rng));
}

TEST(Dh, RoundTripOfCoincidentAxes) {
  std::mt19937 rng(4);
  const AxisLine axis{0.1 * random_vector(rng), random_vector(rng).normalized()};
  const AxisLine slid{axis.point + 0.03 * axis.direction, axis.direction};
  const AxisLine reversed{axis.point, -axis.direction};
  expect_round_trip({axis, slid, reversed}, random_pose(rng));
}

TEST(Dh, RoundTripWithTheTipOnTheLastAxis) {
  const AxisLine first{{0, 0, 0}, {0, 0, 1}}, second{{0.02, 0, 0}, {0, 1, 0}};
  expect_round_trip({first, second}, {Eigen::Matrix3d::Identity(), {0.02, 0.05, 0}});
}

TEST(Dh, ToolOnlyTurns) {
  std::mt19937 rng(5);
  const DhChain chain =
      dh_from_axes({{{0, 0, 0}, {0, 0, 1}}, {{0.03, 0.01, 0}, {0, 1, 0}}}, random_pose(rng));
  EXPECT_TRUE(matrix_near(chain.tool.p, Vector3d::Zero(), kExact));
}

// By hand: z axes 90 deg apart at a distance of 20 mm along x.
TEST(Dh, MatchesHandComputedRow) {
  const DhChain chain = dh_from_axes({{{0, 0, 0.7}, {0, 0, 1}}, {{0.02, 0.4, 0}, {0, -1, 0}}}, {});
  EXPECT_NEAR(chain.rows[0].a, 0.02, kExact);
  EXPECT_NEAR(chain.rows[0].alpha, 1.5707963267948966, kExact);
  EXPECT_NEAR(chain.rows[0].d, 0, kExact);
  EXPECT_NEAR(chain.rows[0].theta, 0, kExact);
}

// Two planar links: the end frame is at the sum of the lengths.
TEST(Dh, EndOfPlanarArm) {
  const DhAxes arm = axes_from_dh({}, {{0, 0, 0.3, 0}, {1.5707963267948966, 0, 0.2, 0}});
  EXPECT_TRUE(matrix_near(arm.axes[1].point, Vector3d(0.3, 0, 0), kExact));
  EXPECT_TRUE(matrix_near(arm.frames[1].p, Vector3d(0.3, 0.2, 0), kExact));
}

// [McFarland2023]: the two thumb CMC axes are 80.9 deg and 9.13 mm apart (three digits).
TEST(Dh, PublishedThumbAxesAreSkew) {
  const Vector3d flexion = Vector3d(0.04239899, 0.66528585, -0.74538383).normalized();
  const Vector3d abduction = Vector3d(0.49555701, 0.73173602, 0.46795901).normalized();
  const Vector3d p(0.0072, -0.0054, -0.0025);
  const DhChain chain = dh_from_axes({{{0, 0, 0}, flexion}, {p, abduction}}, {});
  EXPECT_NEAR(std::abs(chain.rows[0].a), 9.13e-3, 5e-6);
  EXPECT_NEAR(chain.rows[0].alpha, radians(80.9), 1e-3);
}

TEST(Dh, RefusesNoAxes) { EXPECT_THROW((void)dh_from_axes({}, {}), InputError); }

}  // namespace
}  // namespace thenar
