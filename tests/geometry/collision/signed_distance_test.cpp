// Tests for geometry/collision/signed_distance.cpp.

#include "geometry/collision/signed_distance.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "geometry/collision/collision_tree.h"
#include "geometry/mesh_distance.h"
#include "geometry/mesh_parts.h"
#include "tests/geometry/collision/analytic_shapes.h"
#include "tests/geometry/collision/drawn.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

constexpr double kTolerance = 5e-5;  // default of the search [m]

Pose<double> at(double x, double y, double z) {
  return {Eigen::Matrix3d::Identity(), Eigen::Vector3d(x, y, z)};
}

// A ball is one point with a radius: two balls are apart by the way between centres less radii.
TEST(SignedDistance, OfTwoBallsIsExact) {
  const Solid a = touching({rounded_point({0, 0, 0}, 0.02)});
  const SignedDistance s = signed_distance(a, at(0.3, 0.4, 0), ball_solid(0.1), {});
  EXPECT_NEAR(s.distance, 0.5 - 0.12, 1e-12);
  EXPECT_TRUE(matrix_near(s.on_b, Eigen::Vector3d(0.06, 0.08, 0), 1e-7));    // by differences of
  EXPECT_TRUE(matrix_near(s.on_a, Eigen::Vector3d(0.288, 0.384, 0), 1e-7));  // the distance
  EXPECT_TRUE(matrix_near(s.normal, Eigen::Vector3d(0.6, 0.8, 0), 1e-7));
  EXPECT_LE(s.error, kTolerance);
}

TEST(SignedDistance, IsNegativeByTheDepthOfOverlap) {
  const Solid a = touching({rounded_point({0, 0, 0}, 0.02)});
  EXPECT_NEAR(signed_distance(a, at(0.11, 0, 0), ball_solid(0.1), {}).distance, -0.01, 1e-12);
}

// The point of a capsule's axis nearest to a ball lies within the segment.
TEST(SignedDistance, OfCapsuleAndBall) {
  const Solid a = touching({rounded_segment({-0.05, 0, 0}, {0.05, 0, 0}, 0.01)});
  const SignedDistance s = signed_distance(a, at(0.02, 0.2, 0), ball_solid(0.1), {});
  EXPECT_NEAR(s.distance, 0.2 - 0.11, kTolerance);
}

// All of one face is as near as any: halving it down to the tolerance would take 1e5 questions.
TEST(SignedDistance, OfParallelFacesTakesFewQuestions) {
  const Eigen::Vector3d edges(0.04, 0.06, 0.02);
  const Solid a = touching({{block_mesh(edges), 0}});
  const SignedDistance s = signed_distance(a, at(0, 0, 0.025), box_shape({0.1, 0.1, 0.02}), {});
  EXPECT_NEAR(s.distance, 0.005, kTolerance);
  EXPECT_LT(s.evaluations, 200);
}

// A box that a shell inside out goes through: what the shell winds around backwards is outside, and
// a ball that touches it there touches nothing.
TEST(SignedDistance, OfCrossedMeshesIsThatOfTheirBoundary) {
  TriangleMesh shell = block_mesh({0.02, 0.02, 0.02});
  shell.vertices.row(0).array() += 0.07;
  shell.triangles.row(0).swap(shell.triangles.row(1));
  TriangleMesh crossing = block_mesh({0.01, 0.01, 0.01});
  crossing.vertices.row(1).array() += 0.03;
  ShapeSpec spec;
  spec.kind = ShapeKind::kMesh;
  spec.mesh = joined({block_mesh({0.06, 0.06, 0.06}), shell, crossing});
  const auto shape = build_mesh_distance(spec.mesh);
  const Solid solid{shape, {{spec.mesh, 0}}, spec.mesh, {{spec, shape}}};
  EXPECT_NEAR(signed_distance(solid, {}, ball_solid(0.01), at(0.1, 0, 0)).distance, 0.06,
              kTolerance);
}

// Ball against any triangle: the exact answer is the distance of the centre from the triangle.
TEST(SignedDistance, OfTrianglesAndBallsMatchesClosedForm) {
  std::mt19937 rng(1);
  for (int i = 0; i < 2000; ++i) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = drawn_point(rng, 0.1);
    if (i % 5 == 0) corners.col(2) = corners.col(1);
    const Pose<double> X_WA = drawn_pose(rng, 0.2), X_WB = drawn_pose(rng, 0.2);
    const double radius = 0.03 * (1.5 + drawn(rng));
    const SignedDistance s =
        signed_distance(touching({one_triangle(corners, 0.005)}), X_WA, ball_solid(radius), X_WB);
    const Eigen::Vector3d centre = X_WA.inverse() * X_WB.p;
    const double exact =
        (internal::nearest_in_triangle(corners, centre) - centre).norm() - radius - 0.005;
    ASSERT_NEAR(s.distance, exact, s.error) << "triangle " << i;
    ASSERT_LE(s.error, 1.01 * kTolerance);
    // The points are as far apart as said, and each on its own surface.
    ASSERT_NEAR((s.on_a - s.on_b).norm(), std::abs(s.distance), 1e-7);
    ASSERT_NEAR((s.on_b - X_WB.p).norm(), radius, 1e-7);
  }
}

