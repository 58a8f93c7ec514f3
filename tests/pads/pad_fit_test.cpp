#include "pads/pad_fit.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "base/error.h"
#include "geometry/primitives.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// A pad of an exponential pulp on few cells.
PadModel small_pad(double shear_modulus = 8e3, double exponent = 1.5) {
  PadModel pad;
  pad.cells = {2, 1, 2};
  Tissue pulp;
  pulp.name = "pulp";
  pulp.law = TissueLaw::kVerondaWestmann;
  pulp.shear_modulus = shear_modulus;
  pulp.exponent = exponent;
  pulp.poisson_ratio = 0.48;
  pad.tissues = {pulp};
  return pad;
}

/// A wall pressed to forces [N].
PressCourse wall(const std::vector<double>& forces) {
  PressCourse course;
  course.object = {build_box({0.1, 0.1, 0.1}), 0};
  course.X_PO.p = {0, 0, 0.07};
  for (const double force : forces) course.loads.push_back({force, 0, 0});
  return course;
}

/// What a pad would show of its indentation and its area, with noise of `sd` of each value.
PressRecord measured(const PadModel& pad, const std::vector<double>& forces, double sd,
                     std::mt19937* random) {
  PressRecord record;
  record.name = "wall";
  record.course = wall(forces);
  const PressCurves truth = press_curves({pad}, record.course);
  EXPECT_EQ(truth.status, Status::kSolved) << truth.message;
  std::normal_distribution<double> noise(0, 1);
  for (std::size_t i = 0; i < forces.size(); ++i)
    for (const PressQuantity quantity : {PressQuantity::kIndentation, PressQuantity::kArea}) {
      PressDatum datum;
      datum.quantity = quantity;
      datum.load = static_cast<int>(i);
      const double value = predicted(datum, truth.points[0]);
      datum.sd = sd * value;
      datum.value = value + (random != nullptr ? datum.sd * noise(*random) : 0);
      record.data.push_back(datum);
    }
  return record;
}

PadConstant modulus_of(int tissue) { return {PadConstantKind::kShearModulus, tissue, 0}; }
const PadConstant kExponentOfPulp{PadConstantKind::kExponent, 0, 0};

TEST(PadFit, FindsTheConstantsThatMadeItsData) {
  PadFitProblem problem;
  problem.pad = small_pad(20e3, 0.7);
  problem.constants = {{modulus_of(0)}, {kExponentOfPulp}};
  problem.records = {measured(small_pad(), {0.2, 0.6, 1.5, 3}, 0.05, nullptr)};
  const PadFitResult result = fit_pad(problem, {1e-10, false, {}});
  ASSERT_TRUE(result.solution.converged()) << result.solution.message;
  EXPECT_NEAR(result.estimates[0].value / 8e3, 1, 1e-4);
  EXPECT_NEAR(result.estimates[1].value / 1.5, 1, 1e-4);
  EXPECT_TRUE(result.estimates[0].determined);
  EXPECT_LT(result.misfit, 1e-6);
  EXPECT_EQ(result.degrees_of_freedom, 6);
}

// Errors over their sds are standard normal: with 24 fits of two constants the sum of their squares
// is chi-square with 48 degrees of freedom, within 23.3 and 84.0 in 99.8 % of all cases.
TEST(PadFit, SdsCoverTheTruth) {
  std::mt19937 random(7);
  PadFitProblem problem;
  problem.pad = small_pad();
  problem.constants = {{modulus_of(0)}, {kExponentOfPulp}};
  double sum = 0;
  for (int seed = 0; seed < 24; ++seed) {
    problem.records = {measured(small_pad(), {0.2, 0.6, 1.5, 3}, 0.03, &random)};
    const PadFitResult result = fit_pad(problem, {1e-6, false, {}});
    ASSERT_TRUE(result.solution.converged()) << result.solution.message;
    // Both errors together, by their covariance.
    const Eigen::Vector2d sd(result.estimates[0].sd, result.estimates[1].sd);
    const Eigen::Vector2d error(std::log(result.estimates[0].value / 8e3),
                                std::log(result.estimates[1].value / 1.5));
    const Eigen::Matrix2d covariance = sd.asDiagonal() * result.correlations * sd.asDiagonal();
    sum += error.dot(covariance.ldlt().solve(error));
  }
  EXPECT_GT(sum, 23.3);
  EXPECT_LT(sum, 84.0);
}

