// Tests for kinematics_fit/cross_validation.cpp: folds must not see what they predict.

#include "kinematics_fit/cross_validation.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar {
namespace {

const std::string kFreeAxes = R"(
[[parameter]]
match = "axis/*/direction/*"
state = "free"
)";

sample::FitSetup two_specimens() {
  sample::FitSetup setup = sample::middle_finger(kFreeAxes);
  setup.experiments.push_back(sample::experiment("H02"));
  return setup;
}

/// Which fold the test spoils, and what tells its trials from the others.
struct Spoilt {
  LeaveOut what;
  const char* fold;
};

bool belongs(const Spoilt& spoilt, const Experiment& experiment, const Trial& trial) {
  if (spoilt.what == LeaveOut::kPosture) return trial.posture == spoilt.fold;
  if (spoilt.what == LeaveOut::kTendon) return trial.tension.count(spoilt.fold) > 0;
  return experiment.specimen == spoilt.fold;
}

/// The same of a prediction; every trial here loads one tendon.
bool left_out_with(const Spoilt& spoilt, const Experiment& experiment,
                   const PredictedTrial& trial) {
  return belongs(spoilt, experiment, {trial.posture, {{trial.loads, 1.0}}, {}, {}, {}});
}

void PrintTo(const Spoilt& spoilt, std::ostream* out) { *out << spoilt.fold; }

class EveryFold : public testing::TestWithParam<Spoilt> {};

TEST_P(EveryFold, IsPredictedWithoutBeingSeen) {
  const sample::FitSetup clean = two_specimens();
  sample::FitSetup spoilt = clean;
  for (Experiment& experiment : spoilt.experiments)
    for (Trial& trial : experiment.trials)
      if (belongs(GetParam(), experiment, trial)) trial.force.array() += 3;  // [N]
  const CrossValidation before = cross_validate(clean.problem(), GetParam().what);
  const CrossValidation after = cross_validate(spoilt.problem(), GetParam().what);
  int same = 0, moved = 0;
  for (std::size_t e = 0; e < 2; ++e)
    for (std::size_t i = 0; i < before.experiments[e].trials.size(); ++i) {
      const PredictedTrial& a = before.experiments[e].trials[i];
      const PredictedTrial& b = after.experiments[e].trials[i];
      ASSERT_EQ(a.posture + a.loads, b.posture + b.loads);
      if (left_out_with(GetParam(), clean.experiments[e], a)) {
        EXPECT_EQ(a.predicted, b.predicted);  // to the last bit
        ++same;
      } else {
        moved += a.predicted != b.predicted ? 1 : 0;
      }
    }
  EXPECT_GT(same, 0);
  EXPECT_GT(moved, 0);  // others do see the spoilt fold
}

INSTANTIATE_TEST_SUITE_P(Folds, EveryFold,
                         testing::Values(Spoilt{LeaveOut::kPosture, "HyperExt"},
                                         Spoilt{LeaveOut::kTendon, "FDS"},
                                         Spoilt{LeaveOut::kSpecimen, "H02"}),
                         [](const auto& test) { return std::string(test.param.fold); });

TEST(CrossValidation, PredictsEveryTrialOnce) {
  const FitProblem problem = two_specimens().problem();
  for (const LeaveOut what : {LeaveOut::kPosture, LeaveOut::kTendon, LeaveOut::kSpecimen}) {
    const CrossValidation out = cross_validate(problem, what);
    EXPECT_EQ(out.experiments[0].trials.size(), 24U) << name_of(what);
    EXPECT_EQ(out.experiments[1].trials.size(), 24U) << name_of(what);
    EXPECT_EQ(out.not_converged, 0) << name_of(what);
  }
}

// What a start has seen stays seen, whatever is left out of the fit.
TEST(CrossValidation, MarksWhatTheStartHasSeen) {
  sample::FitSetup setup = two_specimens();
  setup.digit.calibrated_on = {{"synek2019_H02", "H02"}};
  const FitProblem problem = setup.problem();
  for (const LeaveOut what : {LeaveOut::kPosture, LeaveOut::kSpecimen}) {
    const CrossValidation out = cross_validate(problem, what);
    EXPECT_FALSE(out.experiments[0].calibrated_on_specimen) << name_of(what);
    EXPECT_TRUE(out.experiments[1].calibrated_on_specimen) << name_of(what);
  }
}

TEST(CrossValidation, NeedsTwoFolds) {
  const FitProblem problem = sample::middle_finger(kFreeAxes).problem();
  try {
    (void)cross_validate(problem, LeaveOut::kSpecimen);
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "to leave one specimen out, there must be two or more; there is only 'H01'");
  }
}

