// Tests for hand/axis_distance.h and the constraints of a fit.

#include "hand/axis_distance.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "kinematics_fit/fit_residuals.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

Hinge<double> hinge(const Vector3d& direction, const Vector3d& point) {
  return {-1, 0, 1, 0, direction.normalized(), point};
}

double distance(const Hinge<double>& a, const Hinge<double>& b) {
  return std::sqrt(squared_axis_distance(a, b));
}

TEST(AxisDistance, IsTheCommonNormalOfSkewAxes) {
  const Hinge<double> a = hinge({1, 0, 0}, {5, 0, 0}), b = hinge({0, 1, 0}, {1, -7, 3});
  EXPECT_NEAR(distance(a, b), 3, 1e-4);  // the smoothing adds kParallel^2 |w|^2 / 2d
}

TEST(AxisDistance, OfParallelAxesIsPerpendicular) {
  const Hinge<double> a = hinge({1, 2, 2}, {0, 0, 0}), b = hinge({1, 2, 2}, {2, -1, 0});
  EXPECT_NEAR(distance(a, b), std::sqrt(5.0), 1e-12);
  const Hinge<double> opposite = hinge({-1, -2, -2}, {2, -1, 0});
  EXPECT_NEAR(distance(a, opposite), std::sqrt(5.0), 1e-12);
}

TEST(AxisDistance, DoesNotDependOnTheStatedPoints) {
  const Vector3d d(0.3, -0.2, 0.9), e(0.1, 1, 0.4), p(1, 2, 3), q(-1, 0, 2);
  const double before = distance(hinge(d, p), hinge(e, q));
  EXPECT_NEAR(distance(hinge(d, p + 4 * d), hinge(e, q - 3 * e)), before, 1e-4);
}

TEST(AxisDistance, MatchesThePublishedThumb) {  // [McFarland2023]: 9.13 mm
  const SourceText text = sample::source("subjects/arms_thumb");
  const TendonDigit thumb = build_tendon_digit(parse_subject(text.text, text.path), "thumb");
  ASSERT_EQ(thumb.names.hinges[0], "CMC1_FE");
  ASSERT_EQ(thumb.names.hinges[1], "CMC1_AA");
  EXPECT_NEAR(distance(thumb.model.tree[0], thumb.model.tree[1]), 9.13e-3, 5e-6);
}

// -- In a fit ---------------------------------------------------------------------------------

const std::string kSettings = R"(
[[parameter]]
match = "axis/CMC1_*/point/*"
state = "free"
sd_mm = 3
between_sd_mm = 0
[[parameter]]
match = "axis/CMC1_*/direction/*"
state = "free"
sd_deg = 10
[[axis_distance]]
joints = ["CMC1_FE", "CMC1_AA"]
range_mm = [9.5, 12]
)";

/// A thumb whose forces come from its own axes, 9.13 mm apart.
FitProblem thumb(const std::string& rows) {
  const SourceText text = sample::source("subjects/arms_thumb");
  sample::FitSetup setup{build_tendon_digit(parse_subject(text.text, text.path), "thumb"), {}, {}};
  const FitSettings settings = sample::settings(rows);
  setup.parameters = choose_parameters(setup.digit, {}, settings);
  Experiment experiment;
  experiment.name = "made up";
  experiment.digit = "thumb";
  experiment.force_segment = "DP1";
  experiment.sd_floor = 0.05;
  experiment.postures = {{"bent", {{"CMC1_FE", -0.2}, {"MCP1_FE", 0.4}, {"IP1", 0.6}}},
                         {"flat", {{"CMC1_AA", 0.3}, {"IP1", 0.2}}}};
  for (const char* posture : {"bent", "flat"})
    for (const char* muscle : {"FPL", "EPL", "APB", "ADPt"})
      experiment.trials.push_back({posture, {{muscle, 20.0}}, Vector3d::Zero(), {}, {}});
  std::mt19937 rng(1);
  sample::simulate(setup, Eigen::VectorXd::Zero(setup.parameters.coordinates()), 0, rng,
                   experiment);
  return {setup.digit, setup.parameters, {experiment}, 0, settings.axis_distances};
}

double fitted_distance(const FitProblem& problem, const Eigen::VectorXd& z) {
  const SpecimenModel<double> model = specimen_model(
      problem.digit(), problem.parameters(),
      parameter_values<double>(problem.parameters(), displacements(problem.coordinates(), z, 0)));
  return distance(model.digit.tree[0], model.digit.tree[1]);
}

TEST(AxisConstraints, JacobianIsExact) {
  const FitProblem problem = thumb(kSettings);
  std::mt19937 rng(2);
  const Eigen::VectorXd z = 0.3 * sample::normal(problem.size(), rng);
  const ConstraintValues at = axis_constraints(problem, z);
  ASSERT_EQ(at.c.size(), 1);
  EXPECT_NEAR(at.c[0], std::pow(fitted_distance(problem, z) / 12e-3, 2), 1e-12);
  EXPECT_NEAR(axis_constraint_lower(problem)[0], std::pow(9.5 / 12, 2), 1e-15);
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    const Eigen::VectorXd step = 1e-5 * Eigen::VectorXd::Unit(z.size(), i);
    const double difference =
        (axis_constraints(problem, z + step).c[0] - axis_constraints(problem, z - step).c[0]) /
        2e-5;
    EXPECT_NEAR(at.C(0, i), difference, 1e-8) << problem.coordinates().names()[i];
  }
}

TEST(AxisConstraints, IpoptKeepsTheAxesApart) {
  const FitProblem problem = thumb(kSettings);
  SolveOptions options;
  options.method = LeastSquaresMethod::kIpopt;
  const Solution fit =
      solve(least_squares(problem), Eigen::VectorXd::Zero(problem.size()), options);
  EXPECT_EQ(fit.status, Status::kSolved) << fit.message;
  EXPECT_NEAR(fitted_distance(problem, fit.z), 9.5e-3, 1e-8);  // the bound is active
}

TEST(AxisConstraints, OtherSolversSayWhatTheyBreak) {
  const FitProblem problem = thumb(kSettings);
  const Solution fit = solve(least_squares(problem), Eigen::VectorXd::Zero(problem.size()));
  EXPECT_EQ(fit.status, Status::kStalled);
  EXPECT_NE(fit.message.find("; breaks 1 of 1 constraints, which only ipopt honours"),
            std::string::npos)
      << fit.message;
}

TEST(AxisConstraints, NamesTheUnknownJoint) {
  std::string settings = kSettings;
  settings.replace(settings.find("\"CMC1_AA\""), 9, "\"CMC9\"");
  try {
    (void)thumb(settings);
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "axis distance of joint 'CMC9', which the digit has not; it has CMC1_FE, "
                 "CMC1_AA, MCP1_FE, IP1");
  }
}

}  // namespace
}  // namespace thenar
