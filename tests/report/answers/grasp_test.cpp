// Tests for report/answers/grasp.cpp.

#include "report/answers/grasp.h"

#include <gtest/gtest.h>

#include "tests/data_folder.h"

namespace thenar {
namespace {

GraspResult bobbin() {
  GraspRequest request;
  request.world.world = "barrett_bobbin";
  request.world.data = kData;
  return measure_grasp(request);
}

TEST(GraspAnswer, TellsTheSameGraspInThreeWays) {
  const GraspResult found = bobbin();
  const OrderedJson json = json_of(found);
  const Table table = table_of(found);
  const std::string text = text_of(found);
  EXPECT_EQ(json["contacts"].size(), found.grasp.contacts.size());
  EXPECT_EQ(table.rows.size(), found.grasp.contacts.size());
  for (const auto& row : table.rows) {
    EXPECT_EQ(row.size(), table.header.size());
    EXPECT_NE(text.find(row[0]), std::string::npos);
  }
  EXPECT_EQ(json["contact_model"], "hard point");
  EXPECT_NE(text.find("torsion about the normal is not modelled"), std::string::npos);
  EXPECT_TRUE(json["complete"]);
}

TEST(GraspAnswer, HasARowForEveryCoordinateThatClosed) {
  CloseRequest request;
  request.world.world = "arm_cube";
  request.world.data = kData;
  const CloseResult found = close_in_world(request);
  const Table table = table_of(found);
  EXPECT_EQ(table.rows.size(), found.grasp.grasp.closed.stopped.size());
  EXPECT_EQ(table.rows.back()[0], "opening");
  EXPECT_EQ(table.rows.back()[1], "slides");
  EXPECT_EQ(json_of(found)["coordinates"].size(), table.rows.size());
}

TEST(GraspAnswer, FoldsWarningsOfAKind) {
  EXPECT_EQ(folded({"effort, of a", "effort, of b", "palm: c"}),
            (std::vector<std::string>{"effort, of a (and 1 more of the kind)", "palm: c"}));
}

}  // namespace
}  // namespace thenar