// Against points strewn densely over A: the best of them cannot be nearer than said, nor, by the
// Lipschitz law, farther than said by more than their spacing.
TEST(SignedDistance, OfBoxesMatchesBruteForce) {
  std::mt19937 rng(2);
  constexpr int kCells = 60;
  for (int i = 0; i < 60; ++i) {
    const Eigen::Vector3d edges = Eigen::Vector3d::Constant(0.06) + drawn_point(rng, 0.04);
    const Eigen::Vector3d edges_B = Eigen::Vector3d::Constant(0.06) + drawn_point(rng, 0.04);
    const Pose<double> X_WA = drawn_pose(rng, 0.08);
    const TriangleMesh mesh = block_mesh(edges);
    double brute = 1;
    for (Eigen::Index t = 0; t < 12; ++t)
      for (int u = 0; u <= kCells; ++u)
        for (int v = 0; u + v <= kCells; ++v) {
          const Eigen::Vector3d weights(u, v, kCells - u - v);
          const Eigen::Vector3d p = mesh.vertices(Eigen::all, mesh.triangles.col(t)) * weights;
          brute = std::min(brute, box_distance(edges_B, X_WA * (p / kCells)));
        }
    const SignedDistance s = signed_distance(touching({{mesh, 0}}), X_WA, box_shape(edges_B), {});
    const double spacing = edges.norm() / kCells;
    ASSERT_LE(s.distance, brute + s.error) << "pair " << i;
    ASSERT_GE(s.distance, brute - spacing) << "pair " << i;
    ASSERT_LE(s.error, 1.01 * kTolerance);
  }
}

TEST(SignedDistance, DependsOnTheRelativePoseOnly) {
  std::mt19937 rng(3);
  const Solid a = touching({{block_mesh({0.02, 0.03, 0.04}), 0}});
  const Solid b = box_shape({0.05, 0.05, 0.05});
  for (int i = 0; i < 50; ++i) {
    const Pose<double> X_WA = drawn_pose(rng, 0.1), X_WB = drawn_pose(rng, 0.1);
    const Pose<double> X = drawn_pose(rng, 1);
    const SignedDistance s = signed_distance(a, X_WA, b, X_WB),
                         moved = signed_distance(a, X * X_WA, b, X * X_WB);
    EXPECT_NEAR(s.distance, moved.distance, kTolerance);
  }
}

// A warm start changes the work, not the answer.
TEST(SignedDistance, StartsFromAnyTriangle) {
  const CollisionTree a = collision_tree(touching({{block_mesh({0.02, 0.03, 0.04}), 0}}));
  const Pose<double> X_WA{rotation_about<double>({0, 0.6, 0.8}, 1.0), {0.06, 0.01, 0}};
  const double cold = signed_distance(a, X_WA, ball_solid(0.03), {}).distance;
  for (int start = -1; start < 14; ++start) {
    SignedDistanceOptions options;
    options.start = start;
    EXPECT_NEAR(signed_distance(a, X_WA, ball_solid(0.03), {}, options).distance, cold, kTolerance);
  }
}

TEST(SignedDistance, BeyondTheCutoffIsALowerBound) {
  const Solid a = touching({{block_mesh({0.02, 0.02, 0.02}), 0}});
  const SignedDistance s = signed_distance(a, at(1, 0, 0), ball_solid(0.1), {}, kTolerance, 0.1);
  EXPECT_GT(s.distance, 0.1);
  EXPECT_LE(s.distance, 1 - 0.1 - 0.01);
  EXPECT_TRUE(std::isinf(s.error));
  EXPECT_TRUE(s.on_a.allFinite());
}

TEST(SignedDistance, OfFingerInMugIsPositive) {
  const Solid finger = touching({rounded_segment({0, 0, 0}, {0, 0, 0.08}, 0.008)});
  const SignedDistance s =
      signed_distance(finger, at(0.01, 0, 0.02), mug_solid(0.04, 0.037, 0.09), {});
  EXPECT_NEAR(s.distance, 0.020 - 0.003 - 0.008, kTolerance);  // from the floor, not the wall
}

TEST(SignedDistance, RejectsWhatHasNoAnswer) {
  const Solid a = touching({rounded_point({0, 0, 0}, 0.02)});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of([&] { (void)signed_distance(a, {}, a, {}); }),
            "a solid without a shape has no distance");
  EXPECT_EQ(message_of([&] { (void)signed_distance(touching({}), {}, a, {}); }),
            "a touch surface must have 1 triangle or more");
  EXPECT_EQ(message_of([&] { (void)signed_distance(a, {}, ball_solid(1), {}, 0); }),
            "tolerance must be positive, got 0 m");
  EXPECT_THROW((void)signed_distance(a, at(nan, 0, 0), ball_solid(1), {}), InputError);
  EXPECT_EQ(message_of([&] {
              (void)collision_tree(touching({rounded_point({nan, 0, 0}, 0)}));
            }),
            "triangle 0 of a touch surface is not finite");
}

}  // namespace
}  // namespace thenar
