// Tests for dynamics/ligament/compliant_joint.cpp: laws, statics, the limit of a pin, stability.

#include "dynamics/ligament/compliant_joint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "dynamics/mechanism/articulated_body.h"
#include "dynamics/mechanism/simbody_machine.h"
#include "dynamics/stepping/contact_step.h"
#include "tests/dynamics/ligament/sample_joints.h"
#include "tests/dynamics/stepping/sample_scenes.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

double& coordinate(MovingScene& scene, int c) {
  return scene.q[layout_of(scene.mechanism).coordinate_q[static_cast<std::size_t>(c)]];
}
double value(const MovingScene& scene, int c, const Eigen::VectorXd& q) {
  return q[layout_of(scene.mechanism).coordinate_q[static_cast<std::size_t>(c)]];
}

/// Weight of the world acts, bones swing.
MovingScene falling(MovingScene scene) {
  scene.gravity = {0, 0, -9.81};
  return scene;
}

TEST(CompliantJoint, LeavesBonesWhereTheyAre) {
  const Mechanism pins = sample::bones(2);
  Mechanism gives = pins;
  const CompliantJoint joint = make_compliant(gives, 0, {sample::even_law(1e4, 1), {0.04, 0, 0}});
  ASSERT_EQ(gives.bodies.size(), 7u);
  EXPECT_EQ(gives.coordinates[0].name, "near");
  EXPECT_EQ(gives.coordinates[6].name, "near/twist");
  EXPECT_EQ(joint.coordinate[static_cast<std::size_t>(BushingCoordinate::kFlexion)], 0);
  check_mechanism(gives);
  // At any flexion both bones stand as on pins.
  const TreeModel model = tree_model(pins), other = tree_model(gives);
  TreeMotion<double> motion(model), moved(other);
  Eigen::VectorXd q = Eigen::VectorXd::Zero(other.layout.q);
  q[other.layout.coordinate_q[0]] = 0.7;
  q[other.layout.coordinate_q[1]] = -0.4;
  motion.set_position(Eigen::Vector2d(0.7, -0.4));
  moved.set_position(q);
  for (const auto& [pin, give] : {std::pair(0, 5), std::pair(1, 6)}) {
    EXPECT_EQ(gives.bodies[static_cast<std::size_t>(give)].name,
              pins.bodies[static_cast<std::size_t>(pin)].name);
    EXPECT_LT((motion.pose(pin).p - moved.pose(give).p).norm(), 1e-15);
    EXPECT_LT((motion.pose(pin).R - moved.pose(give).R).norm(), 1e-15);
  }
}

// A twist turns the bone about its own line, abduction about the floating axis.
TEST(CompliantJoint, TurnsTheBoneAboutItsLine) {
  CompliantJoint joint;
  MovingScene scene = sample::compliant_scene(1, sample::even_law(1e4, 1), &joint);
  coordinate(scene, 0) = 0.5;
  coordinate(scene, joint.coordinate[5]) = 0.3;
  const TreeModel model = tree_model(scene.mechanism);
  TreeMotion<double> motion(model);
  motion.set_position(scene.q);
  const Eigen::Matrix3d wanted =
      rotation_about<double>({0, 1, 0}, 0.5) * rotation_about<double>({1, 0, 0}, 0.3);
  EXPECT_LT((motion.pose(5).R - wanted).norm(), 1e-14);
}

