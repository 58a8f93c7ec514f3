// Tests for base/progress_parts.cpp.

#include "base/progress_parts.h"

#include <vector>

#include <gtest/gtest.h>

namespace thenar {
namespace {

TEST(ProgressParts, SharesTheWholeByTime) {
  std::vector<double> heard;
  Progress whole;
  whole.report = [&](double fraction, const std::string& /*what*/) { heard.push_back(fraction); };
  ProgressParts parts(whole, 4);
  parts.next(1)(0.5, "first");   // half of the first quarter
  parts.next(3)(1.0, "second");  // the end
  ASSERT_EQ(heard.size(), 2u);
  EXPECT_DOUBLE_EQ(heard[0], 0.125);
  EXPECT_DOUBLE_EQ(heard[1], 1);
}

TEST(ProgressParts, ThrowsWhereAStopWasAskedFor) {
  Progress progress;
  EXPECT_NO_THROW(report_or_stop(progress, 0, "loads"));
  progress.stop_requested = [] { return true; };
  EXPECT_THROW(report_or_stop(progress, 0, "loads"), Stopped);
}

}  // namespace
}  // namespace thenar
