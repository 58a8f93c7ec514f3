// Tests for kinematics_fit/prediction.cpp: predicted forces and their intervals.

#include "kinematics_fit/prediction.h"

#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::VectorXd;
using sample::draw_person;
using sample::fit_precisely;
using sample::FitSetup;
using sample::kAxes;
using sample::middle_finger;
using sample::population_sds;

// Unseen people drawn from the prior lie within the 95 % intervals 95 % of the time.
TEST(PredictExperiment, IntervalsCoverNewPeople) {
  FitSetup setup = middle_finger(kAxes);
  setup.experiments.push_back(sample::experiment("H02"));
  constexpr double kNoise = 0.05;  // [N]
  constexpr int kDraws = 60;
  for (Experiment& experiment : setup.experiments) experiment.sd_floor = kNoise;
  Experiment unseen = setup.experiments.front();
  std::mt19937 rng(17);
  double covered = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    const VectorXd sd = population_sds(setup.parameters);
    const VectorXd population = sd.cwiseProduct(sample::normal(sd.size(), rng));
    for (Experiment& experiment : setup.experiments)
      sample::simulate(setup, draw_person(setup.parameters, population, rng), kNoise, rng,
                       experiment);
    sample::simulate(setup, draw_person(setup.parameters, population, rng), kNoise, rng, unseen);
    const FitProblem problem = setup.problem();
    const Solution found = fit_precisely(problem);
    const ArrowMatrix C = posterior_covariance(problem, found.z).C;
    covered += predict_experiment(problem, found.z, C, unseen, -1).error.covered.value() / kDraws;
  }
  // One person's 72 components hang on 8 numbers: 60 x 8 trials of p = 0.95, four deviations.
  EXPECT_NEAR(covered, 0.95, 4 * std::sqrt(0.95 * 0.05 / (kDraws * 8)));
}

// A name is no knowledge: an unseen posture is as uncertain whatever it is called.
TEST(PredictExperiment, IntervalsDoNotDependOnNamesOfPostures) {
  FitSetup setup = middle_finger(kAxes + R"(
[[parameter]]
match = "angle/*/*"
state = "free"
sd_deg = 0
between_sd_deg = 4
)");
  const FitProblem problem = setup.problem();
  const Solution found = fit_precisely(problem);
  const ArrowMatrix C = posterior_covariance(problem, found.z).C;
  Experiment unseen = sample::experiment("H02");
  const Prediction named = predict_experiment(problem, found.z, C, unseen, -1);
  for (PostureRecord& posture : unseen.postures) posture.name += "'";
  for (Trial& trial : unseen.trials) trial.posture += "'";
  const Prediction renamed = predict_experiment(problem, found.z, C, unseen, -1);
  for (std::size_t i = 0; i < named.trials.size(); ++i) {
    EXPECT_TRUE(matrix_near(renamed.trials[i].predicted, named.trials[i].predicted, 1e-12));
    EXPECT_TRUE(matrix_near(renamed.trials[i].sd, named.trials[i].sd, 1e-12));
  }
}

// Another experiment on a specimen that was seen counts, and so does a seen one renamed within.
TEST(PredictExperiment, MarksPredictionsOfSpecimensItsSubjectHasSeen) {
  FitSetup setup = middle_finger(kAxes);
  setup.digit.calibrated_on = {{"others_H02", "H02"}};
  const FitProblem problem = setup.problem();
  const Eigen::VectorXd z = Eigen::VectorXd::Zero(problem.size());
  ArrowMatrix C({problem.size()});
  C.shared.setIdentity();
  Experiment other = sample::experiment("H02");
  const auto marked = [&] {
    return predict_experiment(problem, z, C, other, -1).calibrated_on_specimen;
  };
  EXPECT_TRUE(marked());
  other.specimen = "somebody";
  EXPECT_FALSE(marked());
  other.name = "others_H02";
  EXPECT_TRUE(marked());
  EXPECT_FALSE(predict_fitted(problem, z, 0).calibrated_on_specimen);  // H01
}

TEST(PredictTrials, TellsWrongSizeFromNonsense) {
  const FitProblem problem = middle_finger(kAxes).problem();
  const auto refusal = [&](const VectorXd& z) -> std::string {
    try {
      (void)predict_trials(problem, z, 0, WithJacobian::kNo);
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(VectorXd::Zero(3)), "fit has 8 coordinates, got 3");
  EXPECT_EQ(refusal(VectorXd::Constant(8, std::nan(""))), "coordinates of a fit must be finite");
}

}  // namespace
}  // namespace thenar
