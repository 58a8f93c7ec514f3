// Tests for report/answers/quality.cpp.

#include "report/answers/quality.h"

#include <limits>

#include <gtest/gtest.h>

namespace thenar {
namespace {

/// A set that lacks a direction, with a task of which one load has no answer.
ContactQualityResult short_of_one_direction() {
  ContactQualityResult result;
  result.contacts = "a.json";
  result.count = 2;
  result.torque_scale = 0.1;
  result.epsilon.rank = 5;
  result.epsilon.has_missing_direction = true;
  result.epsilon.missing_direction = ScaledWrench::unit(3);
  result.epsilon.worst_wrench = -ScaledWrench::unit(3);
  TaskQuality task;
  task.lower = task.upper = 0.5;
  task.worst_load.force = {0, 1, 0};
  task.grasp_forces = {2.0, std::nullopt, std::numeric_limits<double>::infinity()};
  result.task = task;
  return result;
}

TEST(QualityAnswer, SaysWhatCannotBeMade) {
  const std::string text = text_of(short_of_one_direction());
  EXPECT_NE(text.find("rank              5 of 6"), std::string::npos) << text;
  EXPECT_NE(text.find("cannot make"), std::string::npos) << text;
  EXPECT_NE(text.find("needs normal forces of 2 N"), std::string::npos) << text;
}

TEST(QualityAnswer, HasNullForWhatIsNotKnown) {
  const OrderedJson json = json_of(short_of_one_direction());
  EXPECT_TRUE(json["volume"].is_null());
  EXPECT_TRUE(json["grasp_matrix"].is_null());
  EXPECT_EQ(json["task"]["squeezes_N"], OrderedJson({2.0, nullptr, nullptr}));
  EXPECT_EQ(json["task"]["squeeze_N"], 2.0);
}

TEST(QualityAnswer, HasDashesInTables) {
  const Table table = table_of({short_of_one_direction(), short_of_one_direction()});
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.header.size(), table.rows[0].size());
  EXPECT_EQ(table.rows[0][5], "-");
  EXPECT_EQ(table.rows[0].back(), "2");
}

TEST(QualityAnswer, OfOneSetIsItselfAndOfSeveralAList) {
  EXPECT_EQ(json_of(std::vector<ContactQualityResult>{short_of_one_direction()}),
            json_of(short_of_one_direction()));
  EXPECT_EQ(json_of(std::vector<ContactQualityResult>{short_of_one_direction(),
                                                      short_of_one_direction()})["answers"]
                .size(),
            2U);
}

}  // namespace
}  // namespace thenar
