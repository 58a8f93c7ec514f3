// Tests for dynamics/stepping/contact_step.cpp: impacts, projections and stiffness in closed form.

#include "dynamics/stepping/contact_step.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using sample::primitive;

/// A fixed floor whose top is the plane z = 0.
void add_level_floor(MovingScene& scene) {
  (void)sample::add_body(scene, "floor", primitive(ShapeKind::kBox, {1, 1, 0.1}), 0,
                         {Eigen::Matrix3d::Identity(), {0, 0, -0.05}});
}

/// A free ball whose centre is at a point.
void add_free_ball(MovingScene& scene, const char* name, double radius, double mass,
                   const Vector3d& centre) {
  (void)sample::add_body(scene, name, primitive(ShapeKind::kSphere, {radius, 0, 0}), mass,
                         {Eigen::Matrix3d::Identity(), centre});
}

/// A scene at its start, and what a step makes of it. A free body has six velocities, the angular
/// ones first.
struct OneStep {
  explicit OneStep(const MovingScene& scene) : step(scene), state(step.initial_state()) {
    step.find_contacts(state, kSearchMargin, touching);
  }
  void resolve_impact() { step.resolve_impact(state, touching, outcome); }
  /// Closes the gaps of all contacts, as if they pressed.
  void close_gaps(double max_correction) {
    for (ActiveContact& contact : touching) contact.mode = ContactMode::kStick;
    step.close_gaps(state, touching, max_correction);
  }

  ContactStep step;
  SceneState state;
  std::vector<ActiveContact> touching;
  StepOutcome outcome;
};

constexpr double kBallRadius = 0.02, kBallWeight = 0.05;  // [m], [kg]

/// A ball that touches a floor.
MovingScene touching_ball(const Vector3d& velocity, double restitution, double friction) {
  MovingScene scene;
  add_level_floor(scene);
  add_free_ball(scene, "ball", kBallRadius, kBallWeight, {0, 0, kBallRadius});
  scene.v.tail<3>() = velocity;
  scene.friction.restitution = restitution;
  scene.friction.coefficient = friction;
  return scene;
}

// v_n+ = -e v_n; an impulse (1 + e) m v_n; a loss of  m v_n^2 (1 - e^2) / 2.
TEST(ContactStepImpact, OfABallOnAFloorObeysNewtonsLaw) {
  for (const double e : {0.0, 0.5, 1.0}) {
    SCOPED_TRACE(e);
    OneStep at(touching_ball({0.3, 0, -2}, e, 0));
    ASSERT_EQ(at.touching.size(), 1U);
    at.resolve_impact();
    EXPECT_TRUE(at.outcome.solved);
    EXPECT_LT((at.state.v.tail<3>() - Vector3d(0.3, 0, 2 * e)).norm(), 1e-9);
    EXPECT_LT(at.state.v.head<3>().norm(), 1e-9);
    ASSERT_EQ(at.outcome.active.size(), 1U);
    EXPECT_NEAR(at.outcome.active[0].impulse.norm(), (1 + e) * kBallWeight * 2, 1e-9);
    EXPECT_NEAR(at.state.w[kImpactLoss], 0.5 * kBallWeight * 4 * (1 - e * e), 1e-9);
    EXPECT_NEAR(at.state.w[kFrictionLoss], 0, 1e-12);
  }
}

TEST(ContactStepImpact, LeavesABallThatRises) {
  OneStep at(touching_ball({0.3, 0, 2}, 0.5, 0.8));
  const Eigen::VectorXd before = at.state.v;
  at.resolve_impact();
  EXPECT_LT((at.state.v - before).norm(), 1e-12);
  EXPECT_LT(at.state.w.norm(), 1e-12);
}

// A ball without spin, I = 2/5 m r^2, that slides at u: friction needs the impulse  2/7 m u  to
// make it roll, at 5/7 u, and dissipates  m u^2 / 7.
TEST(ContactStepImpact, WithMuchFrictionMakesABallRoll) {
  const double e = 0.4, u = 0.7, fall = 1.5;
  OneStep at(touching_ball({u, 0, -fall}, e, 0.5));
  ASSERT_LT(2.0 / 7 * u, 0.5 * (1 + e) * fall);  // it sticks
  at.resolve_impact();
  const double rolls = 5.0 / 7 * u;
  EXPECT_LT((at.state.v.tail<3>() - Vector3d(rolls, 0, e * fall)).norm(), 1e-8);
  EXPECT_LT((at.state.v.head<3>() - Vector3d(0, rolls / kBallRadius, 0)).norm(), 1e-6);
  EXPECT_NEAR(at.state.w[kFrictionLoss], kBallWeight * u * u / 7, 1e-9);
  EXPECT_NEAR(at.state.w[kImpactLoss], 0.5 * kBallWeight * fall * fall * (1 - e * e), 1e-9);
}

