// Tests for base/progress.h.

#include "base/progress.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

TEST(Progress, HearsNothingAndNeverStopsByDefault) {
  const Progress progress;
  EXPECT_NO_THROW(progress(0.5, "half"));
  EXPECT_FALSE(progress.stop());
}

TEST(Progress, PassesReportsUpAndStopRequestsDown) {
  double heard = 0;
  std::string words;
  Progress progress;
  progress.report = [&](double fraction, const std::string& what) {
    heard = fraction;
    words = what;
  };
  progress.stop_requested = [&] { return heard > 0.4; };
  EXPECT_FALSE(progress.stop());
  progress(0.5, "half");
  EXPECT_EQ(heard, 0.5);
  EXPECT_EQ(words, "half");
  EXPECT_TRUE(progress.stop());
}

}  // namespace
}  // namespace thenar
