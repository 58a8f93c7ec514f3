// Tests for base/pace.cpp. Times are made up: no clock runs here.

#include "base/pace.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

// By hand: from 0.1 to 0.3 in 4 s, so that 0.7 takes 14 s more, and all 5 + 4 + 14 s.
TEST(Pace, GoesOnAsFromTheFirstReport) {
  Pace pace(95);
  pace.add_report(100, 0.1);
  pace.add_report(104, 0.3);
  EXPECT_DOUBLE_EQ(pace.remaining_time().value(), 14);
  EXPECT_DOUBLE_EQ(pace.total_time().value(), 23);
}

TEST(Pace, IsSilentBeforeItKnows) {
  Pace pace;
  EXPECT_FALSE(pace.remaining_time());
  pace.add_report(0, 0);
  pace.add_report(1, 0.5);  // too early
  EXPECT_FALSE(pace.total_time());
  Pace slow;
  slow.add_report(0, 0);
  slow.add_report(60, 0.001);  // too little of the work
  EXPECT_FALSE(slow.total_time());
}

// A part may report less than another did before it.
TEST(Pace, NeverGoesBack) {
  Pace pace;
  pace.add_report(0, 0);
  pace.add_report(2, 0.5);
  pace.add_report(4, 0.25);
  EXPECT_DOUBLE_EQ(pace.remaining_time().value(), 4);
}

TEST(Pace, IsRoundedAsAnEstimateDeserves) {
  EXPECT_EQ(rough_time(0.2), "1 s");
  EXPECT_EQ(rough_time(12.4), "12 s");
  EXPECT_EQ(rough_time(44), "40 s");
  EXPECT_EQ(rough_time(100), "2 min");
  EXPECT_EQ(rough_time(33 * 60), "30 min");
  EXPECT_EQ(rough_time(3 * 3600), "3 h");
}

}  // namespace
}  // namespace thenar
