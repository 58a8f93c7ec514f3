// Tests for contact/contact_solver.cpp: one block, by closed forms.

#include <gtest/gtest.h>

#include <cmath>

#include <Eigen/LU>

#include "contact/contact_solver.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Eigen::VectorXd;

constexpr double kRounding = 1e-14;
constexpr double kThroughTolerance = 1e-10;  // of methods that end at their tolerance
constexpr ContactMethod kExactCones[] = {ContactMethod::kAutomatic, ContactMethod::kNewton,
                                         ContactMethod::kGaussSeidel,
                                         ContactMethod::kInteriorPoint};

ContactSolution solve_cold(const ContactProblem& problem,
                           ContactMethod method = ContactMethod::kAutomatic) {
  ContactSolver solver;
  ContactSolverOptions options;
  options.method = method;
  return solver.solve(problem, VectorXd(), options);
}

/// A point of 2 kg on a plane:  u = f / m + b.
ContactProblem point_on_plane(double mu, const Vector3d& b) {
  return {{coulomb_block(mu)}, Matrix3d::Identity() / 2, b};
}

// With |b_t| = mu |b_n| (1 -+ 1e-9) friction just holds, or just does not: then the slip left is
// |b_t| - mu |b_n|.
TEST(SingleContact, SticksBelowFrictionAndSlidesAbove) {
  for (const ContactMethod method : kExactCones) {
    const double mu = 0.7;
    const Vector3d below(-1, 0.6 * mu * (1 - 1e-9), -0.8 * mu * (1 - 1e-9));
    const ContactSolution stick = solve_cold(point_on_plane(mu, below), method);
    ASSERT_EQ(stick.status, Status::kSolved) << name_of(method);
    EXPECT_LT(stick.u.norm(), 1e-11);
    const Vector3d above(-1, 0.6 * mu * (1 + 1e-9), -0.8 * mu * (1 + 1e-9));
    const ContactSolution slide = solve_cold(point_on_plane(mu, above), method);
    ASSERT_EQ(slide.status, Status::kSolved) << name_of(method);
    EXPECT_NEAR(slide.u.tail<2>().norm(), mu * 1e-9, 1e-11);
  }
}

// f_n = m |b_n|, f_t = -mu f_n d, u_t = (|b_t| - mu |b_n|) d along the direction d of b_t.
TEST(SingleContact, SlidesStraightInEveryDirection) {
  for (const ContactMethod method : kExactCones) {
    for (int degree = 0; degree < 360; ++degree) {
      const double angle = degree * M_PI / 180;
      const Vector3d d(0, std::cos(angle), std::sin(angle)), n(1, 0, 0);
      const ContactSolution found = solve_cold(point_on_plane(0.4, -0.5 * n + 3 * d), method);
      ASSERT_EQ(found.status, Status::kSolved) << name_of(method);
      EXPECT_LT((found.f - (n - 0.4 * d)).norm(), kThroughTolerance) << degree;
      EXPECT_LT((found.u - 2.8 * d).norm(), kThroughTolerance) << degree;
    }
  }
}

TEST(SingleContact, LeavesBodiesThatSeparateAlone) {
  for (const ContactMethod method : kExactCones) {
    const Vector3d b(0.1, -5, 2);
    const ContactSolution found = solve_cold(point_on_plane(0.9, b), method);
    ASSERT_EQ(found.status, Status::kSolved);
    EXPECT_LT(found.f.norm(), kThroughTolerance);
  }
}

// A rod's end: W couples normal and tangent. Slip along +t1 with fn from  un = 0:
// (W_nn - mu W_nt) fn = -b_n, and the slip left is b_t + (W_nt - mu W_tt) fn.
TEST(SingleContact, SlidesWhereNormalAndTangentAreCoupled) {
  Matrix3d W;
  W << 2, 0.8, 0, 0.8, 1, 0, 0, 0, 1;
  const double mu = 0.5, fn = 1 / (2 - mu * 0.8), slip = 4 + (0.8 - mu) * fn;
  for (const ContactMethod method : kExactCones) {
    const ContactSolution found = solve_cold({{coulomb_block(mu)}, W, Vector3d(-1, 4, 0)}, method);
    ASSERT_EQ(found.status, Status::kSolved);
    EXPECT_NEAR(found.f(0), fn, kThroughTolerance);
    EXPECT_NEAR(found.u(1), slip, kThroughTolerance);
  }
}

// A disc of mass m and inertia I spins on its face: torsion takes mu e fn / I from its spin, and no
// more than there is.
TEST(SingleContact, TorsionSlowsSpin) {
  const double m = 0.2, I = 1e-4, mu = 0.6, e = 0.01, v = 0.3;
  const MatrixXd W = Vector4d(1 / m, 1 / m, 1 / m, 1 / I).asDiagonal();
  const double taken = mu * e * m * v / I;
  for (const ContactMethod method : kExactCones) {
    for (const double spin : {10 * taken, -1.5 * taken, 0.9 * taken}) {
      const ContactSolution found =
          solve_cold({{soft_finger_block(mu, e)}, W, Vector4d(-v, 0, 0, spin)}, method);
      ASSERT_EQ(found.status, Status::kSolved) << name_of(method);
      const double left = std::copysign(std::max(std::abs(spin) - taken, 0.0), spin);
      EXPECT_NEAR(found.u(3), left, kThroughTolerance * std::abs(spin));
    }
  }
}

