// Tests for studies/pages/thumb_recovery.cpp and measured_lessons.cpp.

#include "studies/pages/thumb_recovery.h"

#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/pages/measured_lessons.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Short chains, few draws.
const ThumbRecoveryResult& recovered() {
  static const ThumbRecoveryResult made = [] {
    ThumbRecoveryRequest request;
    request.data = kData;
    request.draws = 300;
    request.weighed = 400;
    return compute_thumb_recovery(request);
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
  EXPECT_EQ(kept.undecided, 1);
}

// Five axes; ten tilts and ten shifts by two methods, each beside the truth and the prior.
TEST(ThumbRecoveryPage, ShowsBothMethodsBesideTheTruth) {
  ASSERT_FALSE(recovered().outcome.stopped());
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

/// A result whose words are known: of ten tilts nine keep half of their sd and one 0.95, by both
/// measurements over draws of the prior.
ThumbRecoveryResult with_known_shares() {
  ThumbRecoveryResult result = recovered();
  DataUpdate& both = result.lessons.reweighted.front().updates[2];
  both.tilts.sd_ratio.setConstant(0.5);
  both.tilts.sd_ratio[3] = 0.95;
  both.tilts.sd_ratio_error.setConstant(0.1);
  both.tilts.mean_shift.setZero();
  both.tilts.mean_shift[9] = -1.25;
  both.weights.k = 0;
  return result;
}

std::string words_of(const ThumbRecoveryResult& result) {
  return block_of(measured_lessons_section(result), "text").at("text");
}

// By hand: the rms is sqrt((9 0.25 + 0.9025) / 10) = 0.56; nine are below 1 by two errors, one is
// above 0.9.
TEST(ThumbRecoveryPage, WordsAreTheNumbers) {
  const std::string words = words_of(with_known_shares());
  EXPECT_THAT(words,
              HasSubstr("leave 50 to 95 % of the prior's sd of 10 tilts, 56 % in the rms, "));
  EXPECT_THAT(words, HasSubstr("9 of 10 tilts are narrower by two errors or more; 1 keep more "
                               "than 90 % of the prior's sd. The mean that moves most is that of "
                               "IP1 tilt 2, by 1.2 prior sds."));
  // 116 trials and tasks of three components, and 80 tasks of nine muscles.
  EXPECT_THAT(words, HasSubstr("the made-up 348 components of force and 720 activations"));
}

// What cannot be believed, and what cannot be said, is told in words and in the table.
TEST(ThumbRecoveryPage, TellsWeightsThatTellNothing) {
  ThumbRecoveryResult result = with_known_shares();
  DataUpdate& both = result.lessons.reweighted.front().updates[2];
  both.weights.k = 3;
  EXPECT_THAT(words_of(result), HasSubstr("56 % in the rms (NOT reliable: Pareto k is above"));
  both = {both.added, "none of 400 draws can have weight", {}, {}};
  result.lessons.reweighted.front().predicted.undecided[0] = 1;
  EXPECT_THAT(words_of(result), HasSubstr("teach alone is not known: none of 400 draws can have "
                                          "weight. Of 400 thumbs of the prior"));
  EXPECT_THAT(words_of(result), HasSubstr("Draws before any data whose pinch is UNDECIDED"));
  const Json page = measured_lessons_section(result);
  EXPECT_TRUE(block_of(page, "table", 0).at("rows")[0][2].is_null());
  EXPECT_EQ(block_of(page, "table", 1).at("rows")[2][6], "NO: none of 400 draws can have weight");
  EXPECT_EQ(block_of(page, "interval").at("rows").size(), 10u);  // of the posterior alone
}

// That both disagree is said only if they do: by 3 sds, and not by none.
TEST(ThumbRecoveryPage, SaysThatMeasurementsDisagreeIfTheyDo) {
  ThumbRecoveryResult result = with_known_shares();
  MeasuredLessons& lessons = result.lessons;
  const Trial& trial = lessons.force.trials.front();
  lessons.truth.force = trial.force;
  for (std::size_t b = 0; b < lessons.losses.blocks.size(); ++b)
    lessons.truth.loss(static_cast<Eigen::Index>(b), 0) = lessons.losses.blocks[b].loss;
  EXPECT_THAT(words_of(result), Not(HasSubstr("disagree:")));
  lessons.truth.force(0, 0) += 9 * (*trial.sd)[0];  // 9 sds in one of seven: rms 3.4
  EXPECT_THAT(words_of(result), HasSubstr("by 3.4 of their sds (rms), most of all the proximal "
                                          "force under 10 N of FPL by 9.0. So they disagree:"));
}

// The table names what each file assumes.
TEST(ThumbRecoveryPage, AssumedIsWhatTheFilesAssume) {
  const Json page = measured_lessons_section(recovered());
  const Json& rows = block_of(page, "table", 2).at("rows");
  const auto assumed = [](const Json& row) { return row[row.size() - 2].get<std::string>(); };
  EXPECT_EQ(rows[1][0], "10 N of FPL: force, palmar [N]");
  EXPECT_EQ(assumed(rows[0]), "see its file");
  EXPECT_EQ(assumed(rows[3]), "sd, left");  // ulnar block
  EXPECT_EQ(assumed(rows[6]), "sd");        // radial block
}

// Sds of the draws are not those of a normal distribution: 1 sd to one side, 3 to the other.
TEST(ThumbRecoveryPage, TellsTheSkewOfTheWorstNumber) {
  ThumbRecovery recovery = recovered().recovery;
  recovery.numbers[4].drawn = {2, 0.5, 1.5, 3.5};
  recovery.agreement.worst_name = recovery.numbers[4].name;
  const std::string words = block_of(thumb_recovery_section(recovery), "text").at("text");
  EXPECT_THAT(words, HasSubstr("from 1.0 sds below their mean to 3.0 above it"));
  const std::string introduction = thumb_recovery_section(recovery).at("text");
  EXPECT_THAT(introduction, HasSubstr("In all 348 components of force and 720 activations."));
  EXPECT_THAT(introduction, HasSubstr("the priors of five_axis_skewed, not those of the default"));
  EXPECT_THAT(introduction, HasSubstr("9 muscles with constant moment arms and 5 skew axes"));
}

}  // namespace
}  // namespace thenar
