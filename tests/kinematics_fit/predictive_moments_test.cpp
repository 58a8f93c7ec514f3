// Tests for kinematics_fit/predictive_moments.cpp: closed forms, and means over draws.

#include "kinematics_fit/predictive_moments.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The published finger with some rows of settings, in the experiment of H01.
struct MomentScene {
  explicit MomentScene(const std::string& rows) : setup(sample::middle_finger(rows)) {
    plan = plan_experiment(setup.digit, setup.parameters, setup.experiments.front());
  }
  [[nodiscard]] PredictiveMoments moments(const VectorXd& center, const MatrixXd& V) const {
    return predictive_moments(setup.digit, setup.parameters, plan, center, V);
  }
  [[nodiscard]] Eigen::Matrix3Xd forces(const VectorXd& u) const {
    return force_values(setup.digit, setup.parameters, plan, u);
  }
  sample::FitSetup setup;
  ExperimentPlan plan;
};

// E cos of a normal angle is exp(-variance / 2); Cayley's rotation turns by 2 atan(w / 2), which
// differs from w by 0.1 degrees at 12.
TEST(PredictiveMoments, ShortenTheForceOfACellOfUnknownTilt) {
  const MomentScene scene("[[parameter]]\nmatch='sensor/radial'\nstate='free'\nsd_deg=12\n");
  const double variance = std::pow(radians(12), 2);
  const PredictiveMoments moments =
      scene.moments(VectorXd::Zero(1), MatrixXd::Constant(1, 1, variance));
  Eigen::Matrix3Xd expected = scene.forces(VectorXd::Zero(1));
  expected.topRows<2>() *= std::exp(-variance / 2);  // across the axis of the tilt
  EXPECT_GT(expected.norm(), 1);
  EXPECT_TRUE(matrix_near(moments.mean, expected, 1e-4 * expected.norm()));
}

TEST(PredictiveMoments, AreExactWhereForcesAreLinear) {
  const MomentScene scene("[[parameter]]\nmatch='force/*'\nstate='free'\n");
  const Eigen::Index n = scene.setup.parameters.coordinates();
  std::mt19937 rng(3);
  const VectorXd sd = sample::population_sds(scene.setup.parameters);
  const MatrixXd V = sd.cwiseAbs2().asDiagonal();
  const PredictiveMoments moments = scene.moments(VectorXd::Zero(n), V);
  EXPECT_TRUE(matrix_near(moments.mean, scene.forces(VectorXd::Zero(n)), 1e-13));
  // One load of tension t a trial, and two parameters for each component: 2 t^2 sd^2.
  for (Eigen::Index i = 0; i < moments.mean.cols(); ++i) {
    const double t = scene.plan.tension[static_cast<std::size_t>(i)].sum();
    EXPECT_TRUE(matrix_near(moments.variance.segment<3>(3 * i),
                            Eigen::Vector3d::Constant(2 * t * t * 0.03 * 0.03), 1e-12));
  }
}

// Everything that a finger's settings free, correlated, against plain draws.
TEST(PredictiveMoments, AgreeWithMeansOverDraws) {
  const MomentScene scene(sample::kAxesAndPaths +
                          "[[parameter]]\nmatch='sensor/*'\nstate='free'\nsd_deg=12\n"
                          "[[parameter]]\nmatch='hood/*/central'\nstate='free'\nsd=0.5\n"
                          "[[parameter]]\nmatch='angle/*/*'\nstate='free'\nsd_deg=6\n"
                          "[[parameter]]\nmatch='force/*/*/*'\nstate='free'\n");
  const Eigen::Index n = scene.setup.parameters.coordinates();
  std::mt19937 rng(5);
  // A root with correlations of all coordinates, in their own units.
  MatrixXd root = MatrixXd::Identity(n, n);
  for (Eigen::Index k = 0; k < n; ++k) root.col(k) += 0.3 * sample::normal(n, rng) / std::sqrt(n);
  root = sample::population_sds(scene.setup.parameters).asDiagonal() * root;
  const VectorXd center = VectorXd::Zero(n);
  const PredictiveMoments moments = scene.moments(center, root * root.transpose());

  constexpr int kPairs = 4000;  // antithetic: what is odd in u drops out of the mean
  VectorXd sum = VectorXd::Zero(3 * moments.mean.cols()), squares = sum, pairs = sum;
  for (int k = 0; k < kPairs; ++k) {
    const VectorXd step = root * sample::normal(n, rng);
    const VectorXd a = scene.forces(step).reshaped(), b = scene.forces(-step).reshaped();
    sum += (a + b) / 2;
    pairs += ((a + b) / 2).cwiseAbs2();
    squares += (a.cwiseAbs2() + b.cwiseAbs2()) / 2;
  }
  const VectorXd mean = sum / kPairs, variance = squares / kPairs - mean.cwiseAbs2();
  const VectorXd error = (pairs / kPairs - mean.cwiseAbs2()).cwiseMax(0).cwiseSqrt() /
                         std::sqrt(static_cast<double>(kPairs));
  const VectorXd plain = scene.forces(center).reshaped();
  // Four standard errors, and what is beyond second order: a twentieth of the shift.
  const VectorXd shift = mean - plain, missed = moments.mean.reshaped() - mean;
  EXPECT_GT(shift.norm(), 20 * error.norm());
  EXPECT_LT(missed.norm(), 0.05 * shift.norm() + 4 * error.norm());
  // Of sds a twentieth: mixed second derivatives and higher orders.
  EXPECT_LT((moments.variance.cwiseSqrt() - variance.cwiseSqrt()).norm(),
            0.05 * variance.cwiseSqrt().norm());
}

