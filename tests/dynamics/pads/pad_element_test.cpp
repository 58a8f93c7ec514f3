// Tests for dynamics/pads/pad_element.h: bodies on pads, against statics, energy and other methods.

#include "dynamics/pads/pad_element.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

#include "dynamics/mechanism/tree_model.h"
#include "dynamics/mechanism/tree_motion.h"
#include "dynamics/stepping/contact_step.h"
#include "dynamics/stepping/simulate_scene.h"
#include "geometry/primitives.h"
#include "pad_laws/point_laws.h"
#include "pads/motion/bed_pad.h"
#include "pads/motion/element_pad.h"
#include "pads/motion/law_pad.h"
#include "solvers/stiff_ode.h"
#include "tests/dynamics/stepping/sample_scenes.h"
#include "tests/pads/sample_laws.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using sample::kG;
using sample::kTerms;
using sample::primitive;

constexpr double kMass = 0.03;   // of the cube [kg]
constexpr double kHalf = 10e-3;  // of its edge [m]

/// Only damped by what relaxes within milliseconds, so that things come to rest.
const std::vector<ExponentialTerm> kDamps{{0.3, 0.004}};

std::shared_ptr<const MovingPad> soft_finger(double friction,
                                             const std::vector<ExponentialTerm>& terms = {}) {
  return std::make_shared<LawPad>(
      "soft-finger", PadShape(),
      std::make_shared<SoftFinger>(sample::soft_finger_constants(), terms),
      RigidObject{build_box({2 * kHalf, 2 * kHalf, 2 * kHalf}), friction}, Pose<double>{});
}

std::shared_ptr<const MovingPad> elements(double friction,
                                          const std::vector<ExponentialTerm>& terms = kDamps) {
  Tissue pulp;
  pulp.shear_modulus = 12e3;
  pulp.poisson_ratio = 0.49;
  pulp.relaxation = terms;
  return std::make_shared<ElementPad>(
      PadModel{PadShape(), {4, 2, 3}, {pulp}},
      RigidObject{build_box({2 * kHalf, 2 * kHalf, 2 * kHalf}), friction},
      Pose<double>{Eigen::Matrix3d::Identity(), {0, 0, 1}});
}

