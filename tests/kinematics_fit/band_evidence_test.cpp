// Tests for kinematics_fit/bands/band_problems.cpp and band_evidence.cpp.

#include "kinematics_fit/bands/band_evidence.h"

#include <cmath>

#include <gtest/gtest.h>

#include "kinematics_fit/bands/band_problems.h"
#include "kinematics_fit/covariance.h"
#include "kinematics_fit/fit_residuals.h"
#include "tests/kinematics_fit/planted_bands.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

const std::string kTwoNumbers = R"(
[[parameter]]
match = "net/transverse_u/slack"
optional = "yes"
state = "free"
[[parameter]]
match = "net/dorsal_plate/radial"
state = "free"
[[parameter]]
match = "hold/out_of_plane"
mean_mm = 39
)";

/// Forces of a drawn truth with all bands, and the fit to them.
FitProblem fit_to_planted(const std::string& rows, unsigned seed) {
  std::mt19937 random(seed);
  const Experiment plan = planted::experiment();
  const BandProblems problems = planted::problems(plan, {"transverse_u"}, rows);
  planted::Truth truth{{true}, sample::normal(problems.full_problem().size(), random)};
  return planted::problems(planted::measured(problems, truth, plan, random), {"transverse_u"}, rows)
      .full_problem();
}

/// Places from -6 to 6 prior sds (e^-18 is left out), where they are within 6 sds of the mode.
std::vector<double> places(double mode, double sd, double step) {
  std::vector<double> out;
  for (double z = std::max(-6.0, mode - 6 * sd); z <= std::min(6.0, mode + 6 * sd); z += step)
    out.push_back(z);
  return out;
}

/// log of the integral of exp(-1/2 |r_data|^2) N(z; 0, 1) by the trapezoidal rule, from its logs at
/// the places of a grid; `cell` is the product of the steps.
double log_sum(const std::vector<double>& logs, double cell, int dimensions) {
  const double most = *std::max_element(logs.begin(), logs.end());
  double sum = 0;
  for (const double each : logs) sum += std::exp(each - most);
  return most + std::log(sum * cell) - 0.5 * dimensions * std::log(2 * 3.14159265358979323846);
}

double log_density(const FitProblem& problem, const Eigen::VectorXd& z) {
  return -0.5 * fit_residuals(problem, z, WithJacobian::kNo).r.squaredNorm();
}

double by_quadrature(const FitProblem& problem, const Eigen::VectorXd& mode) {
  const Eigen::VectorXd sd = laplace_blocks(problem, mode).block_entries(0).diagonal().cwiseSqrt();
  const Eigen::Vector2d step = 0.5 * sd;
  std::vector<double> logs;
  for (const double first : places(mode[0], sd[0], step[0]))
    for (const double second : places(mode[1], sd[1], step[1]))
      logs.push_back(log_density(problem, Eigen::Vector2d(first, second)));
  return log_sum(logs, step.prod(), 2);
}

// Laplace's approximation is a per cent or two off where forces bend; draws mend it.
TEST(BandEvidence, IsTheIntegralOfTwoNumbers) {
  for (const unsigned seed : {1U, 2U}) {
    const FitProblem problem = fit_to_planted(kTwoNumbers, seed);
    ASSERT_EQ(problem.size(), 2);
    EvidenceOptions options;
    options.draws = 400;
    const BandEvidence found =
        band_evidence(problem, {Eigen::VectorXd::Zero(problem.size())}, options);
    ASSERT_TRUE(found.holds && found.converged && found.by_draws);
    const double exact = by_quadrature(problem, found.z);
    // Their own error is sqrt((1 / left - 1) / draws); the rule of half sds is exact to 1e-3 where
    // forces do not kink.
    const double error = std::sqrt((1 / found.draws_left - 1) / 400);
    EXPECT_NEAR(found.integral, exact, 4 * error + 5e-3) << seed;
    EXPECT_NEAR(found.laplace, exact, 0.3) << seed;
  }
}

TEST(BandEvidence, HasExactSlopesWithoutABand) {
  const BandProblems problems = planted::problems(planted::experiment(), {"transverse_u"});
  const FitProblem problem = problems.problem_with({false});
  EXPECT_EQ(problem.size(), problems.full_problem().size() - 1);
  std::mt19937 random(1);
  const Eigen::VectorXd z = 0.3 * sample::normal(problem.size(), random);
  const Residuals at = fit_residuals(problem, z, WithJacobian::kYes);
  constexpr double kStep = 5e-3;
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    const Eigen::VectorXd by = kStep * Eigen::VectorXd::Unit(z.size(), i);
    const Eigen::VectorXd difference = (fit_residuals(problem, z + by, WithJacobian::kNo).r -
                                        fit_residuals(problem, z - by, WithJacobian::kNo).r) /
                                       (2 * kStep);
    // A knot that is held on a bone or lies above it by rounding changes forces by 2e-7 N, which is
    // 2e-3 of a residual over the step.
    EXPECT_LT((difference - at.J.col(i)).norm(), 4e-3 + 1e-3 * at.J.col(i).norm()) << i;
  }
}

TEST(BandProblems, CarryOverWhatHasTheSameName) {
  const BandProblems problems = planted::problems(planted::experiment(), {"transverse_u"});
  const FitProblem without = problems.problem_with({false});
  Eigen::VectorXd z(problems.full_problem().size());
  for (Eigen::Index i = 0; i < z.size(); ++i) z[i] = 0.01 * static_cast<double>(i);
  const std::vector<std::string> names = problems.full_problem().coordinates().names();
  const Eigen::VectorXd moved = transfer_point(names, z, without);
  const std::vector<std::string> left = without.coordinates().names();
  for (std::size_t i = 0; i < left.size(); ++i) {
    const auto old = std::find(names.begin(), names.end(), left[i]) - names.begin();
    EXPECT_EQ(moved[static_cast<Eigen::Index>(i)], z[old]) << left[i];
  }
}

TEST(BandProblems, NameABandThatIsNotThere) {
  const TendonDigit digit = planted::digit();
  EXPECT_EQ(bands_matching(digit.net->net, {"crossing_*"}),
            (std::vector<std::string>{"crossing_u", "crossing_r"}));
  EXPECT_EQ(message_of([&] { (void)bands_matching(digit.net->net, {"crosing_*"}); }),
            "net extensor_hood has no passive band that matches 'crosing_*'");
}

// Without its lateral slips nothing holds an interosseous muscle.
TEST(BandEvidence, DoesNotHoldWhereAMuscleHasNothingToPull) {
  const BandProblems problems =
      planted::problems(planted::experiment(), {"interosseous_lateral_r"});
  const FitProblem problem = problems.problem_with({false});
  EXPECT_FALSE(band_evidence(problem, {Eigen::VectorXd::Zero(problem.size())}).holds);
}

}  // namespace
}  // namespace thenar
