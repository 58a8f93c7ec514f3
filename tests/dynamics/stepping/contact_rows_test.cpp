// Tests for dynamics/stepping/contact_rows.cpp: rows of balls on slides and of a cube on a floor.

#include "dynamics/stepping/contact_rows.h"

#include <gtest/gtest.h>

#include "dynamics/stepping/free_velocity.h"
#include "dynamics/stepping/scene_contacts.h"
#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar {
namespace {

/// A scene at its start, and the rows of what touches there.
class RowsOf {
 public:
  explicit RowsOf(MovingScene s)
      : scene_(std::move(s)),
        model_(tree_model(scene_.mechanism)),
        motion_(model_),
        contacts_(scene_, model_),
        efforts_(scene_, model_),
        free_(scene_, model_),
        rows(scene_, model_) {
    const SceneState state{0, scene_.q, scene_.v, efforts_.elements.initial_states(scene_.q)};
    motion_.set_state(state);
    contacts_.find_contacts(motion_, state, 1e-6, list);
    (void)free_.compute(motion_, efforts_, state, 0, 0);
    rows.assemble(list, 1e-3, motion_.links(), free_.mass);
    rows.problem.b = rows.Jt.transpose() * scene_.v;
  }

 private:
  MovingScene scene_;
  TreeModel model_;
  SceneMotion motion_;
  SceneContacts contacts_;
  AppliedEfforts efforts_;
  FreeVelocity free_;

 public:
  std::vector<ActiveContact> list;
  ContactRows rows;
};

/// A ball of 0.02 kg on a slide at its lower limit, with dry friction.
MovingScene ball_at_its_limit() {
  MovingScene scene;
  const int ball =
      sample::add_on_joint(scene, "ball", sample::primitive(ShapeKind::kSphere, {0.01, 0, 0}), 0.02,
                           JointKind::kSlide, {1, 0, 0}, {0, 0, 0});
  MechanismJoint& joint = scene.mechanism.joints[static_cast<std::size_t>(ball)];
  joint.lower = 0;
  joint.friction = 3;
  scene.v[0] = -0.5;
  return scene;
}

TEST(ContactRows, OfALimitAndDryFrictionAreThoseOfTheJoint) {
  const RowsOf at(ball_at_its_limit());
  ASSERT_EQ(at.list.size(), 2U);
  EXPECT_EQ(at.list[0].kind, ActiveContact::Kind::kLowerLimit);
  EXPECT_EQ(at.list[1].kind, ActiveContact::Kind::kJointFriction);
  EXPECT_NEAR(at.rows.Jt(0, 0), 1, 1e-15);
  EXPECT_NEAR((at.rows.problem.W.array() - 1 / 0.02).abs().maxCoeff(), 0, 1e-10);
  EXPECT_NEAR(at.rows.problem.b[0], -0.5, 1e-15);
}

/// A cube of 50 mm and 0.1 kg that stands on a level floor.
MovingScene standing_cube() {
  MovingScene scene = sample::incline(0, 0.5).scene;
  scene.friction.restitution = 0.3;
  return scene;
}

TEST(ContactRows, OfACubeBearTwoPlanesAndANormal) {
  const RowsOf at(standing_cube());
  ASSERT_EQ(at.list.size(), 4U);
  ASSERT_EQ(at.rows.Jt.cols(), 12);
  const Eigen::MatrixXd& W = at.rows.problem.W;
  EXPECT_LT((W - W.transpose()).norm(), 1e-12 * W.norm());
  // Equal normal impulses on all corners lift the cube alone: u = 4 f / m.
  Eigen::VectorXd f = Eigen::VectorXd::Zero(12);
  for (int k = 0; k < 4; ++k) f[3 * k] = 1;
  const Eigen::VectorXd u = W * f;
  for (int k = 0; k < 4; ++k) {
    EXPECT_NEAR(u[3 * k], 4 / 0.1, 1e-8);
    EXPECT_NEAR(u[3 * k + 1], 0, 1e-8);
  }
}

TEST(ContactRows, StartFromTheImpulsesThatWereRead) {
  RowsOf at(standing_cube());
  ContactSolution answer;
  answer.f = Eigen::VectorXd::LinSpaced(12, 0.1, 1.2);
  answer.u = Eigen::VectorXd::Zero(12);
  answer.u[1] = 0.2;  // the first slides
  answer.u[3] = 0.1;  // the second opens
  at.rows.store_solution(answer, at.list);
  EXPECT_EQ(at.list[0].mode, ContactMode::kSlide);
  EXPECT_NEAR(at.list[0].slip, 0.2, 1e-15);
  EXPECT_EQ(at.list[1].mode, ContactMode::kOpen);
  EXPECT_EQ(at.list[2].mode, ContactMode::kStick);
  EXPECT_LT((at.rows.warm_start(at.list) - answer.f).norm(), 1e-14);
}

TEST(ContactRows, BounceWhereTheyClose) {
  RowsOf at(standing_cube());
  at.rows.problem.b.setConstant(-1);
  at.rows.problem.b[3] = 1;
  at.rows.apply_restitution(at.list);
  EXPECT_NEAR(at.rows.problem.b[0], -1.3, 1e-15);
  EXPECT_EQ(at.rows.problem.b[1], -1);
  EXPECT_EQ(at.rows.problem.b[3], 1);
}

// What goes on has the mean of both ends: twice the gap over the step, and 3/4 of what alternates.
TEST(ContactRows, AskForTheMeanOfBothEnds) {
  RowsOf at(standing_cube());
  at.rows.problem.b.setZero();
  at.list[0].gap = 1e-5;
  at.list[0].mode = ContactMode::kSlide;
  at.list[0].previous.closing = 0.04;
  at.list[1].gap = 1e-5;  // open before
  at.list[1].mode = ContactMode::kOpen;
  at.list[2].gap = -1;  // pushed out no faster than asked
  at.list[2].mode = ContactMode::kOpen;
  at.rows.add_midpoint_terms(Eigen::VectorXd::Zero(6), 1e-3, 0.1, at.list);
  EXPECT_NEAR(at.rows.problem.b[0], 0.75 * 0.02 + 0.25 * 0.04, 1e-15);
  EXPECT_NEAR(at.rows.problem.b[3], 0.01, 1e-15);
  EXPECT_NEAR(at.rows.problem.b[6], -0.1, 1e-15);
}

}  // namespace
}  // namespace thenar
