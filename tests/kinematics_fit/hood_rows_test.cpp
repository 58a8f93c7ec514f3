// Tests for kinematics_fit/hood_rows.cpp.

#include "kinematics_fit/hood_rows.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/kinematics_fit/fit_samples.h"

namespace thenar {
namespace {

PredictedTrial trial(const std::string& loads, const Eigen::Vector3d& measured,
                     const Eigen::Vector3d& predicted) {
  return {"Hook", loads, measured, predicted, Eigen::Vector3d::Zero()};
}

// Two trials of 3 N and 4 N, off by 1 N each: sqrt(1 + 1) / sqrt(9 + 16); EDC alone 1 / 3.
TEST(HoodRows, CountTrialsUnderOneMuscleOfTheHoodAlone) {
  Prediction prediction;
  prediction.trials = {trial("EDC", {3, 0, 0}, {3, 1, 0}), trial("FDP", {9, 0, 0}, {0, 0, 0}),
                       trial("EDC+UI", {5, 0, 0}, {0, 0, 0}), trial("UI", {0, 4, 0}, {0, 4, -1})};
  const std::optional<HoodRowErrors> errors = hood_row_errors(prediction, {"UI", "EDC", "LU"});
  ASSERT_TRUE(errors.has_value());
  EXPECT_EQ(errors->total.trials, 2);
  EXPECT_NEAR(errors->total.relative, std::sqrt(2.0) / 5, 1e-15);
  ASSERT_EQ(errors->muscles.size(), 2U);
  EXPECT_EQ(errors->muscles[0].muscle, "EDC");
  EXPECT_NEAR(errors->muscles[0].error.relative, 1.0 / 3, 1e-15);
  EXPECT_NEAR(errors->muscles[1].error.relative, 1.0 / 4, 1e-15);
}

TEST(HoodRows, AreNoneWithoutAMeasuredForce) {
  Prediction prediction;
  prediction.trials = {trial("EDC", {0, 0, 0}, {1, 0, 0}), trial("FDP", {9, 0, 0}, {0, 0, 0})};
  EXPECT_FALSE(hood_row_errors(prediction, {"EDC"}).has_value());
  EXPECT_FALSE(hood_row_errors(prediction, {}).has_value());
}

// The subject's rule has EDC, RI, LU and UI, and a net has the same muscles pull.
TEST(HoodRows, AreOfTheSameMusclesWithANetAndWithFractions) {
  FitInputs inputs = sample::finger_inputs("an_chao_middle", {"H01"});
  const std::vector<std::string> with_fractions = hood_muscles(build_problem(inputs).digit());
  inputs.net = sample::source("nets/extensor_hood");
  EXPECT_EQ(hood_muscles(build_problem(inputs).digit()), with_fractions);
  EXPECT_EQ(with_fractions, (std::vector<std::string>{"EDC", "RI", "LU", "UI"}));
}

// 1 - 0.6^2 = 0.64, and 1 - 0.8^2 = 0.36.
TEST(HoodRows, CountWhatAFitSpendsOnTheHood) {
  Covariance covariance;
  covariance.learnt = {{"hood/UI/central", 0, 0.6, 0, false},
                       {"H01: net/UI/slope", 0, 0.8, 0, false},
                       {"path/UI/1/dorsal", 0, 0.1, 0, false},
                       {"H01: gain/UI", 0, 0.1, 0, false}};
  const HoodCount count = count_hood(covariance);
  EXPECT_EQ(count.entries, 2);
  EXPECT_NEAR(count.effective, 1.0, 1e-15);
}

}  // namespace
}  // namespace thenar
