// Tests for posterior/gauge.cpp: shifts of axes along themselves.

#include "posterior/gauge.h"

#include <random>
#include <string>

#include <gtest/gtest.h>

#include "posterior/hand_posterior.h"
#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::VectorXd;
using sample::FitSetup;
using sample::moving_axes;

/// Neither noise nor differences between specimens are learnt.
const PosteriorOptions kSphereOnly = [] {
  PosteriorOptions options;
  options.learn_noise = options.learn_specimen_scale = false;
  return options;
}();

TEST(Gauge, ShiftsAlongAnAxisAreLeftOutAndNothingIsLost) {
  for (const bool two : {false, true}) {
    FitSetup setup = moving_axes("axis/MCP3_*/point/*");
    if (two) setup.experiments.push_back(sample::experiment("H02"));
    const FitProblem problem = setup.problem();
    const HandPosterior posterior(problem, kSphereOnly);
    EXPECT_EQ(posterior.size(), problem.size() - (two ? 6 : 2));
    for (const std::string& name : posterior.names())
      EXPECT_EQ(name.find("along"), std::string::npos) << name;

    // Any z of the fit has an x with the same forces, whatever its shifts along the axes.
    std::mt19937 rng(4);
    const VectorXd z = 0.7 * sample::normal(problem.size(), rng);
    const VectorXd x = posterior.from_fit_coordinates(z);
    for (int e = 0; e < (two ? 2 : 1); ++e)
      EXPECT_TRUE(matrix_near(posterior.forces(x, e).reshaped(3, 24), predict_trials(problem, z, e),
                              1e-11));
    // And it is a shift that matters at tilted axes, if not made up for.
    VectorXd bare = z;
    for (std::size_t i = 0; i < problem.coordinates().names().size(); ++i)
      if (problem.coordinates().names()[i].find("along") != std::string::npos)
        bare[static_cast<Eigen::Index>(i)] = 0;
    EXPECT_FALSE(
        matrix_near(predict_trials(problem, bare, 0), predict_trials(problem, z, 0), 1e-4));
  }
}

TEST(Gauge, OfAnAxisThatIsNotTiltedNeedsNoOtherParameter) {
  const FitProblem problem = moving_axes("axis/PIP3/point/along").problem();
  const HandPosterior posterior(problem, kSphereOnly);
  EXPECT_EQ(posterior.size(), problem.size() - 1);
}

// Without freedom across the axis, a shift along its start direction moves the tilted one.
TEST(Gauge, IsKeptWhereNothingTakesItUp) {
  const FitProblem problem = moving_axes("axis/MCP3_*/point/along").problem();
  EXPECT_EQ(HandPosterior(problem, kSphereOnly).size(), problem.size());
}

// Shifts along the axes become zero, and the points of tilted axes make up for them.
TEST(Gauge, TakenOutLeavesTheForcesOfTheFit) {
  const FitProblem problem = moving_axes("axis/MCP3_*/point/*").problem();
  const std::vector<Gauge> gauges = find_gauges(problem);
  ASSERT_EQ(gauges.size(), 2U);
  std::mt19937 rng(6);
  const VectorXd z = 0.7 * sample::normal(problem.size(), rng);
  const VectorXd bare = without_gauges(problem, gauges, z);
  for (const Gauge& gauge : gauges)
    EXPECT_EQ(bare[problem.coordinates().entries(gauge.along).population], 0);
  EXPECT_GT((bare - z).norm(), 0.1);
  EXPECT_TRUE(matrix_near(predict_trials(problem, bare, 0), predict_trials(problem, z, 0), 1e-11));
}

}  // namespace
}  // namespace thenar
