// Tests for kinematics_fit/model/experiment_plan.cpp: names become indices; warnings and refusals.

#include "kinematics_fit/model/experiment_plan.h"

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar {
namespace {

using sample::FitSetup;
using sample::kAxes;
using sample::kAxesAndPaths;
using sample::middle_finger;

/// Angles of all joints of the digit [rad] (coordinates).
Eigen::VectorXd posture_of(const TendonDigit& digit, const std::map<std::string, double>& angles) {
  return posture(digit.skeleton, angles);
}

// Every trial finds its posture, the tensions of its muscles, and its measured force.
TEST(ExperimentPlan, FindsPosturesMusclesAndForces) {
  const FitSetup setup = middle_finger(kAxes);
  const Experiment& experiment = setup.experiments.front();
  const ExperimentPlan plan = plan_experiment(setup.digit, setup.parameters, experiment);
  ASSERT_EQ(plan.force.cols(), static_cast<Eigen::Index>(experiment.trials.size()));
  for (std::size_t i = 0; i < experiment.trials.size(); ++i) {
    const Trial& trial = experiment.trials[i];
    const auto posture = static_cast<std::size_t>(plan.posture_of_trial[i]);
    EXPECT_EQ(plan.posture_names[posture], trial.posture);
    EXPECT_EQ(plan.postures[posture], posture_of(setup.digit, experiment.postures[posture].angles));
    double sum = 0;  // [N]
    for (const auto& [muscle, tension] : trial.tension) sum += tension;
    EXPECT_EQ(plan.tension[i].sum(), sum);
    EXPECT_EQ(Eigen::Vector3d(plan.force.col(static_cast<Eigen::Index>(i))), trial.force);
  }
}

// sd^2 = stated^2 + (misfit x sum of tensions)^2, of every component
TEST(ExperimentPlan, AddsWhatTheModelMissesToTheNoise) {
  FitSetup setup = middle_finger("misfit = 0.03\n" + kAxes);
  Experiment& experiment = setup.experiments.front();
  experiment.trials.resize(1);
  experiment.trials[0].tension = {{"FDS", 6}, {"FDP", 4}};
  experiment.trials[0].sd = Eigen::Vector3d(0.4, 0, 1.6);
  const ExperimentPlan plan = plan_experiment(setup.digit, setup.parameters, experiment);
  EXPECT_TRUE(plan.sd.isApprox(Eigen::Vector3d(0.5, 0.3, std::sqrt(2.65)), 1e-15)) << plan.sd;
}

// Of several loads at once alone: sd^2 = stated^2 + (superposition x sum of tensions)^2.
TEST(ExperimentPlan, AddsToTheNoiseOfLoadsThatDoNotAddUp) {
  FitSetup setup = middle_finger("superposition = 0.04\n" + kAxes);
  Experiment& experiment = setup.experiments.front();
  experiment.trials.resize(2);
  experiment.trials[0].tension = {{"FDS", 6}, {"FDP", 4}};
  experiment.trials[1].tension = {{"FDS", 10}, {"FDP", 0}};
  for (Trial& trial : experiment.trials) trial.sd = Eigen::Vector3d(0.3, 0.3, 0.3);
  const ExperimentPlan plan = plan_experiment(setup.digit, setup.parameters, experiment);
  EXPECT_TRUE(plan.sd.col(0).isApprox(Eigen::Vector3d(0.5, 0.5, 0.5), 1e-15)) << plan.sd;
  EXPECT_TRUE(plan.sd.col(1).isApprox(Eigen::Vector3d(0.3, 0.3, 0.3), 1e-15)) << plan.sd;
}

// Of loads unlike those of the fit: sd^2 = stated^2 + sum of (linearity t ln(t / nearest
// fitted))^2. The fit has seen 2 and 4 N of FDS and 5 N of FDP: 4 e N is a factor of e too much, 3
// N is nearer to 4 N by ratio, 5 / e N of FDP a factor of e too little; of UI it has seen nothing.
TEST(ExperimentPlan, AddsToTheNoiseOfLoadsUnlikeThoseFitted) {
  FitSetup setup = middle_finger("linearity = 0.02\n" + kAxes);
  Experiment& experiment = setup.experiments.front();
  experiment.trials.resize(3);
  experiment.trials[0].tension = {{"FDS", 2}};
  experiment.trials[1].tension = {{"FDS", 4}, {"UI", 0}};
  experiment.trials[2].tension = {{"FDP", 5}};
  const FitParameters parameters = setup.problem().parameters();
  EXPECT_EQ(parameters.fitted_tension.size(), 2U);
  const double e = std::exp(1.0);
  EXPECT_NEAR(missed_force_sd(parameters, {{"FDS", 4 * e}}), 0.02 * 4 * e, 1e-15);
  EXPECT_NEAR(missed_force_sd(parameters, {{"FDS", 3}}), 0.02 * 3 * std::log(4.0 / 3), 1e-15);
  EXPECT_EQ(missed_force_sd(parameters, {{"FDS", 4}, {"UI", 7}}), 0);
  EXPECT_NEAR(missed_force_sd(parameters, {{"FDS", 2 / e}, {"FDP", 5 / e}}),
              0.02 / e * std::hypot(2, 5), 1e-15);

  // In the plan of an experiment that is predicted, beside what was stated; none in the fit's own.
  experiment.trials.resize(1);
  experiment.trials[0].tension = {{"FDS", 4 * e}};
  experiment.trials[0].sd = Eigen::Vector3d(0.3, 0.3, 0.3);
  const ExperimentPlan plan = plan_experiment(setup.digit, parameters, experiment);
  const double sd = std::hypot(0.3, 0.08 * e);
  EXPECT_TRUE(plan.sd.isApprox(Eigen::Vector3d(sd, sd, sd), 1e-14)) << plan.sd;
  EXPECT_TRUE(setup.problem().plans()[0].sd.isApprox(Eigen::Vector3d(0.3, 0.3, 0.3), 1e-15));
}

TEST(ExperimentPlan, SaysThatMomentsAreNotFitted) {
  FitSetup setup = middle_finger(kAxesAndPaths);
  setup.digit.calibrated_on.clear();
  setup.experiments.front().trials[2].moment = Eigen::Vector3d(0.1, 0, 0);
  EXPECT_EQ(setup.problem().warnings(),
            std::vector<std::string>{"experiment 'synek2019_H01': 1 measured moments are not "
                                     "fitted, only the forces are"});
}

TEST(ExperimentPlan, SaysWhichAnglesAndTensionsNoFingerHas) {
  FitSetup setup = middle_finger(kAxesAndPaths);
  setup.digit.calibrated_on.clear();
  setup.experiments.front().postures[1].angles["PIP3"] = 300 * kDegree;
  setup.experiments.front().trials[0].tension = {{"FDS", 950.0}};
  EXPECT_EQ(setup.problem().warnings(),
            (std::vector<std::string>{
                "experiment 'synek2019_H01': posture 'MajorFlex': PIP3 = 300.0 deg is beyond -15.6 "
                ".. 96.2 deg",
                "experiment 'synek2019_H01': FDS was pulled with 950.0 N, but can make 189.0 N"}));
}

// 0.7 rad, read as 0.7 degrees; a file whose finger is straight throughout says nothing.
TEST(ExperimentPlan, SaysThatPosturesLookLikeRadians) {
  FitSetup setup = middle_finger(kAxesAndPaths);
  setup.digit.calibrated_on.clear();
  const auto told = [&](double factor) {
    FitSetup scaled = setup;
    for (PostureRecord& posture : scaled.experiments.front().postures)
      for (auto& [joint, angle] : posture.angles) angle *= factor;
    int count = 0;
    for (const std::string& warning : scaled.problem().warnings())
      count += warning.find("are the angles of the unit that their key names?") != warning.npos;
    return count;
  };
  EXPECT_EQ(told(1), 0);
  EXPECT_EQ(told(kDegree), 1);
}

// A fifth of a degree from straight at both joints: far from singular to rounding, and not to a
// goniometer.
TEST(ExperimentPlan, SaysWhichPosturesAreNearlyStraight) {
  FitSetup setup = middle_finger(kAxesAndPaths);
  setup.digit.calibrated_on.clear();
  auto& angles = setup.experiments.front().postures[1].angles;
  angles["PIP3"] = angles["DIP3"] = 0.2 * kDegree;
  const std::vector<std::string> warnings = setup.problem().warnings();
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("posture 'MajorFlex' is nearly singular (condition "),
            std::string::npos)
      << warnings[0];
}

TEST(ExperimentPlan, RefusesAnExperimentOfAnotherDigit) {
  FitSetup setup = middle_finger(kAxes);
  setup.experiments.front().digit = "index";
  try {
    (void)setup.problem();
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "experiment 'synek2019_H01' is of the index, but the digit built is the middle");
  }
}

TEST(ExperimentPlan, NamesTheMuscleThatTheDigitHasNot) {
  FitSetup setup = middle_finger(kAxes);
  setup.experiments.front().trials[0].tension = {{"FPL", 1.0}};
  try {
    (void)setup.problem();
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "no muscle 'FPL' pulls on this digit; there are EDC, FDP, FDS, RI, LU, UI");
  }
}

}  // namespace
}  // namespace thenar
