// Tests for dynamics/pads/pad_element.h: bodies on pads, against statics, energy and other methods.

#include "dynamics/pads/pad_element.h"

#include <cmath>

#include <gtest/gtest.h>

#include "dynamics/stepping/simulate_scene.h"
#include "geometry/primitives.h"
#include "pads/laws/point_laws.h"
#include "pads/motion/bed_pad.h"
#include "pads/motion/element_pad.h"
#include "pads/motion/law_pad.h"
#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using sample::kG;
using sample::primitive;

const std::vector<ExponentialTerm> kTerms{{0.3, 0.004}, {0.25, 0.07}, {0.2, 1.4}};
constexpr double kMass = 0.03;   // of the cube [kg]
constexpr double kHalf = 10e-3;  // of its edge [m]

/// Only damped by what relaxes within milliseconds, so that things come to rest.
const std::vector<ExponentialTerm> kDamps{{0.3, 0.004}};

std::shared_ptr<const MovingPad> soft_finger(double friction,
                                             const std::vector<ExponentialTerm>& terms = {}) {
  const SoftFingerConstants c{0.36, 1.79, 0.82, 5.7e-3, 0.32, 0.29, 0.61, 0.54, 8e3};
  return std::make_shared<LawPad>(
      "soft-finger", PadShape(), std::make_shared<SoftFinger>(c, terms),
      RigidObject{build_box({2 * kHalf, 2 * kHalf, 2 * kHalf}), friction}, Pose<double>{});
}

std::shared_ptr<const MovingPad> elements(double friction) {
  Tissue pulp;
  pulp.shear_modulus = 12e3;
  pulp.poisson_ratio = 0.49;
  pulp.relaxation = kDamps;
  return std::make_shared<ElementPad>(
      PadModel{PadShape(), {4, 2, 3}, {pulp}},
      RigidObject{build_box({2 * kHalf, 2 * kHalf, 2 * kHalf}), friction},
      Pose<double>{Eigen::Matrix3d::Identity(), {0, 0, 1}});
}

/// A cube on a vertical slide, its face a gap above a pad that looks up and does not move.
MovingScene cube_on_pad(const std::shared_ptr<const MovingPad>& pad, double gap,
                        const PadElementOptions& options = {}) {
  MovingScene scene;
  const int base =
      sample::add_body(scene, "finger", primitive(ShapeKind::kBox, {0.01, 0.01, 0.01}), 0);
  const int cube = sample::add_on_joint(
      scene, "cube", primitive(ShapeKind::kBox, {2 * kHalf, 2 * kHalf, 2 * kHalf}), kMass,
      JointKind::kSlide, {0, 0, 1}, {0, 0, 0});
  scene.q[0] = PadShape().height + kHalf + gap;
  scene.apart.emplace_back(base, cube);
  scene.elements.push_back(
      std::make_shared<PadElement>("pad", base, Pose<double>{}, cube, pad, options));
  return scene;
}

SceneOptions for_seconds(double seconds, SteppingMethod method = SteppingMethod::kEvents) {
  SceneOptions options;
  options.method = method;
  options.seconds = seconds;
  options.tolerance = 1e-7;
  return options;
}

double depth_of(const SceneSample& at) { return PadShape().height + kHalf - at.q[0]; }

/// Depth at which the soft finger above carries a force against a flat face [m].
double depth_at(double force) {
  const auto pad = soft_finger(0)->clone();
  double low = 0, high = 3e-3;
  for (int i = 0; i < 60; ++i) {
    const double mean = 0.5 * (low + high);
    const Pose<double> X{Eigen::Matrix3d::Identity(), {0, 0, PadShape().height + kHalf - mean}};
    (pad->move(X, 0).force < force ? low : high) = mean;
  }
  return low;
}

/// The cube with a damper, so that it comes to rest.
MovingScene damped(MovingScene scene) {
  scene.mechanism.joints.back().damping = 3;
  return scene;
}

