// Tests for posterior/study/thumb_study.cpp and thumb_case.cpp.

#include "posterior/study/thumb_study.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/posterior/study/study_inputs.h"

namespace thenar {
namespace {

ThumbStudySettings small_study() {
  ThumbStudySettings settings;
  settings.cases = {{false, Arms::kFixed, 0.02, 4, false}, {true, Arms::kFixed, 0.02, 4, false}};
  settings.draws = settings.warm_up = 300;
  settings.mode_starts = 4;
  settings.scored_draws = 20;
  return settings;
}

// Four postures and a good load cell tell skewed axes from orthogonal ones, by every measure.
TEST(ThumbStudy, SkewedAxesExplainASkewedThumbBetter) {
  const ThumbStudy study = study_thumb(sample::study_inputs(), small_study());
  ASSERT_TRUE(study.complete);
  ASSERT_EQ(study.cases.size(), 2U);
  const ThumbCase &orthogonal = study.cases[0], &skewed = study.cases[1];
  EXPECT_TRUE(skewed.converged());
  EXPECT_LT(skewed.direction, orthogonal.direction);
  EXPECT_LT(skewed.relative_error, orthogonal.relative_error);
  EXPECT_GT(skewed.left_out.elpd, orthogonal.left_out.elpd);
  EXPECT_EQ(study.by_truth.size(), 1U);
  EXPECT_EQ(skewed.learnt.size(), 20U);
  for (const LearntNumber& number : skewed.learnt) {
    ASSERT_TRUE(number.truth.has_value());
    EXPECT_LT(std::abs(number.mean - *number.truth), 5 * number.sd) << number.name;
  }
}

TEST(ThumbStudy, SameSeedSameBits) {
  ThumbStudySettings settings = small_study();
  settings.cases.resize(1);
  settings.retries = 0;
  const ThumbStudy a = study_thumb(sample::study_inputs(), settings),
                   b = study_thumb(sample::study_inputs(), settings);
  EXPECT_EQ(a.cases[0].run.draws.x, b.cases[0].run.draws.x);
  EXPECT_EQ(a.cases[0].tasks.direction, b.cases[0].tasks.direction);
}

// Stopped between cases, what was finished is kept, and marked.
TEST(ThumbStudy, StopKeepsFinishedCases) {
  ThumbStudySettings settings = small_study();
  settings.draws = settings.warm_up = 50;
  settings.retries = 0;
  bool stop = false;
  settings.progress.report = [&](double fraction, const std::string&) { stop = fraction > 0; };
  settings.progress.stop_requested = [&] { return stop; };
  const ThumbStudy study = study_thumb(sample::study_inputs(), settings);
  EXPECT_FALSE(study.complete);
  EXPECT_EQ(study.cases.size(), 1U);
}

}  // namespace
}  // namespace thenar
