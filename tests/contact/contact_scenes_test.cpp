// Tests for contact/contact_solver.cpp: scenes of several contacts, by closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <Eigen/LU>

#include "base/units.h"
#include "contact/contact_solver.h"
#include "tests/contact/contact_samples.h"

namespace thenar {
namespace {

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Body = sample::TouchingBodies::Body;

constexpr double kSceneTolerance = 1e-9;  // in SI units, of impulses and velocities near 1
constexpr double kStep = 0.01;            // [s]
constexpr double kGravity = 9.81;         // [m/s^2]
constexpr ContactMethod kSceneMethods[] = {ContactMethod::kAutomatic,
                                           ContactMethod::kInteriorPoint};

ContactSolution solve_scene(const ContactProblem& problem,
                            ContactMethod method = ContactMethod::kAutomatic) {
  ContactSolver solver;
  ContactSolverOptions options;
  options.method = method;
  return solver.solve(problem, VectorXd(), options);
}

/// A box of half edges a (x, y) and h (z) on the ground by its four corners, after a step of
/// gravity and of a push through its centre along x.
struct CornerBox {
  double mass = 0.5, a = 0.03, h = 0.05;
  sample::TouchingBodies bodies;

  CornerBox(double mu, double push) {  // push: acceleration [m/s^2]
    Body body;
    body.mass = mass;
    body.inertia = (mass / 3 * Vector3d(a * a + h * h, a * a + h * h, 2 * a * a)).asDiagonal();
    body.centre = Vector3d(0, 0, h);
    body.velocity << 0, 0, 0, push * kStep, 0, -kGravity * kStep;
    bodies.bodies.push_back(body);
    for (const double x : {-a, a})
      for (const double y : {-a, a})
        bodies.touch(coulomb_block(mu), 0, -1, Vector3d(x, y, 0), Vector3d::UnitZ());
  }

