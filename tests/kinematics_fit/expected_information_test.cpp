// Tests for kinematics_fit/bands/expected_information.cpp.

#include "kinematics_fit/bands/expected_information.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

PredictedReading reading(double probability, double mean, double variance) {
  return {probability, VectorXd::Constant(1, mean), MatrixXd::Constant(1, 1, variance)};
}

double density(const PredictedReading& of, double y) {
  const double v = of.covariance(0, 0), off = y - of.mean(0);
  return std::exp(-0.5 * off * off / v) / std::sqrt(2 * 3.14159265358979323846 * v);
}

/// H(y) - sum p H(y | k) of one row by the trapezoidal rule [bit].
double by_quadrature(const std::vector<PredictedReading>& hypotheses) {
  constexpr double kStep = 1e-3;
  double information = 0;
  for (double y = -40; y <= 40; y += kStep) {
    double mixture = 0;
    for (const PredictedReading& each : hypotheses) mixture += each.probability * density(each, y);
    for (const PredictedReading& each : hypotheses) {
      const double p = density(each, y);
      if (p > 0) information += kStep * each.probability * p * std::log2(p / mixture);
    }
  }
  return information;
}

TEST(ExpectedInformation, IsThatOfQuadratureForTwoHypotheses) {
  for (const double apart : {0.5, 1.0, 2.0, 4.0}) {
    const std::vector<PredictedReading> two{reading(0.3, 0, 1), reading(0.7, apart, 1.5)};
    // Gauss and Hermite's rule takes a smooth step at the boundary between two hypotheses.
    EXPECT_NEAR(expected_information(two, {{0, 1}})(0), by_quadrature(two), 0.01) << apart;
    EXPECT_NEAR(expected_information(two, {{0, 1}}, 40)(0), by_quadrature(two), 2e-4) << apart;
  }
}

TEST(ExpectedInformation, TellsAllWhereHypothesesAreFarApart) {
  const std::vector<PredictedReading> four{reading(0.25, 0, 1), reading(0.25, 100, 1),
                                           reading(0.25, 200, 1), reading(0.25, 300, 1)};
  const VectorXd bits = expected_information(four, {{0, 1, 2, 3}, {0, 0, 1, 1}, {0, 0, 0, 0}});
  EXPECT_NEAR(bits(0), 2, 1e-9);
  EXPECT_NEAR(bits(1), 1, 1e-9);
  EXPECT_NEAR(bits(2), 0, 1e-12);
}

TEST(ExpectedInformation, TellsNothingWhereTheyAgree) {
  const std::vector<PredictedReading> two{reading(0.4, 1, 2), reading(0.6, 1, 2)};
  EXPECT_NEAR(expected_information(two, {{0, 1}})(0), 0, 1e-12);
}

// Two rows of which one says nothing are worth the other alone; turned, they are worth the same.
TEST(ExpectedInformation, DoesNotDependOnTheAxesOfTheReading) {
  const double alone =
      expected_information({reading(0.5, 0, 1), reading(0.5, 1.5, 1)}, {{0, 1}}, 15)(0);
  Eigen::Matrix2d turn;
  turn << std::cos(0.7), -std::sin(0.7), std::sin(0.7), std::cos(0.7);
  const Eigen::Matrix2d V = turn * Eigen::Vector2d(1, 3).asDiagonal() * turn.transpose();
  const std::vector<PredictedReading> two{{0.5, Eigen::Vector2d::Zero(), V},
                                          {0.5, turn * Eigen::Vector2d(1.5, 0), V}};
  EXPECT_NEAR(expected_information(two, {{0, 1}}, 15)(0), alone, 3e-3);
}

// A mean over draws, with its own error.
TEST(ExpectedInformation, IsTheMeanFallOfEntropyOverReadings) {
  Eigen::Matrix3d V = Eigen::Matrix3d::Identity();
  V(0, 1) = V(1, 0) = 0.6;
  const std::vector<PredictedReading> three{
      {0.2, Eigen::Vector3d(0, 0, 0), V},
      {0.3, Eigen::Vector3d(1, 0.5, -1), 2 * V},
      {0.5, Eigen::Vector3d(-1, 1, 1), Eigen::Matrix3d::Identity()}};
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::discrete_distribution<int> which{0.2, 0.3, 0.5};
  double sum = 0, squares = 0;
  constexpr int kDraws = 20000;
  for (int i = 0; i < kDraws; ++i) {
    const int drawn = which(random);
    const Eigen::Vector3d v(normal(random), normal(random), normal(random));
    const Eigen::Matrix3d L = Eigen::Matrix3d(three[drawn].covariance).llt().matrixL();
    const Eigen::Vector3d y = Eigen::Vector3d(three[drawn].mean) + L * v;
    double mixture = 0, own = 0;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Matrix3d C = three[k].covariance;
      const Eigen::Vector3d off = y - Eigen::Vector3d(three[k].mean);
      const double p = std::exp(-0.5 * off.dot(C.inverse() * off)) / std::sqrt(C.determinant());
      mixture += three[k].probability * p;
      if (k == drawn) own = p;
    }
    sum += std::log2(own / mixture);
    squares += std::pow(std::log2(own / mixture), 2);
  }
  const double mean = sum / kDraws, error = std::sqrt(squares / kDraws - mean * mean) / 141;
  EXPECT_NEAR(expected_information(three, {{0, 1, 2}})(0), mean, 4 * error + 0.005);
}

TEST(AnswerEntropy, AddsWhatAnswersAlike) {
  EXPECT_DOUBLE_EQ(answer_entropy({0.25, 0.25, 0.5}, {0, 1, 2}), 1.5);
  EXPECT_DOUBLE_EQ(answer_entropy({0.25, 0.25, 0.5}, {0, 0, 1}), 1);
}

TEST(ExpectedInformation, RefusesWhatIsNoDistribution) {
  EXPECT_EQ(message_of([] {
              (void)expected_information({reading(0.5, 0, 1), reading(0.6, 0, 1)}, {});
            }),
            "probabilities of hypotheses sum to 1.1");
  EXPECT_EQ(message_of([] { (void)expected_information({reading(1, 0, -1)}, {}); }),
            "the covariance of a predicted reading must be positive definite");
}

}  // namespace
}  // namespace thenar