// If it still slides, friction is  mu (1 + e) m v_n  and slows the point of contact by 7/2 of what
// it slows the centre.
TEST(ContactStepImpact, WithLittleFrictionLetsABallSlide) {
  const double e = 0.4, u = 2, fall = 1.5, mu = 0.1, slowed = mu * (1 + e) * fall;
  OneStep at(touching_ball({u, 0, -fall}, e, mu));
  ASSERT_GT(u, 3.5 * slowed);  // it slides
  at.resolve_impact();
  EXPECT_LT((at.state.v.tail<3>() - Vector3d(u - slowed, 0, e * fall)).norm(), 1e-8);
  EXPECT_LT((at.state.v.head<3>() - Vector3d(0, 2.5 * slowed / kBallRadius, 0)).norm(), 1e-6);
  const double mean_slip = u - 0.5 * 3.5 * slowed;
  EXPECT_NEAR(at.state.w[kFrictionLoss], kBallWeight * slowed * mean_slip, 1e-9);
}

// Momentum and  v2+ - v1+ = e (v1 - v2);  the loss is that of the reduced mass.
TEST(ContactStepImpact, OfTwoBallsConservesMomentum) {
  const double m1 = 0.1, m2 = 0.3, v1 = 1.2, v2 = -0.4, e = 0.6;
  MovingScene scene;
  add_free_ball(scene, "one", 0.01, m1, {0, 0, 0});
  add_free_ball(scene, "two", 0.02, m2, {0.03, 0, 0});
  scene.v[3] = v1;
  scene.v[9] = v2;
  scene.friction.restitution = e;
  OneStep at(scene);
  ASSERT_EQ(at.touching.size(), 1U);
  at.resolve_impact();
  const double momentum = m1 * v1 + m2 * v2, closing = v1 - v2;
  EXPECT_NEAR(at.state.v[3], (momentum - m2 * e * closing) / (m1 + m2), 1e-9);
  EXPECT_NEAR(at.state.v[9], (momentum + m1 * e * closing) / (m1 + m2), 1e-9);
  const double reduced = m1 * m2 / (m1 + m2);
  EXPECT_NEAR(at.state.w[kImpactLoss], 0.5 * reduced * closing * closing * (1 - e * e), 1e-9);
}

// A bar that falls flat on a peg at d from its middle. The peg feels the mass
// m' = (1 / m + d^2 / I)^-1,  I = m (l^2 + h^2) / 12.
TEST(ContactStepImpact, OfABarNearItsEndTurnsIt) {
  const double length = 0.2, height = 0.01, d = 0.09, m = 0.12, fall = 1.1, e = 0.3;
  MovingScene scene;
  (void)sample::add_body(scene, "peg", primitive(ShapeKind::kSphere, {0.02, 0, 0}), 0,
                         {Eigen::Matrix3d::Identity(), {d, 0, -0.02 - 0.5 * height}});
  (void)sample::add_body(scene, "bar", primitive(ShapeKind::kBox, {length, 0.01, height}), m);
  scene.v[5] = -fall;
  scene.friction.restitution = e;
  OneStep at(scene);
  ASSERT_EQ(at.touching.size(), 1U);
  at.resolve_impact();
  const double inertia = m * (length * length + height * height) / 12;
  const double felt = 1 / (1 / m + d * d / inertia), impulse = felt * (1 + e) * fall;
  EXPECT_NEAR(at.state.v[5], -fall + impulse / m, 1e-9);
  EXPECT_NEAR(at.state.v[1], -d * impulse / inertia, 1e-7);
  EXPECT_NEAR(at.state.w[kImpactLoss], 0.5 * felt * fall * fall * (1 - e * e), 1e-9);
}