TEST(CompliantJoint, HasTheAccelerationsOfSimbody) {
  CompliantJoint joint;
  const MovingScene scene = sample::compliant_scene(2, sample::uneven_law(), &joint);
  const TreeModel model = tree_model(scene.mechanism);
  SimbodyMachine simbody(scene.mechanism);
  const Eigen::VectorXd q = 0.2 * Eigen::VectorXd::LinSpaced(model.layout.q, -1, 1.3);
  const Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(model.layout.v, 2, -1);
  const Eigen::VectorXd tau = Eigen::VectorXd::LinSpaced(model.layout.v, 0.1, 0.3);
  TreeMotion<double> motion(model);
  motion.set_position(q);
  motion.set_speed(v);
  motion.clear_loads();
  Eigen::VectorXd ours(model.layout.v);
  ArticulatedBody<double>(model).accelerations(motion, Eigen::Vector3d(1, 2, -9.81), tau, ours);
  simbody.set_state(q, v);
  const Eigen::VectorXd theirs = simbody.accelerations(tau, {1, 2, -9.81});
  EXPECT_LT((ours - theirs).norm(), 1e-9 * theirs.norm());
}

// A chain of hinges and slides, and a free joint with a bushing between two frames: the same bones.
TEST(CompliantJoint, MovesAsABoneOnAFreeJointInABushing) {
  for (const int count : {1, 2}) {
    SCOPED_TRACE(count);
    const BushingLaw law = sample::uneven_law(1);
    MovingScene chain = falling(sample::compliant_scene(count, law));
    MovingScene bushing = falling(sample::bushing_scene(count, law));
    SceneOptions options;
    options.duration = 0.15;
    options.sample_interval = 0.05;
    options.tolerance = 1e-11;
    const SceneRun a = simulate_scene(chain, options), b = simulate_scene(bushing, options);
    ASSERT_EQ(a.status, SceneStatus::kDone);
    ASSERT_EQ(b.status, SceneStatus::kDone);
    ContactStep step_a(chain), step_b(bushing);
    std::vector<Pose<double>> poses_a, poses_b;
    for (std::size_t i = 0; i < a.samples.size(); ++i) {
      step_a.compute_poses({0, a.samples[i].q, a.samples[i].v, a.samples[i].z}, poses_a);
      step_b.compute_poses({0, b.samples[i].q, b.samples[i].v, b.samples[i].z}, poses_b);
      EXPECT_LT((poses_a.back().p - poses_b.back().p).norm(), 1e-8);
      EXPECT_LT((poses_a.back().R - poses_b.back().R).norm(), 1e-7);
      EXPECT_NEAR(a.samples[i].energy.springs, b.samples[i].energy.springs, 1e-8);
    }
  }
}

// Without damping nothing is lost, through 90 deg of flexion and into the straight parts.
TEST(CompliantJoint, KeepsEnergyWithoutDamping) {
  MovingScene scene = falling(sample::compliant_scene(2, sample::uneven_law()));
  scene.v[0] = 12;
  SceneOptions options;
  options.duration = 0.3;
  const SceneRun run = simulate_scene(scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  double turned_over = 0;
  for (const SceneSample& sample : run.samples) {
    turned_over = std::max(turned_over, sample.energy.kinetic);
    EXPECT_NEAR(sample.energy.total(), run.samples.front().energy.total(), 1e-7 * turned_over);
  }
  EXPECT_GT(turned_over, 1e-3);
}

/// What an element does at a state, by itself.
ElementAction action_at(const MovingScene& scene, const Eigen::VectorXd& q,
                        const Eigen::VectorXd& v) {
  const TreeModel model = tree_model(scene.mechanism);
  TreeMotion<double> motion(model);
  motion.set_position(q);
  motion.set_speed(v);
  ElementAction out;
  out.clear(model.layout.v, 0);
  const Eigen::VectorXd z;
  (void)scene.elements.front()->clone()->add_action({0, 0, q, v, z, motion, 0}, out);
  return out;
}

TEST(CompliantJoint, HasExactStiffnessAndDamping) {
  const MovingScene scene = sample::compliant_scene(2, sample::uneven_law(1));
  const Eigen::Index n = scene.v.size();
  // Slides a few tenths of a millimetre, turns some tenths of a radian.
  Eigen::VectorXd q = 0.2 * Eigen::VectorXd::LinSpaced(n, -1, 1.3), v = 3 * q;
  for (Eigen::Index i = 1; i < 4; ++i) q[i] *= 1e-3;
  const ElementAction at = action_at(scene, q, v);
  const double d = 1e-7;
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::VectorXd step = d * Eigen::VectorXd::Unit(n, k);
    const Eigen::VectorXd by_q =
        (action_at(scene, q - step, v).tau - action_at(scene, q + step, v).tau) / (2 * d);
    const Eigen::VectorXd by_v =
        (action_at(scene, q, v - step).tau - action_at(scene, q, v + step).tau) / (2 * d);
    EXPECT_LT((by_q - at.stiffness.col(k)).norm(), 1e-5 * at.stiffness.norm());
    EXPECT_LT((by_v - at.damping.col(k)).norm(), 1e-6 * at.damping.norm());
  }
}

