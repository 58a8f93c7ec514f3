// Ways to close of drives whose ranges and tips are known in closed form.

#include "grasp/robot/closing_options.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

/// A drive of its own for each coordinate, with rest at zero.
HandLayout layout_of(const std::vector<std::pair<double, double>>& limits) {
  HandLayout layout;
  layout.lower.resize(static_cast<Eigen::Index>(limits.size()));
  layout.upper.resize(static_cast<Eigen::Index>(limits.size()));
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const int coordinate = static_cast<int>(i);
    layout.lower[coordinate] = limits[i].first;
    layout.upper[coordinate] = limits[i].second;
    Drive drive;
    drive.moves = {{coordinate, 1}};
    layout.drives.push_back(drive);
  }
  return layout;
}

/// Options where tips are 2 m apart and each sense brings them 0.5 m nearer.
std::vector<SenseOption> options_of(const HandLayout& layout, const DriveGroups& groups) {
  return closing_options(layout, Eigen::VectorXd::Zero(layout.lower.size()), groups,
                         [](const std::vector<double>& senses) {
                           double distance = 2;
                           for (const double sense : senses) distance -= 0.5 * sense;
                           return distance;
                         });
}

using Speeds = std::vector<double>;

TEST(ClosingOptions, RangesAndTipsThatAgreeComeFirstThenTheReverse) {
  // Ranges of 1 and 0.2 rad are evidence of (1 - 0.2) / (1 + 0.2) = 2 / 3 each.
  const HandLayout layout = layout_of({{-0.2, 1}, {-0.2, 1}});
  const std::vector<SenseOption> options = options_of(layout, {{1, 1}, {0, 1}});
  ASSERT_EQ(options.size(), 2U);
  EXPECT_EQ(options[0].speed, (Speeds{1, 1}));
  EXPECT_EQ(options[0].penalty, 0);
  EXPECT_EQ(options[1].speed, (Speeds{-1, -1}));
  EXPECT_EQ(options[1].penalty, 0.6);  // 0.4 (2 / 3 + 2 / 3) and 0.4 (1 + 1), but no more than this
}

// Tips 1.5 and 2.5 m apart are evidence of 1 / 4, which counts whole.
TEST(ClosingOptions, RangesAndTipsThatDisagreeAreBothTried) {
  const std::vector<SenseOption> options = options_of(layout_of({{-1, 0.2}}), {{1}, {0}});
  ASSERT_EQ(options.size(), 2U);
  EXPECT_EQ(options[0].speed, Speeds{-1});
  EXPECT_EQ(options[0].penalty, 0.4);
  EXPECT_EQ(options[1].speed, Speeds{1});
  EXPECT_NEAR(options[1].penalty, 0.4 * 2.0 / 3, 1e-15);
}

// Jaws that begin closed go one way alone, which is not that of closing.
TEST(ClosingOptions, RangesOfSlidesSayNothing) {
  const std::vector<SenseOption> options = options_of(layout_of({{-1, 0}}), {{1}, {0}, {true}});
  ASSERT_EQ(options.size(), 1U);
  EXPECT_EQ(options[0].speed, Speeds{1});
  EXPECT_EQ(options[0].penalty, 0);
}

TEST(ClosingOptions, DrivesOfOneGroupKeepTheirSignsToEachOther) {
  // The tips say nothing: what one drive brings nearer, the other takes away.
  const std::vector<SenseOption> options =
      options_of(layout_of({{-0.2, 1}, {-1, 0.2}}), {{1, -1}, {0, 0}});
  ASSERT_EQ(options.size(), 1U);
  EXPECT_EQ(options[0].speed, (Speeds{1, -1}));
}

TEST(ClosingOptions, StatedSpeedsKeepTheirMagnitudesAndOthersStandStill) {
  HandLayout layout = layout_of({{-0.2, 1}, {-1, 1}});
  layout.drives[0].speed = -3;
  const std::vector<SenseOption> options = options_of(layout, {{1, 0}, {0, -1}});
  ASSERT_EQ(options.size(), 1U);
  EXPECT_EQ(options[0].speed, (Speeds{3, 0}));
}

TEST(ClosingOptions, HandsWithoutCurlingDrivesHaveOneOptionThatStandsStill) {
  const std::vector<SenseOption> options = options_of(layout_of({{-1, 1}}), {{0}, {-1}});
  ASSERT_EQ(options.size(), 1U);
  EXPECT_EQ(options[0].speed, Speeds{0});
  EXPECT_EQ(options[0].penalty, 0);
}

}  // namespace
}  // namespace thenar
