// Tests for contact/friction_pyramids.cpp.

#include "contact/friction_pyramids.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/contact_solver.h"
#include "tests/contact/contact_samples.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;
using Eigen::VectorXd;

ContactSolution solve_pyramids(const ContactProblem& problem, int edges) {
  ContactSolver solver;
  ContactSolverOptions options;
  options.method = ContactMethod::kPyramid;
  options.pyramid_edges = edges;
  return solver.solve(problem, VectorXd(), options);
}

/// A point of unit mass that comes down at 1 m/s and slides at 3 m/s, mu = 0.4.
ContactProblem sliding_point(double angle) {
  return {{coulomb_block(0.4)},
          Eigen::Matrix3d::Identity(),
          Vector3d(-1, 3 * std::cos(angle), 3 * std::sin(angle))};
}

// Along an edge of the pyramid the answer is that of the cone.
TEST(FrictionPyramids, AreExactAlongTheirEdges) {
  for (int k = 0; k < 8; ++k) {
    const double angle = k * M_PI / 4;
    const ContactSolution found = solve_pyramids(sliding_point(angle), 8);
    ASSERT_EQ(found.status, Status::kSolved);
    EXPECT_LT(found.residual.natural, 1e-12);
    EXPECT_NEAR(found.f(1), -0.4 * std::cos(angle), 1e-12);
  }
}

// Between edges the force stays on the nearer one, up to pi / m aside of the slip.
TEST(FrictionPyramids, AreAsideBetweenTheirEdges) {
  const double angle = 0.5 * M_PI / 8;
  const ContactSolution found = solve_pyramids(sliding_point(angle), 8);
  ASSERT_EQ(found.status, Status::kSolved);
  EXPECT_LT((found.f - Vector3d(1, -0.4, 0)).norm(), 1e-12);
  EXPECT_GT(found.residual.alignment, 0.01);
}

/// Largest residual on the true cones of some random problems without single rows.
double pyramid_error(double soft, int contacts, int edges) {
  std::mt19937 rng(2);
  sample::RandomTouch like;
  like.contacts = contacts;
  like.limits = 0;
  like.soft = soft;
  double out = 0;
  for (int trial = 0; trial < 10; ++trial) {
    const ContactSolution found = solve_pyramids(sample::random_touch(rng, like).problem(), edges);
    EXPECT_EQ(found.status, Status::kSolved) << trial;
    out = std::max(out, found.residual.natural);
  }
  return out;
}

// Friction is off by up to pi / m in direction and 1 - cos(pi / m) in size, so the largest error
// falls about as 1 / m.
TEST(FrictionPyramids, ApproachTheConeWithTheirEdges) {
  EXPECT_LT(pyramid_error(0, 3, 64), 0.15 * pyramid_error(0, 3, 4));
  EXPECT_LT(pyramid_error(1, 1, 24), 0.35 * pyramid_error(1, 1, 4));
}

// A spinning soft finger is against a pole of its polyhedron, which is exact.
TEST(FrictionPyramids, HoldSpin) {
  const double e = 0.01;
  const ContactProblem problem{{soft_finger_block(0.5, e)},
                               Vector4d(1, 1, 1, 1 / (e * e)).asDiagonal().toDenseMatrix(),
                               Vector4d(-1, 0, 0, 200)};
  const ContactSolution found = solve_pyramids(problem, 8);
  ASSERT_EQ(found.status, Status::kSolved);
  EXPECT_NEAR(found.f(3), -0.5 * e, 1e-12);
  EXPECT_NEAR(found.u(3), 150, 1e-9);
}

TEST(FrictionPyramids, CountTheirUnknowns) {
  internal::ScaledContacts contacts;
  contacts.assign({{coulomb_block(0.5), soft_finger_block(0.5, 0.01), box_block(-1, 2),
                    bilateral_block(), unilateral_block(), box_block(1, 1)},
                   Eigen::MatrixXd::Identity(11, 11),
                   VectorXd::Zero(11)});
  const internal::PyramidProblem found = internal::friction_pyramids(contacts, 8);
  // Normals and edges 1 + 8, 1 + 3 * 8 + 2; box, tie twice, limit; the fixed row has none.
  EXPECT_EQ(found.generators.cols(), 9 + 27 + 1 + 2 + 1);
  EXPECT_EQ(found.lcp.q.size(), found.generators.cols() + 3);  // two lambdas, one upper end
  EXPECT_EQ(found.origin(10), 1);
}

TEST(FrictionPyramids, RefuseOddEdges) {
  EXPECT_THROW((void)solve_pyramids(sliding_point(0), 7), std::exception);
  EXPECT_THROW((void)solve_pyramids(sliding_point(0), 2), std::exception);
}

}  // namespace
}  // namespace thenar
