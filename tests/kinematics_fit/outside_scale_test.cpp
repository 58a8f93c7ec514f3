// Tests for kinematics_fit/outside_scale.cpp: digits in the size of a person, and fits of them.

#include "kinematics_fit/outside_scale.h"

#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kinematics_fit/fit_residuals.h"
#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using testing::HasSubstr;

using Lengths = std::map<std::string, double>;  // segment -> [m]

constexpr double kMm = 1e-3;

/// Lengths of the bones of an_chao_middle, by the sums in its file, times a factor each [m].
Lengths sized(double proximal, double middle, double distal) {
  return {{"PP3", proximal * 47.0237 * kMm},
          {"MP3", middle * 28.8286 * kMm},
          {"DP3", distal * 19.0171 * kMm}};
}

TendonDigit planar_digit(const std::string& subject = sample::kPlanarFinger) {
  return build_tendon_digit(parse_subject(subject, "planar.toml"), "index");
}

Experiment planar_experiment(const std::string& outside) {
  const std::string rows =
      sample::planar_trials("components = ['proximal', 'dorsal']", "[-0.6, -1.2]", "[-0.9, -1]");
  return parse_experiment(rows + outside, "trials.toml");
}

Vector3d point_of(const TendonDigit& digit, int strand, int point) {
  return digit.model.paths[static_cast<std::size_t>(strand)][static_cast<std::size_t>(point)].p;
}

// The middle phalanx of the planar finger, 25 mm from x = 45 to 20, is 30 mm long in this person.
TEST(OutsideScale, MovesPointsAsWorkedOutByHand) {
  const TendonDigit digit = scale_to_outside(
      planar_digit(),
      planar_experiment("[outside]\nlength_mm = {PP2 = 45, MP2 = 30, DP2 = 20.396078054371138}\n"));
  const double w = std::sqrt(1.2);  // at both ends of the bone that grew
  const double exact = 1e-15;       // [m]
  // Joints and tip: what lies beyond the bone moves by 5 mm.
  EXPECT_TRUE(matrix_near(digit.model.tree[0].point, Vector3d(90, 0, 0) * kMm, exact));
  EXPECT_TRUE(matrix_near(digit.model.tree[1].point, Vector3d(45, 0, 0) * kMm, exact));
  EXPECT_TRUE(matrix_near(digit.model.tree[2].point, Vector3d(15, 0, 0) * kMm, exact));
  EXPECT_TRUE(matrix_near(digit.model.tip, Vector3d(-5, -4, 0) * kMm, exact));
  // FDP: 17 mm along the middle phalanx; 10 of 45 mm along the proximal one; on the metacarpal.
  EXPECT_TRUE(matrix_near(point_of(digit, 0, 1), Vector3d(45 - 1.2 * 17, -5 * w, 0) * kMm, exact));
  EXPECT_TRUE(matrix_near(point_of(digit, 0, 4),
                          Vector3d(80, -9 * (1 + (w - 1) * 10 / 45), 0) * kMm, exact));
  EXPECT_TRUE(matrix_near(point_of(digit, 0, 5), Vector3d(98, -10, 0) * kMm, exact));
}

// A bone that was not measured grows like those that were, in the geometric mean.
TEST(OutsideScale, UnmeasuredBonesFollowTheOthers) {
  const TendonDigit digit = scale_to_outside(
      planar_digit(), planar_experiment("[outside]\nlength_mm = {PP2 = 54, MP2 = 20}\n"));
  const double tip = (digit.model.tip - digit.model.tree[2].point).norm();
  EXPECT_NEAR(tip, std::sqrt(1.2 * 0.8) * std::hypot(20, 4) * kMm, 1e-15);
}

