// Tests for kinematics_fit/force_jacobian.cpp: every kind of parameter against differences.

#include "kinematics_fit/force_jacobian.h"

#include <gtest/gtest.h>

#include "tests/kinematics_fit/fit_samples.h"

namespace thenar {
namespace {

/// Sds of the coordinates, the size by which each is moved [SI].
Eigen::VectorXd scales(const FitParameters& parameters) {
  Eigen::VectorXd sd(parameters.coordinates());
  for (int c = 0; c < parameters.coordinates(); ++c)
    sd[c] = parameters.all[parameters.leader[c]].sd;
  return sd;
}

/// Compares every column of the Jacobian, in newtons per sd, with central differences.
void expect_exact(const sample::FitSetup& setup) {
  constexpr double kStep = 1e-4;  // of an sd; the error of the difference falls with its square
  constexpr double kTolerance = 3e-7;  // [N per sd]
  const ExperimentPlan plan =
      plan_experiment(setup.digit, setup.parameters, setup.experiments.front());
  std::mt19937 rng(3);
  const Eigen::VectorXd sd = scales(setup.parameters);
  const Eigen::VectorXd u = 0.3 * sd.cwiseProduct(sample::normal(sd.size(), rng));
  const ForceJacobian exact = force_jacobian(setup.digit, setup.parameters, plan, u);
  EXPECT_TRUE(exact.force.isApprox(force_values(setup.digit, setup.parameters, plan, u), 1e-12));
  for (Eigen::Index c = 0; c < u.size(); ++c) {
    const Eigen::VectorXd step = kStep * sd[c] * Eigen::VectorXd::Unit(u.size(), c);
    const Eigen::Matrix3Xd difference =
        (force_values(setup.digit, setup.parameters, plan, u + step) -
         force_values(setup.digit, setup.parameters, plan, u - step)) /
        (2 * kStep);
    const double error = (difference.reshaped() - sd[c] * exact.J.col(c)).cwiseAbs().maxCoeff();
    EXPECT_LT(error, kTolerance) << setup.parameters.all[setup.parameters.leader[c]].name;
  }
}

const std::string kAllFree = R"(
[[parameter]]
match = "*"
state = "free"
[[parameter]]
match = "hold/out_of_plane"
mean_mm = 39
)";

TEST(ForceJacobian, IsExactForEveryParameterOfARigidHold) {
  const sample::FitSetup setup = sample::middle_finger(kAllFree);
  EXPECT_EQ(setup.parameters.coordinates(), static_cast<int>(setup.parameters.all.size()));
  expect_exact(setup);
}

// Of each trial: tension times what is added, in the axes of the experiment.
TEST(ForceJacobian, AddsWhatTheGeometryDoesNotExplain) {
  const sample::FitSetup setup = sample::middle_finger(
      "[[parameter]]\nmatch = 'force/FDS/radial'\nstate = 'free'\n"
      "[[parameter]]\nmatch = 'gain/FDS'\nmean = 0.8\n");
  const Experiment& experiment = setup.experiments.front();
  const ExperimentPlan plan = plan_experiment(setup.digit, setup.parameters, experiment);
  const auto force = [&](double u) -> Eigen::Matrix3Xd {
    return force_values(setup.digit, setup.parameters, plan, Eigen::VectorXd::Constant(1, u));
  };
  Eigen::Matrix3Xd expected(3, plan.force.cols());
  for (Eigen::Index i = 0; i < expected.cols(); ++i) {
    const auto& tension = experiment.trials[static_cast<std::size_t>(i)].tension;
    const auto fds = tension.find("FDS");
    expected.col(i) = experiment.axes_of_digit.cast<double>() *
                      Eigen::Vector3d(0, 0, fds == tension.end() ? 0 : 0.2 * fds->second);
  }
  EXPECT_GT(expected.norm(), 1);
  EXPECT_TRUE((force(0.2) - force(0)).isApprox(expected, 1e-12));
}

// The same of one posture alone: the trials of the others stay as they are.
TEST(ForceJacobian, AddsWhatTheGeometryDoesNotExplainInOnePosture) {
  const sample::FitSetup setup =
      sample::middle_finger("[[parameter]]\nmatch = 'force/FDS/dorsal/Hook'\nstate = 'free'\n");
  const Experiment& experiment = setup.experiments.front();
  const ExperimentPlan plan = plan_experiment(setup.digit, setup.parameters, experiment);
  const auto force = [&](double u) -> Eigen::Matrix3Xd {
    return force_values(setup.digit, setup.parameters, plan, Eigen::VectorXd::Constant(1, u));
  };
  const Eigen::Matrix3Xd added = force(0.2) - force(0);
  int changed = 0;
  for (Eigen::Index i = 0; i < added.cols(); ++i) {
    const Trial& trial = experiment.trials[static_cast<std::size_t>(i)];
    const bool here = trial.posture == "Hook" && trial.tension.count("FDS") > 0;
    const Eigen::Vector3d expected =
        experiment.axes_of_digit.cast<double>() *
        Eigen::Vector3d(0, here ? 0.2 * trial.tension.at("FDS") : 0, 0);
    EXPECT_LT((added.col(i) - expected).norm(), 1e-12) << i;
    changed += here ? 1 : 0;
  }
  EXPECT_EQ(changed, 1);
}

TEST(ForceJacobian, IsExactForAHoldInTheFlexionPlane) {
  expect_exact(sample::middle_finger(
      kAllFree + "[[parameter]]\nmatch='hold/out_of_plane'\nstate='fixed'\nmean_mm=0\n"));
}

TEST(ForceJacobian, IsExactForAPinnedTipAndForcesInAnotherSegment) {
  sample::FitSetup setup = sample::middle_finger(kAllFree);
  setup.experiments.front().hold = TipConstraint::kPinned;
  setup.experiments.front().force_segment = "MP3";
  expect_exact(setup);
}

TEST(ForceJacobian, IsExactForConstantArms) {
  const SourceText text = sample::source("subjects/arms_thumb");
  sample::FitSetup setup{build_tendon_digit(parse_subject(text.text, text.path), "thumb"), {}, {}};
  Experiment experiment;
  experiment.digit = "thumb";
  experiment.force_segment = "DP1";
  experiment.sd_floor = 0.1;
  experiment.postures = {{"bent", {{"CMC1_FE", -0.2}, {"MCP1_FE", 0.4}, {"IP1", 0.6}}}};
  experiment.trials = {{"bent", {{"FPL", 10.0}, {"APB", 5.0}}, {1, 1, 1}, {}, {}},
                       {"bent", {{"EPL", 8.0}}, {1, 1, 1}, {}, {}}};
  setup.experiments = {experiment};
  setup.parameters = choose_parameters(setup.digit, {"bent"}, sample::settings(kAllFree));
  expect_exact(setup);
}

// Friction may start at its lower bound, zero, and must feel from there that it can rise.
TEST(ForceJacobian, FrictionHasADerivativeAtZero) {
  const sample::FitSetup setup =
      sample::middle_finger("[[parameter]]\nmatch='friction/FDP'\nstate='free'\n");
  const ExperimentPlan plan =
      plan_experiment(setup.digit, setup.parameters, setup.experiments.front());
  const ForceJacobian at_zero =
      force_jacobian(setup.digit, setup.parameters, plan, Eigen::VectorXd::Zero(1));
  EXPECT_GT(at_zero.J.cwiseAbs().maxCoeff(), 0.1);  // [N]
}

// A hinge does not care which of its points is stated.
TEST(ForceJacobian, ShiftAlongAnAxisChangesNothing) {
  const sample::FitSetup setup =
      sample::middle_finger("[[parameter]]\nmatch='axis/*/point/along'\nstate='free'\n");
  const ExperimentPlan plan =
      plan_experiment(setup.digit, setup.parameters, setup.experiments.front());
  const Eigen::VectorXd u = Eigen::VectorXd::Constant(4, 5e-3);
  const Eigen::Matrix3Xd moved = force_values(setup.digit, setup.parameters, plan, u);
  const Eigen::Matrix3Xd still = force_values(setup.digit, setup.parameters, plan, 0 * u);
  EXPECT_LT((moved - still).cwiseAbs().maxCoeff(), 1e-13);  // [N]
  EXPECT_LT(force_jacobian(setup.digit, setup.parameters, plan, u).J.cwiseAbs().maxCoeff(),
            1e-10);  // [N/m]
}

}  // namespace
}  // namespace thenar