  /// Velocity of the box after impulses f: turning, centre (6).
  [[nodiscard]] VectorXd after(const VectorXd& f) const {
    return bodies.velocity() + bodies.inverse_mass() * bodies.jacobian().transpose() * f;
  }
};

// Twelve rows on a body of six freedoms: how corners share is open, their sum is not.
TEST(ContactScenes, BoxOnFourCornersStands) {
  for (const ContactMethod method : kSceneMethods) {
    const CornerBox box(0.5, 0.3 * kGravity);
    const ContactSolution found = solve_scene(box.bodies.problem(), method);
    ASSERT_EQ(found.status, Status::kSolved) << name_of(method);
    EXPECT_LT(box.after(found.f).norm(), kSceneTolerance);
    const VectorXd wrench = box.bodies.jacobian().transpose() * found.f;
    EXPECT_NEAR(wrench(5), box.mass * kGravity * kStep, kSceneTolerance);
    EXPECT_NEAR(wrench(3), -box.mass * 0.3 * kGravity * kStep, kSceneTolerance);
  }
}

// Loads that are gone leave no squeeze behind, not even where velocities are rounding alone.
TEST(ContactScenes, BoxOnFourCornersForgetsItsLoad) {
  const CornerBox loaded(0.5, 0.3 * kGravity);
  ContactProblem problem = loaded.bodies.problem();
  ContactSolver solver;
  const VectorXd f = solver.solve(problem, VectorXd()).f;
  problem.b *= 1e-16;
  const ContactSolution& found = solver.solve(problem, f);
  ASSERT_EQ(found.status, Status::kSolved);
  EXPECT_LT(found.f.norm(), 1e-15);
}

// Pushed beyond mu it slides without turning, at (push - mu g) dt, as long as it does not tip.
TEST(ContactScenes, BoxOnFourCornersSlides) {
  for (const ContactMethod method : kSceneMethods) {
    const CornerBox box(0.3, 0.5 * kGravity);
    const ContactSolution found = solve_scene(box.bodies.problem(), method);
    ASSERT_EQ(found.status, Status::kSolved) << name_of(method);
    const VectorXd after = box.after(found.f);
    EXPECT_NEAR(after(3), 0.2 * kGravity * kStep, kSceneTolerance);
    EXPECT_LT(after.head<3>().norm(), 1e-8);
    EXPECT_NEAR(after(5), 0, kSceneTolerance);
  }
}

// Rough enough not to slide, a box tips about its edge where push h > g a, at the rate
// (push h - g a) dt m / (I + m (a^2 + h^2)); at the threshold within 1e-6 of it, on both sides.
TEST(ContactScenes, BoxTipsBeyondItsEdge) {
  for (const double excess : {-1e-6, 1e-6, 0.2}) {
    const CornerBox shape(5, 0);
    const double push = kGravity * shape.a / shape.h * (1 + excess);
    const CornerBox box(5, push);
    const ContactSolution found = solve_scene(box.bodies.problem());
    ASSERT_EQ(found.status, Status::kSolved);
    const double m = box.mass, a = box.a, h = box.h,
                 about_edge = m / 3 * (a * a + h * h) + m * (a * a + h * h),
                 rate = std::max(0.0, (push * h - kGravity * a) * kStep * m / about_edge);
    EXPECT_NEAR(box.after(found.f)(1), rate, 1e-10) << excess;
  }
}

/// A cube between two fingers on slides along x, which push with `force` (Coulomb contacts).
ContactProblem pinched_cube(double mass, double finger, double mu, double force) {
  sample::TouchingBodies bodies;
  Body cube;
  cube.mass = mass;
  cube.inertia = mass * 0.02 * 0.02 / 6 * Eigen::Matrix3d::Identity();
  cube.centre.setZero();
  cube.velocity << 0, 0, 0, 0, 0, -kGravity * kStep;
  bodies.bodies.push_back(cube);
  bodies.touch(coulomb_block(mu), 0, -1, Vector3d(-0.01, 0, 0), Vector3d::UnitX());
  bodies.touch(coulomb_block(mu), 0, -1, Vector3d(0.01, 0, 0), -Vector3d::UnitX());
  ContactProblem problem = bodies.problem();
  for (const Eigen::Index normal : {0, 3}) {
    problem.W(normal, normal) += 1 / finger;
    problem.b(normal) -= force * kStep / finger;
  }
  return problem;
}

// Fingers stop at the cube: fn = F dt. Each carries half of the weight.
TEST(ContactScenes, PinchHoldsTheCube) {
  for (const double finger : {0.1, 1e-4, 1e2}) {
    const ContactProblem problem = pinched_cube(0.1, finger, 0.8, 2);
    const ContactSolution found = solve_scene(problem);
    ASSERT_EQ(found.status, Status::kSolved);
    EXPECT_LT(found.u.lpNorm<Eigen::Infinity>(), 1e-10);
    for (const Eigen::Index k : {0, 3}) {
      EXPECT_NEAR(found.f(k), 2 * kStep, 1e-10);
      EXPECT_NEAR(found.f.segment<2>(k + 1).norm(), 0.1 * kGravity * kStep / 2, 1e-10);
    }
  }
}

// Beyond 2 mu F the cube slides down, at g dt less what friction holds.
TEST(ContactScenes, PinchLosesWhatItCannotHold) {
  const ContactProblem problem = pinched_cube(0.4, 0.1, 0.8, 2);
  const ContactSolution found = solve_scene(problem);
  ASSERT_EQ(found.status, Status::kSolved);
  const double slip = kGravity * kStep - 2 * 0.8 * 2 * kStep / 0.4;
  for (const Eigen::Index k : {1, 4}) EXPECT_NEAR(found.u.segment<2>(k).norm(), slip, 1e-10);
}

// Two links, mass matrix M, limits at both joints, by hand: the first is met, the second left
// alone, as W21 f1 opens it.
TEST(ContactScenes, ArmStopsAtItsLimit) {
  Matrix2d M;
  M << 3, 1, 1, 2;
  const Matrix2d W = M.inverse();  // [2 -1; -1 3] / 5
  const ContactProblem problem{{unilateral_block(), unilateral_block()}, W, Vector2d(-1, 2)};
  const ContactSolution found = solve_scene(problem);
  ASSERT_EQ(found.status, Status::kSolved);
  EXPECT_LT((found.f - Vector2d(2.5, 0)).norm(), kSceneTolerance);
  EXPECT_LT((found.u - Vector2d(0, 1.5)).norm(), kSceneTolerance);
}

// Dry friction of the second joint, a motor with a limit at the first.
TEST(ContactScenes, ArmWithDryFrictionAndMotor) {
  Matrix2d M;
  M << 3, 1, 1, 2;
  const ContactProblem problem{
      {box_block(-0.5, 0.5), box_block(-0.2, 0.2)}, M.inverse(), Vector2d(-1, 0.01)};
  const ContactSolution found = solve_scene(problem);
  ASSERT_EQ(found.status, Status::kSolved);
  // The motor saturates at 0.5 and leaves u2 = 0.01 - 0.1 + 0.6 f2 = 0 to friction: f2 = 0.15.
  EXPECT_LT((found.f - Vector2d(0.5, 0.15)).norm(), kSceneTolerance);
}

/// Balls of 1 kg in a row, of which the first comes at 1 m/s; restitution folded into b.
ContactProblem cradle(int balls, double restitution) {
  const int n = balls - 1;
  MatrixXd W = 2 * MatrixXd::Identity(n, n);
  for (int i = 1; i < n; ++i) W(i, i - 1) = W(i - 1, i) = -1;
  VectorXd b = VectorXd::Zero(n);
  b(0) = -(1 + restitution);
  return {std::vector<ContactBlock>(static_cast<std::size_t>(n), unilateral_block()), W, b};
}

// Without restitution all balls go on together at 1 / n: the k-th contact passes on (n - k) / n.
TEST(ContactScenes, CradleWithoutRestitutionMovesAsOne) {
  const ContactSolution found = solve_scene(cradle(5, 0));
  ASSERT_EQ(found.status, Status::kSolved);
  for (int k = 1; k < 5; ++k) EXPECT_NEAR(found.f(k - 1), (5.0 - k) / 5, kSceneTolerance);
}

// Newton's law of restitution at all contacts at once is not the cradle of the toy shop, in which
// impacts follow each other: three balls leave at -1/3, 2/3, 2/3, with all energy, not at 0, 0, 1.
TEST(ContactScenes, CradleWithRestitutionSharesAtOnce) {
  const ContactSolution found = solve_scene(cradle(3, 1));
  ASSERT_EQ(found.status, Status::kSolved);
  EXPECT_LT((Vector3d(1 - found.f(0), found.f(0) - found.f(1), found.f(1)) - Vector3d(-1, 2, 2) / 3)
                .norm(),
            kSceneTolerance);
}

// A column of two points: the lower contact carries both. Either may be a million times heavier.
TEST(ContactScenes, ColumnsOfVeryUnequalMasses) {
  for (const double upper : {1e-6, 1.0, 1e6}) {
    for (const ContactMethod method : kSceneMethods) {
      MatrixXd W = MatrixXd::Zero(6, 6);
      W.topLeftCorner<3, 3>().setIdentity();
      W.bottomRightCorner<3, 3>() = (1 + 1 / upper) * Eigen::Matrix3d::Identity();
      W.topRightCorner<3, 3>() = W.bottomLeftCorner<3, 3>() = -Eigen::Matrix3d::Identity();
      VectorXd b = VectorXd::Zero(6);
      b(0) = -kGravity * kStep;
      b(4) = 0.2 * kGravity * kStep;  // the upper one is pushed sideways, friction holds it
      const ContactSolution found =
          solve_scene({{coulomb_block(0.5), coulomb_block(0.5)}, W, b}, method);
      ASSERT_EQ(found.status, Status::kSolved) << upper << name_of(method);
      const double weight = kGravity * kStep;
      EXPECT_NEAR(found.f(3) / (upper * weight), 1, 1e-6) << upper << name_of(method);
      EXPECT_NEAR(found.f(0) / ((1 + upper) * weight), 1, 1e-6);
      EXPECT_NEAR(found.f(4) / (0.2 * upper * weight), -1, 1e-6);
    }
  }
}

/// A point in a groove of two walls with normals (+-sin, 0, cos), pressed down.
ContactProblem groove(double angle, double mu) {
  sample::TouchingBodies bodies;
  Body body;
  body.mass = 1;
  body.inertia = Eigen::Matrix3d::Identity();
  body.centre.setZero();
  body.velocity << 0, 0, 0, 0, 0, -1;
  bodies.bodies.push_back(body);
  for (const double side : {-1, 1})
    bodies.touch(coulomb_block(mu), 0, -1, Vector3d::Zero(),
                 Vector3d(side * std::sin(angle), 0, std::cos(angle)));
  return bodies.problem();
}

// In steep and rough grooves impulses may grow without limit against each other. Whatever they
// are, they stop the point, and their certificate holds.
TEST(ContactScenes, GroovesHoldBySelfLocking) {
  for (const double mu : {0.0, 0.3, 1.0, 5.0, 100.0}) {
    for (const double angle : {0.3, 1.0, 1.5}) {
      const ContactProblem problem = groove(angle, mu);
      const ContactSolution found = solve_scene(problem);
      ASSERT_EQ(found.status, Status::kSolved) << mu << " " << angle;
      EXPECT_LT(found.u.norm(), 1e-8) << mu << " " << angle;
      EXPECT_LE(contact_residual(problem, found.f).natural, 1e-11);
    }
  }
}

// Two walls that close on a body at 1 m/s each: no impulse opens both. Nothing is called solved;
// Lemke's ray proves that there is no answer.
TEST(ContactScenes, WallsThatCloseHaveNoAnswer) {
  Matrix2d W;
  W << 1, -1, -1, 1;
  const ContactProblem problem{{unilateral_block(), unilateral_block()}, W, Vector2d(-1, -1)};
  for (const ContactMethod method : {ContactMethod::kAutomatic, ContactMethod::kNewton,
                                     ContactMethod::kGaussSeidel, ContactMethod::kInteriorPoint}) {
    const ContactSolution found = solve_scene(problem, method);
    EXPECT_NE(found.status, Status::kSolved) << name_of(method);
    EXPECT_GT(found.residual.natural, 0.1);
  }
  EXPECT_EQ(solve_scene(problem, ContactMethod::kPyramid).status, Status::kInfeasible);
}

// The same with an immovable body between: W has no entry at all.
TEST(ContactScenes, ImmovableBodiesThatApproachHaveNoAnswer) {
  const ContactProblem problem{{coulomb_block(0.5)}, Eigen::Matrix3d::Zero(), Vector3d(-1, 0, 0)};
  const ContactSolution found = solve_scene(problem);
  EXPECT_NE(found.status, Status::kSolved);
  EXPECT_TRUE(found.f.allFinite());
}

// A disc that slides on a table over its edge, tilted by next to nothing: what bears along the edge
// and on the face differ by the tilt alone, and sets of contacts that bear by less than that.
TEST(ContactScenes, DiscSlidesOverAnEdge) {
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> share(-1, 1);
  constexpr double kRadius = 0.012, kThick = 0.002, kMass = 8e-3;
  for (int trial = 0; trial < 300; ++trial) {
    sample::TouchingBodies disc;
    Body body;
    body.mass = kMass;
    const double across = kMass * (3 * kRadius * kRadius + kThick * kThick) / 12;
    body.inertia = Vector3d(across, across, kMass * kRadius * kRadius / 2).asDiagonal();
    body.centre = Vector3d(0, 0, kThick / 2);
    body.velocity << share(rng), share(rng), share(rng), 0.05 * share(rng), 0.05 * share(rng),
        -0.05 * std::abs(share(rng));
    disc.bodies.push_back(body);
    // Its rim above the table by 60 degrees, and where the rim meets the edge.
    const double edge = 0.9 * kRadius * share(rng), turn = kPi * share(rng);
    for (int k = 0; k < 6; ++k) {
      const double angle = turn + kPi / 3 * k;
      const Vector3d point(kRadius * std::cos(angle), kRadius * std::sin(angle), 0);
      if (point.x() > edge) disc.touch(coulomb_block(0.3), 0, -1, point, Vector3d::UnitZ());
    }
    const double tilt = std::pow(10, -8 + 2 * share(rng));
    for (const double side : {-1, 1}) {
      const Vector3d point(edge, side * std::sqrt(kRadius * kRadius - edge * edge), 0);
      disc.touch(coulomb_block(0.3), 0, -1, point, Vector3d(tilt * share(rng), 0, 1).normalized());
    }
    const ContactProblem problem = disc.problem();
    const ContactSolution found = solve_scene(problem);
    EXPECT_EQ(found.status, Status::kSolved)
        << trial << ": " << found.residual.natural << ", tilt " << tilt;
    EXPECT_LT(contact_residual(problem, found.f).natural, 1e-11) << trial;
  }
}

}  // namespace
}  // namespace thenar