// With I = m e^2 force and torque share one disc: (ft, torque / e) is against (ut, e spin), and
// |(ut, e spin)| falls by mu v.
TEST(SingleContact, TorsionAndFrictionShareTheEllipsoid) {
  const double m = 0.2, e = 0.01, mu = 0.6, v = 0.3;
  const MatrixXd W = Vector4d(1, 1, 1, 1 / (e * e)).asDiagonal().toDenseMatrix() / m;
  const Vector3d slip(0.3, -0.2, 0.4);  // (ut, e spin)
  const Vector4d b(-v, slip(0), slip(1), slip(2) / e);
  for (const ContactMethod method : kExactCones) {
    const ContactSolution found = solve_cold({{soft_finger_block(mu, e)}, W, b}, method);
    ASSERT_EQ(found.status, Status::kSolved) << name_of(method);
    const Vector3d left(found.u(1), found.u(2), e * found.u(3));
    EXPECT_LT((left - (1 - mu * v / slip.norm()) * slip).norm(), kThroughTolerance);
    const Vector3d force(found.f(1), found.f(2), found.f(3) / e);
    EXPECT_LT((force + mu * m * v * slip.normalized()).norm(), kThroughTolerance);
  }
}

TEST(SingleContact, WithoutFrictionOnlyTheNormalPushes) {
  for (const ContactMethod method : kExactCones) {
    const ContactSolution found = solve_cold(point_on_plane(0, Vector3d(-1, 3, -4)), method);
    ASSERT_EQ(found.status, Status::kSolved);
    EXPECT_LT((found.f - Vector3d(2, 0, 0)).norm(), kThroughTolerance);
    EXPECT_LT((found.u - Vector3d(0, 3, -4)).norm(), kThroughTolerance);
  }
}

// Friction of a joint, a motor at its limit, a tie.
TEST(SingleContact, BoxesSaturate) {
  for (const ContactMethod method : kExactCones) {
    const auto solved = [&](const ContactBlock& block, double b) {
      return solve_cold({{block}, MatrixXd::Constant(1, 1, 0.5), VectorXd::Constant(1, b)}, method);
    };
    EXPECT_NEAR(solved(box_block(-2, 3), 4).f(0), -2, kThroughTolerance);    // u = 3
    EXPECT_NEAR(solved(box_block(-2, 3), -4).f(0), 3, kThroughTolerance);    // u = -2.5
    EXPECT_NEAR(solved(box_block(-2, 3), 0.5).f(0), -1, kThroughTolerance);  // u = 0
    EXPECT_NEAR(solved(box_block(1, 3), 4).f(0), 1, kThroughTolerance);      // pushes at least 1
    EXPECT_NEAR(solved(bilateral_block(), 4).f(0), -8, kThroughTolerance);
    EXPECT_NEAR(solved(unilateral_block(), -4).f(0), 8, kThroughTolerance);
    EXPECT_NEAR(solved(unilateral_block(), 4).f(0), 0, kThroughTolerance);
  }
}

// Painleve's configuration, mu W_nt > W_nn: at a contact that neither approaches nor separates
// there are two answers, none and an impulse that stops the slip at once. Both are certified, and
// the warm start says which one is found; from nothing it is the one without impulse.
TEST(SingleContact, PainleveHasTwoAnswers) {
  Matrix3d W;
  W << 1, 0.8, 0, 0.8, 1, 0, 0, 0, 1;
  const ContactProblem problem{{coulomb_block(1.5)}, W, Vector3d(0.01, 1, 0)};
  const Vector3d jam = -W.inverse() * problem.b;  // |ft| / fn = 1.26 < 1.5
  EXPECT_LT(contact_residual(problem, jam).natural, kRounding);
  EXPECT_EQ(contact_residual(problem, Vector3d::Zero()).natural, 0);
  ContactSolver solver;
  EXPECT_EQ(solver.solve(problem, VectorXd()).f, Vector3d::Zero());
  const ContactSolution near = solver.solve(problem, 1.1 * jam);
  ASSERT_EQ(near.status, Status::kSolved);
  EXPECT_LT((near.f - jam).norm(), kThroughTolerance);
}

// In the same configuration a body that comes down cannot go on sliding: un would not reach 0. The
// only answer is the impulse that stops it. Newton alone does not get there, and says so.
TEST(SingleContact, PainleveStopsASlidingBodyThatComesDown) {
  Matrix3d W;
  W << 1, 0.8, 0, 0.8, 1, 0, 0, 0, 1;
  for (const ContactMethod method : kExactCones) {
    const ContactSolution found =
        solve_cold({{coulomb_block(1.5)}, W, Vector3d(-0.01, 1, 0)}, method);
    if (method == ContactMethod::kNewton && found.status == Status::kStalled) continue;
    ASSERT_EQ(found.status, Status::kSolved) << name_of(method);
    EXPECT_LT(found.u.norm(), kThroughTolerance);
  }
}

TEST(SingleContact, RestingProblemIsAnsweredAtOnce) {
  const ContactSolution found = solve_cold(point_on_plane(0.5, Vector3d::Zero()));
  EXPECT_EQ(found.status, Status::kSolved);
  EXPECT_EQ(found.f, Vector3d::Zero());
  // What the last step needed, this one does not.
  ContactSolver solver;
  const ContactSolution warm =
      solver.solve(point_on_plane(0.5, Vector3d::Zero()), Vector3d(0.1, 0.02, 0));
  EXPECT_EQ(warm.status, Status::kSolved);
  EXPECT_EQ(warm.f, Vector3d::Zero());
  const ContactSolution empty = solve_cold({{}, MatrixXd(0, 0), VectorXd(0)});
  EXPECT_EQ(empty.status, Status::kSolved);
}

}  // namespace
}  // namespace thenar