// Under a load along one way only, the deflection is that of the law: load / stiffness, and
// s asinh(load / (k s)) with a toe.
TEST(CompliantJoint, YieldsAsItsLawSays) {
  for (const double toe : {kInf, 2e-4}) {
    for (int way = 0; way < kBushingCoordinates; ++way) {
      if (way == static_cast<int>(BushingCoordinate::kFlexion)) continue;
      SCOPED_TRACE(way);
      const bool turns = way > 3;
      BushingLaw law = sample::even_law(2e4, 2, 1);
      CapsuleLaw& own = law.laws[static_cast<std::size_t>(way)];
      own.toe = turns ? 200 * toe : toe;
      CompliantJoint joint;
      MovingScene scene = sample::compliant_scene(1, law, &joint);
      scene.drives.push_back({0, 0, 50, 0.01});  // holds flexion
      // Ways across, along, axial are the world's -z .. : columns of the bushing's frame.
      Eigen::Matrix3d axes;
      axes << 0, 1, 0, 0, 0, 1, 1, 0, 0;
      const Eigen::Vector3d axis = turns ? axes.col(way - 4) : axes.col(way);
      SceneForce force;
      force.body = 5;
      const double load = turns ? 0.08 : 10;
      (turns ? force.moment : force.force) = load * axis;
      scene.forces.push_back(force);
      SceneOptions options;
      options.duration = 2;
      const SceneRun run = simulate_scene(scene, options);
      ASSERT_EQ(run.status, SceneStatus::kDone);
      const double found =
          value(scene, joint.coordinate[static_cast<std::size_t>(way)], run.samples.back().q);
      const double k = own.stiffness, s = own.toe;
      const double wanted = std::isinf(s) ? load / k : s * std::asinh(load / (k * s));
      EXPECT_NEAR(found, wanted, 1e-7 * wanted);
    }
  }
}

// The stiffer, the more a pin: flexion differs in proportion to 1 / stiffness.
TEST(CompliantJoint, TendsToThePin) {
  SceneOptions options;
  options.duration = 0.2;
  options.sample_interval = 0.2;
  const MovingScene pins = falling(sample::scene_of(sample::bones(2)));
  const SceneRun wanted = simulate_scene(pins, options);
  std::vector<double> errors;
  for (const double stiffness : {1e4, 1e5, 1e6}) {
    CompliantJoint joint;
    const MovingScene scene = falling(
        sample::compliant_scene(2, sample::even_law(stiffness, 1e-4 * stiffness, 1), &joint));
    const SceneRun run = simulate_scene(scene, options);
    ASSERT_EQ(run.status, SceneStatus::kDone);
    errors.push_back(
        std::abs(value(scene, 1, run.samples.back().q) - value(pins, 1, wanted.samples.back().q)));
  }
  // Of first order in 1 / stiffness.
  EXPECT_LT(errors.back(), 1e-4);
  EXPECT_NEAR(std::log10(errors[0] / errors[1]), 1, 0.1);
  EXPECT_NEAR(std::log10(errors[1] / errors[2]), 1, 0.1);
}

