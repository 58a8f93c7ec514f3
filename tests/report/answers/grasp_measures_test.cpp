// Tests for report/answers/grasp_measures.cpp.

#include "report/answers/grasp_measures.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace thenar {
namespace {

MeasureRow row_of(const GraspMeasures& measures, const std::string& name) {
  const std::vector<MeasureRow> rows = measure_rows(measures);
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const MeasureRow& row) { return row.name == name; });
  return found == rows.end() ? MeasureRow{} : *found;
}

TEST(GraspMeasureRows, PutsWhatEffortsSupportFirst) {
  GraspMeasures measures;
  measures.pull.value = SupportedLoad{46.5, 714.5};
  const MeasureRow row = row_of(measures, "supports a pull along z");
  EXPECT_EQ(row.value, "46.5 N");
  EXPECT_EQ(row.note.find("by efforts and friction; 714.5 N with rigid structure"), 0U) << row.note;
  const OrderedJson json = json_of(measures);
  EXPECT_EQ(json["pull_N"], 714.5);
  EXPECT_EQ(json["pull_by_efforts_N"], 46.5);
}

TEST(GraspMeasureRows, TellsOneNumberWhereStructureAddsNothing) {
  GraspMeasures measures;
  measures.turn.value = SupportedLoad{0.5, 0.5};
  const MeasureRow row = row_of(measures, "supports a torque about z");
  EXPECT_EQ(row.value, "0.5 N m");
  EXPECT_EQ(row.note, "");
}

TEST(GraspMeasureRows, TellsTheSupportedMultipleOfTheWeight) {
  GraspMeasures measures;
  measures.times_weight.value = SupportedLoad{203.9, 714.5};
  const MeasureRow row = row_of(measures, "multiple of its weight supported");
  EXPECT_EQ(row.value, "203.9, along its weakest axis");
  EXPECT_EQ(row.note.find("by efforts and friction; 714.5 with rigid structure"), 0U) << row.note;
}

TEST(GraspMeasureRows, SaysWhyThereIsNoValue) {
  GraspMeasures measures;
  measures.pull.message = "the effort of 'motor' is unknown";
  const MeasureRow row = row_of(measures, "supports a pull along z");
  EXPECT_EQ(row.value, "no value");
  EXPECT_EQ(row.note, measures.pull.message);
  const OrderedJson json = json_of(measures);
  EXPECT_TRUE(json["pull_N"].is_null());
  EXPECT_TRUE(json["pull_by_efforts_N"].is_null());
  EXPECT_EQ(json["reasons"]["pull_N"], measures.pull.message);
}

}  // namespace
}  // namespace thenar
