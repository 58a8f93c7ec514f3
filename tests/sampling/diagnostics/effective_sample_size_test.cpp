// Tests for sampling/diagnostics/effective_sample_size.cpp, against closed forms of autoregressive
// chains.

#include "sampling/diagnostics/effective_sample_size.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sampling/diagnostics/convergence.h"
#include "tests/sampling/diagnostics/reference_chains.h"

namespace thenar {
namespace {

using sample::autoregressive;

/// Four groups of ten walkers.
const std::vector<int> kGroupOfWalker = [] {
  std::vector<int> group;
  for (int chain = 0; chain < 40; ++chain) group.push_back(chain / 10);
  return group;
}();

// An autoregressive chain carries (1 - phi) / (1 + phi) of its draws.
TEST(EffectiveSampleSize, ForTheMeanOfAutoregressiveChains) {
  for (const double phi : {0.0, 0.5, 0.9, -0.5}) {
    const Eigen::MatrixXd x = autoregressive(phi, 20000, 4);
    const double expected = 80000 * (1 - phi) / (1 + phi);
    EXPECT_NEAR(mean_ess(x) / expected, 1, 0.1) << phi;
    EXPECT_NEAR(bulk_ess(x) / expected, 1, 0.1) << phi;
  }
}

// Their squares are correlated by phi^2.
TEST(EffectiveSampleSize, ForTheSdOfAutoregressiveChains) {
  const double phi = 0.8, square = phi * phi;
  const Eigen::MatrixXd x = autoregressive(phi, 20000, 4);
  EXPECT_NEAR(sd_ess(x) / (80000 * (1 - square) / (1 + square)), 1, 0.1);
}

// Alternating draws know the mean far better than independent ones: limited by N log10 N.
TEST(EffectiveSampleSize, OfAntitheticChainsIsBounded) {
  const Eigen::MatrixXd x = autoregressive(-0.99, 1000, 4);
  EXPECT_NEAR(mean_ess(x), 4000 * std::log10(4000.0), 1e-9);
}

// Independent walkers count one by one.
TEST(EffectiveSampleSize, OfIndependentWalkersAddsUp) {
  const Eigen::MatrixXd x = autoregressive(0.5, 5000, 40);
  EXPECT_NEAR(ensemble_ess(x, kGroupOfWalker) / (200000.0 / 3), 1, 0.1);
}

// The chain forgets so slowly that few lags are not enough: both ways meet at the closed form.
TEST(EffectiveSampleSize, OfLongMemoryNeedsAllLags) {
  const double phi = 0.99;
  const Eigen::MatrixXd x = autoregressive(phi, 50000, 4);
  EXPECT_NEAR(mean_ess(x) / (200000 * (1 - phi) / (1 + phi)), 1, 0.15);
}

}  // namespace
}  // namespace thenar
