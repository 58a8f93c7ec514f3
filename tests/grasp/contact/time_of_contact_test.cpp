// Tests for grasp/contact/time_of_contact.cpp.

#include "grasp/contact/time_of_contact.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/grasp/contact/analytic_shapes.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

constexpr double kGap = 1e-4;  // default [m]

/// A moves, B stands at the origin.
template <typename Motion>
Approach approach(const Solid& a, const Solid& b, double speed, Motion X_WA) {
  return {[body = touch_body(a), b, X_WA](double s, double cutoff) {
            SeparationOptions options;
            options.tolerance = kGap / 4;
            options.cutoff = cutoff;
            return separation(body, X_WA(s), b, {}, options);
          },
          speed};
}

/// Along x, from x = start [m], s [m] back towards the origin.
auto towards_origin(double start) {
  return [start](double s) { return Pose<double>{Eigen::Matrix3d::Identity(), {start - s, 0, 0}}; };
}

TimeOfContactOptions by(ContactSearch search) {
  TimeOfContactOptions options;
  options.search = search;
  return options;
}

class EveryContactSearch : public testing::TestWithParam<ContactSearch> {};

// Two balls on a line touch when their centres are apart by their radii.
TEST_P(EveryContactSearch, FindsBallsMeeting) {
  const Solid ball = touching({rounded_point({0, 0, 0}, 0.01)});
  const TimeOfContact t = time_of_contact(
      {approach(ball, ball_solid(0.05), 1, towards_origin(0.5))}, 1, by(GetParam()));
  ASSERT_TRUE(t.touches);
  EXPECT_EQ(t.pair, 0);
  EXPECT_LE(t.s, 0.5 - 0.06);
  EXPECT_GE(t.s, 0.5 - 0.06 - kGap);
  EXPECT_GE(t.at.distance, 0);
}

// A bar of length L hinged at height h above the ground strikes it at asin(h / L).
TEST_P(EveryContactSearch, FindsBarStrikingTheGround) {
  const Solid bar = touching({rounded_segment({0, 0, 0}, {0.1, 0, 0}, 0)});
  const auto motion = [](double angle) {
    return Pose<double>{rotation_about<double>({0, 1, 0}, angle), {0, 0, 0.06}};
  };
  const double speed = reach_from(touch_body(bar), {0, 0, 0}, {0, 1, 0});
  EXPECT_NEAR(speed, 0.1, 1e-15);
  const TimeOfContact t =
      time_of_contact({approach(bar, ground_solid(), speed, motion)}, 1.5, by(GetParam()));
  ASSERT_TRUE(t.touches);
  const double height = 0.06 - 0.1 * std::sin(t.s);
  EXPECT_GE(height, 0);
  EXPECT_LE(height, kGap);
}

TEST_P(EveryContactSearch, FindsTheFirstOfSeveral) {
  const Solid ball = touching({rounded_point({0, 0, 0}, 0.01)});
  const auto pair = [&](double start) {
    return approach(ball, ball_solid(0.05), 1, towards_origin(start));
  };
  // They touch within the same step of 1 mm.
  const TimeOfContact t =
      time_of_contact({pair(0.3007), pair(0.3001), pair(0.3004)}, 1, by(GetParam()));
  ASSERT_TRUE(t.touches);
  EXPECT_EQ(t.pair, 1);
  EXPECT_NEAR(t.s, 0.2401 - kGap / 2, kGap / 2 + 1e-12);
}

TEST_P(EveryContactSearch, SaysThatNothingTouches) {
  const Solid ball = touching({rounded_point({0, 0, 0}, 0.01)});
  const TimeOfContact t = time_of_contact(
      {approach(ball, ball_solid(0.05), 1, towards_origin(0.5))}, 0.4, by(GetParam()));
  EXPECT_FALSE(t.touches);
  EXPECT_EQ(t.s, 0.4);
  EXPECT_EQ(t.pair, -1);
  EXPECT_FALSE(t.gave_up);
}

TEST_P(EveryContactSearch, ReportsTheDepthOfAnOverlapAtTheStart) {
  const Solid ball = touching({rounded_point({0, 0, 0}, 0.01)});
  const TimeOfContact t = time_of_contact(
      {approach(ball, ball_solid(0.05), 1, towards_origin(0.04))}, 1, by(GetParam()));
  ASSERT_TRUE(t.touches);
  EXPECT_EQ(t.s, 0);
  EXPECT_NEAR(t.at.distance, -0.02, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Both, EveryContactSearch,
                         testing::Values(ContactSearch::kAdvance, ContactSearch::kBisect));

// A sheet 0.2 mm thick lies within one step of 1 mm: only advancement is sure to see it.
TEST(TimeOfContact, AdvancesThroughNothing) {
  const Solid point = touching({rounded_point({0, 0, 0}, 0)});
  const Solid sheet = box_shape({2e-4, 1, 1});
  const TimeOfContact t =
      time_of_contact({approach(point, sheet, 1, towards_origin(0.0305))}, 0.06, {});
  ASSERT_TRUE(t.touches);
  EXPECT_NEAR(t.s, 0.0305 - 1e-4 - kGap / 2, kGap / 2);
}

// From afar nothing is asked twice: one question clears the whole way.
TEST(TimeOfContact, AsksOnceOfWhatIsFar) {
  const Solid point = touching({rounded_point({0, 0, 0}, 0)});
  const TimeOfContact t =
      time_of_contact({approach(point, ball_solid(0.05), 1, towards_origin(1e6))}, 1, {});
  EXPECT_FALSE(t.touches);
  EXPECT_EQ(t.questions, 1);
}

TEST(TimeOfContact, GivesUpWhereItIsFree) {
  const Solid point = touching({rounded_point({0, 0, 0}, 0)});
  TimeOfContactOptions options;
  options.most_questions = 2;
  // The true speed is a thousandth of the bound, so that steps are short.
  const auto slow = [](double s) {
    return Pose<double>{Eigen::Matrix3d::Identity(), {0.1 - s / 1000, 0, 0}};
  };
  const TimeOfContact t = time_of_contact({approach(point, ball_solid(0.05), 1, slow)}, 1, options);
  EXPECT_FALSE(t.touches);
  EXPECT_TRUE(t.gave_up);
  EXPECT_LT(t.s, 0.11);
}

TEST(TimeOfContact, RejectsWhatMovesNowhere) {
  EXPECT_EQ(message_of([] { (void)time_of_contact({}, 0); }), "a motion must end after 0, got 0");
  EXPECT_EQ(message_of([] {
              (void)time_of_contact({{nullptr, -1}}, 1);
            }),
            "speed of pair 0 must be finite and >= 0, got -1");
}

}  // namespace
}  // namespace thenar