TEST(PadElement, CarriesAWeightAtTheDepthOfItsLaw) {
  const MovingScene scene = damped(cube_on_pad(soft_finger(0.5), 1e-4));
  const SceneRun run = simulate_scene(scene, for_seconds(1));
  ASSERT_EQ(run.status, SceneStatus::kDone);
  const SceneSample& last = run.samples.back();
  ASSERT_EQ(last.contacts.size(), 1U);
  EXPECT_NEAR(last.contacts[0].force.z(), -kMass * kG, 1e-3 * kMass * kG) << "on the finger";
  EXPECT_GT(last.contacts[0].area, 1e-5);
  EXPECT_NEAR(depth_of(last), depth_at(kMass * kG), 0.01 * depth_at(kMass * kG));
}

TEST(PadElement, RestsWithoutMovingThePadAgain) {
  const MovingScene scene = damped(cube_on_pad(soft_finger(0.5), 1e-4));
  const SceneRun run = simulate_scene(scene, for_seconds(3));
  ASSERT_EQ(run.status, SceneStatus::kDone);
  EXPECT_GT(run.cost.asleep, 1);
}

/// The height that a cube comes back to, over that from which it fell, by the largest of samples
/// after the first touch.
double comes_back(double force_error) {
  const MovingScene scene = cube_on_pad(soft_finger(0), 2e-3, {force_error, 0.02});
  SceneOptions options = for_seconds(0.12);
  options.sample = 1e-3;
  const SceneRun run = simulate_scene(scene, options);
  EXPECT_EQ(run.status, SceneStatus::kDone);
  double deepest = 0, back = -1;
  for (const SceneSample& at : run.samples) {
    deepest = std::max(deepest, depth_of(at));
    if (deepest > 1e-3) back = std::max(back, -depth_of(at));
  }
  return back / 2e-3;
}

TEST(PadElement, AnElasticPadGivesBackWhatItTook) {
  EXPECT_NEAR(comes_back(0.05), 1, 0.05);
  EXPECT_NEAR(comes_back(0.002), 1, 0.004);
}

TEST(PadElement, TendsToOneAnswerAsItsErrorFalls) {
  // Depth 15 ms after a touch at 0.2 m/s.
  const auto depth = [](double force_error) {
    const MovingScene scene = cube_on_pad(soft_finger(0, kTerms), 2e-3, {force_error, 0.02});
    const SceneRun run = simulate_scene(scene, for_seconds(0.035));
    EXPECT_EQ(run.status, SceneStatus::kDone);
    return depth_of(run.samples.back());
  };
  const double fine = depth(1e-4);
  ASSERT_GT(fine, 2e-4);
  EXPECT_LT(std::abs(depth(1e-3) - fine), 0.01 * fine);
  EXPECT_LT(std::abs(depth(0.05) - fine), 0.1 * fine);
}

TEST(PadElement, StepsOfFixedLengthAgreeWithStepsBetweenEvents) {
  const MovingScene scene = damped(cube_on_pad(soft_finger(0.5, kTerms), 1e-4, {0.002, 0.02}));
  const SceneRun events = simulate_scene(scene, for_seconds(0.2));
  SceneOptions fixed = for_seconds(0.2, SteppingMethod::kTimeStepping);
  fixed.step = 2e-4;
  const SceneRun steps = simulate_scene(scene, fixed);
  ASSERT_EQ(events.samples.size(), steps.samples.size());
  for (std::size_t i = 0; i < steps.samples.size(); ++i)
    EXPECT_NEAR(depth_of(steps.samples[i]), depth_of(events.samples[i]), 2e-5) << i;
}