/// Bones that fall against the dampers of finger joints, some 2 mN m s/rad. On pins that are free
/// to swing, steps of 20 ms are too long for bones of 40 mm by themselves.
MovingScene braked(MovingScene scene) {
  for (MechanismJoint& joint : scene.mechanism.joints)
    if (joint.name == "near" || joint.name == "far") joint.damping = 2e-3;
  return falling(std::move(scene));
}

/// Largest energy of a run [J].
double largest_energy(const SceneRun& run) {
  double most = -kInf;
  for (const SceneSample& sample : run.samples) most = std::max(most, sample.energy.total());
  return most;
}

// Steps of fixed length that are far longer than the capsule's periods gain no energy, and both
// bones arrive where they do on pins.
TEST(CompliantJoint, IsStableInLongStepsHoweverStiff) {
  for (const double step : {1e-3, 5e-3, 20e-3}) {
    SceneOptions options;
    options.method = SteppingMethod::kTimeStepping;
    options.step_length = step;
    options.duration = 1;
    options.sample_interval = 0.02;
    const MovingScene pins = braked(sample::scene_of(sample::bones(2)));
    const SceneRun wanted = simulate_scene(pins, options);
    for (const double stiffness : {1e4, 1e5, 1e6, 1e7, 1e8, 1e9})
      for (const double damping : {0.0, 1.0}) {
        SCOPED_TRACE(testing::Message()
                     << stiffness << " N/m, damping " << damping << ", step " << step << " s");
        const MovingScene scene = braked(
            sample::compliant_scene(2, sample::even_law(stiffness, 1e-4 * stiffness, damping)));
        const SceneRun run = simulate_scene(scene, options);
        EXPECT_EQ(run.status, SceneStatus::kDone);
        EXPECT_LT(largest_energy(run), 1e-5);
        const double error =
            value(scene, 1, run.samples.back().q) - value(pins, 1, wanted.samples.back().q);
        EXPECT_LT(std::abs(error), 20 / stiffness + 1e-5);
      }
  }
}

// Between events steps are as long as the error allows.
TEST(CompliantJoint, IsStableBetweenEventsHoweverStiff) {
  for (const auto& [stiffness, damping] :
       {std::pair(1e4, 0.0), {1e4, 1.0}, {1e6, 0.0}, {1e6, 1.0}, {1e9, 1.0}}) {
    SCOPED_TRACE(testing::Message() << stiffness << " N/m, damping " << damping);
    SceneOptions options;
    options.duration = 0.1;
    options.tolerance = 1e-6;
    const SceneRun run = simulate_scene(
        falling(sample::compliant_scene(2, sample::even_law(stiffness, 1e-4 * stiffness, damping))),
        options);
    EXPECT_EQ(run.status, SceneStatus::kDone);
    EXPECT_LT(largest_energy(run), 1e-4);
  }
}

// A muscle of 0.2 N m presses the tip of a bone of 40 mm on a floor: 5 N, however stiff the joint
// and long the step.
TEST(CompliantJoint, PressesOnAFloorHoweverStiff) {
  for (const double stiffness : {1e4, 1e6, 1e9})
    for (const SteppingMethod method : {SteppingMethod::kEvents, SteppingMethod::kTimeStepping})
      for (const double step : {1e-3, 20e-3}) {
        SCOPED_TRACE(testing::Message() << stiffness << " N/m, step " << step << " s, method "
                                        << static_cast<int>(method));
        MovingScene scene =
            sample::compliant_scene(1, sample::even_law(stiffness, 1e-4 * stiffness, 1));
        ShapeSpec tip = sample::primitive(ShapeKind::kSphere, {0.005, 0, 0});
        tip.X_BS.p.x() = 0.04;
        scene.mechanism.bodies.back().solid = std::make_shared<const Solid>(build_solid({tip}));
        Pose<double> X;
        X.p.z() = -0.055;
        sample::add_body(scene, "floor", sample::primitive(ShapeKind::kBox, {0.4, 0.4, 0.1}), 0, X);
        scene.drives.push_back({0, 0.2, 0, 2e-3});
        SceneOptions options;
        options.method = method;
        options.step_length = options.max_step = step;
        options.duration = 1;
        const SceneRun run = simulate_scene(scene, options);
        EXPECT_EQ(run.cost.unsolved, 0);
        if (method == SteppingMethod::kEvents) {
          EXPECT_EQ(run.status, SceneStatus::kDone);
        }
        double force = 0;
        for (const ContactSample& contact : run.samples.back().contacts) force += contact.force.z();
        // Midpoint steps keep modes that are faster than the step ringing for long.
        const bool rings = method == SteppingMethod::kTimeStepping && step > 1e-3;
        EXPECT_NEAR(std::abs(force), 5, rings ? 0.05 : 1e-3);
      }
}

