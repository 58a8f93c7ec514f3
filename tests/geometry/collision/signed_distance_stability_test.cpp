// What signed_distance() does with what breaks such searches.

#include <cstdlib>
#include <random>

#include <gtest/gtest.h>

#include "geometry/collision/collision_tree.h"
#include "geometry/collision/signed_distance.h"
#include "tests/geometry/collision/analytic_shapes.h"
#include "tests/geometry/collision/drawn.h"

namespace thenar {
namespace {

// Far from everything, rounding alone is the error: 1e6 m has a last digit of 1e-10 m.
TEST(SeparationStability, OfThingsFarAway) {
  const Solid a = touching({{block_mesh({0.02, 0.02, 0.02}), 0}});
  const SignedDistance s =
      signed_distance(a, {Eigen::Matrix3d::Identity(), {1e6, 0, 0}}, ball_solid(0.1), {});
  EXPECT_NEAR(s.distance, 1e6 - 0.11, s.error);
  EXPECT_LE(s.error, 6e-5);
}

TEST(SeparationStability, OfThingsWithoutSize) {
  const Solid point = touching({rounded_point({0, 0, 0}, 0)});
  EXPECT_EQ(signed_distance(point, {}, ball_solid(0), {}).distance, 0);
  EXPECT_NEAR(signed_distance(point, {}, ball_solid(0.1), {}).distance, -0.1, 1e-12);
}

// One block in the place of another: its surface is on the other's, at 0.
TEST(SeparationStability, OfIdenticalSurfaces) {
  const Eigen::Vector3d edges(0.04, 0.05, 0.06);
  const SignedDistance s =
      signed_distance(touching({{block_mesh(edges), 0}}), {}, box_shape(edges), {});
  EXPECT_LE(s.distance, 0);
  EXPECT_GE(s.distance, -0.02);
}

// Random rounded triangles and balls against brute force; THENAR_QUERIES sets how many.
TEST(SeparationStability, OfRandomQueriesIsExact) {
  const char* wanted = std::getenv("THENAR_QUERIES");
  const int queries = wanted ? std::atoi(wanted) : 20'000;
  std::mt19937 rng(6);
  for (int i = 0; i < queries; ++i) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = drawn_point(rng, 0.1);
    if (i % 3 == 0) corners.col(2) = corners.col(0) + 1e-12 * corners.col(1);
    const double radius = 0.02 * (1 + drawn(rng));
    const Pose<double> X_WA = drawn_pose(rng, 0.2);
    const SignedDistance s =
        signed_distance(touching({one_triangle(corners, 0.004)}), X_WA, ball_solid(radius), {});
    const Eigen::Vector3d centre = X_WA.inverse() * Eigen::Vector3d::Zero();
    const double exact =
        (internal::nearest_in_triangle(corners, centre) - centre).norm() - radius - 0.004;
    ASSERT_NEAR(s.distance, exact, s.error + 1e-12) << "query " << i;
  }
}

}  // namespace
}  // namespace thenar