// Forces of a pinned tip go with arm / length: a hand that is larger all over makes the same
// forces, with moments larger by its factor.
TEST(OutsideScale, CommonFactorKeepsForcesAndScalesMoments) {
  sample::FitSetup setup = sample::middle_finger(sample::kAxes, "H01", "an_chao_middle");
  Experiment& experiment = setup.experiments.front();
  experiment.hold = TipConstraint::kPinned;
  experiment.outside_length = sized(1.2, 1.2, 1.2);
  const TendonDigit large = scale_to_outside(setup.digit, experiment);
  const VectorXd none = VectorXd::Zero(setup.parameters.coordinates());
  const auto forces = [&](const TendonDigit& digit) {
    return force_values(digit, setup.parameters,
                        plan_experiment(digit, setup.parameters, experiment), none);
  };
  const Eigen::Matrix3Xd force = forces(setup.digit);
  ASSERT_GT(force.norm(), 1);
  EXPECT_TRUE(matrix_near(forces(large), force, 1e-11));  // [N]

  const VectorXd q = posture(setup.digit.skeleton, {{"MCP3_FE", 0.5}, {"PIP3", 0.9}});
  EXPECT_TRUE(matrix_near(tip_statics(large, q).R, 1.2 * tip_statics(setup.digit, q).R, 1e-15));
  EXPECT_TRUE(matrix_near(tip_statics(large, q).J, 1.2 * tip_statics(setup.digit, q).J, 1e-15));
}

TEST(OutsideScale, RefusesWhatCannotBe) {
  const auto refusal = [](const std::string& outside, const TendonDigit& digit = planar_digit()) {
    return message_of([&] { (void)scale_to_outside(digit, planar_experiment(outside)); });
  };
  EXPECT_EQ(refusal("[outside]\nlength_mm = {PP3 = 45}\n"),
            "experiment 'planar_forces': the digit has no segment 'PP3'");
  EXPECT_EQ(
      refusal("[outside]\nlength_mm = {MC2 = 45}\n"),
      "experiment 'planar_forces': 'MC2' is not a bone from a joint of this digit to the next");
  EXPECT_EQ(refusal("[outside]\nlength_mm = {MP2 = 2.5}\n"),
            "experiment 'planar_forces': MP2 of 2.5 mm is 0.1 times that of the subject, 25 mm; "
            "wanted 0.5 to 2 times");
  EXPECT_THAT(refusal("[outside]\nlength_mm = {MP2 = 51}\n"), HasSubstr("2.04 times"));
  EXPECT_THAT(refusal(""), HasSubstr("nothing was measured on its outside"));
  EXPECT_THAT(
      refusal("[outside]\nlength_mm = {MP2 = 25}\n", planar_digit(sample::planar_finger_of_arms())),
      HasSubstr("'FDP' is known by its moment arms alone"));
}

// Which hand is which: one specimen has one size, stated once or in all its experiments.
TEST(OutsideScale, OneSpecimenHasOneSize) {
  sample::FitSetup setup = sample::middle_finger(sample::kAxes, "H01", "an_chao_middle");
  Experiment again = setup.experiments.front();
  again.name = "again";
  setup.experiments.front().outside_length = sized(1.1, 1, 1);
  setup.experiments.push_back(again);
  const FitProblem problem(setup.digit, setup.parameters, setup.experiments, 0, {},
                           Scaling::kOutside);
  EXPECT_EQ(problem.experiments()[1].outside_length, setup.experiments[0].outside_length);
  setup.experiments[1].outside_length = sized(1.2, 1, 1);
  EXPECT_EQ(message_of([&] {
              (void)FitProblem(setup.digit, setup.parameters, setup.experiments, 0, {},
                               Scaling::kOutside);
            }),
            "experiments 'synek2019_H01' and 'again' state different lengths in [outside] of one "
            "specimen, H01");
}

/// Two hands of different sizes under the same protocol.
sample::FitSetup two_sizes(const Lengths& first, const Lengths& second) {
  sample::FitSetup setup = sample::middle_finger(sample::kAxesAndPaths, "H01", "an_chao_middle");
  setup.experiments.front().outside_length = first;
  Experiment other = setup.experiments.front();
  other.outside_length = second;
  other.name = "other";
  other.specimen = "other";
  setup.experiments.push_back(other);
  return setup;
}

