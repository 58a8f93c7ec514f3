// Tests for sampling/diagnostics/: Pareto tails and leave-one-out.

#include "sampling/diagnostics/leave_one_out.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/random_stream.h"
#include "sampling/diagnostics/convergence.h"

namespace thenar {
namespace {

/// Generalised Pareto quantiles at (i + 1/2) / n.
Eigen::VectorXd pareto_quantiles(double k, double sigma, int n) {
  return Eigen::VectorXd::NullaryExpr(n, [&](Eigen::Index i) {
    const double rest = 1 - (double(i) + 0.5) / n;
    return k == 0 ? -sigma * std::log(rest) : sigma * (std::pow(rest, -k) - 1) / k;
  });
}

// The sd of the best estimate of k is (1 + k) / sqrt(n); quantiles without noise do better.
TEST(ParetoTail, FindsKnownShapes) {
  for (const double k : {-0.3, 0.0, 0.3, 0.7, 1.2}) {
    const ParetoFit fit = fit_pareto(pareto_quantiles(k, 2.5, 4000));
    EXPECT_NEAR(fit.k, k, (1 + k) / std::sqrt(4000)) << k;
    EXPECT_NEAR(fit.sigma, 2.5, 2.5 * 2 / std::sqrt(4000)) << k;
  }
}

TEST(ParetoTail, FindsRandomShapesWithinTheirError) {
  const double k = 0.5;
  Eigen::ArrayXd found(200);
  for (int run = 0; run < 200; ++run) {
    RandomStream random(1, run, 0);
    Eigen::VectorXd x =
        Eigen::VectorXd::NullaryExpr(200, [&] { return (std::pow(random.uniform(), -k) - 1) / k; });
    std::sort(x.begin(), x.end());
    found[run] = fit_pareto(x).k;
  }
  // Sd (1 + k) / sqrt(n) of one, and a bias of a fraction of it.
  const double sd = (1 + k) / std::sqrt(200);
  EXPECT_NEAR(found.mean(), k, 0.25 * sd);
  EXPECT_NEAR(std::sqrt((found - found.mean()).square().mean()) / sd, 1, 0.2);  // 4 / sqrt(400)
}

// Ratios whose tail is exactly Pareto: (1 - p)^-k. M = 3 sqrt(10000) = 300.
TEST(ParetoTail, WeightsTellTheirTail) {
  const int n = 10000;
  for (const double k : {0.2, 0.6, 0.9}) {
    const Eigen::VectorXd log_ratio = Eigen::VectorXd::NullaryExpr(
        n, [&](Eigen::Index i) { return -k * std::log(1 - (double(i) + 0.5) / n); });
    const SmoothedWeights of = smooth_weights(log_ratio);
    const double drawn = (300 * k + 5) / 310;  // towards 1/2
    EXPECT_NEAR(of.k, drawn, (1 + k) / std::sqrt(300)) << k;
    EXPECT_NEAR(of.log_weight.array().exp().sum(), 1, 1e-12);
    EXPECT_LE(of.log_weight.maxCoeff(), 0);
  }
}

TEST(ParetoTail, EqualRatiosNeedNoSmoothing) {
  const SmoothedWeights of = smooth_weights(Eigen::VectorXd::Constant(100, 3));
  EXPECT_EQ(of.k, 0);
  EXPECT_NEAR(of.log_weight[7], -std::log(100), 1e-14);
  EXPECT_TRUE(std::isinf(smooth_weights(Eigen::VectorXd::LinSpaced(10, 0, 1)).k));
}

TEST(ParetoTail, RefusesWhatIsNoTail) {
  EXPECT_THROW((void)fit_pareto(Eigen::Vector4d(1, 2, 3, 4)), InputError);
  EXPECT_THROW((void)fit_pareto(Eigen::VectorXd::Zero(10)), InputError);
  EXPECT_THROW((void)smooth_weights(Eigen::Vector2d(0, std::nan(""))), InputError);
}

double log_normal(double x, double mean, double variance) {
  return -0.5 * (std::log(2 * M_PI * variance) + (x - mean) * (x - mean) / variance);
}

/// y_i ~ N(mu, 1), mu ~ N(0, 100): exact posterior, and exactly what y_i is without itself.
struct Conjugate {
  Eigen::VectorXd y;

  [[nodiscard]] double precision(int left_out) const { return 0.01 + double(y.size() - left_out); }

  [[nodiscard]] Eigen::MatrixXd draw_log_likelihood(int draws) const {
    RandomStream random(1, 0, 0);
    const double mean = y.sum() / precision(0), sd = 1 / std::sqrt(precision(0));
    Eigen::MatrixXd of(y.size(), draws);
    for (int s = 0; s < draws; ++s) {
      const double mu = mean + sd * random.normal();
      for (Eigen::Index i = 0; i < y.size(); ++i) of(i, s) = log_normal(y[i], mu, 1);
    }
    return of;
  }