/// A cube on a vertical slide falls between two pads that look at each other, pressed together
/// before.
TEST(PadElement, TwoPadsHoldACubeByFrictionWithoutCreep) {
  for (const bool fine : {false, true}) {
    SCOPED_TRACE(fine ? "elements" : "soft fingers");
    MovingScene scene;
    const Vector3d tip(0.01, 0.01, 0.01);
    const int left = sample::add_on_joint(scene, "left", primitive(ShapeKind::kBox, tip), 0.02,
                                          JointKind::kSlide, {1, 0, 0}, {0, 0, 0});
    const int right = sample::add_on_joint(scene, "right", primitive(ShapeKind::kBox, tip), 0.02,
                                           JointKind::kSlide, {-1, 0, 0}, {0, 0, 0});
    const int cube = sample::add_on_joint(
        scene, "cube", primitive(ShapeKind::kBox, {2 * kHalf, 2 * kHalf, 2 * kHalf}), kMass,
        JointKind::kSlide, {0, 0, 1}, {0, 0, 0});
    scene.mechanism.joints.back().damping = 5;
    // Pads look along x of the world, towards the cube, and are pressed with 1 N.
    const double away = PadShape().height + kHalf;
    for (const int finger : {left, right}) {
      const double side = finger == left ? -1 : 1;
      Pose<double> X_BP;
      X_BP.R << Vector3d(0, 1, 0), Vector3d(-side, 0, 0).cross(Vector3d(0, 1, 0)),
          Vector3d(-side, 0, 0);
      X_BP.p = Vector3d(side * (away - 5e-5), 0, 0);
      const auto pad = fine ? elements(0.8) : soft_finger(0.8, kDamps);
      scene.elements.push_back(std::make_shared<PadElement>("pad", finger, X_BP, cube, pad));
      scene.apart.emplace_back(std::min(finger, cube), std::max(finger, cube));
      SceneDrive drive;
      drive.coordinate = finger;
      drive.bias = 1;
      drive.damping = 10;
      scene.drives.push_back(drive);
    }
    scene.apart.emplace_back(left, right);
    SceneOptions options = for_seconds(1);
    options.tolerance = 1e-6;
    options.sample = 0.05;
    const SceneRun run = simulate_scene(scene, options);
    ASSERT_EQ(run.status, SceneStatus::kDone) << run.reason;
    const double settled = run.samples[10].q[cube], last = run.samples.back().q[cube];
    EXPECT_LT(settled, -1e-5) << "pads yield to the weight";
    EXPECT_GT(settled, -2e-3);
    EXPECT_NEAR(last, settled, 1e-6);
    ASSERT_EQ(run.samples.back().contacts.size(), 2U);
    double carried = 0;
    for (const ContactSample& contact : run.samples.back().contacts) {
      EXPECT_NEAR(std::abs(contact.force.x()), 1, 1e-2);
      carried += contact.force.z();
    }
    EXPECT_NEAR(carried, -kMass * kG, 1e-2 * kMass * kG) << "on the fingers";
  }
}

/// A pad above a cube on a horizontal slide without friction, pressed down by `weight`, and the
/// cube pulled aside by `pull`. The law is `stiffer` times as stiff as a fingertip.
SceneRun pulled_under_pad(double pull, double weight, double friction, double stiffer,
                          double seconds) {
  MovingScene scene;
  scene.gravity.setZero();
  const int cube =
      sample::add_on_joint(scene, "cube", primitive(ShapeKind::kBox, {0.2, 2 * kHalf, 2 * kHalf}),
                           kMass, JointKind::kSlide, {1, 0, 0}, {0, 0, 0});
  const int finger =
      sample::add_on_joint(scene, "finger", primitive(ShapeKind::kBox, {0.01, 0.01, 0.01}), 0.02,
                           JointKind::kSlide, {0, 0, -1}, {0, 0, 0});
  const SoftFingerConstants c{0.36 * stiffer, 1.79, 0.82, 5.7e-3,       0.32,
                              0.29,           0.61, 0.54, 8e3 * stiffer};
  const auto pad = std::make_shared<LawPad>(
      "soft-finger", PadShape(), std::make_shared<SoftFinger>(c, kDamps),
      RigidObject{build_box({0.2, 2 * kHalf, 2 * kHalf}), friction}, Pose<double>{});
  // Upside down, just above the cube.
  Pose<double> X_BP;
  X_BP.R << Vector3d(1, 0, 0), Vector3d(0, -1, 0), Vector3d(0, 0, -1);
  X_BP.p = {0, 0, kHalf + PadShape().height};
  scene.elements.push_back(
      std::make_shared<PadElement>("pad", finger, X_BP, cube, pad, PadElementOptions{0.01, 0.02}));
  scene.apart.emplace_back(cube, finger);
  SceneDrive press, drag;
  press.coordinate = 1;
  press.bias = weight;
  press.damping = 20;
  drag.coordinate = 0;
  drag.bias = pull;
  drag.when = {0.2, 1e9};
  scene.drives = {press, drag};
  return simulate_scene(scene, for_seconds(0.2 + seconds));
}

