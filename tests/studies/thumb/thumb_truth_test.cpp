// Tests for studies/thumb/thumb_truth.cpp and the thumbs and settings that the study is made of.

#include "studies/thumb/thumb_truth.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "base/spatial.h"
#include "kinematics_fit/fit.h"
#include "kinematics_fit/fit_residuals.h"
#include "kinematics_fit/force_jacobian.h"
#include "kinematics_fit/prediction.h"
#include "tendons/neighbouring_axes.h"
#include "tests/matrix_near.h"
#include "tests/studies/thumb/study_inputs.h"

namespace thenar {
namespace {

/// Hinges of the thumb in joint order: CMC flexion and abduction, MCP flexion and abduction, IP.
enum ThumbJoint { kCmcFlexion, kCmcAbduction, kMcpFlexion, kMcpAbduction, kIp };

FitParameters parameters_of(const TendonDigit& digit, const SourceText& settings) {
  return choose_parameters(digit, {}, parse_fit_settings(settings.text, settings.path));
}

/// The start with its free coordinates at u [SI].
TendonModel<double> moved_thumb(const TendonDigit& start, const FitParameters& parameters,
                                const Eigen::VectorXd& u) {
  return specimen_model(start, parameters, parameter_values<double>(parameters, u)).digit;
}

// [McFarland2023] by way of its axes: the common normal of the CMC axes is 9.13 mm, their angle
// 80.9 degrees.
TEST(ThumbStudySubjects, TrueThumbHasThePublishedSkewness) {
  const TendonDigit truth = sample::thumb_of(sample::study_inputs().truth);
  const AxisOffset cmc = axis_offset(truth.model, {kCmcFlexion, kCmcAbduction, ""});
  EXPECT_NEAR(1e3 * cmc.distance, 9.13, 0.005);
  EXPECT_NEAR(degrees(cmc.angle), 80.9, 0.05);
  const AxisOffset mcp = axis_offset(truth.model, {kMcpFlexion, kMcpAbduction, ""});
  EXPECT_GT(mcp.distance, 1e-3);
}

// [Hollister1995]: from the metacarpal's base the flexion axis is at 0.87 of its length, the
// abduction axis at 0.83: nearer to the base.
TEST(ThumbStudySubjects, TrueThumbHasTheOrderOfHollister) {
  const TendonDigit truth = sample::thumb_of(sample::study_inputs().truth);
  EXPECT_LT(axis_offset(truth.model, {kMcpFlexion, kMcpAbduction, ""}).beyond, -1e-3);
}

TEST(ThumbStudySubjects, StartIsOrthogonalAndCrosses) {
  const TendonDigit start = sample::thumb_of(sample::study_inputs().start);
  for (const auto& [flexion, abduction] :
       {std::pair{kCmcFlexion, kCmcAbduction}, std::pair{kMcpFlexion, kMcpAbduction}}) {
    const AxisOffset gap = axis_offset(start.model, {flexion, abduction, ""});
    EXPECT_NEAR(gap.angle, kPi / 2, 1e-15);
    EXPECT_NEAR(gap.distance, 0, 1e-15);
  }
}

// The ties of data/fits/five_axis_orthogonal.toml keep pairs square and crossing wherever they go.
TEST(ThumbStudySubjects, TiesKeepPairsOrthogonalAndCrossing) {
  const ThumbStudyInputs inputs = sample::study_inputs();
  const TendonDigit start = sample::thumb_of(inputs.start);
  const FitParameters parameters = parameters_of(start, inputs.orthogonal);
  EXPECT_EQ(parameters.coordinates(), 14);
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> far(-1, 1);
  for (int trial = 0; trial < 20; ++trial) {
    Eigen::VectorXd u(parameters.coordinates());
    for (Eigen::Index c = 0; c < u.size(); ++c)
      u[c] = 3 * parameters.all[parameters.leader[c]].sd * far(rng);  // up to 45 deg, 15 mm
    const TendonModel<double> model = moved_thumb(start, parameters, u);
    for (const auto& [flexion, abduction] :
         {std::pair{kCmcFlexion, kCmcAbduction}, std::pair{kMcpFlexion, kMcpAbduction}}) {
      const AxisOffset gap = axis_offset(model, {flexion, abduction, ""});
      EXPECT_NEAR(gap.angle, kPi / 2, 1e-14);
      EXPECT_NEAR(gap.distance, 0, 1e-16);  // [m]
      EXPECT_GT((model.tree[flexion].point - start.model.tree[flexion].point).norm(), 1e-4);
    }
  }
}

// Pairs may turn, so the test above is not of axes that stand still.
TEST(ThumbStudySubjects, OrthogonalPairsTurnAsWholes) {
  const ThumbStudyInputs inputs = sample::study_inputs();
  const TendonDigit start = sample::thumb_of(inputs.start);
  const FitParameters parameters = parameters_of(start, inputs.orthogonal);
  for (const char* name : {"axis/CMC1_FE/direction/1", "axis/CMC1_FE/direction/2",
                           "axis/MCP1_AA/direction/1", "axis/MCP1_FE/direction/2"}) {
    const auto leader = std::find_if(parameters.leader.begin(), parameters.leader.end(),
                                     [&](int p) { return parameters.all[p].name == name; });
    ASSERT_NE(leader, parameters.leader.end()) << name;
    const Eigen::VectorXd u =
        0.3 * Eigen::VectorXd::Unit(parameters.coordinates(), leader - parameters.leader.begin());
    const TendonModel<double> model = moved_thumb(start, parameters, u);
    double most = 0;
    for (std::size_t i = 0; i < model.tree.size(); ++i)
      most = std::max(
          most, axis_offset(model.tree[i], start.model.tree[i], Eigen::Vector3d::UnitX()).angle);
    EXPECT_NEAR(most, std::atan(0.3), 1e-12) << name;
  }
}

// Another frame is another way to write the same thumb.
TEST(ThumbTruth, MakesTheSameForcesInAnotherFrame) {
  const ThumbStudyInputs inputs = sample::study_inputs();
  const TendonDigit published = sample::thumb_of(inputs.truth);
  const Experiment pulls = simulate_pulls(published, {4, 10, 0.1, 0.01, false, 1});
  EXPECT_TRUE(matrix_near(true_forces(sample::true_thumb(inputs), pulls),
                          true_forces(published, pulls), 1e-4));  // [N]; tip axes have 6 decimals
}

// The true thumb is one of the skewed thumbs: its axes are where true_value() says.
TEST(ThumbTruth, SkewedThumbReachesItExactly) {
  const ThumbStudyInputs inputs = sample::study_inputs();
  const TendonDigit start = sample::thumb_of(inputs.start), truth = sample::true_thumb(inputs);
  const FitParameters parameters = parameters_of(start, inputs.skewed);
  ASSERT_EQ(parameters.coordinates(), 20);
  Eigen::VectorXd u(20);
  for (int c = 0; c < 20; ++c) {
    const Parameter& leader = parameters.all[parameters.leader[c]];
    u[c] = true_value(leader, start, truth).value();
    EXPECT_LT(std::abs(u[c] / leader.sd), 2) << leader.name << " is far from its prior";
  }
  TendonDigit reached = start;
  reached.model = moved_thumb(start, parameters, u);
  for (std::size_t i = 0; i < reached.model.tree.size(); ++i) {
    const Hinge<double>&got = reached.model.tree[i], &want = truth.model.tree[i];
    EXPECT_TRUE(matrix_near(got.direction, want.direction, 1e-14));
    EXPECT_LT((want.point - got.point).cross(want.direction).norm(), 1e-15);  // [m]
  }
  const Experiment pulls = simulate_pulls(truth, {4, 10, 0.1, 0.01, false, 1});
  EXPECT_TRUE(matrix_near(true_forces(reached, pulls), true_forces(truth, pulls), 1e-12));
}

/// Relative error in sample of the best fit to forces without noise, of a very good load cell.
double error_of_best_fit(const SourceText& settings) {
  const ThumbStudyInputs inputs = sample::study_inputs();
  SimulatedPullOptions options{4, 10, 0, 1e-5, false, 1};
  FitInputs fit{inputs.start, settings, {}, {}};
  fit.experiments = {{"", experiment_text(simulate_pulls(sample::true_thumb(inputs), options))}};
  const FitProblem problem = build_problem(fit);
  const Solution best = solve(least_squares(problem), Eigen::VectorXd::Zero(problem.size()));
  return predict_fitted(problem, best.z, 0).error.relative;
}

// The prior of 20 numbers outweighs data of 1e-5 N by no more than a few of these.
TEST(ThumbTruth, NoiselessForcesAreFittedExactlyBySkewedAxesAlone) {
  const ThumbStudyInputs inputs = sample::study_inputs();
  EXPECT_LT(error_of_best_fit(inputs.skewed), 1e-5);
  EXPECT_GT(error_of_best_fit(inputs.orthogonal), 1e-2);
}

TEST(ThumbExperiment, TextKeepsEveryBit) {
  const TendonDigit truth = sample::true_thumb(sample::study_inputs());
  Experiment pulls = simulate_pulls(truth, {});
  pulls.activations = simulate_tasks(truth, {}).activations;
  const Experiment read = parse_experiment(experiment_text(pulls), "made up");
  ASSERT_EQ(read.trials.size(), 18U);
  ASSERT_EQ(read.activations.size(), 80U);
  for (std::size_t i = 0; i < read.trials.size(); ++i) {
    EXPECT_EQ(read.trials[i].force, pulls.trials[i].force);
    EXPECT_EQ(*read.trials[i].sd, *pulls.trials[i].sd);
    EXPECT_EQ(read.trials[i].tension, pulls.trials[i].tension);
  }
  for (std::size_t i = 0; i < read.activations.size(); ++i) {
    EXPECT_EQ(read.activations[i].force, pulls.activations[i].force);
    EXPECT_EQ(read.activations[i].activation, pulls.activations[i].activation);
  }
  EXPECT_EQ(read.postures.front().angles, pulls.postures.front().angles);
}

}  // namespace
}  // namespace thenar
