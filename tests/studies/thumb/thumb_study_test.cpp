// Tests for studies/thumb/thumb_study.cpp and thumb_fit.cpp.

#include "studies/thumb/thumb_study.h"

#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/studies/thumb/study_inputs.h"

namespace thenar {
namespace {

ThumbStudySettings small_study() {
  ThumbStudySettings settings;
  settings.fits = {{false, Arms::kFixed, 0.02, 4, 1, false},
                   {true, Arms::kFixed, 0.02, 4, 1, false}};
  settings.draws = settings.warm_up = 300;
  settings.mode_starts = 4;
  settings.scored_draws = 20;
  return settings;
}

// Four postures and a good load cell tell skewed axes from orthogonal ones, by every measure.
TEST(ThumbStudy, SkewedAxesExplainASkewedThumbBetter) {
  const ThumbStudy study = study_thumb(sample::study_inputs(), small_study());
  ASSERT_TRUE(study.complete);
  ASSERT_EQ(study.fits.size(), 2U);
  const ThumbFit &orthogonal = study.fits[0], &skewed = study.fits[1];
  EXPECT_TRUE(skewed.converged());
  EXPECT_LT(skewed.direction, orthogonal.direction);
  EXPECT_LT(skewed.relative_error, orthogonal.relative_error);
  EXPECT_GT(skewed.left_out.elpd, orthogonal.left_out.elpd);
  EXPECT_EQ(study.references.size(), 1U);
  EXPECT_EQ(skewed.learnt.size(), 20U);
  for (const LearntNumber& number : skewed.learnt) {
    ASSERT_TRUE(number.truth.has_value());
    EXPECT_LT(std::abs(number.mean - *number.truth), 5 * number.sd) << number.name;
  }

  // Axes that cross are of no type. Of the skewed ones every thumb is of one, before the forces and
  // after, and forces make the true one more probable.
  EXPECT_TRUE(orthogonal.types.empty());
  ASSERT_EQ(skewed.types.size(), 4U);
  double before = 0, after = 0;
  for (const TypeProbability& each : skewed.types) {
    before += each.prior;
    after += each.posterior;
  }
  EXPECT_NEAR(before, 1, 1e-12);
  EXPECT_NEAR(after, 1, 1e-12);
  const std::vector<AxisLine> axes =
      thumb_axes(study.criteria, study.truth.model, study.truth.names.hinges);
  const ThumbType truth = classify_thumb(study.criteria, axes);
  EXPECT_TRUE(truth.flexion_distal);
  for (const TypeProbability& each : skewed.types) {
    if (each.type.index() != truth.index()) continue;
    EXPECT_GT(each.posterior, each.prior);
  }
}

// Every fit of the study is told from every other.
TEST(ThumbStudy, FitsHaveNamesOfTheirOwn) {
  std::set<std::string> names;
  const ThumbStudySettings settings = full_thumb_study();
  for (const ThumbFitSettings& fit : settings.fits) names.insert(describe_fit(fit));
  EXPECT_EQ(names.size(), settings.fits.size());
}

// Moved towards the base, the abduction axis leaves flexion the distal one, and the other way
// round.
TEST(ThumbStudy, TypesOfTheModelAreThoseOfItsAxes) {
  ThumbStudySettings settings = small_study();
  settings.fits.clear();
  const ThumbStudy study = study_thumb(sample::study_inputs(), settings);
  const std::vector<std::string>& hinges = study.start.names.hinges;
  TendonModel<double> model = study.start.model;
  std::vector<AxisLine> axes = thumb_axes(study.criteria, model, hinges);
  ASSERT_EQ(axes.size(), 5U);
  for (std::size_t i = 0; i < axes.size(); ++i)
    EXPECT_EQ(axes[i].direction, model.tree[i].direction);
  // The abduction axis of MCP moved along the metacarpal either way.
  for (const double along : {-0.003, 0.003}) {
    const auto abduction = static_cast<std::size_t>(study.criteria.mcp_abduction);
    const auto flexion = static_cast<std::size_t>(study.criteria.mcp_flexion);
    model = study.start.model;
    model.tree[abduction].point += along * study.criteria.along[flexion];
    EXPECT_EQ(
        classify_thumb(study.criteria, thumb_axes(study.criteria, model, hinges)).flexion_distal,
        along < 0);
  }
  EXPECT_THROW((void)thumb_axes(study.criteria, model, {"CMC1_FE"}), InputError);
}

// Twice the skewness is twice every tilt's tangent and every shift.
TEST(ThumbStudy, SkewnessIsAMultipleOfThePublished) {
  ThumbStudySettings settings = small_study();
  settings.fits.clear();
  const ThumbStudy study = study_thumb(sample::study_inputs(), settings);
  const TendonDigit twice = true_thumb(study, 2);
  for (const Parameter& parameter : list_parameters(study.start)) {
    const auto once = true_value(parameter, study.start, study.truth);
    if (!once || parameter.name.rfind("axis/", 0) != 0) continue;
    EXPECT_NEAR(*true_value(parameter, study.start, twice), 2 * *once, 1e-14) << parameter.name;
  }
}

TEST(ThumbStudy, SameSeedSameBits) {
  ThumbStudySettings settings = small_study();
  settings.fits.resize(1);
  settings.retries = 0;
  const ThumbStudy a = study_thumb(sample::study_inputs(), settings),
                   b = study_thumb(sample::study_inputs(), settings);
  EXPECT_EQ(a.fits[0].run.draws.x, b.fits[0].run.draws.x);
  EXPECT_EQ(a.fits[0].tasks.direction, b.fits[0].tasks.direction);
}

// Stopped between fits, what was finished is kept, and marked.
TEST(ThumbStudy, StopKeepsFinishedCases) {
  ThumbStudySettings settings = small_study();
  settings.draws = settings.warm_up = 50;
  settings.retries = 0;
  bool stop = false;
  settings.progress.report = [&](double fraction, const std::string&) { stop = fraction > 0; };
  settings.progress.stop_requested = [&] { return stop; };
  const ThumbStudy study = study_thumb(sample::study_inputs(), settings);
  EXPECT_FALSE(study.complete);
  EXPECT_EQ(study.fits.size(), 1U);
}

}  // namespace
}  // namespace thenar
