// Tests for kinematics_fit/fit.cpp and fit_file.cpp: a fit survives its file.

#include <cmath>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "kinematics_fit/fit_residuals.h"
#include "tests/data/mutated_arrays.h"
#include "tests/kinematics_fit/fit_samples.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

using testing::Contains;
using testing::HasSubstr;

FitInputs small_inputs() {
  FitInputs inputs = sample::finger_inputs("synek2019_middle", {"H01"});
  inputs.settings = {
      "few.toml",
      "source = 'Synek2019'\n[[parameter]]\nmatch = 'axis/*/direction/*'\nstate = 'free'\n"
      "[[axis_distance]]\njoints = ['MCP3_FE', 'PIP3']\nrange_mm = [40, 60]\n"};
  inputs.also_free = {"gain/LU"};
  return inputs;
}

class FitFile : public TemporaryFolder {
 protected:
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_))
      names.push_back(entry.path().filename().string());
    return names;
  }
};

TEST_F(FitFile, ReadsBackWhatWasWritten) {
  SolveOptions options;
  options.method = LeastSquaresMethod::kIpopt;
  options.seed = 5;
  Fit fit = run_fit(small_inputs(), options);
  EXPECT_TRUE(fit.run.arguments.empty());
  fit.run = {{"fit", "my H01.toml"}, "/work", "abc", "2001-09-09T01:46:40Z"};
  const std::string path = (folder_ / "fit.h5").string();
  write_fit(fit, path);
  const Fit back = read_fit(path);
  EXPECT_EQ(command_line(back.run), command_line(fit.run));
  EXPECT_EQ(back.run.folder + back.run.commit + back.run.date, "/workabc2001-09-09T01:46:40Z");
  EXPECT_EQ(back.solution.z, fit.solution.z);  // to the last bit
  EXPECT_EQ(predict_trials(back.problem, back.solution.z, 0),
            predict_trials(fit.problem, fit.solution.z, 0));
  EXPECT_EQ(back.solution.cost, fit.solution.cost);
  EXPECT_EQ(back.solution.status, fit.solution.status);
  EXPECT_EQ(back.solution.message, fit.solution.message);
  EXPECT_EQ(back.solution.evaluations, fit.solution.evaluations);
  EXPECT_EQ(back.method, LeastSquaresMethod::kIpopt);
  EXPECT_EQ(back.seed, 5U);
  EXPECT_EQ(back.covariance.C.shared, fit.covariance.C.shared);
  EXPECT_EQ(back.problem.coordinates().names(), fit.problem.coordinates().names());
  EXPECT_EQ(back.problem.axis_distances().size(), 1U);
  EXPECT_EQ(back.inputs.subject.text, fit.inputs.subject.text);
  EXPECT_EQ(back.inputs.also_free, fit.inputs.also_free);
  EXPECT_EQ(files(), std::vector<std::string>{"fit.h5"});
}

// A fit says what it was fitted to, and what its start was calibrated on.
TEST_F(FitFile, CarriesWhatItHasSeen) {
  FitInputs inputs = small_inputs();
  inputs.experiments = {sample::source("experiments/synek2019_H02")};
  const std::string path = (folder_ / "fit.h5").string();
  write_fit(run_fit(inputs), path);
  const ResultFile file = read_result(path);
  EXPECT_EQ(file.list("fit/calibrated_on/experiment"), std::vector<std::string>{"synek2019_H02"});
  EXPECT_EQ(file.list("fit/calibrated_on/specimen"), std::vector<std::string>{"H02"});
  EXPECT_EQ(file.list("fit/calibrated_on/source"), std::vector<std::string>{"Synek2019"});
  const Fit back = read_fit(path);
  const Experiment stranger = sample::experiment("B01");
  EXPECT_TRUE(predict_experiment(back.problem, back.solution.z, back.covariance.C, stranger, -1)
                  .calibrated_on_specimen);
}

