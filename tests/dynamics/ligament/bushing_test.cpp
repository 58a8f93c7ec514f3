// Tests for dynamics/ligament/bushing.cpp and bushing_law.cpp.

#include "dynamics/ligament/bushing.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "dynamics/mechanism/tree_model.h"
#include "dynamics/mechanism/tree_motion.h"
#include "tests/dynamics/ligament/sample_joints.h"

namespace thenar {
namespace {

/// An element at a state, by itself: its action and energy.
struct Evaluated {
  ElementAction action;
  double energy;
};
Evaluated evaluate(const MovingScene& scene, const Eigen::VectorXd& q) {
  const TreeModel model = tree_model(scene.mechanism);
  TreeMotion<double> motion(model);
  const Eigen::VectorXd v = Eigen::VectorXd::Zero(model.layout.v), z;
  motion.set_position(q);
  motion.set_speed(v);
  Evaluated out;
  out.action.clear(model.layout.v, 0);
  const std::unique_ptr<ForceElement> element = scene.elements.front()->clone();
  EXPECT_TRUE(element->add_action({0, 0, q, v, z, motion, 0}, out.action));
  out.energy = element->energy({0, 0, q, v, z, motion, 0});
  return out;
}

/// Efforts are minus the energy's gradient along every speed.
void expect_gradient(const MovingScene& scene, const Eigen::VectorXd& q) {
  const MechanismLayout layout = layout_of(scene.mechanism);
  const Evaluated at = evaluate(scene, q);
  const double d = 1e-7;  // a thousandth of a toe, squared, is what differences miss
  for (Eigen::Index k = 0; k < layout.v; ++k) {
    Eigen::VectorXd up = q, down = q;
    const Eigen::VectorXd v = Eigen::VectorXd::Unit(layout.v, k);
    advance_positions(scene.mechanism, layout, v, d, up);
    advance_positions(scene.mechanism, layout, v, -d, down);
    EXPECT_NEAR(at.action.tau[k],
                -(evaluate(scene, up).energy - evaluate(scene, down).energy) / (2 * d),
                1e-6 * (1 + at.action.tau.norm()))
        << k;
  }
}

/// A pose of the far bone against the near one.
Eigen::VectorXd turned(const MovingScene& scene, double flexion, double abduction, double twist) {
  Eigen::VectorXd q = scene.q;
  q[0] = 0.3;  // near hinge
  const Eigen::Quaterniond turn(rotation_about<double>({0, 0, 1}, flexion) *
                                rotation_about<double>({1, 0, 0}, abduction) *
                                rotation_about<double>({0, 1, 0}, twist));
  q.segment<4>(1) << turn.w(), turn.x(), turn.y(), turn.z();
  q.segment<3>(5) << 2e-4, -3e-4, 1e-4;
  return q;
}

TEST(BushingPose, FindsTheAnglesOfAJoint) {
  for (const double flexion : {-1.5, 0.0, 0.8, 1.6, 2.5}) {
    const Pose<double> X{rotation_about<double>({0, 0, 1}, flexion) *
                             rotation_about<double>({1, 0, 0}, 0.2) *
                             rotation_about<double>({0, 1, 0}, -0.3),
                         {1, 2, 3}};
    BushingVector wanted;
    wanted << 1, 2, 3, flexion, 0.2, -0.3;
    EXPECT_LT((bushing_pose(X).x - wanted).norm(), 1e-14);
  }
}

TEST(BushingElement, HasEffortsThatAreGradients) {
  const MovingScene scene = sample::bushing_scene(2, sample::uneven_law());
  for (const double flexion : {-0.5, 0.0, 0.9, 1.57, 2.0})
    expect_gradient(scene, turned(scene, flexion, 0.1, -0.15));
}

// At rest, where nothing pulls, its stiffness is exact.
TEST(BushingElement, HasTheStiffnessOfItsLaw) {
  const MovingScene scene = sample::bushing_scene(2, sample::even_law(2e4, 2));
  const MechanismLayout layout = layout_of(scene.mechanism);
  Eigen::VectorXd q = turned(scene, 0.6, 0, 0);
  q.segment<3>(5).setZero();
  const ElementAction at = evaluate(scene, q).action;
  EXPECT_LT(at.tau.norm(), 1e-12);
  const double d = 1e-6;
  for (Eigen::Index k = 0; k < layout.v; ++k) {
    Eigen::VectorXd up = q, down = q;
    const Eigen::VectorXd v = Eigen::VectorXd::Unit(layout.v, k);
    advance_positions(scene.mechanism, layout, v, d, up);
    advance_positions(scene.mechanism, layout, v, -d, down);
    const Eigen::VectorXd slope =
        (evaluate(scene, down).action.tau - evaluate(scene, up).action.tau) / (2 * d);
    EXPECT_LT((slope - at.stiffness.col(k)).norm(), 1e-6 * at.stiffness.norm());
  }
}

/// Two bones and a ligament from one to the other, or to the world.
MovingScene tied(const LigamentLaw& law, int from = 0) {
  MovingScene scene = sample::scene_of(sample::bones(2));
  scene.elements.push_back(
      std::make_shared<LigamentElement>("collateral", BodyPoint{from, {0.03, 0.005, 0.004}},
                                        BodyPoint{1, {0.01, 0.002, 0.003}}, law));
  return scene;
}

TEST(LigamentElement, HasEffortsThatAreGradients) {
  for (const int from : {0, -1}) {
    const MovingScene scene = tied({0.012, 800, 0.03, 0}, from);
    expect_gradient(scene, Eigen::Vector2d(0.4, -0.3));
    expect_gradient(scene, Eigen::Vector2d(0.1, -1.2));
  }
}

TEST(LigamentElement, DoesNothingWhenSlack) {
  const Evaluated at = evaluate(tied({0.1, 800, 0.03, 0}), Eigen::Vector2d(0.4, -0.3));
  EXPECT_TRUE(at.action.tau.isZero(0));
  EXPECT_TRUE(at.action.stiffness.isZero(0));
  EXPECT_EQ(at.energy, 0);
}

// A bone of 20 g hangs on a ligament of 10 mm from a point above its centre: it stretches until it
// carries the weight,  e = sqrt(4 e_l m g / K).
TEST(LigamentElement, CarriesAWeight) {
  Mechanism mechanism;
  mechanism.bodies.push_back(sample::bone("bone"));
  MechanismJoint joint;
  joint.name = "free";
  joint.kind = JointKind::kFree;
  joint.X_BM.p = mechanism.bodies[0].mass.com;
  mechanism.joints.push_back(joint);
  MovingScene scene = sample::scene_of(std::move(mechanism));
  scene.gravity = {0, 0, -9.81};
  const LigamentLaw law{0.01, 300, 0.03, 2};
  scene.elements.push_back(std::make_shared<LigamentElement>(
      "cord", BodyPoint{-1, {0, 0, 0.01}}, BodyPoint{0, scene.mechanism.bodies[0].mass.com}, law));
  SceneOptions options;
  options.duration = 3;
  const SceneRun run = simulate_scene(scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  const double strain = std::sqrt(4 * 0.03 * 0.02 * 9.81 / 300);
  EXPECT_NEAR(run.samples.back().q[6], -0.01 * strain, 1e-8);
}

TEST(BushingLaw, RefusesWhatIsImpossible) {
  BushingLaw law;
  law.flexion_ratios[3] = 0.1;
  EXPECT_THROW(check_law(law), InputError);
  law.flexion_ratios = {};
  law.law_for(BushingCoordinate::kTwist).stiffness = -1;
  EXPECT_THROW(BushingElement("x", {}, {}, law), InputError);
}

}  // namespace
}  // namespace thenar
