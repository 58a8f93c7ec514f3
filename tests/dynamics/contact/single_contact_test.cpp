// Tests for dynamics/contact/contact_solver.cpp: one contact, by closed forms.

#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/contact/contact_solver.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kRounding = 1e-14;
constexpr ContactMethod kMethods[] = {ContactMethod::kAutomatic, ContactMethod::kNewton,
                                      ContactMethod::kGaussSeidel};

/// A point of 2 kg on a plane:  u = f / m + b.
ContactProblem point_on_plane(double mu, const Vector3d& b) {
  return {{coulomb_block(mu)}, Eigen::Matrix3d::Identity() / 2, b};
}

ContactSolution solve_cold(const ContactProblem& problem, ContactMethod method) {
  ContactSolver solver;
  ContactSolverOptions options;
  options.method = method;
  return solver.solve(problem, VectorXd(), options);
}

// With |b_t| = mu |b_n| (1 -+ 1e-9) friction just holds, or just does not: then the slip left is
// |b_t| - mu |b_n|.
TEST(SingleContact, SticksBelowFrictionAndSlidesAbove) {
  for (const ContactMethod method : kMethods) {
    const double mu = 0.7;
    const Vector3d below(-1, 0.6 * mu * (1 - 1e-9), -0.8 * mu * (1 - 1e-9));
    const ContactSolution stick = solve_cold(point_on_plane(mu, below), method);
    ASSERT_EQ(stick.status, Status::kSolved);
    EXPECT_LT(stick.u.norm(), kRounding);
    const Vector3d above(-1, 0.6 * mu * (1 + 1e-9), -0.8 * mu * (1 + 1e-9));
    const ContactSolution slide = solve_cold(point_on_plane(mu, above), method);
    ASSERT_EQ(slide.status, Status::kSolved);
    EXPECT_NEAR(slide.u.tail<2>().norm(), mu * 1e-9, kRounding);
  }
}

// f_n = m |b_n|, f_t = -mu f_n d, u_t = (|b_t| - mu |b_n|) d along the direction d of b_t.
TEST(SingleContact, SlidesStraightInEveryDirection) {
  for (const ContactMethod method : kMethods) {
    for (int degree = 0; degree < 360; ++degree) {
      const double angle = degree * M_PI / 180;
      const Vector3d d(0, std::cos(angle), std::sin(angle)), n(1, 0, 0);
      const ContactSolution found = solve_cold(point_on_plane(0.4, -0.5 * n + 3 * d), method);
      ASSERT_EQ(found.status, Status::kSolved);
      EXPECT_LT((found.f - (n - 0.4 * d)).norm(), kRounding) << degree;
      EXPECT_LT((found.u - 2.8 * d).norm(), kRounding) << degree;
    }
  }
}

TEST(SingleContact, LeavesBodiesThatSeparateAlone) {
  for (const ContactMethod method : kMethods) {
    const Vector3d b(0.1, -5, 2);
    const ContactSolution found = solve_cold(point_on_plane(0.9, b), method);
    ASSERT_EQ(found.status, Status::kSolved);
    EXPECT_EQ(found.f, Vector3d::Zero());
    EXPECT_EQ(found.u, b);
  }
}

}  // namespace
}  // namespace thenar