// Near 90 deg of abduction the coordinates are no longer good: the step counts as unsolved.
TEST(CompliantJoint, TellsWhereItsCoordinatesEnd) {
  CompliantJoint joint;
  MovingScene scene = sample::compliant_scene(1, sample::even_law(1e4, 1e-3), &joint);
  SceneOptions options;
  options.duration = 1e-3;
  EXPECT_EQ(simulate_scene(scene, options).status, SceneStatus::kDone);
  coordinate(scene, joint.coordinate[static_cast<std::size_t>(BushingCoordinate::kAbduction)]) =
      1.5;
  EXPECT_EQ(simulate_scene(scene, options).status, SceneStatus::kUnsolved);
}

TEST(CompliantJoint, RefusesWhatIsNoHinge) {
  Mechanism mechanism = sample::bones(2);
  mechanism.joints[1].kind = JointKind::kSlide;
  EXPECT_EQ(message_of<InputError>([&] { (void)make_compliant(mechanism, 1, {}); }),
            "joint 'far' is a slide: only hinges give");
  EXPECT_THROW((void)make_compliant(mechanism, 0, {{}, {0, 1, 0}}), InputError);
  EXPECT_EQ(joint_index(mechanism, "far"), 1);
  EXPECT_THROW((void)joint_index(mechanism, "fra"), InputError);
}

// Its centre of mass, the origin of its frame, is no place of the bone.
TEST(CompliantJoint, WantsTheBoneOfABodyWithoutMass) {
  Mechanism mechanism = sample::bones(2);
  mechanism.bodies[0].mass = {0, {0, 0, 0}, Eigen::Matrix3d::Zero()};
  mechanism.joints[0].X_BM.p = Eigen::Vector3d(-0.01, 0, 0);
  EXPECT_EQ(message_of<InputError>([&] { (void)make_compliant(mechanism, 0, {}); }),
            "joint 'near': 'near bone' has no mass, so that nothing says where its bone points: "
            "state one, 'bone'");
  EXPECT_EQ(make_compliant(mechanism, 0, {{}, {0.04, 0, 0}}).name, "near");
}

// Flexion, which twist may follow, is the coordinate: it must be the hinge's angle.
TEST(CompliantJoint, RefusesAHingeThatIsNotItsCoordinate) {
  const auto complaint = [](const auto& change) {
    Mechanism mechanism = sample::bones(2);
    change(mechanism.joints[1]);
    return message_of<InputError>([&] { (void)make_compliant(mechanism, 1, {}); });
  };
  EXPECT_EQ(complaint([](MechanismJoint& joint) { joint.ratio = -1; }),
            "joint 'far' does not turn as its coordinate does (ratio -1, offset 0 rad): it cannot "
            "give, as flexion is the coordinate");
  EXPECT_THAT(complaint([](MechanismJoint& joint) { joint.offset = 0.5; }),
              testing::HasSubstr("(ratio 1, offset 0.5 rad)"));
  EXPECT_THAT(complaint([](MechanismJoint& joint) { joint.curve = {0.1}; }),
              testing::HasSubstr("(ratio 1, offset 0 rad, a curve)"));
}

}  // namespace
}  // namespace thenar
