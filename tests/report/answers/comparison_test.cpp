// Tests for report/answers/comparison.cpp.

#include "report/answers/comparison.h"

#include <limits>

#include <gtest/gtest.h>

namespace thenar {
namespace {

/// One hand on two objects: one closure of two, whose load efforts bear in part, and none.
CompareResult sample() {
  HandOnObject ball;
  ball.hand = "jaw";
  ball.object = "ball";
  ball.approaches = 2;
  ball.closures = 1;
  ball.success = 0.5;
  ball.epsilon = Eigen::VectorXd::Constant(1, 0.25);
  BestGrasp best;
  best.margin = {{"pull", 3}};
  best.with_structure = {{"pull", std::numeric_limits<double>::infinity()}};
  ball.best = {best};
  HandOnObject card;
  card.hand = "jaw";
  card.object = "card";
  card.approaches = 2;
  card.outcomes[static_cast<std::size_t>(GraspOutcome::kMissed)] = 2;
  CompareResult result;
  result.comparison.tasks = {"force-closure", "pull"};
  result.comparison.cells = {ball, card};
  result.comparison.warnings = {"an effort is a guess"};
  return result;
}

TEST(ComparisonAnswer, HasARowForEachPair) {
  const Table table = table_of(sample());
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0][2], "50");
  EXPECT_EQ(table.rows[0][6], "0.250");
  EXPECT_EQ(table.header[9], "pull_N");
  EXPECT_EQ(table.rows[0][9].substr(0, 1), "3");
  EXPECT_EQ(table.header[10], "pull_with_structure_N");
  EXPECT_EQ(table.rows[0][10], "inf");
  EXPECT_EQ(table.rows[1][6], "-");
}

TEST(ComparisonAnswer, TellsHowApproachesEndedWhereNothingClosed) {
  const std::string text = text_of(sample());
  EXPECT_NE(text.find("2 missed the object"), std::string::npos) << text;
  EXPECT_NE(text.find("warning: an effort is a guess"), std::string::npos);
}

TEST(ComparisonAnswer, NamesAHandOfMostClosuresOnlyBeyondChance) {
  CompareResult result = sample();
  result.comparison.complete = true;
  result.comparison.hands = {"jaw", "claw"};
  result.comparison.cells[0].closures = 20;
  for (HandOnObject& cell : result.comparison.cells) cell.approaches = 20;
  HandOnObject claw = result.comparison.cells[0];
  claw.hand = "claw";
  claw.approaches = 40;
  for (const auto& [closures, named] : {std::pair(14, false), std::pair(10, true)}) {
    claw.closures = closures;
    CompareResult both = result;
    both.comparison.cells.push_back(claw);
    const std::string text = text_of(both);
    EXPECT_EQ(text.find("jaw has more force closures than each other") != text.npos, named) << text;
    EXPECT_EQ(text.find("no hand has more force closures") != text.npos, !named) << text;
    EXPECT_EQ(json_of(both)["most_closures"], named ? OrderedJson("jaw") : OrderedJson());
  }
}

// A count of types without a pinch would tell of the starts that were drawn, not of the hand.
TEST(ComparisonAnswer, CountsGraspTypesOfHandsThatPinchedOnly) {
  CompareResult result = sample();
  HandAbilities hand;
  hand.hand = "jaw";
  hand.types = {"power, pad, thumb and 2 digits", "power, palm, 2 digits"};
  result.comparison.abilities = {hand};
  EXPECT_FALSE(count_grasp_types(hand));
  const std::string without = text_of(result);
  result.comparison.abilities[0].types.emplace_back("precision, pad, thumb and 1 digit");
  EXPECT_EQ(count_grasp_types(result.comparison.abilities[0]), 3U);
  EXPECT_NE(text_of(result), without);
}

TEST(ComparisonAnswer, HasNullAndInfiniteInJson) {
  const OrderedJson json = json_of(sample());
  EXPECT_EQ(json["cells"][0]["best"][0]["margin"]["pull_N"], 3);
  EXPECT_EQ(json["cells"][0]["best"][0]["margin_with_structure"]["pull_N"], "infinite");
  EXPECT_TRUE(json["cells"][0]["best"][0]["hand_epsilon_N"].is_null());
  EXPECT_EQ(json["cells"][1]["approaches"], 2);
}

}  // namespace
}  // namespace thenar
