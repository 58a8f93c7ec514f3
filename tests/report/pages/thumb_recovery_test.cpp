// Tests for report/pages/thumb_recovery.cpp and measured_lessons.cpp.

#include "report/pages/thumb_recovery.h"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "report/pages/measured_lessons.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

/// Short chains, few draws.
const ThumbRecoveryResult& recovered() {
  static const ThumbRecoveryResult made = [] {
    ThumbRecoveryRequest request;
    request.data = kData;
    request.draws = 300;
    request.weighed = 400;
    return ask_thumb_recovery(request);
  }();
  return made;
}

const Json& block_of(const Json& section, const std::string& type, int number = 0) {
  for (const Json& block : section.at("blocks"))
    if (block.at("type") == type && number-- == 0) return block;
  throw std::out_of_range(type);
}

TEST(ThumbRecoveryPage, NamesTiltsAndShifts) {
  EXPECT_EQ(words_of_axis_parameter("axis/CMC1_AA/direction/2"), "CMC1_AA tilt 2");
  EXPECT_EQ(words_of_axis_parameter("axis/IP1/point/1"), "IP1 shift 1");
  EXPECT_EQ(words_of_axis_parameter("noise/pulls"), "noise/pulls");
}

// By hand: rms of 0.6 and 1 is sqrt(0.68); the first is narrower by more than two errors.
TEST(ThumbRecoveryPage, KeptSharesAreThoseByHand) {
  ReweightedDraws draws;
  draws.names = {"axis/IP1/direction/1", "axis/IP1/direction/2"};
  DataUpdate update;
  update.tilts.sd_ratio = Eigen::Vector2d(0.6, 1);
  update.tilts.sd_ratio_error = Eigen::Vector2d(0.1, 0.1);
  update.tilts.mean_shift = Eigen::Vector2d(0.2, -0.9);
  const KeptShares kept = kept_shares(draws, update);
  EXPECT_NEAR(kept.rms, std::sqrt(0.68), 1e-12);
  EXPECT_EQ(kept.least, 0.6);
  EXPECT_EQ(kept.least_name, "IP1 tilt 1");
  EXPECT_EQ(kept.most, 1);
  EXPECT_EQ(kept.largest_shift, -0.9);
  EXPECT_EQ(kept.largest_shift_name, "IP1 tilt 2");
  EXPECT_EQ(kept.narrower, 1);
}

// Five axes; ten tilts and ten shifts by two methods, each beside the truth and the prior.
TEST(ThumbRecoveryPage, ShowsBothMethodsBesideTheTruth) {
  ASSERT_FALSE(recovered().stopped);
  const Json page = thumb_recovery_section(recovered().recovery);
  EXPECT_EQ(block_of(page, "table").at("rows").size(), 5u);
  for (const int chart : {0, 1}) {
    const Json& intervals = block_of(page, "interval", chart);
    EXPECT_EQ(intervals.at("rows").size(), 20u);
    for (const Json& row : intervals.at("rows")) {
      EXPECT_TRUE(row.contains("truth"));
      EXPECT_LT(row.at("low").get<double>(), row.at("high").get<double>());
    }
  }
  const std::string words = block_of(page, "text").at("text");
  EXPECT_NE(words.find("Agreement"), std::string::npos);
  EXPECT_NE(words.find("What could not be told"), std::string::npos);
}

// A row for each tilt, for each addition to prior and posterior, and for each measured number.
TEST(ThumbRecoveryPage, ShowsWhatMeasurementsLeave) {
  const Json page = measured_lessons_section(recovered());
  EXPECT_EQ(block_of(page, "table", 0).at("rows").size(), 10u);
  EXPECT_EQ(block_of(page, "table", 1).at("rows").size(), 2 * additions_to_ask().size());
  EXPECT_EQ(block_of(page, "table", 2).at("rows").size(),
            3 + recovered().lessons.losses.blocks.size());
  // The page says that no sd was published.
  const std::string text = page.at("text");
  EXPECT_NE(text.find("ASSUMED"), std::string::npos);
  EXPECT_NE(text.find("1.67 N"), std::string::npos);
  EXPECT_NE(text.find("46 degrees from proximal"), std::string::npos);
}

// Numbers in words are those of the results.
TEST(ThumbRecoveryPage, WordsAreTheNumbers) {
  const ReweightedDraws& prior = recovered().lessons.reweighted.front();
  const KeptShares kept = kept_shares(prior, update_by_both(prior));
  const std::string verdict = block_of(measured_lessons_section(recovered()), "text").at("text");
  EXPECT_NE(
      verdict.find(fmt::format("leave {:.0f} to {:.0f} %", 100 * kept.least, 100 * kept.most)),
      std::string::npos);
}

}  // namespace
}  // namespace thenar