FitProblem problem_of(const sample::FitSetup& setup, Scaling scaling) {
  return {setup.digit, setup.parameters, setup.experiments, 0, {}, scaling};
}

TEST(OutsideScale, JacobiansAreThoseOfDifferences) {
  const FitProblem problem =
      problem_of(two_sizes(sized(1.2, 0.9, 1), sized(0.8, 1, 1.1)), Scaling::kOutside);
  std::mt19937 rng(3);
  const VectorXd z = 0.5 * sample::normal(problem.size(), rng);
  const Residuals at = fit_residuals(problem, z, WithJacobian::kYes);
  const double h = 1e-4;
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    VectorXd more = z, less = z;
    more[i] += h;
    less[i] -= h;
    const VectorXd slope = (fit_residuals(problem, more, WithJacobian::kNo).r -
                            fit_residuals(problem, less, WithJacobian::kNo).r) /
                           (2 * h);
    EXPECT_TRUE(matrix_near(at.J.col(i), slope, 1e-6)) << i;  // h^2 times third derivatives
  }
}

// A stranger's size is known without forces; the population of one other hand predicts the rest.
TEST(OutsideScale, StrangersArePredictedInTheirOwnSize) {
  sample::FitSetup setup = two_sizes(sized(1.2, 0.9, 1), sized(0.85, 1.15, 1.1));
  std::mt19937 rng(12);
  const VectorXd person = VectorXd::Zero(setup.parameters.coordinates());
  for (Experiment& experiment : setup.experiments) {
    sample::FitSetup truth = setup;
    truth.digit = scale_to_outside(setup.digit, experiment);
    sample::simulate(truth, person, 0, rng, experiment);
  }
  const auto left_out = [&](Scaling scaling) {
    const CrossValidation found = cross_validate(problem_of(setup, scaling), LeaveOut::kSpecimen);
    return std::max(found.experiments[0].error.relative, found.experiments[1].error.relative);
  };
  const double scaled = left_out(Scaling::kOutside), plain = left_out(Scaling::kSubject);
  RecordProperty("scaled", std::to_string(scaled));
  RecordProperty("plain", std::to_string(plain));
  EXPECT_LT(scaled, plain);
}

/// Distance of the population that is found from the true one, in prior sds.
double population_error(const sample::FitSetup& setup, Scaling scaling, const VectorXd& truth) {
  const FitProblem problem = problem_of(setup, scaling);
  const Solution found = sample::fit_precisely(problem);
  const VectorXd u = displacements(problem.coordinates(), found.z, kPopulation);
  return (u - truth).cwiseQuotient(sample::population_sds(setup.parameters)).norm() /
         std::sqrt(static_cast<double>(truth.size()));
}

TEST(OutsideScale, HandsOfTwoSizesTellWhatTheyShareBetter) {
  double scaled = 0, plain = 0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    sample::FitSetup setup = two_sizes(sized(1.2, 0.9, 1), sized(0.85, 1.15, 1.1));
    std::mt19937 rng(seed);
    const VectorXd shared = sample::population_sds(setup.parameters)
                                .cwiseProduct(sample::normal(setup.parameters.coordinates(), rng));
    for (Experiment& experiment : setup.experiments) {
      sample::FitSetup truth = setup;
      truth.digit = scale_to_outside(setup.digit, experiment);
      sample::simulate(truth, sample::draw_person(setup.parameters, shared, rng), 0.02, rng,
                       experiment);
    }
    scaled += population_error(setup, Scaling::kOutside, shared) / 4;
    plain += population_error(setup, Scaling::kSubject, shared) / 4;
  }
  RecordProperty("scaled", std::to_string(scaled));
  RecordProperty("plain", std::to_string(plain));
  EXPECT_LT(scaled, plain);
}

}  // namespace
}  // namespace thenar
