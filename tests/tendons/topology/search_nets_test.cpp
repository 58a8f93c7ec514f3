// Tests for tendons/topology/search_nets.cpp: why a search ends. What it finds is tested in
// planted_net_test.cpp.

#include "tendons/topology/search_nets.h"

#include <gtest/gtest.h>

#include "tests/tendons/topology/tug.h"

namespace thenar {
namespace {

/// A first band of this share of 4 N, read twice at 1 % of the whole.
std::vector<TendonRecord> read_twice(double share) {
  const double full = tug::kArm * 4;
  return {2, tug::record(4, -share * full, 0.01 * full)};
}

NetSearchResult explore(double share, const std::vector<TendonTest>& pool, const TestOracle& oracle,
                        int max_tests = 36) {
  std::mt19937 random(1);
  NetSearchOptions options;
  options.max_tests = max_tests;
  return search_nets(tug::candidate(2), read_twice(share), {pool, oracle}, random, options);
}

TEST(ExploreNets, SaysThatNobodyMeasures) {
  EXPECT_EQ(explore(0.5, {tug::test(4), tug::test(8)}, {}).stop, NetSearchStop::kNoOracle);
}

// The second test repeats the first, on which all nets that fit agree.
TEST(ExploreNets, SaysThatTheNetsThatAreLeftAgree) {
  const std::vector<TendonRecord> known = read_twice(0.5);
  EXPECT_EQ(explore(0.5, {known[0].test}, {}).stop, NetSearchStop::kAgreed);
}

TEST(ExploreNets, SaysThatNoTestIsLeft) {
  EXPECT_EQ(explore(0.5, {}, {}).stop, NetSearchStop::kTests);
}

// No more is measured than allowed, also if there were more records than that before.
TEST(ExploreNets, MeasuresNoMoreThanAllowed) {
  int asked = 0;
  const TestOracle oracle = [&](const TendonTest& test) {
    ++asked;
    TendonRecord record = read_twice(0.5)[0];
    record.test = test;
    return record;
  };
  const NetSearchResult found = explore(0.5, {tug::test(4), tug::test(8), tug::test(6)}, oracle, 1);
  EXPECT_EQ(found.stop, NetSearchStop::kTests);
  EXPECT_EQ(asked, 0);
}

TEST(ExploreNets, SaysThatItWasStopped) {
  Progress stopped;
  stopped.stop_requested = [] { return true; };
  std::mt19937 random(1);
  EXPECT_EQ(
      search_nets(tug::candidate(2), read_twice(0.5), {{tug::test(4)}, {}}, random, {}, stopped)
          .stop,
      NetSearchStop::kAsked);
}

}  // namespace
}  // namespace thenar
