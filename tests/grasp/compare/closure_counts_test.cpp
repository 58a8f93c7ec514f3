// Tests for grasp/compare/closure_counts.cpp.

#include "grasp/compare/closure_counts.h"

#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace thenar {
namespace {

/// Hands "0", "1", .. with so many closures of 20 approaches to each of some objects.
Comparison compared(const std::vector<std::vector<int>>& closures) {
  Comparison comparison;
  comparison.complete = true;
  for (std::size_t h = 0; h < closures.size(); ++h) {
    comparison.hands.push_back(std::to_string(h));
    for (std::size_t i = 0; i < closures[h].size(); ++i) {
      HandOnObject cell;
      cell.hand = std::to_string(h);
      cell.object = std::to_string(i);
      cell.approaches = 20;
      cell.closures = closures[h][i];
      comparison.cells.push_back(cell);
    }
  }
  return comparison;
}

TEST(ClosureCounts, AreOverAllObjects) {
  const ClosureCount count = count_closures(compared({{20, 0}, {14, 3}}), "1");
  EXPECT_EQ(count.closures, 17);
  EXPECT_EQ(count.approaches, 40);
  EXPECT_EQ(count.success_rate(), 17.0 / 40);
}

// Published tables of Fisher's test: p = 0.26 of 20 and 14 in 40, 0.04 of 20 and 10.
TEST(ClosureCounts, NameAHandOnlyBeyondChance) {
  EXPECT_EQ(hand_of_most_closures(compared({{20, 0}, {14, 0}})), "");
  EXPECT_EQ(hand_of_most_closures(compared({{20, 0}, {10, 0}})), "0");
  EXPECT_EQ(hand_of_most_closures(compared({{10, 0}, {20, 0}})), "1");
}

TEST(ClosureCounts, HoldTheFirstHandAgainstEachOther) {
  EXPECT_EQ(hand_of_most_closures(compared({{1, 0}, {20, 0}, {14, 0}})), "");
}

TEST(ClosureCounts, NameNoHandOfOneOrOfAComparisonThatIsNotComplete) {
  EXPECT_EQ(hand_of_most_closures(compared({{20, 20}})), "");
  Comparison half = compared({{20, 20}, {0, 0}});
  half.complete = false;
  EXPECT_EQ(hand_of_most_closures(half), "");
}

}  // namespace
}  // namespace thenar