/// A bed of the same pad without friction.
std::shared_ptr<const MovingPad> bed() {
  return std::make_shared<BedPad>(
      std::make_shared<FoundationBed>(pad_columns(PadShape(), 20), sample::foundation_constants()),
      RigidObject{build_box({2 * kHalf, 2 * kHalf, 2 * kHalf}), 0},
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
  scene.excluded_pairs.emplace_back(base, cube);
  scene.elements.push_back(
      std::make_shared<PadElement>("pad", base, Pose<double>{}, cube, pad, options));
  return scene;
}

SceneOptions for_seconds(double seconds, SteppingMethod method = SteppingMethod::kEvents) {
  SceneOptions options;
  options.method = method;
  options.duration = seconds;
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
    (pad->try_step(X, 0).force < force ? low : high) = mean;
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
  EXPECT_GT(run.cost.rest_time, 1);
}

/// The height that a cube comes back to, over that from which it fell, by the largest of samples
/// after the first touch.
double comes_back(double force_error) {
  const MovingScene scene = cube_on_pad(soft_finger(0), 2e-3, {force_error, 0.02});
  SceneOptions options = for_seconds(0.12);
  options.sample_interval = 1e-3;
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
  fixed.step_length = 2e-4;
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
      scene.excluded_pairs.emplace_back(std::min(finger, cube), std::max(finger, cube));
      SceneDrive drive;
      drive.coordinate = finger;
      drive.bias = 1;
      drive.damping = 10;
      scene.drives.push_back(drive);
    }
    scene.excluded_pairs.emplace_back(left, right);
    SceneOptions options = for_seconds(1);
    options.tolerance = 1e-6;
    options.sample_interval = 0.05;
    const SceneRun run = simulate_scene(scene, options);
    ASSERT_EQ(run.status, SceneStatus::kDone) << run.message;
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
  scene.excluded_pairs.emplace_back(cube, finger);
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
  scene.excluded_pairs.emplace_back(finger, cube);
  set_free_velocity(scene.mechanism, cube, scene.q, {0.02, 0, -0.1}, {0, 0, 3}, scene.v);
  const SceneRun run = simulate_scene(scene, for_seconds(0.1));
  ASSERT_EQ(run.status, SceneStatus::kDone);
  ContactStep step(scene);
  const auto momenta = [&](const SceneSample& at) {
    Eigen::Matrix<double, 6, 1> out = Eigen::Matrix<double, 6, 1>::Zero();
    std::vector<Pose<double>> X;
    step.compute_poses({at.t, at.q, at.v}, X);
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

/// A soft finger that loses its answer: clones 1 and 2 from an age on, those up to good - 1 at
/// once, later ones never.
class LostPad final : public MovingPad {
 public:
  /// @param good  the first clone that keeps its answers
  LostPad(std::unique_ptr<MovingPad> pad, double age, int good)
      : pad_(std::move(pad)), age_(age), good_(good), clones_(std::make_shared<int>(0)) {}
  [[nodiscard]] std::unique_ptr<MovingPad> clone() const override {
    auto out = std::make_unique<LostPad>(pad_->clone(), age_, good_);
    out->clones_ = clones_;
    out->number_ = ++*clones_;
    return out;
  }
  [[nodiscard]] std::string rung() const override { return pad_->rung(); }
  [[nodiscard]] PadContact try_step(const Pose<double>& X_PO, double seconds) override {
    moved_ = kept_ + seconds;
    // The element and the scene's own have one each: the third is the first that begins anew.
    if (number_ >= good_ || (number_ < 3 && moved_ < age_)) return pad_->try_step(X_PO, seconds);
    PadContact out;
    out.status = Status::kStalled;
    return out;
  }
  void accept_step() override {
    kept_ = moved_;
    pad_->accept_step();
  }
  [[nodiscard]] double energy() const override { return pad_->energy(); }
  [[nodiscard]] double reach() const override { return pad_->reach(); }
  [[nodiscard]] const std::vector<ExponentialTerm>& relaxation() const override {
    return pad_->relaxation();
  }
  [[nodiscard]] const Pose<double>& object_pose() const override { return pad_->object_pose(); }

 private:
  std::unique_ptr<MovingPad> pad_;
  double age_, kept_ = 0, moved_ = 0;  // [s]
  int good_, number_ = 0;
  std::shared_ptr<int> clones_;
};

TEST(PadElement, IsToldWhereItIsLostAndComesBackToStatics) {
  // Lost while the cube sinks in; found at once, or at the fourth attempt.
  for (const int good : {3, 6}) {
    SCOPED_TRACE(good);
    const auto pad = std::make_shared<LostPad>(soft_finger(0.5, kDamps)->clone(), 0.01, good);
    const SceneRun run = simulate_scene(damped(cube_on_pad(pad, 1e-4)), for_seconds(1));
    EXPECT_EQ(run.status, SceneStatus::kUnsolved);
    EXPECT_GT(run.cost.unsolved, 0);
    const SceneSample& last = run.samples.back();
    ASSERT_EQ(last.contacts.size(), 1U);
    EXPECT_NEAR(last.contacts[0].force.z(), -kMass * kG, 1e-3 * kMass * kG);
    const double relaxed = 1 - kDamps[0].share, depth = depth_at(kMass * kG / relaxed);
    EXPECT_NEAR(depth_of(last), depth, 0.01 * depth);
  }
}

/// A power law, F = force (depth / 1 mm)^power.
std::shared_ptr<const MovingPad> power_law(double force, double power,
                                           const std::vector<ExponentialTerm>& terms = {}) {
  PowerLawConstants c;
  c.force = force;
  c.depth_exponent = power;
  c.patch = 4e-3;
  c.patch_exponent = 0.3;
  c.torsion = 0.5;
  c.shear = 8e3;
  return std::make_shared<LawPad>("power-law", PadShape(), std::make_shared<PowerLaw>(c, terms),
                                  RigidObject{build_box({2 * kHalf, 2 * kHalf, 2 * kHalf}), 0},
                                  Pose<double>{});
}

TEST(PadElement, TwoThatDoubtAStepGoOnTogether) {
  // A cube between two pads that it is pressed into, thrown at one of them.
  const double force[] = {0.4, 1.2}, depth[] = {1.5e-3, 0.6e-3}, speed = 0.3, seconds = 0.02;
  MovingScene scene = cube_on_pad(power_law(force[0], 2), -depth[0], {2e-3, 0.02});
  Pose<double> down;
  down.R = Vector3d(1, -1, -1).asDiagonal();
  const double above = scene.q[0] + kHalf - depth[1] + PadShape().height;
  down.p = {0, 0, above};
  scene.elements.push_back(std::make_shared<PadElement>("other", 0, down, 1, power_law(force[1], 2),
                                                        PadElementOptions{2e-3, 0.02}));
  scene.gravity.setZero();
  scene.v[0] = -speed;
  const SceneRun run = simulate_scene(scene, for_seconds(seconds));
  ASSERT_EQ(run.status, SceneStatus::kDone);
  // The same by small steps of Runge and Kutta.
  double z = 0, v = -speed;
  const auto push = [&](double at) {
    const double a = std::max(0.0, depth[0] - at) / 1e-3, b = std::max(0.0, depth[1] + at) / 1e-3;
    return (force[0] * a * a - force[1] * b * b) / kMass;
  };
  const int steps = 20000;
  const double h = seconds / steps;
  for (int i = 0; i < steps; ++i) {
    const double k1 = push(z), k2 = push(z + h / 2 * v + h * h / 8 * k1),
                 k4 = push(z + h * v + h * h / 2 * k2);
    z += h * v + h * h / 6 * (k1 + 2 * k2);
    v += h / 6 * (k1 + 4 * k2 + k4);
  }
  const double way = run.samples.back().q[0] - scene.q[0];
  EXPECT_NEAR(way, z, 5e-6);
  EXPECT_NEAR(run.samples.back().v[0], v, 0.01 * speed);
}

TEST(PadElement, FollowsAPushAfterASleep) {
  MovingScene scene = damped(cube_on_pad(soft_finger(0.5), 1e-4));
  SceneDrive push;
  push.bias = -1;
  push.when = {2, 1e9};
  scene.drives = {push};
  const SceneRun run = simulate_scene(scene, for_seconds(3));
  ASSERT_EQ(run.status, SceneStatus::kDone);
  ASSERT_GT(run.cost.rest_time, 0.5);
  const auto& at_rest = run.samples[199].contacts;
  ASSERT_EQ(at_rest.size(), 1U);
  EXPECT_NEAR(at_rest[0].force.z(), -kMass * kG, 1e-3 * kMass * kG);
  const SceneSample& last = run.samples.back();
  ASSERT_EQ(last.contacts.size(), 1U);
  const double force = kMass * kG + 1;
  EXPECT_NEAR(last.contacts[0].force.z(), -force, 1e-3 * force);
  EXPECT_NEAR(depth_of(last), depth_at(force), 0.01 * depth_at(force));
}

/// An element by itself over a cube whose depth in its pad is given.
class Pressed {
 public:
  explicit Pressed(const std::shared_ptr<const MovingPad>& pad)
      : scene_(cube_on_pad(pad, 0)),
        model_(tree_model(scene_.mechanism)),
        motion_(model_),
        q_(scene_.q),
        v_(scene_.v),
        element_(scene_.elements.front()->clone()) {}
  /// Puts the cube somewhere. @param rate  of its depth [m/s]
  void place(double t, double depth, double rate) {
    t_ = t;
    q_[0] = scene_.q[0] - depth;
    v_[0] = -rate;
    motion_.set_position(q_);
    motion_.set_speed(v_);
  }
  [[nodiscard]] double step_error() { return element_->step_error(input()); }
  void accept_step() { element_->accept_step(input()); }
  [[nodiscard]] double max_step_length() const { return element_->max_step_length(); }
  [[nodiscard]] double energy() { return element_->energy(input()); }
  /// Its effort on the cube [N].
  [[nodiscard]] double force() {
    ElementAction out;
    out.clear(1, 0);
    EXPECT_TRUE(element_->add_action(input(), out));
    return out.tau[0];
  }

 private:
  [[nodiscard]] ElementInput input() const { return {t_, t_, q_, v_, z_, motion_, 0}; }
  MovingScene scene_;
  TreeModel model_;
  TreeMotion<double> motion_;
  Eigen::VectorXd q_, v_, z_;
  std::unique_ptr<ForceElement> element_;
  double t_ = 0;
};

/// Force of springs and dampers of 1 N/m at a time after each unit of depth per second began: the
/// integral of g.
double integral_of_g(double t) {
  double sum = t;
  for (const ExponentialTerm& term : kTerms)
    sum += term.share * (-term.time * std::expm1(-t / term.time) - t);
  return t > 0 ? sum : 0;
}

TEST(PadElement, RelaxesFromTheBeginningOfAMotionThatFollowsARest) {
  // Depth: 0.5 mm within 10 ms, 30 s of rest, 0.3 mm more within 20 ms.
  const double newton_per_m = 1000, begin = 30, ramp[] = {0.5e-3 / 0.01, 0.3e-3 / 0.02};
  const auto depth = [&](double t) {
    return ramp[0] * std::min(t, 0.01) + ramp[1] * std::clamp(t - begin, 0.0, 0.02);
  };
  const auto rate = [&](double t) { return t <= 0.01 ? ramp[0] : t > begin ? ramp[1] : 0; };
  const auto exact = [&](double t) {
    return newton_per_m * (ramp[0] * (integral_of_g(t) - integral_of_g(t - 0.01)) +
                           ramp[1] * (integral_of_g(t - begin) - integral_of_g(t - begin - 0.02)));
  };
  Pressed pressed(power_law(1, 1, kTerms));
  const auto go = [&](double t) {
    pressed.place(t, depth(t), rate(t));
    (void)pressed.step_error();
    pressed.accept_step();
  };
  for (int i = 0; i <= 10; ++i) go(1e-3 * i);
  EXPECT_NEAR(pressed.force(), exact(0.01), 1e-9);
  for (int i = 1; 0.01 + 0.02 * i < begin; ++i) go(0.01 + 0.02 * i);
  go(begin);
  // Pads at rest are not moved while they relax by less than a fifth of what is allowed.
  EXPECT_NEAR(pressed.force(), exact(begin), 1e-9);
  for (int i = 1; i <= 20; ++i) {
    const double t = begin + 2e-3 * i;
    // Within a step, as predicted; then at its end.
    pressed.place(t - 1e-3, depth(t - 1e-3), rate(t));
    EXPECT_NEAR(pressed.force(), exact(t - 1e-3), 1e-6) << i;
    go(t);
    EXPECT_NEAR(pressed.force(), exact(t), 1e-9) << i;
  }
}

TEST(PadElement, DoubtsAStepInWhichItsObjectMayHavePassed) {
  Pressed pressed(soft_finger(0));
  const double speed = 5;
  pressed.place(0.01, -0.03, speed);
  pressed.accept_step();
  // As far as the cube is away, and a little.
  EXPECT_LE(pressed.max_step_length() * speed, 0.03 + 2e-4);
  EXPECT_GE(pressed.max_step_length() * speed, 0.5 * 0.03);
  pressed.place(0.01 + 0.1 / speed, 0.07, speed);  // beyond the pad
  EXPECT_GT(pressed.step_error(), 1);
  pressed.place(0.01 + 0.027 / speed, -0.003, speed);
  EXPECT_LE(pressed.step_error(), 1);
}

TEST(PadElement, ThrowsAFastObjectBack) {
  // A light cube at 5 m/s, from so far that a step of 20 ms would end beyond all of the pad.
  const double gap = 0.11;
  const std::tuple<const char*, std::shared_ptr<const MovingPad>, double> pads[] = {
      {"soft finger", soft_finger(0), 1e-3}, {"elements", elements(0, {}), 1e-4}};
  for (const auto& [name, pad, mass] : pads) {
    SCOPED_TRACE(name);
    MovingScene scene = cube_on_pad(pad, gap, {0.01, 0.05});
    scene.gravity.setZero();
    scene.mechanism.bodies[1].mass.mass = mass;
    scene.v[0] = -5;
    SceneOptions options = for_seconds(0.06);
    options.sample_interval = 0.06;
    const SceneRun run = simulate_scene(scene, options);
    EXPECT_EQ(run.status, SceneStatus::kDone);
    EXPECT_NEAR(run.samples.back().v[0], 5, 0.02 * 5);
  }
}

TEST(PadElement, StoresWhatAnElasticBounceLends) {
  // Kinetic energy, weight and what the pad stores, within a share of what it takes.
  const std::tuple<const char*, std::shared_ptr<const MovingPad>, double> pads[] = {
      {"soft finger", soft_finger(0), 0.002},
      {"bed", bed(), 0.005},
      {"elements", elements(0, {}), 0.002}};
  for (const auto& [name, pad, share] : pads) {
    SCOPED_TRACE(name);
    const MovingScene scene = cube_on_pad(pad, 2e-3, {2e-3, 0.02});
    SceneOptions options = for_seconds(0.05);
    options.sample_interval = 1e-3;
    const SceneRun run = simulate_scene(scene, options);
    ASSERT_EQ(run.status, SceneStatus::kDone);
    const double start = run.samples.front().energy.total();
    double most = 0;
    for (const SceneSample& at : run.samples) most = std::max(most, at.energy.of_passive);
    EXPECT_GT(most, kMass * kG * 2e-3) << "all of the fall, and more";
    for (const SceneSample& at : run.samples)
      EXPECT_NEAR(at.energy.total(), start, share * most) << at.t;
  }
}

TEST(PadElement, StoresAtRestWhatSpringsAndDampersDo) {
  // F = k x once and for all, with a damper in parallel to a part of it: at rest g_inf k x^2 / 2,
  // at once k x^2 / 2.
  const double k = 1000, x = 4e-4;
  Pressed pressed(power_law(1, 1, kTerms));
  pressed.place(1e-9, x, 0);
  pressed.accept_step();
  EXPECT_NEAR(pressed.energy(), 0.5 * k * x * x, 1e-6 * k * x * x);
  pressed.place(100, x, 0);
  pressed.accept_step();
  EXPECT_NEAR(pressed.energy(), 0.25 * 0.5 * k * x * x, 1e-6 * k * x * x);
  // Between, H_i = g_i k x exp(-t / tau_i) in springs of g_i k.
  Pressed other(power_law(1, 1, kTerms));
  other.place(1e-9, x, 0);
  other.accept_step();
  other.place(0.05, x, 0);
  other.accept_step();
  double share = 0.25;
  for (const ExponentialTerm& term : kTerms) share += term.share * std::exp(-0.1 / term.time);
  EXPECT_NEAR(other.energy(), share * 0.5 * k * x * x, 1e-6 * k * x * x);
}

TEST(PadElement, HasNoForceOnceAnObjectHasLeft) {
  const MovingScene scene = cube_on_pad(soft_finger(0.5, kTerms), 2e-3);
  SceneOptions options = for_seconds(0.5);
  options.sample_interval = 1e-3;
  const SceneRun run = simulate_scene(scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  for (const SceneSample& at : run.samples)
    EXPECT_TRUE(depth_of(at) >= -1e-5 || at.contacts.empty()) << at.t;
}

/// The depth of the cube that falls on the soft finger above, which relaxes, by an integrator for
/// stiff equations:  m x'' = m g - F,  F = g_inf Fe(x) + sum H_i,  H_i' = g_i Fe'(x) x' - H_i /
/// tau_i.
/// @return depths at the given times [m]
std::vector<double> stiffly_integrated(double gap, const std::vector<double>& times) {
  const auto elastic = soft_finger(0)->clone();
  const auto force = [&](double depth) {
    const Pose<double> X{Eigen::Matrix3d::Identity(), {0, 0, PadShape().height + kHalf - depth}};
    return elastic->try_step(X, 0).force;
  };
  double left = 1;
  for (const ExponentialTerm& term : kTerms) left -= term.share;
  // Depth, its speed, and what each term has.
  Eigen::VectorXd y = Eigen::VectorXd::Zero(5);
  y[0] = -gap;
  const OdeRightHandSide slope = [&](double, const Eigen::VectorXd& at) {
    constexpr double kWay = 1e-8;  // of a difference [m]
    const double stiffness = (force(at[0] + kWay) - force(at[0] - kWay)) / (2 * kWay);
    Eigen::VectorXd out(5);
    out[0] = at[1];
    out[1] = kG - (left * force(at[0]) + at.tail<3>().sum()) / kMass;
    for (Eigen::Index i = 0; i < 3; ++i) {
      const ExponentialTerm& term = kTerms[static_cast<std::size_t>(i)];
      out[2 + i] = term.share * stiffness * at[1] - at[2 + i] / term.time;
    }
    return out;
  };
  StiffOdeOptions options;
  options.relative = 1e-8;
  options.absolute = (Eigen::VectorXd(5) << 1e-10, 1e-8, 1e-8, 1e-8, 1e-8).finished();
  StiffOde ode(slope, 0, y, options);
  std::vector<double> depths;
  for (const double t : times) {
    while (ode.time() < t) EXPECT_EQ(ode.step(t), OdeStatus::kStepped);
    depths.push_back(ode.state()[0]);
  }
  return depths;
}

TEST(PadElement, FallsAndRelaxesAsAStiffIntegratorSays) {
  constexpr double kGap = 1e-4;
  std::vector<double> times, exact, worst;
  for (const double force_error : {0.02, 0.002, 0.0002}) {
    SceneOptions options = for_seconds(1);
    options.sample_interval = 0.02;
    const SceneRun run =
        simulate_scene(cube_on_pad(soft_finger(0, kTerms), kGap, {force_error, 0.02}), options);
    ASSERT_EQ(run.status, SceneStatus::kDone);
    if (times.empty()) {
      for (const SceneSample& at : run.samples)
        if (at.t > 0) times.push_back(at.t);
      exact = stiffly_integrated(kGap, times);
    }
    worst.push_back(0);
    for (std::size_t k = 0; k < times.size(); ++k)
      worst.back() = std::max(worst.back(), std::abs(depth_of(run.samples[k + 1]) - exact[k]));
  }
  const double largest = *std::max_element(exact.begin(), exact.end());
  EXPECT_LT(worst[0], 0.01 * largest);
  EXPECT_LT(worst[1], 0.5 * worst[0]);
  EXPECT_LT(worst[2], 0.5 * worst[1]);
}

}  // namespace
}  // namespace thenar
