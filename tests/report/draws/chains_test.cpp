// Tests for report/draws/chains.cpp.

#include "report/draws/chains.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/random_stream.h"

namespace thenar {
namespace {

TEST(RankCounts, AreLevelIfChainsInterleave) {
  Eigen::MatrixXd x(4, 2);
  x << 1, 2, 3, 4, 5, 6, 7, 8;
  EXPECT_EQ(rank_counts(x, 2), Eigen::MatrixXd::Constant(2, 2, 2.0));
}

TEST(RankCounts, AreApartIfOneChainLiesAboveTheOther) {
  Eigen::MatrixXd x(4, 2), wanted(2, 2);
  x << 1, 5, 2, 6, 3, 7, 4, 8;
  wanted << 4, 0, 0, 4;
  EXPECT_EQ(rank_counts(x, 2), wanted);
}

// rho_t = phi^t:  1 + 2 phi / (1 - phi) = (1 + phi) / (1 - phi).
TEST(CorrelationTime, IsThatOfAnAutoregression) {
  const Eigen::VectorXd rho =
      Eigen::VectorXd::NullaryExpr(200, [](Eigen::Index t) { return std::pow(0.6, t); });
  EXPECT_NEAR(correlation_time(rho), 4, 1e-12);
}

// Pairs 1 + 0.5 and 0.2 - 0.3: the second is negative, so only the first counts, 2 x 1.5 - 1.
TEST(CorrelationTime, StopsAtTheFirstPairThatIsNotPositive) {
  EXPECT_NEAR(correlation_time(Eigen::Vector4d(1, 0.5, 0.2, -0.3)), 2, 1e-12);
}

TEST(CorrelationTime, IsAtLeastOne) { EXPECT_EQ(correlation_time(Eigen::Vector2d(1, -0.9)), 1); }

// x = 1, 2, 3, 4: deviations -1.5, -0.5, 0.5, 1.5; c_1 / c_0 = 1.25 / 5.
TEST(Autocorrelation, MatchesHandCalculation) {
  const Eigen::VectorXd rho = autocorrelation(Eigen::Vector4d(1, 2, 3, 4));
  EXPECT_NEAR(rho[0], 1, 1e-12);
  EXPECT_NEAR(rho[1], 0.25, 1e-12);
}

TEST(Autocorrelation, IsNotKnownOfAChainThatStands) {
  EXPECT_TRUE(std::isnan(autocorrelation(Eigen::Vector4d::Ones())[0]));
  EXPECT_TRUE(std::isnan(correlation_time(autocorrelation(Eigen::Vector4d::Ones()))));
}

// 500 0.05 0.95 1500/1999 = 17.8214; 1.96 sqrt of it is 8.2742.
TEST(RankBand, MatchesHandCalculation) {
  const CountBand band = rank_band(500, 4, 20, 1);
  EXPECT_NEAR(band.low, 25 - 8.2742, 1e-4);
  EXPECT_NEAR(band.high, 25 + 8.2742, 1e-4);
}

TEST(RankBand, HasNoWidthForASingleChain) {
  const CountBand band = rank_band(500, 1, 20, 1);
  EXPECT_EQ(band.low, 25);
  EXPECT_EQ(band.high, 25);
}

// Shares of counts within the band, for chains that remember: AR(1) with (1 + phi)/(1 - phi) = 3.
// The indicator of a bin forgets faster than the chain itself, so that the band is rather too wide;
// independent draws come near 95 %, but counts are whole numbers: 17 .. 33 hold 95.8 % of a normal.
TEST(RankBand, HoldsTheCountsThatItShould) {
  constexpr int kRuns = 60, kBins = 20;
  for (const double phi : {0.0, 0.5}) {
    const CountBand band = rank_band(500, 4, kBins, (1 + phi) / (1 - phi));
    double within = 0;
    for (int run = 0; run < kRuns; ++run) {
      Eigen::MatrixXd x(500, 4);
      for (int c = 0; c < 4; ++c) {
        RandomStream random(7, static_cast<std::uint32_t>(c), static_cast<std::uint32_t>(run));
        double value = random.normal();
        for (int i = 0; i < 500; ++i) {
          value = phi * value + std::sqrt(1 - phi * phi) * random.normal();
          x(i, c) = value;
        }
      }
      const Eigen::ArrayXXd counts = rank_counts(x, kBins).array();
      within += static_cast<double>((counts >= band.low && counts <= band.high).count());
    }
    const double share = within / (kRuns * 4 * kBins);
    EXPECT_GT(share, 0.94) << phi;
    EXPECT_LT(share, phi > 0 ? 1.0 : 0.97) << phi;
  }
}

TEST(Spread, IsEven) {
  EXPECT_EQ(spread(10, 4), (std::vector<Eigen::Index>{0, 2, 5, 7}));
  EXPECT_EQ(spread(3, 4), (std::vector<Eigen::Index>{0, 1, 2}));
  EXPECT_TRUE(spread(0, 4).empty());
}

TEST(Rounded, KeepsFourDigitsOfTheScale) {
  const Eigen::Vector2d values(123.456789, -0.00012);
  EXPECT_EQ(rounded(values, 1).dump(), "[123.457,-0.0]");
  EXPECT_EQ(rounded(values, 100).dump(), "[123.5,-0.0]");
  EXPECT_EQ(rounded(values, 1e-4).dump(), "[123.456789,-0.00012]");
}

TEST(Rounded, WritesWhatIsNoNumberAsNull) {
  const Eigen::Vector2d values(std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity());
  EXPECT_EQ(rounded(values, 1).dump(), "[null,null]");
}

TEST(Worse, PutsNaNFirst) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(worse(nan, 2));
  EXPECT_FALSE(worse(2, nan));
  EXPECT_FALSE(worse(nan, nan));
  EXPECT_TRUE(worse(1.1, 1.0));
}

}  // namespace
}  // namespace thenar
