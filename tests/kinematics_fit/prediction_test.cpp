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

/// What single postures have of their own.
const std::string kOfPostures = R"(
[[parameter]]
match = "angle/*/*"
state = "free"
sd_deg = 0
between_sd_deg = 4
[[parameter]]
match = "force/*/*/*"
state = "free"
sd = 0
between_sd = 0.04
)";

/// A little of everything that differs between people, mounts and postures.
const std::string kLively = R"(
[[parameter]]
match = "path/FD?/*/dorsal"
state = "free"
sd_mm = 0.5
between_sd_mm = 0.7
[[parameter]]
match = "gain/RI"
state = "free"
sd = 0.3
between_sd = 0.1
[[parameter]]
match = "sensor/*"
state = "free"
sd_deg = 0
between_sd_deg = 10
)" + kOfPostures;

// If the model is right, intervals hold what was left out 95 % of the time: of a new person, of a
// posture that has forces of its own beyond the geometry, and of loads that were never hung alone.
TEST(PredictExperiment, IntervalsCoverPeoplePosturesAndCombinedLoads) {
  FitSetup setup = middle_finger(kLively);
  setup.experiments.push_back(sample::experiment("H02"));
  constexpr double kNoise = 0.1;  // [N]
  constexpr int kDraws = 40;
  for (Experiment& experiment : setup.experiments) experiment.sd_floor = kNoise;
  std::mt19937 rng(23);
  struct Count {
    double sum = 0, squares = 0;
    void add(double covered) {
      sum += covered / kDraws;
      squares += covered * covered / kDraws;
    }
    /// Standard error of the mean; draws are independent, the components of one are not.
    [[nodiscard]] double error() const { return std::sqrt((squares - sum * sum) / kDraws); }
  } stranger, posture, combined;
  for (int draw = 0; draw < kDraws; ++draw) {
    // A population, two people of it, and a third; the first also under two loads at once.
    const VectorXd sd = population_sds(setup.parameters);
    const VectorXd population = sd.cwiseProduct(sample::normal(sd.size(), rng));
    Experiment unseen = setup.experiments[1], both = setup.experiments[0];
    for (std::size_t i = 0; i + 1 < both.trials.size(); ++i)
      if (both.trials[i].posture == both.trials[i + 1].posture)
        both.trials[i].tension.insert(both.trials[i + 1].tension.begin(),
                                      both.trials[i + 1].tension.end());
    const VectorXd first = draw_person(setup.parameters, population, rng);
    sample::simulate(setup, first, kNoise, rng, setup.experiments[0]);
    sample::simulate(setup, first, kNoise, rng, both);
    sample::simulate(setup, draw_person(setup.parameters, population, rng), kNoise, rng,
                     setup.experiments[1]);
    sample::simulate(setup, draw_person(setup.parameters, population, rng), kNoise, rng, unseen);

    const FitProblem problem = setup.problem();
    const auto predict = [&](const FitProblem& fitted, const Experiment& experiment, int who) {
      const Solution found = fit_precisely(fitted);
      return predict_experiment(fitted, found.z, posterior_covariance(fitted, found.z).C,
                                experiment, who);
    };
    stranger.add(predict(problem, unseen, kUnfittedSpecimen).error.covered.value());
    combined.add(predict(problem, both, 0).error.covered.value());
    // One posture left out.
    const std::string& left_out = unseen.postures.back().name;
    const FitProblem rest = subset(
        problem, [&](const Experiment&, const Trial& trial) { return trial.posture != left_out; });
    Prediction whole = predict(rest, setup.experiments[0], 0);
    std::vector<PredictedTrial> there;
    for (const PredictedTrial& trial : whole.trials)
      if (trial.posture == left_out) there.push_back(trial);
    posture.add(force_error(there).covered.value());
  }
  for (const Count* count : {&stranger, &posture, &combined}) {
    EXPECT_NEAR(count->sum, 0.95, 4 * count->error());
    EXPECT_LT(count->error(), 0.01);
  }
}

// A name is no knowledge: an unseen posture is as uncertain whatever it is called.
TEST(PredictExperiment, IntervalsDoNotDependOnNamesOfPostures) {
  FitSetup setup = middle_finger(kAxes + kOfPostures);
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

// A publication's subject has seen each of its specimens, those too whose names it does not list.
TEST(CalibratedOnASource, HasSeenEverySpecimenOfIt) {
  Experiment unnamed = sample::experiment("H02");
  unnamed.name = unnamed.specimen = "H99";
  EXPECT_TRUE(has_seen({{"", "", "Synek2019"}}, unnamed));
  EXPECT_FALSE(has_seen({{"", "", "An1979"}}, unnamed));
  unnamed.source = "";
  EXPECT_FALSE(has_seen({{"", "", "Synek2019"}}, unnamed));
}

// By hand: r = 0.3, 0 and -0.1 N of sds 0.1, 0.2 and 0.1 N; log sqrt(2 pi) = 0.918939.
TEST(ForceError, HasTheLogLossOfNormalErrors) {
  PredictedTrial trial;
  trial.measured = {1, 1, 1};
  trial.predicted = {1.3, 1, 0.9};
  trial.sd = {0.1, 0.2, 0.1};
  const double expected =
      0.918938533 + (2 * std::log(0.1) + std::log(0.2)) / 3 + (4.5 + 0 + 0.5) / 3;
  EXPECT_NEAR(force_error({trial}).log_loss.value(), expected, 1e-9);
  trial.sd.setZero();
  EXPECT_FALSE(force_error({trial}).log_loss.has_value());
}

TEST(PredictTrials, TellsWrongSizeFromNonsense) {
  const FitProblem problem = middle_finger(kAxes).problem();
  const auto refusal = [&](const VectorXd& z) -> std::string {
    try {
      (void)predict_trials(problem, z, 0);
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
