// Tests for studies/pages/thumb_study.cpp.

#include "studies/pages/thumb_study.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

/// Both models at one noise and in one more posture, as short as can be.
const ThumbStudy& small_study() {
  static const ThumbStudy study = [] {
    ThumbStudySettings settings;
    settings.fits = {{false, Arms::kFixed, 0.1, 2, 1, false},
                     {true, Arms::kFixed, 0.1, 2, 1, false},
                     {true, Arms::kFixed, 0.1, 4, 1, false}};
    settings.draws = settings.warm_up = 60;
    settings.mode_starts = 2;
    settings.retries = 0;
    settings.scored_draws = 5;
    return study_thumb(thumb_study_inputs(THENAR_DATA_DIR), settings);
  }();
  return study;
}

TEST(ThumbStudyPage, TableHasTheReferencesAndEveryFit) {
  const Json table = thumb_comparison_table(small_study());
  ASSERT_EQ(table["rows"].size(), 5U);
  EXPECT_EQ(table["rows"][1][0], "the truth, 10 % noise");
  for (const Json& row : table["rows"]) EXPECT_EQ(row.size(), table["columns"].size());
}

// Four types of each of the two skewed fits; axes that cross are of none.
TEST(ThumbStudyPage, SkewedFitsHaveFourTypes) {
  const Json table = thumb_type_table(small_study());
  ASSERT_EQ(table["rows"].size(), 8U);
  for (std::size_t fit = 0; fit < 8; fit += 4) {
    double before = 0, after = 0;
    for (std::size_t k = fit; k < fit + 4; ++k) {
      EXPECT_EQ(table["rows"][k].size(), table["columns"].size());
      before += table["rows"][k][2].get<double>();
      after += table["rows"][k][3].get<double>();
    }
    EXPECT_NEAR(before, 100, 1e-9);
    EXPECT_NEAR(after, 100, 1e-9);
  }
  EXPECT_EQ(table["rows"][0][1], "MCP flexion axis distal, normal ulnar");
}

// elpd is compared with the orthogonal model on the same data alone.
TEST(ThumbStudyPage, GainIsOverTheRivalOnTheSameData) {
  const Json rows = thumb_comparison_table(small_study())["rows"];
  EXPECT_TRUE(rows[2][9].is_null());
  EXPECT_DOUBLE_EQ(
      rows[3][9],
      compare_elpd(small_study().fits[1].left_out, small_study().fits[0].left_out).elpd);
  EXPECT_TRUE(rows[4][9].is_null());  // no orthogonal fit in four postures
}

// Ten lines, tilts and shifts of five axes; each point the mean ratio of two numbers.
TEST(ThumbStudyPage, LearntChartIsTheMeanRatioOfSds) {
  const Json chart = learnt_chart(small_study(), Over::kPostures, Arms::kFixed);
  ASSERT_EQ(chart["series"].size(), 10U);
  EXPECT_EQ(chart["series"][0]["name"], "CMC1_FE direction");
  EXPECT_EQ(chart["series"][0]["x"], Json({2, 4}));
  const std::vector<LearntNumber>& learnt = small_study().fits[1].learnt;
  EXPECT_DOUBLE_EQ(chart["series"][0]["y"][0],
                   (learnt[0].sd / learnt[0].prior_sd + learnt[1].sd / learnt[1].prior_sd) / 2);
  EXPECT_TRUE(learnt_chart(small_study(), Over::kNoise, Arms::kFree)["series"].empty());
}

TEST(ThumbStudyPage, EveryFitHasItsModes) {
  EXPECT_GE(thumb_mode_table(small_study())["rows"].size(), 3U);
}

// Chains of 60 draws cannot agree to 1.01, and the page says so first of all.
TEST(ThumbStudyPage, SectionStartsWithWhatIsNotToBeReliedOn) {
  const Json section = thumb_study_section(small_study());
  const Json& banner = section["blocks"][0];
  EXPECT_EQ(banner["type"], "banner");
  EXPECT_EQ(banner["ok"], false);
  EXPECT_FALSE(banner["reasons"].empty());
}

}  // namespace
}  // namespace thenar
