// Tests for kinematics_fit/choose_settings.cpp: against every neighbour, and blind to what a fold
// leaves out.

#include "kinematics_fit/choose_settings.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar {
namespace {

const std::string kRows = sample::kAxesAndPaths + R"(
[[choose]]
name = "tilts of axes"
match = ["axis/*/direction/*"]
sd_factor = [0.01, 1, 4]
[[choose]]
name = "what the model misses"
misfit = [0, 0.02, 0.3]
[[choose]]
name = "paths between people"
match = ["path/*", "arm/*"]
between_sd_mm = [0.2, 3]
)";

/// The published finger on some specimens, and the settings above.
struct ChoiceScene {
  explicit ChoiceScene(const std::vector<std::string>& specimens)
      : setup(sample::middle_finger(kRows, specimens.front())) {
    for (std::size_t i = 1; i < specimens.size(); ++i)
      setup.experiments.push_back(sample::experiment(specimens[i]));
  }
  sample::FitSetup setup;
  FitSettings settings = sample::settings(kRows);
};

/// Mean over experiments and kinds of folds of the left-out log loss and log relative error, by
/// plain loops.
double left_out_loss(const FitProblem& problem, const std::vector<LeaveOut>& by) {
  double sum = 0;
  int count = 0;
  for (const LeaveOut what : by) {
    const CrossValidation validation = cross_validate(problem, what);
    for (const Prediction& prediction : validation.experiments) {
      double loss = 0, missed = 0, measured = 0;
      for (const PredictedTrial& t : prediction.trials)
        for (int c = 0; c < 3; ++c)
          loss += 0.5 * std::log(2 * M_PI * t.sd[c] * t.sd[c]) +
                  0.5 * std::pow((t.predicted[c] - t.measured[c]) / t.sd[c], 2);
      for (const PredictedTrial& t : prediction.trials) {
        missed += (t.predicted - t.measured).squaredNorm();
        measured += t.measured.squaredNorm();
      }
      sum += loss / (3.0 * static_cast<double>(prediction.trials.size())) +
             0.5 * std::log(missed / measured);
      ++count;
    }
  }
  return sum / count;
}

FitProblem problem_with(const ChoiceScene& scene, const FitSettings& settings) {
  FitParameters parameters =
      choose_parameters(scene.setup.digit, scene.setup.parameters.postures, settings);
  return {scene.setup.digit, std::move(parameters), scene.setup.experiments};
}

/// No other value of any one choice has a smaller loss.
void expect_best_of_neighbours(const ChoiceScene& scene, const std::vector<LeaveOut>& by) {
  const ChosenSettings found = choose_settings(scene.setup.problem(), scene.settings);
  EXPECT_EQ(found.by, by);
  EXPECT_EQ(found.status, Status::kSolved);
  const double best = left_out_loss(problem_with(scene, found.settings), by);
  EXPECT_NEAR(best, found.loss, 1e-12);
  int worse = 0;
  for (std::size_t at = 0; at < found.settings.choices.size(); ++at)
    for (std::size_t value = 0; value < found.settings.choices[at].values.size(); ++value) {
      FitSettings other = found.settings;
      set_choice(other, at, value);
      const double loss = left_out_loss(problem_with(scene, other), by);
      EXPECT_GE(loss, best - 1.001e-3) << at << ' ' << value;
      worse += loss > best + 0.01 ? 1 : 0;
    }
  EXPECT_GT(worse, 0);  // the choice matters
}

TEST(ChooseSettings, HasNoBetterNeighbourByPostures) {
  expect_best_of_neighbours(ChoiceScene({"H01"}), {LeaveOut::kPosture});
}

TEST(ChooseSettings, HasNoBetterNeighbourBySpecimensToo) {
  expect_best_of_neighbours(ChoiceScene({"H01", "H02"}), {LeaveOut::kPosture, LeaveOut::kSpecimen});
}

TEST(ChooseSettings, TriesEachSettingOnce) {
  const ChoiceScene scene({"H01"});
  const ChosenSettings found = choose_settings(scene.setup.problem(), scene.settings);
  EXPECT_EQ(found.tried.front().chosen, (std::vector<std::size_t>{0, 0, 0}));
  for (std::size_t i = 0; i < found.tried.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(found.tried[i].chosen, found.tried[j].chosen);
}

// The forces of the specimen that a fold leaves out say nothing to it.
TEST(ValidateChoice, IsBlindToWhatAFoldLeavesOut) {
  ChoiceScene scene({"H01", "H02"});
  const auto validate = [&] {
    return validate_choice(scene.setup.problem(), scene.settings, {}, LeaveOut::kSpecimen);
  };
  const NestedValidation before = validate();
  ASSERT_EQ(before.folds.size(), 2U);
  EXPECT_EQ(before.folds[1].fold, "H02");
  for (Trial& trial : scene.setup.experiments[1].trials) trial.force *= -3;
  const NestedValidation after = validate();
  const std::vector<PredictedTrial>& of = before.validation.experiments[1].trials;
  for (std::size_t i = 0; i < of.size(); ++i)
    EXPECT_EQ(after.validation.experiments[1].trials[i].predicted, of[i].predicted);
  EXPECT_EQ(after.folds[1].settings.loss, before.folds[1].settings.loss);
  EXPECT_NE(after.folds[0].settings.loss, before.folds[0].settings.loss);
}

TEST(ChooseSettings, StopsWithTheBestOfThoseTried) {
  const ChoiceScene scene({"H01"});
  int asked = 0, most = 1 << 30;
  SolveOptions options;
  options.progress.stop_requested = [&] { return ++asked > most; };
  const auto choose = [&] {
    return choose_settings(scene.setup.problem(), scene.settings, {}, options);
  };
  const ChosenSettings all = choose();
  EXPECT_EQ(all.status, Status::kSolved);
  // The same search, stopped half-way.
  most = asked / 2;
  asked = 0;
  const ChosenSettings found = choose();
  EXPECT_EQ(found.status, Status::kStopped);
  ASSERT_FALSE(found.tried.empty());
  EXPECT_LT(found.tried.size(), all.tried.size());
  for (const TriedSettings& one : found.tried) EXPECT_GE(one.loss, found.loss - 1e-3);
}

TEST(ChooseSettings, WantsSomethingToChoose) {
  const ChoiceScene scene({"H01"});
  EXPECT_THROW((void)choose_settings(scene.setup.problem(), sample::settings(sample::kAxes)),
               InputError);
}

}  // namespace
}  // namespace thenar
