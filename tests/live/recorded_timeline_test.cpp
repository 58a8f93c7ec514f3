// Tests for live/recorded_timeline.cpp: times between instants.

#include "live/recorded_timeline.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

/// A recorded motion of nothing but its times.
class TimesAlone final : public RecordedTimeline {
 public:
  explicit TimesAlone(std::vector<double> times) : RecordedTimeline(std::move(times)) {}
  using RecordedTimeline::interpolated;
  using RecordedTimeline::interpolated_number;
  using RecordedTimeline::nearest_instant;

  [[nodiscard]] const LiveShape& shape() const override { return shape_; }
  [[nodiscard]] LiveInstant instant() const override { return {}; }
  [[nodiscard]] TimelineState state(const MotionParts& /*parts*/) const override { return {}; }
  [[nodiscard]] MotionQuality quality() const override { return {}; }
  [[nodiscard]] std::vector<std::string> warnings() const override { return {}; }
  [[nodiscard]] const std::string& name() const override { return name_; }

 private:
  LiveShape shape_;
  std::string name_ = "times";
};

TEST(RecordedTimeline, KeepsToItsTimes) {
  TimesAlone motion({1, 2, 4});
  EXPECT_EQ(motion.live_time().t, 1);
  EXPECT_EQ(motion.live_time().duration, 4);
  EXPECT_TRUE(motion.live_time().recorded);
  EXPECT_EQ(motion.seek(3.3), 3.3);
  EXPECT_EQ(motion.seek(-1), 1);
  EXPECT_EQ(motion.seek(9), 4);
  EXPECT_EQ(motion.changes(), 3U);  // one for each look
}

// Numbers that are linear in time come out as they are at any time, instants among them.
TEST(RecordedTimeline, GoesStraightBetweenInstants) {
  const std::vector<double> times{1, 2, 4, 4.5};
  TimesAlone motion(times);
  Eigen::MatrixXd rows(4, 2);
  for (Eigen::Index i = 0; i < 4; ++i) {
    const double t = times[static_cast<std::size_t>(i)];
    rows.row(i) << 3 * t - 1, -t;
  }
  for (double t = 1; t <= 4.5; t += 0.125) {
    (void)motion.seek(t);
    EXPECT_NEAR(motion.interpolated(rows)[0], 3 * t - 1, 1e-14) << t;
    EXPECT_NEAR(motion.interpolated(rows)[1], -t, 1e-14) << t;
    EXPECT_NEAR(motion.interpolated_number([&](std::size_t i) { return 2 * times[i]; }), 2 * t,
                1e-14);
  }
}

TEST(RecordedTimeline, ShowsTheNearestInstant) {
  TimesAlone motion({1, 2, 4});
  const double asked[] = {1, 1.4, 1.6, 2.9, 3.1, 4};
  const std::size_t wanted[] = {0, 0, 1, 1, 2, 2};
  for (std::size_t i = 0; i < 6; ++i) {
    (void)motion.seek(asked[i]);
    EXPECT_EQ(motion.nearest_instant(), wanted[i]) << asked[i];
  }
}

// Steps are of a 240th of a second; play ends with the last instant, and a reset begins anew.
TEST(RecordedTimeline, StepsToItsEnd) {
  TimesAlone motion({0, 1});
  motion.play(2);
  EXPECT_EQ(motion.live_time().speed, 2);
  EXPECT_EQ(motion.step(60, {}).steps, 60);
  EXPECT_NEAR(motion.live_time().t, 0.25, 1e-15);
  EXPECT_TRUE(motion.live_time().playing);
  (void)motion.step(1000, {});
  EXPECT_EQ(motion.live_time().t, 1);
  EXPECT_FALSE(motion.live_time().playing);
  motion.reset();
  EXPECT_EQ(motion.live_time().t, 0);
}

TEST(RecordedTimeline, RefusesAMotionWithoutInstants) {
  EXPECT_EQ(message_of([] { TimesAlone motion({}); }), "wanted a motion with instants, got none");
}

}  // namespace
}  // namespace thenar
