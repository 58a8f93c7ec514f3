// Tests for live/motion_history.cpp: a bounded past.

#include "live/motion_history.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

PastInstant instant_at(double t, Eigen::Index numbers = 2) {
  PastInstant past;
  past.scene.state.t = t;
  past.scene.state.q = Eigen::VectorXd::Constant(numbers, t);
  past.scene.state.v = Eigen::VectorXd::Zero(numbers);
  return past;
}

MotionHistory history_of(const std::vector<double>& times, const HistoryLimits& limits = {}) {
  MotionHistory history(limits);
  for (const double t : times) history.add(instant_at(t));
  return history;
}

TEST(MotionHistory, ForgetsTheOldestFirst) {
  HistoryLimits limits;
  limits.instants = 3;
  const MotionHistory history = history_of({0, 1, 2, 3, 4}, limits);
  ASSERT_EQ(history.size(), 3U);
  EXPECT_EQ(history.instant(0).scene.state.t, 2);
  EXPECT_EQ(history.instant(2).scene.state.t, 4);
  EXPECT_EQ(history.instant(2).scene.state.q, Eigen::Vector2d(4, 4));
}

// Memory grows with the numbers that are kept, and stays at its limit: one instant beyond at most.
TEST(MotionHistory, KeepsToItsMemory) {
  const std::size_t one = history_of({0}).bytes();
  MotionHistory larger;
  larger.add(instant_at(0, 102));
  EXPECT_EQ(larger.bytes() - one, 2 * 100 * sizeof(double));  // q and v
  HistoryLimits limits;
  limits.bytes = 4 * one;
  MotionHistory history(limits);
  for (int i = 0; i < 50; ++i) history.add(instant_at(i));
  EXPECT_EQ(history.bytes(), 4 * one);
  EXPECT_EQ(history.size(), 4U);
  EXPECT_EQ(history.instant(3).scene.state.t, 49);
}

// Halfway between two instants the earlier one is taken; beyond the ends the ends.
TEST(MotionHistory, FindsTheNearestInstant) {
  const MotionHistory history = history_of({0, 1, 3});
  const double asked[] = {-5, 0, 0.4, 0.5, 0.6, 2.1, 3, 9};
  const std::size_t wanted[] = {0, 0, 0, 0, 1, 2, 2, 2};
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(history.nearest_index(asked[i]), wanted[i]) << asked[i];
}

TEST(MotionHistory, CutsBehindAnInstant) {
  MotionHistory history = history_of({0, 1, 2, 3});
  history.erase_after(1);
  EXPECT_EQ(history.size(), 2U);
  EXPECT_EQ(history.bytes(), history_of({0, 1}).bytes());
  history.add(instant_at(1.5));
  EXPECT_EQ(history.instant(2).scene.state.t, 1.5);
  history.clear();
  EXPECT_EQ(history.size(), 0U);
  EXPECT_EQ(history.bytes(), 0U);
  EXPECT_EQ(message_of([&] { (void)history.nearest_index(0); }), "no instant is kept");
}

}  // namespace
}  // namespace thenar