// Scaling all moduli and all forces alike changes no deformation, so that at imposed indentations
// parts of a force tell nothing of one modulus of a pad of one tissue.
TEST(PadFit, TellsWhatTheDataCannotDetermine) {
  PadFitProblem problem;
  problem.pad = small_pad();
  problem.constants = {{modulus_of(0)}, {kExponentOfPulp}};
  PressRecord record;
  record.name = "shape of a curve";
  record.course = wall({});
  for (const double mm : {0.4, 0.8, 1.2}) record.course.loads.push_back({{}, mm * 1e-3, 0});
  const PressCurves truth = press_curves({problem.pad}, record.course);
  ASSERT_EQ(truth.status, Status::kSolved) << truth.message;
  for (const int load : {0, 1}) {
    PressDatum datum;
    datum.quantity = PressQuantity::kForce;
    datum.load = load;
    datum.over = 2;
    datum.value = predicted(datum, truth.points[0]);
    datum.sd = 0.01 * datum.value;
    record.data.push_back(datum);
  }
  problem.records = {record};
  const auto says = [&](const std::string& words) {
    const PadFitResult result = fit_pad(problem, {1e-6, false, {}});
    for (const std::string& warning : result.warnings)
      if (warning.find(words) != std::string::npos) return true;
    return false;
  };
  EXPECT_TRUE(says("pulp: shear modulus is not determined by the data: give it a prior"));
  EXPECT_FALSE(says("pulp: exponent is not determined"));
  // With a prior it is known as well as before.
  problem.constants[0].prior_factor = 1.5;
  EXPECT_TRUE(says("pulp: shear modulus is not determined by the data: its prior decides"));
  const PadFitResult result = fit_pad(problem, {1e-6, false, {}});
  EXPECT_NEAR(result.estimates[0].sd, std::log(1.5), 1e-3);
  EXPECT_NEAR(result.estimates[0].value / 8e3, 1, 1e-3);
}

TEST(PadFit, OneDatumOfThreeConstantsIsMetAndDeterminesNone) {
  PadFitProblem problem;
  problem.pad = small_pad();
  problem.constants = {{modulus_of(0)}, {kExponentOfPulp}, {{PadConstantKind::kBoneHeight, 0, 0}}};
  problem.records = {measured(small_pad(12e3, 1.5), {0.6}, 0.05, nullptr)};
  problem.records[0].data.resize(1);
  const PadFitResult result = fit_pad(problem, {1e-6, false, {}});
  EXPECT_TRUE(result.solution.converged()) << result.solution.message;
  const PressDatum& datum = problem.records[0].data[0];
  EXPECT_NEAR(result.predictions[0][0].value, datum.value, 0.01 * datum.sd);
  for (const ConstantEstimate& each : result.estimates) {
    EXPECT_FALSE(each.determined);
    EXPECT_TRUE(std::isinf(each.sd));
    EXPECT_TRUE(std::isfinite(each.value));
  }
  EXPECT_EQ(result.degrees_of_freedom, -2);
}

TEST(PadFit, ItsMeshIsCheckedOnFinerCells) {
  PadFitProblem problem;
  problem.pad = small_pad();
  problem.constants = {{modulus_of(0)}};
  // Data of a pad on cells of half the size.
  PadModel finer = small_pad();
  finer.cells = {4, 2, 4};
  problem.records = {measured(finer, {0.2, 0.6, 1.5}, 0.05, nullptr)};
  std::vector<PressDatum>& data = problem.records[0].data;
  data = {data[0], data[2], data[4]};  // indentations
  const PadFitResult result = fit_pad(problem, {1e-8, true, {}});
  ASSERT_TRUE(result.solution.converged());
  // The shift is what the finer cells would do to first order: most of the error.
  const double error = std::log(result.estimates[0].value / 8e3);
  EXPECT_GT(std::abs(error), 0.05);
  EXPECT_LT(std::abs(error + result.estimates[0].mesh_shift), 0.5 * std::abs(error));
  for (const PressPrediction& each : result.predictions[0]) EXPECT_TRUE(each.finer.has_value());
}

TEST(PadFit, AStopGivesWhatIsFoundSoFar) {
  PadFitProblem problem;
  problem.pad = small_pad(20e3, 0.7);
  problem.constants = {{modulus_of(0)}};
  problem.records = {measured(small_pad(), {0.2, 1}, 0.05, nullptr)};
  PadFitOptions options;
  options.progress.stop_requested = [] { return true; };
  const PadFitResult result = fit_pad(problem, options);
  EXPECT_EQ(result.solution.status, Status::kStopped);
  EXPECT_TRUE(result.estimates.empty());
}

TEST(PadFit, NonsenseIsRefused) {
  PadFitProblem problem;
  problem.pad = small_pad();
  problem.records = {measured(small_pad(), {0.2, 1}, 0.05, nullptr)};
  const auto message = [&] { return message_of([&] { (void)fit_pad(problem); }); };
  EXPECT_EQ(message(), "no constant of the pad is free");
  problem.constants = {{{PadConstantKind::kThickness, 0, 0}}};
  EXPECT_EQ(message(), "'pulp' is not a layer of skin, and has no thickness");
  problem.constants = {{{PadConstantKind::kShare, 0, 2}}};
  EXPECT_EQ(message(), "'pulp' has 0 terms of relaxation, wanted number 3");
  problem.constants = {{modulus_of(0)}};
  problem.records[0].data[0].sd = 0;
  EXPECT_EQ(message(), "'wall': the sd of a datum must be above 0, got 0");
  problem.records[0].data[0].sd = 1;
  problem.records[0].data[0].quantity = PressQuantity::kForce;
  EXPECT_EQ(message(), "'wall': the force of load 0 is imposed, not measured");
  problem.records.clear();
  EXPECT_EQ(message(), "there are no data to fit a pad to");
}

}  // namespace
}  // namespace thenar