TEST_F(FitFile, LeavesNothingBehindWhereItCannotWrite) {
  const Fit fit = run_fit(small_inputs());
  std::ofstream(folder_ / "file") << "in the way";
  EXPECT_THROW(write_fit(fit, (folder_ / "file" / "fit.h5").string()), InputError);
  fs::remove(folder_ / "file");
  fs::create_directories(folder_ / "taken" / "by a folder");
  EXPECT_THROW(write_fit(fit, (folder_ / "taken").string()), InputError);
  EXPECT_EQ(files(), std::vector<std::string>{"taken"});
}

TEST_F(FitFile, RefusesWhatIsNotAFit) {
  ResultFile other;
  other.add("format", std::string("thenar grasp 1"));
  const std::string path = (folder_ / "other.h5").string();
  write_result(other, path);
  try {
    (void)read_fit(path);
    FAIL() << "expected DataError";
  } catch (const DataError& e) {
    EXPECT_EQ(e.what(), path + ":1: wanted a 'thenar fit 1' file");
  }
}

// No array may reach the reader in another shape, or with numbers that it cannot be asked for.
TEST_F(FitFile, IsRefusedWithAnyArrayChanged) {
  const std::string path = (folder_ / "fit.h5").string();
  write_fit(run_fit(small_inputs()), path);
  const MutationVerdicts verdicts = verdicts_on_mutations(
      read_result(path), path, [](const std::string& file) { (void)read_fit(file); });
  EXPECT_GE(verdicts.size(), kMinMutations);
  // What may be absent is not missed, and says nothing that is asked for.
  EXPECT_EQ(read_all_the_same(verdicts),
            (MutationVerdicts{"predictions/synek2019_H01/start_has_seen_specimen missing"}));
  EXPECT_THAT(verdicts, Contains(HasSubstr("fit.h5:1: 'fit/z': wanted ")));
}

/// What read_fit() says of a fit whose file was changed.
std::string refusal(const std::string& path, const ResultFile& file) {
  write_result(file, path);
  try {
    (void)read_fit(path);
  } catch (const DataError& e) {
    return e.what();
  }
  return "";
}

TEST_F(FitFile, RefusesWhatWasTamperedWith) {
  const std::string path = (folder_ / "fit.h5").string();
  write_fit(run_fit(small_inputs()), path);
  const ResultFile good = read_result(path);
  EXPECT_EQ(refusal(path, good), "");

  ResultFile bad = good;
  bad.arrays.erase("fit/cost");
  EXPECT_EQ(refusal(path, bad).find(path + ":1: "), 0U);

  bad = good;
  bad.arrays.at("fit/z").values[0] = std::nan("");
  EXPECT_EQ(refusal(path, bad), path + ":1: 'fit/z': it has numbers that are not finite");

  bad = good;
  bad.texts.at("fit/name")[0] = "gain/FDP";
  EXPECT_EQ(refusal(path, bad), path +
                                    ":1: coordinate 0 of the fit is 'gain/FDP', its inputs give "
                                    "'axis/MCP3_FE/direction/1'");
}

TEST_F(FitFile, AStoppedFitIsStillAFit) {
  SolveOptions options;
  int asked = 0;
  options.progress.stop_requested = [&] { return ++asked > 1; };
  const Fit fit = run_fit(small_inputs(), options);
  EXPECT_EQ(fit.solution.status, Status::kStopped);
  const std::string path = (folder_ / "fit.h5").string();
  write_fit(fit, path);
  EXPECT_EQ(read_fit(path).solution.status, Status::kStopped);
}

TEST(BuildProblem, RefusesTheSameExperimentTwice) {
  FitInputs inputs = small_inputs();
  inputs.experiments.push_back(inputs.experiments.front());
  try {
    (void)build_problem(inputs);
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "experiment 'synek2019_H01' is given twice: it would count twice");
  }
}

