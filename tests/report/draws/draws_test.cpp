// Tests for the blocks of report/draws/draws.cpp and chains.cpp.

#include "report/draws/draws.h"

#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "report/draws/chains.h"
#include "tests/report/quantity_samples.h"

namespace thenar {
namespace {

using sample::quantity;

std::vector<std::string> names_in(const Json& list) {
  std::vector<std::string> names;
  for (const Json& entry : list) names.push_back(entry["name"]);
  return names;
}

TEST(ChainsBlock, PutsTheWorstFirst) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Json block = chains_block(
      {quantity("good", 0, 1, 1.001), quantity("stuck", 0, 1, nan), quantity("bad", 0, 1, 1.2)},
      "");
  EXPECT_EQ(names_in(block["quantities"]), (std::vector<std::string>{"stuck", "bad", "good"}));
  EXPECT_TRUE(block["quantities"][0]["r_hat"].is_null());
}

TEST(ChainsBlock, ThinsTracesButRanksAllDraws) {
  const Json block = chains_block({quantity("a", 0, 1, 1, {1000})}, "");
  const Json& entry = block["quantities"][0];
  EXPECT_EQ(block["draws"].size(), 250U);
  EXPECT_EQ(block["draws"][1], 5);
  ASSERT_EQ(entry["traces"].size(), 4U);
  EXPECT_EQ(entry["traces"][0].size(), 250U);
  double ranked = 0;
  for (const Json& count : entry["ranks"]["counts"][2]) ranked += count.get<double>();
  EXPECT_EQ(ranked, 1000);
  EXPECT_EQ(entry["ranks"]["mean"], 50);
}

TEST(ChainsBlock, ShowsWalkersByTheirGroups) {
  Quantity walkers = quantity("a", 0, 1, 1, {50, 24});
  for (int c = 0; c < 24; ++c) walkers.group.push_back(c / 12);
  const Json block = chains_block({walkers}, "");
  EXPECT_EQ(block["chains"], Json({"group 1", "group 2"}));
  EXPECT_EQ(block["quantities"][0]["ranks"]["mean"], 30);  // 12 x 50 draws in 20 bins
}

TEST(ChainsBlock, DrawsAChainThatStands) {
  Quantity stuck = quantity("a", 0, 1, 1);
  stuck.draws.col(1).setConstant(2);
  const Json block = chains_block({stuck}, "");
  EXPECT_TRUE(block["quantities"][0]["autocorrelation"][1][0].is_null());
  EXPECT_FALSE(block["quantities"][0]["autocorrelation"][0][0].is_null());
}

TEST(ChainsBlock, RefusesQuantitiesOfOtherShape) {
  EXPECT_THROW((void)chains_block({quantity("a", 0, 1, 1), quantity("b", 0, 1, 1, {99})}, ""),
               InputError);
  EXPECT_THROW((void)chains_block({quantity("a", 0, 1, 1, {3})}, ""), InputError);
}

TEST(CornerBlock, ThinsAllQuantitiesAtTheSameDraws) {
  Quantity a = quantity("a", 0, 1, 1, {1000}), b = a;
  b.name = "b";
  b.draws *= 2;
  const Json block = corner_block({a, b}, "");
  const Json& list = block["quantities"];
  ASSERT_EQ(list[0]["draws"].size(), 800U);
  // Both are rounded to a thousandth of their own sd's decade.
  for (std::size_t i = 0; i < 800; ++i)
    EXPECT_NEAR(2 * list[0]["draws"][i].get<double>(), list[1]["draws"][i].get<double>(), 2e-3);
}

TEST(CornerBlock, StartsWithWhatWasLearnt) {
  std::vector<Quantity> all;
  for (int i = 0; i < 7; ++i) all.push_back(quantity("wide", 0, 0.9, 1));
  all.push_back(quantity("known", 0, 0.1, 1));
  const Json shown = corner_block(all, "")["shown"];
  EXPECT_EQ(shown.size(), 6U);
  EXPECT_EQ(shown.back(), 7);
}

// Prior -1, 0, 1 has mean 0 and sd 1; draws 0, 0.01 .. 1 have their quantiles where they say.
TEST(ForestBlock, CountsInPriorSds) {
  Quantity q = quantity("a", 0, 1, 1);
  q.draws = Eigen::VectorXd::LinSpaced(101, 0, 1);
  q.prior = Eigen::Vector3d(-1, 0, 1);
  q.truth = 0.4;
  const Json row = forest_block({q}, "")["rows"][0];
  EXPECT_EQ(row["low"], 0.05);
  EXPECT_EQ(row["inner_low"], 0.25);
  EXPECT_EQ(row["estimate"], 0.5);
  EXPECT_EQ(row["high"], 0.95);
  EXPECT_EQ(row["prior_low"], -0.9);
  EXPECT_EQ(row["truth"], 0.4);
  // sd of 0, 0.01 .. 1: sqrt(101 x 102 / 12) / 100 = 0.2930.
  EXPECT_EQ(row["display"], "0.50 \u00b1 0.29 deg; 71 % learnt");
}

TEST(ForestBlock, SortsByWhatWasLearnt) {
  const Json rows =
      forest_block({quantity("wide", 0, 1, 1), quantity("known", 3, 0.1, 1)}, "")["rows"];
  EXPECT_EQ(names_in(rows), (std::vector<std::string>{"known", "wide"}));
}

TEST(ForestBlock, KeepsTheBestAndTheLeastKnown) {
  std::vector<Quantity> all;
  for (int i = 1; i <= 20; ++i) all.push_back(quantity(std::to_string(i), 0, 0.05 * i, 1));
  const std::vector<std::string> names = names_in(forest_block(all, "", 7)["rows"]);
  EXPECT_EQ(names, (std::vector<std::string>{"1", "2", "3", "17", "18", "19", "20"}));
}

TEST(ForestBlock, LeavesOutWhatHasNoPrior) {
  Quantity q = quantity("a", 0, 1, 1);
  q.prior.resize(0);
  EXPECT_TRUE(forest_block({q}, "")["rows"].empty());
}

TEST(EstimateTable, HasARowForEachWorstFirst) {
  const Json table =
      estimate_table({quantity("good", 0, 1, 1.001), quantity("bad", 0, 1, 1.2)}, "");
  EXPECT_EQ(table["rows"][0][0], "bad [deg]");
  EXPECT_EQ(table["rows"][0].size(), table["columns"].size());
  EXPECT_EQ(table["rows"][0][8], 1.2);
}

// With an error of 0.0123 all digits beyond the third decimal are noise.
TEST(EstimateTable, ShowsNoDigitsThatTheErrorLeavesOpen) {
  Quantity q = quantity("a", 0, 1, 1);
  q.estimate.mean = 12.345678;
  q.estimate.mcse_mean = 0.0123456;
  q.estimate.sd = 1.98765;
  q.estimate.mcse_sd = 0.0;  // not known: as it is
  const Json row = estimate_table({q}, "")["rows"][0];
  EXPECT_EQ(row[1], 12.346);
  EXPECT_EQ(row[2], 0.012);
  EXPECT_EQ(row[3], 1.98765);
}

}  // namespace
}  // namespace thenar
