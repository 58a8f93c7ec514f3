// Tests for dynamics/scene/work_precision.cpp.

#include "dynamics/scene/work_precision.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "dynamics/scene/build_scene.h"
#include "dynamics/stepping/contact_step.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

constexpr double kStart = 10 * kDegree, kApart = 0.12, kGravity = 9.81;

// Energy of a ball that rolls: (7/10) v^2 = g (height lost).
TEST(RolledAngle, KeepsEnergy) {
  EXPECT_NEAR(rolled_angle(kStart, 0, kApart), kStart, 1e-12);
  const double h = 1e-4, k = 5 * kGravity / (7 * kApart);
  for (const double t : {0.05, 0.15, 0.25}) {
    const double rate =
        (rolled_angle(kStart, t + h, kApart) - rolled_angle(kStart, t - h, kApart)) / (2 * h);
    const double angle = rolled_angle(kStart, t, kApart);
    EXPECT_NEAR(rate * rate, 2 * k * (std::cos(kStart) - std::cos(angle)), 1e-5 * rate * rate);
  }
}

TEST(RolledAngle, RefusesWhatIsOutOfRange) {
  EXPECT_THROW((void)rolled_angle(0, 1, kApart), InputError);
  EXPECT_THROW((void)rolled_angle(kStart, 10, kApart), InputError);
}

// data/scenes/ball_on_ball.toml: errors stay below 30 tolerances by events, and fall as the square
// of the step by fixed steps.
TEST(WorkPrecision, ErrorsFallAsTheMethodsPromise) {
  const BuiltScene built = build_scene(read_scene(kData + "/scenes/ball_on_ball.toml"), {});
  const double exact = rolled_angle(kStart, built.options.duration, kApart);
  const int ball = body_named(built.scene.mechanism, "ball");
  const auto error = [&](const SceneSample& sample) {
    ContactStep step(built.scene);
    std::vector<Pose<double>> X;
    step.compute_poses({sample.t, sample.q, sample.v, sample.z}, X);
    const Eigen::Vector3d p = X[static_cast<std::size_t>(ball)].p;
    return (p - kApart * Eigen::Vector3d(std::sin(exact), 0, std::cos(exact))).norm();
  };
  WorkSettings settings;
  settings.tolerances = {1e-6, 1e-8, 1e-10};
  settings.steps = {4e-3, 2e-3, 1e-3};
  settings.repeats = 1;
  const std::vector<WorkPoint> points = work_precision(built.scene, built.options, settings, error);
  ASSERT_EQ(points.size(), 6u);
  for (const WorkPoint& point : points) EXPECT_EQ(point.status, SceneStatus::kDone);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(points[i].method, SteppingMethod::kEvents);
    EXPECT_LT(points[i].error, 30 * points[i].setting);
  }
  for (std::size_t i = 4; i < 6; ++i) {
    EXPECT_EQ(points[i].method, SteppingMethod::kTimeStepping);
    EXPECT_NEAR(std::log2(points[i - 1].error / points[i].error), 2, 0.1);
  }
}

}  // namespace
}  // namespace thenar