// One specimen: its own value is the whole estimate; the population keeps the share that prior
// variances give it, and an sd that can never be less than what one specimen leaves unsaid.
TEST(FittedValues, OfOneSpecimenAndOfItsPopulation) {
  FitInputs inputs = small_inputs();
  inputs.settings = {"tilt.toml",
                     "source = 'Synek2019'\n[[parameter]]\nmatch = 'axis/PIP3/direction/1'\n"
                     "state = 'free'\nsd_deg = 3\nbetween_sd_deg = 4\n"};
  inputs.also_free = {};
  const Fit fit = run_fit(inputs);
  const FittedValues own = fitted_values(fit, 0), population = fitted_values(fit, -1);
  const auto p = fit.problem.parameters().leader.front();
  const double share = 9.0 / 25.0;                         // 3^2 / (3^2 + 4^2)
  EXPECT_NEAR(own.value[p], 5 * fit.solution.z[0], 1e-9);  // prior sd of the sum: 5 deg
  EXPECT_NEAR(population.value[p], share * own.value[p], 1e-9);
  EXPECT_NEAR(population.sd[p], std::hypot(share * own.sd[p], 5 * std::sqrt(share * (1 - share))),
              1e-9);
}

TEST(BuildProblem, RefusesToMixDigits) {
  FitInputs inputs = sample::finger_inputs("synek2019_middle", {"H01", "H02"});
  std::string& text = inputs.experiments[1].text;
  const std::string digit = "digit = \"middle\"";
  text.replace(text.find(digit), digit.size(), "digit = \"index\"");
  try {
    (void)build_problem(inputs);
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "experiments are of different digits: 'synek2019_H01' of the middle, "
                 "'synek2019_H02' of the index");
  }
}

TEST(BuiltInSettings, AreThoseOfTheDigit) {
  EXPECT_EQ(built_in_settings("middle").text, sample::source("fits/finger").text);
  EXPECT_EQ(built_in_settings("thumb").text, sample::source("fits/thumb").text);
}

// Secants over blocks against Levenberg and Marquardt's steps, which Ceres alone takes where
// evaluations are counted.
TEST(Fit, OfSeveralSpecimensIsTheMinimumThatCeresFinds) {
  const FitProblem problem = sample::noisy_copies(3);
  const LeastSquares blocks = least_squares(problem);
  ASSERT_EQ(blocks.layout.blocks, 3);
  const Eigen::VectorXd start = Eigen::VectorXd::Zero(problem.size());
  SolveOptions options;
  options.tolerance = 1e-12;
  const Solution ours = solve(blocks, start, options);
  options.max_evaluations = 1000;
  const Solution ceres = solve(blocks, start, options);
  ASSERT_EQ(ceres.status, Status::kSolved);
  EXPECT_EQ(ours.status, Status::kSolved);
  EXPECT_NEAR(ours.cost, ceres.cost, 1e-7 * ceres.cost);
  EXPECT_LT(ours.evaluations, ceres.evaluations);
}

TEST(Fit, OfManySpecimensConverges) {
  const FitProblem problem = sample::noisy_copies(24);
  const Solution found = solve(least_squares(problem), Eigen::VectorXd::Zero(problem.size()));
  EXPECT_EQ(found.status, Status::kSolved);
  EXPECT_LT(found.newton_step, 0.01);
}

// The second specimen has one row of activations alone: three components and a width.
TEST(Fit, TakesAnExperimentWithoutTrials) {
  FitInputs inputs = sample::finger_inputs("an_chao_middle", {"H01", "H02"});
  std::string& text = inputs.experiments[1].text;
  text = text.substr(0, text.find("[trials]")) +
         "[[activation]]\nposture = 'MinorFlex'\nactivation = {FDS = 0.2}\n"
         "activation_sd = 0.1\nforce_N = [-1, -1, 0]\n";
  const FitProblem problem = build_problem(inputs);
  ASSERT_EQ(problem.plans()[1].force.cols(), 0);
  const Residuals row =
      data_residuals(problem, Eigen::VectorXd::Zero(problem.size()), 1, WithJacobian::kYes);
  EXPECT_EQ(row.r.size(), 4);
  EXPECT_EQ(row.J.rows(), 4);
  EXPECT_EQ(force_rows(problem, 1), 3);
  EXPECT_EQ(run_fit(inputs, {}).solution.status, Status::kSolved);
}

}  // namespace
}  // namespace thenar