  [[nodiscard]] Eigen::VectorXd exact() const {
    return y.unaryExpr([this](double yi) {
      return log_normal(yi, (y.sum() - yi) / precision(1), 1 + 1 / precision(1));
    });
  }

  [[nodiscard]] double exact_seen() const {
    const double mean = y.sum() / precision(0);
    return y.unaryExpr([&](double yi) { return log_normal(yi, mean, 1 + 1 / precision(0)); }).sum();
  }
};

Conjugate conjugate() {
  RandomStream random(2, 0, 0);
  return {Eigen::VectorXd::NullaryExpr(30, [&] { return 3 + random.normal(); })};
}

TEST(LeaveOneOut, EqualsTheExactOneOfAConjugateModel) {
  const Conjugate model = conjugate();
  const LeaveOneOut of = leave_one_out(model.draw_log_likelihood(16000), 4);
  const Eigen::VectorXd exact = model.exact();
  // The error of a mean of N = 16000 weights near 1, whose log has the sd |y - mean| / sqrt(30).
  for (Eigen::Index i = 0; i < exact.size(); ++i)
    EXPECT_NEAR(of.pointwise[i], exact[i], 0.01) << "Pareto k " << of.k[i];
  EXPECT_NEAR(of.elpd, exact.sum(), 0.03);
  EXPECT_NEAR(of.effective_parameters, model.exact_seen() - exact.sum(), 0.03);
  EXPECT_NEAR(of.se, std::sqrt(30.0 * (exact.array() - exact.mean()).square().sum() / 29), 0.03);
  EXPECT_LT(of.k.maxCoeff(), 0.5);
  EXPECT_EQ(of.good_k, 0.7);
  EXPECT_THAT(of.warnings, testing::IsEmpty());
}

// Leaving it out moves the posterior by 17 of its sds: no draw is there.
TEST(LeaveOneOut, DoubtsAGrossOutlier) {
  Conjugate model = conjugate();
  model.y[12] += 100;
  const LeaveOneOut of = leave_one_out(model.draw_log_likelihood(4000), 4);
  EXPECT_GT(of.k[12], 0.7);
  ASSERT_EQ(of.warnings.size(), 1U);
  EXPECT_THAT(of.warnings[0],
              testing::StartsWith("1 of 30 observations have a Pareto k above 0.70"));
  EXPECT_THAT(of.warnings[0], testing::HasSubstr("of number 13"));
}

// A model that gives every observation exp(-1/2) of the density: 30 times one half, exactly.
TEST(LeaveOneOut, ComparesTwoModels) {
  const Eigen::MatrixXd seen = conjugate().draw_log_likelihood(1000);
  const ElpdDifference difference =
      compare_elpd(leave_one_out(seen, 4), leave_one_out(seen.array() - 0.5, 4));
  EXPECT_NEAR(difference.elpd, 15, 1e-9);
  EXPECT_NEAR(difference.se, 0, 1e-9);
}

// Ten walkers that do the same are worth one tenth of their draws, which lengthens the tail that
// is smoothed by sqrt(10).
TEST(LeaveOneOut, WalkersOfAnEnsembleAreNotIndependent) {
  const int draws = 500;
  const Eigen::MatrixXd apart = conjugate().draw_log_likelihood(2 * draws);
  Eigen::MatrixXd seen(apart.rows(), 20 * draws);
  std::vector<int> group(20);
  for (int chain = 0; chain < 20; ++chain) {
    group[chain] = chain / 10;
    seen.middleCols(chain * draws, draws) = apart.middleCols(group[chain] * draws, draws);
  }
  const LeaveOneOut of = leave_one_out(seen, 20, group);
  const Eigen::VectorXd likelihood = apart.row(0).array().exp();
  const double efficiency = mean_ess(likelihood.reshaped(draws, 2)) / (20 * draws);
  const double wanted = smooth_weights(-seen.row(0).transpose(), efficiency).k;
  EXPECT_NEAR(of.k[0], wanted, 1e-9);
  EXPECT_GT(std::abs(leave_one_out(seen, 20).k[0] - wanted), 0.01);
}

TEST(LeaveOneOut, RefusesWhatIsNotThere) {
  EXPECT_THROW((void)leave_one_out(Eigen::MatrixXd::Zero(3, 10), 4), InputError);
  EXPECT_THROW((void)leave_one_out(
                   Eigen::MatrixXd::Constant(3, 16, -std::numeric_limits<double>::infinity()), 4),
               InputError);
}

}  // namespace
}  // namespace thenar
