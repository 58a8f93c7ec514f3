// Tests for kinematics_fit/odd_trials.cpp: a trial that does not go with the others is found.

#include "kinematics_fit/odd_trials.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "kinematics_fit/fit_residuals.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using sample::FitSetup;
using sample::middle_finger;

// Axes that are known so well that forces are linear in their tilts.
const std::string kSteadyAxes = R"(
[[parameter]]
match = "axis/*/direction/*"
state = "free"
sd_deg = 0.2
between_sd_deg = 0.3
)";

/// Forces of a finger drawn from the prior.
FitSetup drawn(std::mt19937& rng) {
  FitSetup setup = middle_finger(kSteadyAxes);
  setup.experiments.front().sd_floor = 0.02;  // [N]
  const VectorXd sd = sample::person_sds(setup.parameters);
  const VectorXd u = sd.cwiseProduct(sample::normal(sd.size(), rng));
  sample::simulate(setup, u, 0.02, rng, setup.experiments.front());
  return setup;
}

struct Found {
  FitProblem problem;
  VectorXd z;
  std::vector<OddTrial> odd;
};

Found find_odd(const FitSetup& setup, double robust_scale = 0) {
  Found out{setup.problem(robust_scale), {}, {}};
  out.z = sample::fit_precisely(out.problem).z;
  out.odd = odd_trials(out.problem, out.z, posterior_covariance(out.problem, out.z));
  return out;
}

TEST(OddTrials, AreNoneAmongDrawsOfTheModel) {
  std::mt19937 rng(5);
  for (int draw = 0; draw < 30; ++draw) EXPECT_TRUE(find_odd(drawn(rng)).odd.empty()) << draw;
}

// The distance is that from the prediction of a fit without the trial, in sds of both together.
TEST(OddTrials, AreFarFromWhatAFitWithoutThemPredicts) {
  std::mt19937 rng(6);
  FitSetup setup = drawn(rng);
  const int turned = 9;
  Trial& trial = setup.experiments.front().trials[turned];
  trial.force += Eigen::Vector3d(0.1, -0.08, 0.06);  // [N]
  for (const double robust_scale : {0.0, 3.0}) {
    const Found found = find_odd(setup, robust_scale);
    ASSERT_FALSE(found.odd.empty());
    EXPECT_EQ(found.odd.front().trial, turned);
    // The fit without it.
    const FitProblem others = subset(found.problem, [&](const Experiment&, const Trial& each) {
      return each.force != trial.force;
    });
    const VectorXd z = sample::fit_precisely(others).z;
    const MatrixXd C = posterior_covariance(others, z).C.block_entries(0);
    const FitProblem plain = setup.problem();
    const Residuals data = data_residuals(plain, z, 0, WithJacobian::kYes);
    const MatrixXd J = data.J.middleRows<3>(3 * turned);
    const VectorXd e = data.r.segment<3>(3 * turned);
    const MatrixXd S = MatrixXd::Identity(3, 3) + J * C * J.transpose();
    const double distance = std::sqrt(e.dot(S.llt().solve(e)));
    // A robust fit keeps a little of what it shrinks.
    EXPECT_NEAR(found.odd.front().distance, distance, (robust_scale > 0 ? 0.1 : 2e-3) * distance);
  }
}

// One row turned by far more than its noise pulls sound rows along; they are not accused for it.
TEST(OddTrials, AccuseNoTrialForTheSakeOfAnother) {
  std::mt19937 rng(8);
  for (int draw = 0; draw < 10; ++draw) {
    FitSetup setup = drawn(rng);
    const int turned = draw % static_cast<int>(setup.experiments.front().trials.size());
    setup.experiments.front().trials[static_cast<std::size_t>(turned)].force +=
        Eigen::Vector3d(0.4, -0.5, 0.3);  // [N], of sd 0.02
    const Found found = find_odd(setup);
    ASSERT_EQ(found.odd.size(), 1U) << draw;
    EXPECT_EQ(found.odd.front().trial, turned);
  }
}

TEST(OddTrials, AreNamedWithTheirLoadsAndPostures) {
  std::mt19937 rng(7);
  FitSetup setup = drawn(rng);
  std::vector<Trial>& trials = setup.experiments.front().trials;
  for (const int turned : {0, 1, 7, 12}) trials[static_cast<std::size_t>(turned)].force *= -1;
  const Found found = find_odd(setup);
  const std::vector<std::string> told = describe(found.problem, found.odd);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("experiment 'synek2019_H01'"), std::string::npos) << told[0];
  const Trial& oddest = trials[static_cast<std::size_t>(found.odd.front().trial)];
  EXPECT_NE(told[0].find("them: " + oddest.tension.begin()->first + " in posture '" +
                         oddest.posture + "' ("),
            std::string::npos)
      << told[0];
  EXPECT_NE(told[0].find(fmt::format(" and {} more.", found.odd.size() - 3)), std::string::npos)
      << told[0];
}

}  // namespace
}  // namespace thenar