TEST(PadElement, AStiffLawHoldsAndSlidesAsAHardPointDoes) {
  // Coulomb: the cube goes with (pull - friction weight) / mass, or not at all.
  const double friction = 0.5, weight = 1, seconds = 0.1;
  const auto way = [&](double pull, double stiffer) {
    const SceneRun run = pulled_under_pad(pull, weight, friction, stiffer, seconds);
    EXPECT_EQ(run.status, SceneStatus::kDone);
    return run.samples.back().q[0];
  };
  const double slides = 0.5 * (0.8 - friction * weight) / kMass * seconds * seconds;
  double last = 2;
  // What friction gives by and by, not at once, is kept as speed: off by the root of the yield.
  for (const double stiffer : {1.0, 10.0, 100.0}) {
    const double off = std::abs(way(0.8, stiffer) - slides) / slides;
    EXPECT_LT(off, 0.4 * last) << stiffer;
    last = off;
  }
  EXPECT_LT(last, 0.04);
  // What holds yields by the springs of its patch, in inverse proportion.
  for (const double stiffer : {1.0, 100.0})
    EXPECT_LT(std::abs(way(0.2, stiffer)), 5e-3 / stiffer) << stiffer;
}

TEST(PadElement, KeepsMomentumAndSpin) {
  // Two free bodies meet by a pad that is off both centres, and fly apart again.
  MovingScene scene;
  scene.gravity.setZero();
  const double edge = 2 * kHalf;
  const int finger =
      sample::add_body(scene, "finger", primitive(ShapeKind::kBox, {edge, edge, edge}), 0.05,
                       {Eigen::Matrix3d::Identity(), {0, 0, 0}});
  const int cube = sample::add_body(scene, "cube", primitive(ShapeKind::kBox, {edge, edge, edge}),
                                    kMass, {Eigen::Matrix3d::Identity(), {2e-3, 1e-3, 26e-3}});
  Pose<double> X_BP;
  X_BP.p = {1e-3, 0, 5e-3};
  scene.elements.push_back(
      std::make_shared<PadElement>("pad", finger, X_BP, cube, soft_finger(0.6, kTerms)));
  scene.apart.emplace_back(finger, cube);
  set_free_velocity(scene.mechanism, cube, scene.q, {0.02, 0, -0.1}, {0, 0, 3}, scene.v);
  const SceneRun run = simulate_scene(scene, for_seconds(0.1));
  ASSERT_EQ(run.status, SceneStatus::kDone);
  ContactStep step(scene);
  const auto momenta = [&](const SceneSample& at) {
    Eigen::Matrix<double, 6, 1> out = Eigen::Matrix<double, 6, 1>::Zero();
    std::vector<Pose<double>> X;
    step.poses({at.t, at.q, at.v}, X);
    const MechanismLayout layout = layout_of(scene.mechanism);
    for (const int body : {finger, cube}) {
      const auto i = static_cast<std::size_t>(body);
      const BodyMass& mass = scene.mechanism.bodies[i].mass;
      // Speeds of a free joint: turn, then way, of the centre of mass.
      const Vector3d w = at.v.segment<3>(layout.first_v[i]),
                     u = at.v.segment<3>(layout.first_v[i] + 3);
      const Vector3d c = X[i] * mass.com;
      out.head<3>() += X[i].R * mass.inertia * X[i].R.transpose() * w + c.cross(mass.mass * u);
      out.tail<3>() += mass.mass * u;
    }
    return out;
  };
  const auto before = momenta(run.samples.front()), after = momenta(run.samples.back());
  bool touched = false;
  for (const SceneSample& at : run.samples) touched = touched || !at.contacts.empty();
  EXPECT_TRUE(touched);
  EXPECT_LT((after - before).tail<3>().norm(), 1e-7 * before.tail<3>().norm());
  EXPECT_LT((after - before).head<3>().norm(), 1e-6 * before.head<3>().norm());
}

TEST(PadElement, HasNoForceOnceAnObjectHasLeft) {
  const MovingScene scene = cube_on_pad(soft_finger(0.5, kTerms), 2e-3);
  SceneOptions options = for_seconds(0.5);
  options.sample = 1e-3;
  const SceneRun run = simulate_scene(scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  for (const SceneSample& at : run.samples)
    EXPECT_TRUE(depth_of(at) >= -1e-5 || at.contacts.empty()) << at.t;
}

}  // namespace
}  // namespace thenar
