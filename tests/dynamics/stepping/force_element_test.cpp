// Tests for dynamics/stepping/force_element.h: elements with states of their own, in free flight
// and against contacts.

#include <gtest/gtest.h>

#include "dynamics/scene/measure_run.h"
#include "dynamics/stepping/simulate_scene.h"
#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar {
namespace {

using sample::kG;
using sample::primitive;

constexpr double kMass = 0.2;   // [kg]
constexpr double kForce = 3;    // at full activation [N]
constexpr double kRise = 0.04;  // time constant [s]

/// Pulls a slide by kForce z, where z follows 1 from `begin` on:  z' = (1 - z) / kRise.
class SlowPull final : public ForceElement {
 public:
  explicit SlowPull(double begin = 0) : begin_(begin) {}
  [[nodiscard]] std::unique_ptr<ForceElement> clone() const override {
    return std::make_unique<SlowPull>(*this);
  }
  [[nodiscard]] std::string name() const override { return "pull"; }
  [[nodiscard]] std::vector<std::string> state_names() const override { return {"activation [1]"}; }
  [[nodiscard]] Eigen::VectorXd initial_states(const Eigen::VectorXd& /*q*/) const override {
    return Eigen::VectorXd::Zero(1);
  }
  bool add_action(const ElementInput& at, ElementAction& out) override {
    const double z = at.z[at.first_z];
    out.tau[0] += kForce * z;
    if (at.selection_time >= begin_) out.z_rate[at.first_z] += (1 - z) / kRise;
    out.z_decay[at.first_z] += 1 / kRise;
    return true;
  }
  [[nodiscard]] std::vector<double> switching_times() const override { return {begin_}; }
  [[nodiscard]] bool may_start_motion(const ElementInput& at) const override {
    return at.t >= begin_ && at.z[at.first_z] < 1 - 1e-12;
  }

 private:
  double begin_;
};

/// A spring and damper on the first coordinate, as a joint has one, too.
class Spring final : public ForceElement {
 public:
  Spring(double stiffness, double damping) : stiffness_(stiffness), damping_(damping) {}
  [[nodiscard]] std::unique_ptr<ForceElement> clone() const override {
    return std::make_unique<Spring>(*this);
  }
  [[nodiscard]] std::string name() const override { return "spring"; }
  bool add_action(const ElementInput& at, ElementAction& out) override {
    out.tau[0] -= stiffness_ * at.q[0] + damping_ * at.v[0];
    out.stiffness(0, 0) += stiffness_;
    out.damping(0, 0) += damping_;
    return true;
  }
  [[nodiscard]] double energy(const ElementInput& at) override {
    return 0.5 * stiffness_ * at.q[0] * at.q[0];
  }