// At a bound, that its data push against, the mean is the force there; 0.05 within it, of the steps
// of 0.05 that both sides have.
TEST(PredictiveMoments, KeepsStepsWithinTheBoundsOfParameters) {
  const MomentScene scene(
      "[[parameter]]\nmatch='friction/FDP'\nstate='free'\nmean=0\nlower=0\nupper=0.5\n");
  const MatrixXd V = MatrixXd::Constant(1, 1, 0.2 * 0.2);
  const auto forces = [&](double friction) {
    return scene.forces(VectorXd::Constant(1, friction));
  };
  EXPECT_TRUE(matrix_near(scene.moments(VectorXd::Zero(1), V).mean, forces(0), 1e-12));
  EXPECT_TRUE(matrix_near(scene.moments(VectorXd::Constant(1, 0.05), V).mean,
                          (forces(0) + forces(0.1)) / 2, 1e-12));
}

// Which of two correlated coordinates comes first changes the root of their covariance: with one at
// its bound, means stay but for what is of second order.
TEST(PredictiveMoments, DoNotHangOnTheOrderOfCoordinates) {
  const std::string friction =
      "[[parameter]]\nmatch='friction/FDP'\nstate='free'\nmean=0\nlower=0\nupper=0.5\n";
  const std::string tilt = "[[parameter]]\nmatch='axis/PIP3/direction/1'\nstate='free'\n";
  const MomentScene scene(friction + tilt);
  const int n = scene.setup.parameters.coordinates();
  ASSERT_EQ(n, 2);
  const double sd = 1e-3;  // of both: [1], [rad]
  for (const double correlation : {0.9, -0.9}) {
    MatrixXd V(2, 2);
    V << 1, correlation, correlation, 1;
    V *= sd * sd;
    const Eigen::Matrix3Xd at = scene.forces(VectorXd::Zero(2));
    EXPECT_LT((scene.moments(VectorXd::Zero(2), V).mean - at).cwiseAbs().maxCoeff(), 1e-5);
  }
}

// A finger almost straight at PIP and DIP, whose angles are known to 4 degrees: within an sd the
// tip is singular, and forces turn round. There the expansion points anywhere; medians of plain
// draws, and half the width of their central 95 %, are what is told. Bent, the expansion is good.
TEST(PredictiveMoments, NearASingularPostureAreThoseOfDraws) {
  for (const bool straight : {true, false}) {
    sample::FitSetup setup =
        sample::middle_finger("[[parameter]]\nmatch='angle/*/*'\nstate='free'\nsd_deg=4\n");
    Experiment& experiment = setup.experiments.front();
    experiment.hold = TipConstraint::kPinned;
    for (PostureRecord& posture : experiment.postures)
      posture.angles = {{"MCP3_FE", radians(30)},
                        {"PIP3", radians(straight ? 4 : 60)},
                        {"DIP3", radians(straight ? 3 : 40)}};
    const ExperimentPlan plan = plan_experiment(setup.digit, setup.parameters, experiment);
    const Eigen::Index n = setup.parameters.coordinates();
    const MatrixXd V = MatrixXd(sample::population_sds(setup.parameters).cwiseAbs2().asDiagonal());
    const PredictiveMoments moments =
        predictive_moments(setup.digit, setup.parameters, plan, VectorXd::Zero(n), V);
    std::mt19937 rng(11);
    const VectorXd sd = sample::population_sds(setup.parameters);
    constexpr int kDraws = 4001;
    MatrixXd draws(3 * moments.mean.cols(), kDraws);
    for (int k = 0; k < kDraws; ++k)
      draws.col(k) = force_values(setup.digit, setup.parameters, plan,
                                  VectorXd(sd.cwiseProduct(sample::normal(n, rng))))
                         .reshaped();
    int by_draws = 0;
    for (Eigen::Index i = 0; i < moments.mean.cols(); ++i) {
      by_draws += moments.by_draws[static_cast<std::size_t>(i)] ? 1 : 0;
      for (Eigen::Index row = 3 * i; row < 3 * i + 3; ++row) {
        VectorXd sorted = draws.row(row);
        std::sort(sorted.begin(), sorted.end());
        const double median = sorted[kDraws / 2];
        const double width = (sorted[kDraws * 975 / 1000] - sorted[kDraws * 25 / 1000]) / 3.92;
        // Of a median of 1000 draws the standard error is 0.04 sds of a normal; of a width, of
        // tails as of 1 / x, some tenths.
        EXPECT_NEAR(moments.mean.reshaped()[row], median, 0.25 * width + 1e-9) << straight << row;
        EXPECT_NEAR(std::sqrt(moments.variance[row]), width, 0.4 * width + 1e-9) << straight << row;
      }
    }
    if (straight) {
      EXPECT_GT(by_draws, moments.mean.cols() / 2);
    } else {
      EXPECT_EQ(by_draws, 0);
    }
  }
}

TEST(PredictiveMoments, RefusesACovarianceOfOtherSize) {
  const MomentScene scene("[[parameter]]\nmatch='force/*'\nstate='free'\n");
  EXPECT_THROW((void)scene.moments(VectorXd::Zero(1), MatrixXd::Identity(2, 2)), InputError);
}

}  // namespace
}  // namespace thenar
