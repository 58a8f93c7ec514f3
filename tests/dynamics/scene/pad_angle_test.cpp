// Tests for dynamics/scene/pad_angle.cpp.

#include "dynamics/scene/pad_angle.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"

namespace thenar {
namespace {

/// A body that is turned by 30 deg about z and pressed by one that stands at +y of it.
struct Pressed {
  /// @param first  whether the pad's body is the first of the contact
  explicit Pressed(bool first) : body(first ? 0 : 1), other(first ? 1 : 0) {
    ContactSample contact;
    contact.a = 0;
    contact.b = 1;
    contact.normal = {0, first ? -1.0 : 1.0, 0};                    // outward of b
    contact.force = 5 * contact.normal + Eigen::Vector3d(2, 0, 1);  // on a; friction plays no part
    run.samples.resize(2);
    run.samples[1].t = 0.5;
    run.samples[1].contacts = {contact};
    std::vector<Pose<double>> X(2);
    X[static_cast<std::size_t>(body)].R = rotation_about<double>({0, 0, 1}, 30 * kDegree);
    measures.X_WB = {X, X};
  }
  int body, other;
  SceneRun run;
  RunMeasures measures;
};

// The pad looks along the body's x, which is 60 deg from y.
TEST(PadAngle, IsBetweenThePadAndWhatItPresses) {
  for (const bool first : {true, false}) {
    const Pressed at(first);
    const std::vector<PadState> states =
        pad_angles(at.run, at.measures, at.body, at.other, {1, 0, 0});
    ASSERT_EQ(states.size(), 1u);  // at the other instant nothing touches
    EXPECT_EQ(states[0].t, 0.5);
    EXPECT_NEAR(states[0].force, 5, 1e-14);
    EXPECT_NEAR(states[0].angle, 60 * kDegree, 1e-14);
  }
}

TEST(PadAngle, RefusesMeasuresOfAnotherRun) {
  Pressed at(true);
  EXPECT_THROW((void)pad_angles(at.run, at.measures, 0, 2, {1, 0, 0}), InputError);
  at.measures.X_WB.pop_back();
  EXPECT_THROW((void)pad_angles(at.run, at.measures, 0, 1, {1, 0, 0}), InputError);
}

}  // namespace
}  // namespace thenar