 private:
  double stiffness_, damping_;
};

/// Finds no answer.
class Broken final : public ForceElement {
 public:
  [[nodiscard]] std::unique_ptr<ForceElement> clone() const override {
    return std::make_unique<Broken>(*this);
  }
  [[nodiscard]] std::string name() const override { return "broken"; }
  bool add_action(const ElementInput& /*at*/, ElementAction& /*out*/) override { return false; }
};

/// A cube on a slide along x, free of weight.
MovingScene cube_on_slide() {
  MovingScene scene;
  scene.gravity.setZero();
  sample::add_on_joint(scene, "cube", primitive(ShapeKind::kBox, {0.1, 0.1, 0.1}), kMass,
                       JointKind::kSlide, {1, 0, 0}, {0, 0, 0});
  return scene;
}

SceneRun run_for(const MovingScene& scene, SteppingMethod method, double seconds,
                 double step = 1e-3) {
  SceneOptions options;
  options.method = method;
  options.duration = seconds;
  options.step_length = step;
  return simulate_scene(scene, options);
}

/// Way of the cube from rest under SlowPull:  z = 1 - exp(-t / r),  x'' = F z / m.
double way_after(double t) {
  return kForce / kMass * (0.5 * t * t - kRise * t + kRise * kRise * (1 - std::exp(-t / kRise)));
}

TEST(ForceElement, ItsStatesFollowTheirOwnRates) {
  MovingScene scene = cube_on_slide();
  scene.elements = {std::make_shared<SlowPull>()};
  const SceneRun run = run_for(scene, SteppingMethod::kEvents, 0.5);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  for (const SceneSample& at : run.samples) {
    EXPECT_NEAR(at.z[0], 1 - std::exp(-at.t / kRise), 1e-7);
    EXPECT_NEAR(at.q[0], way_after(at.t), 1e-8);
    // What it did is what the cube has.
    EXPECT_NEAR(at.z[1], at.energy.kinetic, 1e-7);
  }
}

TEST(ForceElement, FixedStepsAreOfSecondOrder) {
  MovingScene scene = cube_on_slide();
  scene.elements = {std::make_shared<SlowPull>()};
  double last = 0;
  for (const double step : {8e-3, 4e-3, 2e-3, 1e-3}) {
    const SceneRun run = run_for(scene, SteppingMethod::kTimeStepping, 0.4, step);
    const double error = std::abs(run.samples.back().q[0] - way_after(0.4));
    if (last > 0) {
      EXPECT_NEAR(std::log2(last / error), 2, 0.15) << step;
    }
    last = error;
  }
}

TEST(ForceElement, ASpringIsTheSpringOfAJoint) {
  for (const auto& [stiffness, damping] : {std::pair{50.0, 0.3}, {5e5, 20.0}}) {
    SCOPED_TRACE(stiffness);
    MovingScene by_element = cube_on_slide(), by_joint = by_element;
    by_element.q[0] = by_joint.q[0] = 0.01;
    by_element.elements = {std::make_shared<Spring>(stiffness, damping)};
    by_joint.mechanism.joints[0].stiffness = stiffness;
    by_joint.mechanism.joints[0].damping = damping;
    for (const SteppingMethod method : {SteppingMethod::kEvents, SteppingMethod::kTimeStepping}) {
      const SceneRun a = run_for(by_element, method, 0.3), b = run_for(by_joint, method, 0.3);
      ASSERT_EQ(a.samples.size(), b.samples.size());
      for (std::size_t k = 0; k < a.samples.size(); ++k) {
        // Each step may err by 1e-9; the joint's own spring has its closed form in other tests.
        EXPECT_NEAR(a.samples[k].q[0], b.samples[k].q[0], 5e-9);
        EXPECT_NEAR(a.samples[k].energy.total(), b.samples[k].energy.total(), 1e-7 * stiffness);
      }
    }
  }
}

TEST(ForceElement, WhatADamperTakesIsAccountedFor) {
  MovingScene scene = cube_on_slide();
  scene.q[0] = 0.01;
  scene.elements = {std::make_shared<Spring>(50, 0.3)};
  const SceneRun run = run_for(scene, SteppingMethod::kEvents, 0.3);
  const RunMeasures measures = measure_run(scene, run);
  // No contact takes energy: the element's work, negative, explains all that is gone.
  EXPECT_LT(measures.work, -1e-4);
  EXPECT_EQ(measures.dissipated, 0);
  EXPECT_NEAR(measures.balance->error, 0, 1e-9);
}

// The block stays until F z exceeds mu m g, at t = -r log(1 - mu m g / F), and it must not fall
// asleep before.
TEST(ForceElement, WakesWhatRests) {
  constexpr double kFriction = 0.5, kBegin = 0.2;
  MovingScene scene;
  sample::add_body(scene, "floor", primitive(ShapeKind::kBox, {2, 2, 0.1}), 0,
                   {Eigen::Matrix3d::Identity(), {0, 0, -0.05}});
  const int block = sample::add_body(scene, "block", primitive(ShapeKind::kBox, {0.1, 0.1, 0.1}),
                                     kMass, {Eigen::Matrix3d::Identity(), {0, 0, 0.05}});
  scene.friction.coefficient = kFriction;

  /// SlowPull on the x of a free body.
  class Push final : public ForceElement {
   public:
    [[nodiscard]] std::unique_ptr<ForceElement> clone() const override {
      return std::make_unique<Push>(*this);
    }
    [[nodiscard]] std::string name() const override { return "push"; }
    [[nodiscard]] std::vector<std::string> state_names() const override {
      return pull_.state_names();
    }
    [[nodiscard]] Eigen::VectorXd initial_states(const Eigen::VectorXd& q) const override {
      return pull_.initial_states(q);
    }
    bool add_action(const ElementInput& at, ElementAction& out) override {
      out.tau[3] += kForce * at.z[at.first_z];
      if (at.selection_time >= kBegin) out.z_rate[at.first_z] += (1 - at.z[at.first_z]) / kRise;
      return true;
    }
    [[nodiscard]] std::vector<double> switching_times() const override { return {kBegin}; }
    [[nodiscard]] bool may_start_motion(const ElementInput& at) const override {
      return pull_.may_start_motion(at);
    }

   private:
    SlowPull pull_{kBegin};
  };
  scene.elements = {std::make_shared<Push>()};
  const SceneRun run = run_for(scene, SteppingMethod::kEvents, 0.6);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  const double slides = kBegin - kRise * std::log(1 - kFriction * kMass * kG / kForce);
  for (const SceneSample& at : run.samples) {
    const double x = sample::centre(scene, block, at).x();
    if (at.t < slides) {
      EXPECT_LT(std::abs(x), 1e-12) << at.t;
      continue;
    }
    // From there  m x'' = F z - mu m g, by the two integrals of z.
    const double t = at.t - kBegin, t0 = slides - kBegin;
    const auto speed_part = [](double s) { return s + kRise * std::exp(-s / kRise); };
    const auto way_part = [](double s) {
      return 0.5 * s * s - kRise * kRise * std::exp(-s / kRise);
    };
    const double free_way = way_part(t) - way_part(t0) - speed_part(t0) * (t - t0);
    const double expected = kForce / kMass * free_way - 0.5 * kFriction * kG * (t - t0) * (t - t0);
    EXPECT_NEAR(x, expected, 2e-7) << at.t;
  }
}

// The midpoint rule tells work as accurately as motion: what is unaccounted for falls with h^2.
TEST(ForceElement, FixedStepsKeepTheBooksToSecondOrder) {
  double last = 0;
  for (const double step : {4e-3, 2e-3, 1e-3}) {
    MovingScene scene = cube_on_slide();
    scene.q[0] = 0.01;
    scene.elements = {std::make_shared<Spring>(500, 0.3), std::make_shared<SlowPull>()};
    const SceneRun run = run_for(scene, SteppingMethod::kTimeStepping, 0.2, step);
    const double error = std::abs(measure_run(scene, run).balance->error);
    if (last > 0) {
      EXPECT_NEAR(std::log2(last / error), 2, 0.3) << step;
    }
    last = error;
  }
}

TEST(ForceElement, OneThatFindsNoAnswerIsSaid) {
  MovingScene scene = cube_on_slide();
  scene.elements = {std::make_shared<Broken>()};
  for (const SteppingMethod method : {SteppingMethod::kEvents, SteppingMethod::kTimeStepping}) {
    const SceneRun run = run_for(scene, method, 0.01);
    EXPECT_EQ(run.status, SceneStatus::kUnsolved);
    EXPECT_GT(run.cost.unsolved, 0);
  }
}

/// Pulls nothing, and finds no answer farther than 5 ms from where the last step ended.
class Shortsighted final : public ForceElement {
 public:
  [[nodiscard]] std::unique_ptr<ForceElement> clone() const override {
    return std::make_unique<Shortsighted>(*this);
  }
  [[nodiscard]] std::string name() const override { return "shortsighted"; }
  bool add_action(const ElementInput& at, ElementAction& /*out*/) override {
    return at.t - accepted_ < 5e-3;
  }
  void accept_step(const ElementInput& at) override { accepted_ = at.t; }

 private:
  double accepted_ = 0;  // [s]
};

TEST(ForceElement, StepsThatAreNotSolvedAreTriedShorter) {
  MovingScene scene = cube_on_slide();
  scene.elements = {std::make_shared<Shortsighted>()};
  SceneOptions options;
  options.duration = options.sample_interval = 0.3;  // of steps that would be 20 ms long
  const SceneRun run = simulate_scene(scene, options);
  EXPECT_EQ(run.status, SceneStatus::kDone);
  EXPECT_GT(run.cost.rejected, 0);
}

}  // namespace
}  // namespace thenar
