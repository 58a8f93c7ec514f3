// Tests for sampling/diagnostics/simulation_based_calibration.cpp.

#include "sampling/diagnostics/simulation_based_calibration.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/random_stream.h"

namespace thenar {
namespace {

TEST(RankOfTruth, CountsDrawsBelow) {
  const Eigen::Vector4d draws(1, 2, 2, 3);
  EXPECT_EQ(rank_of_truth(0, draws), 0);
  EXPECT_EQ(rank_of_truth(2.5, draws), 3);
  EXPECT_EQ(rank_of_truth(2, draws), 2);
  EXPECT_THROW((void)rank_of_truth(std::nan(""), draws), InputError);
}

// Of 0 .. 99 in two chains, ten draws from the middles of tenths: 5, 15, .. 95.
TEST(RankOfTruth, ThinsEvenlyOverAllChains) {
  const Eigen::MatrixXd x = Eigen::VectorXd::LinSpaced(100, 0, 99).reshaped(50, 2);
  EXPECT_EQ(rank_of_truth(0, x, 10), 0);
  EXPECT_EQ(rank_of_truth(14.5, x, 10), 1);
  EXPECT_EQ(rank_of_truth(94.5, x, 10), 9);
  EXPECT_EQ(rank_of_truth(98, x, 10), 10);
  EXPECT_THROW((void)rank_of_truth(0, x, 101), InputError);
}

/// mu ~ N(0, 1), five y ~ N(mu, 1): ranks of mu among 63 draws of a posterior that believes in
/// mu ~ N(prior_mean, prior_sd^2), and whose sd is stretched.
Eigen::MatrixXi conjugate_ranks(double prior_mean, double prior_sd, double stretch) {
  const int runs = 500, draws = 63;
  Eigen::MatrixXi rank(1, runs);
  for (int run = 0; run < runs; ++run) {
    RandomStream random(1, run, 0);
    const double mu = random.normal();
    double sum = prior_mean / (prior_sd * prior_sd);
    for (int i = 0; i < 5; ++i) sum += mu + random.normal();
    const double precision = 1 / (prior_sd * prior_sd) + 5;
    const Eigen::VectorXd x = Eigen::VectorXd::NullaryExpr(
        draws, [&] { return sum / precision + stretch * random.normal() / std::sqrt(precision); });
    rank(0, run) = rank_of_truth(mu, x);
  }
  return rank;
}

TEST(Calibration, PassesAnExactPosterior) {
  const RankCalibration of = judge_calibration({"mu"}, conjugate_ranks(0, 1, 1), 63);
  EXPECT_THAT(of.warnings, testing::IsEmpty());
  EXPECT_GT(of.parameters[0].band_p, 0.005);
  EXPECT_GT(of.parameters[0].chi_square_p, 0.005);
}

TEST(Calibration, FailsAWrongPriorSd) {
  const RankCalibration of = judge_calibration({"mu"}, conjugate_ranks(0, 0.3, 1), 63);
  ASSERT_EQ(of.warnings.size(), 1U);
  EXPECT_THAT(of.warnings[0], testing::StartsWith("ranks of mu are not uniform (p = "));
  EXPECT_THAT(of.warnings[0], testing::EndsWith("below 0.005): its posterior is too narrow"));
}

TEST(Calibration, TellsWhatIsWrong) {
  const auto shape = [](const Eigen::MatrixXi& rank) {
    return judge_calibration({"mu"}, rank, 63).parameters[0].shape;
  };
  EXPECT_EQ(shape(conjugate_ranks(0, 1, 1.5)), "too wide");
  EXPECT_EQ(shape(conjugate_ranks(0, 1, 0.7)), "too narrow");
  EXPECT_EQ(shape(conjugate_ranks(2, 1, 1)), "too high");
  EXPECT_EQ(shape(conjugate_ranks(-2, 1, 1)), "too low");
}

TEST(Calibration, RefusesRanksOutOfRange) {
  EXPECT_THROW((void)judge_calibration({"mu"}, Eigen::MatrixXi::Constant(1, 10, 64), 63),
               InputError);
  EXPECT_THROW((void)judge_calibration({}, Eigen::MatrixXi::Zero(1, 10), 63), InputError);
}

}  // namespace
}  // namespace thenar