// The fold under way when the stop comes is left out: what stays is what a whole run gives too.
TEST(CrossValidation, InterruptedHoldsOnlyWholeFolds) {
  const FitProblem problem = sample::middle_finger(kFreeAxes).problem();
  const CrossValidation whole = cross_validate(problem, LeaveOut::kPosture);
  EXPECT_EQ(whole.folds_done, 4);
  EXPECT_EQ(whole.status, Status::kSolved);
  for (int patience = 0; patience < 40; patience += 3) {
    int asked = 0;
    SolveOptions options;
    options.progress.stop_requested = [&] { return ++asked > patience; };
    const CrossValidation part = cross_validate(problem, LeaveOut::kPosture, options);
    const Prediction& some = part.experiments[0];
    EXPECT_EQ(part.status == Status::kStopped, part.folds_done < 4);
    EXPECT_EQ(some.trials.size(), 6U * static_cast<std::size_t>(part.folds_done));
    EXPECT_EQ(some.error.trials, 6 * part.folds_done);
    for (std::size_t i = 0; i < some.trials.size(); ++i)
      EXPECT_EQ(some.trials[i].predicted, whole.experiments[0].trials[i].predicted);
  }
}

TEST(CrossValidation, GivesEveryLeftOutTrialAnInterval) {
  const FitProblem problem = two_specimens().problem();
  for (const LeaveOut what : {LeaveOut::kPosture, LeaveOut::kTendon, LeaveOut::kSpecimen}) {
    const CrossValidation out = cross_validate(problem, what);
    for (const Prediction& prediction : out.experiments) {
      EXPECT_TRUE(prediction.error.covered.has_value()) << name_of(what);
      for (const PredictedTrial& trial : prediction.trials) EXPECT_GT(trial.sd.minCoeff(), 0);
    }
  }
}

TEST(CrossValidation, StopsWhenAsked) {
  const FitProblem problem = sample::middle_finger(kFreeAxes).problem();
  SolveOptions options;
  options.progress.stop_requested = [] { return true; };
  EXPECT_TRUE(cross_validate(problem, LeaveOut::kPosture, options).experiments[0].trials.empty());
}

TEST(Subset, KeepsConstraintsAndRobustScale) {
  const sample::FitSetup setup = two_specimens();
  const FitProblem problem(setup.digit, setup.parameters, setup.experiments, 2,
                           {{"MCP3_FE", "PIP3", 0.04, 0.06}});
  const FitProblem rest = subset(problem, [](const Experiment& experiment, const Trial&) {
    return experiment.specimen == "H01";
  });
  EXPECT_EQ(rest.experiments().size(), 1U);
  EXPECT_EQ(rest.robust_scale(), 2);
  EXPECT_EQ(rest.axis_distances().size(), 1U);
}

// -- Errors, by hand --------------------------------------------------------------------------

TEST(ForceError, IsByHand) {
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  const ForceError error =
      force_error({{"a", "x", {3, 0, 4}, {3, 0, 1}, none}, {"b", "x", {0, 0, 5}, {0, 4, 5}, none}});
  EXPECT_DOUBLE_EQ(error.rms, std::sqrt((9.0 + 16.0) / 2));
  EXPECT_DOUBLE_EQ(error.relative, std::sqrt((9.0 + 16.0) / (25 + 25)));
  EXPECT_DOUBLE_EQ(error.relative_flexion, std::sqrt(16.0 / 9.0));
  EXPECT_FALSE(error.covered.has_value());  // unknown is not none
  EXPECT_EQ(error.trials, 2);
}

TEST(ForceError, CountsComponentsWithinTheInterval) {
  const Eigen::Vector3d sd(1, 1, 1);
  const ForceError error = force_error({{"a", "x", {1, 0, 0}, {2.9, 2.0, -1}, sd}});
  EXPECT_DOUBLE_EQ(error.covered.value(), 2.0 / 3);
}

// Angles 0 and 90 degrees, and a force of zero, which has no direction.
TEST(ForceError, MedianIsBetweenTheMiddleTwoAndSkipsWhatHasNoDirection) {
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  const ForceError error = force_error({{"a", "x", {1, 0, 0}, {2, 0, 0}, none},
                                        {"b", "x", {1, 0, 0}, {0, 3, 0}, none},
                                        {"c", "x", {1, 0, 0}, {0, 0, 0}, none}});
  EXPECT_DOUBLE_EQ(error.direction, 3.141592653589793 / 4);
}

TEST(ForceError, NeedsAForceToCompareWith) {
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  EXPECT_THROW((void)force_error({}), InputError);
  EXPECT_THROW((void)force_error({{"a", "x", none, {1, 0, 0}, none}}), InputError);
}

}  // namespace
}  // namespace thenar