// Ball and floor: the ball moves by the whole gap, whether it is open or the ball has sunk in.
TEST(ContactStepProjection, MovesABallToTheFloor) {
  for (const double gap : {5e-5, -5e-5}) {
    SCOPED_TRACE(gap);
    MovingScene scene;
    add_level_floor(scene);
    add_free_ball(scene, "ball", kBallRadius, kBallWeight, {0.1, 0.2, kBallRadius + gap});
    scene.v.setConstant(0.3);
    OneStep at(scene);
    ASSERT_EQ(at.touching.size(), 1U);
    at.close_gaps(1);
    EXPECT_LT((at.state.q.tail<3>() - Vector3d(0.1, 0.2, kBallRadius)).norm(), 1e-12);
    EXPECT_EQ(at.state.v, scene.v);
    EXPECT_EQ(at.state.w.norm(), 0);
    EXPECT_EQ(at.state.t, 0);
  }
}

TEST(ContactStepProjection, CorrectsNoMoreThanAllowed) {
  MovingScene scene;
  add_level_floor(scene);
  add_free_ball(scene, "ball", kBallRadius, kBallWeight, {0, 0, kBallRadius + 5e-5});
  OneStep at(scene);
  at.close_gaps(1e-5);
  EXPECT_NEAR(at.state.q.tail<1>()[0], kBallRadius + 4e-5, 1e-12);
}

TEST(ContactStepProjection, LeavesContactsWithoutAForce) {
  MovingScene scene;
  add_level_floor(scene);
  add_free_ball(scene, "ball", kBallRadius, kBallWeight, {0, 0, kBallRadius + 5e-5});
  OneStep at(scene);
  at.touching[0].mode = ContactMode::kOpen;
  at.step.close_gaps(at.state, at.touching, 1);
  EXPECT_EQ(at.state.q, scene.q);
}

// The least motion in the metric of masses moves each ball by the other's share of the mass.
TEST(ContactStepProjection, MovesTheLighterOfTwoBallsFarther) {
  const double m1 = 0.1, m2 = 0.3, gap = 4e-5;
  MovingScene scene;
  add_free_ball(scene, "one", 0.01, m1, {0, 0, 0});
  add_free_ball(scene, "two", 0.02, m2, {0.03 + gap, 0, 0});
  OneStep at(scene);
  at.close_gaps(1);
  EXPECT_NEAR(at.state.q[4], gap * m2 / (m1 + m2), 1e-12);
  EXPECT_NEAR(at.state.q[11], 0.03 + gap - gap * m1 / (m1 + m2), 1e-12);
  // Without friction nothing turns.
  EXPECT_NEAR(at.state.q[0], 1, 1e-12);
  EXPECT_NEAR(at.state.q[7], 1, 1e-12);
}

/// A ball of m = 0.02 kg on a slide.
MovingScene ball_on_slide() {
  MovingScene scene;
  (void)sample::add_on_joint(scene, "ball", primitive(ShapeKind::kSphere, {0.01, 0, 0}), 0.02,
                             JointKind::kSlide, {1, 0, 0}, {0, 0, 0});
  scene.gravity.setZero();
  return scene;
}

// h c + h^2 k = m  at  h = (sqrt(c^2 + 4 k m) - c) / 2 k.
TEST(ContactStepStiffness, StartsWhereSlopesExceedTheMass) {
  const double k = 50, c = 0.3, m = 0.02;
  const double limit = (std::sqrt(c * c + 4 * k * m) - c) / (2 * k);
  MovingScene sprung = ball_on_slide(), driven = ball_on_slide();
  sprung.mechanism.joints[0].stiffness = k;
  sprung.mechanism.joints[0].damping = c;
  driven.drives.push_back({0, 0, k, c});
  for (const MovingScene& scene : {sprung, driven}) {
    OneStep at(scene);
    EXPECT_FALSE(at.step.is_stiff(at.state, (1 - 1e-9) * limit));
    EXPECT_TRUE(at.step.is_stiff(at.state, (1 + 1e-9) * limit));
  }
}

TEST(ContactStepStiffness, IsNoneOfADriveAtItsLimitNorOfAFreeBody) {
  MovingScene scene = ball_on_slide();
  OneStep free(scene);
  EXPECT_FALSE(free.step.is_stiff(free.state, 1e3));
  scene.drives.push_back({0, 0, 50, 0.3});
  scene.drives[0].target = 1;
  scene.drives[0].max_effort = 0.1;  // of the 50 N that it would have
  OneStep at(scene);
  EXPECT_FALSE(at.step.is_stiff(at.state, 1e3));
}

}  // namespace
}  // namespace thenar
