// Tests for grasp/contact/scaled_wrench.h.

#include "grasp/contact/scaled_wrench.h"

#include <cmath>
#include <type_traits>

#include <gtest/gtest.h>

#include "pads/motion/moving_pad.h"

namespace thenar {
namespace {

using WrenchVector = decltype(wrench_vector(Wrench{}));  // the moment first, unscaled

// Neither six numbers of another order nor a wrench that is not scaled pass for a scaled one.
static_assert(!std::is_convertible_v<WrenchVector, ScaledWrench>);
static_assert(!std::is_constructible_v<ScaledWrench, WrenchVector>);
static_assert(!std::is_assignable_v<ScaledWrench&, WrenchVector>);
static_assert(!std::is_convertible_v<Wrench, ScaledWrench>);
static_assert(!std::is_constructible_v<ScaledWrench, Wrench>);
static_assert(!std::is_convertible_v<ScaledWrench, Wrench>);
static_assert(!std::is_convertible_v<ScaledWrench, WrenchVector>);
static_assert(!std::is_constructible_v<Wrench, ScaledWrench>);
static_assert(!std::is_convertible_v<ScaledMotion, ScaledWrench>);
static_assert(!std::is_convertible_v<ScaledWrench, ScaledMotion>);

const Wrench kWrench{{0.1, -0.2, 0.4}, {1, 2, 3}};  // [N m], [N]

// By hand: the force first, and moments over 0.5 m doubled.
TEST(ScaledWrench, HasTheForceFirstAndTheMomentOverTheScale) {
  const WrenchCoordinates expected = (WrenchCoordinates() << 1, 2, 3, 0.2, -0.4, 0.8).finished();
  EXPECT_EQ(scaled_wrench(kWrench, 0.5).vector(), expected);
  EXPECT_EQ(ScaledWrench::from_coordinates(expected), scaled_wrench(kWrench, 0.5));
}

TEST(ScaledWrench, ConvertsBack) {
  const Wrench back = unscaled_wrench(scaled_wrench(kWrench, 0.5), 0.5);
  EXPECT_EQ(back.moment, kWrench.moment);
  EXPECT_EQ(back.force, kWrench.force);
}

TEST(ScaledWrench, UnitsOfAxes3To5AreMoments) {
  EXPECT_EQ(ScaledWrench::unit(1).force, Eigen::Vector3d::UnitY());
  EXPECT_EQ(ScaledWrench::unit(5).moment_over_length, Eigen::Vector3d::UnitZ());
}

// By hand: 2 (1, 0, 2, 0, 0, 0) - (0, 0, 0, 0, 3, 0).
TEST(ScaledWrench, CountsBothHalvesAlike) {
  const ScaledWrench a{{1, 0, 2}, {0, 0, 0}}, b{{0, 0, 0}, {0, 3, 0}};
  const ScaledWrench c = 2 * a - b;
  EXPECT_EQ(c, (ScaledWrench{{2, 0, 4}, {0, -3, 0}}));
  EXPECT_EQ(c + b, 2 * a);
  EXPECT_EQ(c.dot(a + b), 1);  // 2 + 8 - 9
  EXPECT_DOUBLE_EQ(c.norm(), std::sqrt(29.0));
  EXPECT_FALSE(c.is_zero());
  EXPECT_TRUE((c - c).is_zero());
}

}  // namespace
}  // namespace thenar
