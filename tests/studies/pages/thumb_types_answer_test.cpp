// Tests for studies/pages/thumb_types_answer.cpp.

#include "studies/pages/thumb_types_answer.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

/// Ten thumbs, 8 of type 1 and 2 of type 4; one assumed number.
ThumbTypesResult ten_thumbs() {
  ThumbTypesResult result;
  result.types.draws = 10;
  result.types.complete = true;
  result.types.flexion_distal = 8;
  for (const bool flexion_distal : {true, false})
    for (const bool toward : {false, true}) {
      const ThumbType type{flexion_distal, toward};
      result.types.types[static_cast<std::size_t>(type.index())].type = type;
    }
  result.types.types[0].count = 8;
  result.types.types[3].count = 2;
  AxisVariability axis;
  axis.joint = "IP1";
  axis.assumed = {"tilt_sd_deg"};
  result.types.variability.axes = {axis};
  return result;
}

// Wilson's interval of 8 in 10 is 49.0 to 94.3 %.
TEST(ThumbTypesAnswer, GivesSharesWithIntervals) {
  const Table table = share_table(ten_thumbs());
  ASSERT_EQ(table.rows.size(), 4U);
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"1", "MCP flexion axis distal, normal ulnar",
                                                     "8", "80.0", "49.0", "94.3"}));
  const OrderedJson json = json_of(ten_thumbs());
  EXPECT_EQ(json["types"][3]["share"], 0.2);
  EXPECT_EQ(json["mcp_flexion_distal"]["share_published"], 0.652);
}

TEST(ThumbTypesAnswer, NamesItsFiles) {
  ThumbTypesResult result = ten_thumbs();
  result.types.inputs = {{"spread.toml", "s"}, {"thumb.toml", "t"}};
  EXPECT_EQ(files_of(result),
            (FileDigests{{"spread.toml", sha256("s")}, {"thumb.toml", sha256("t")}}));
}

TEST(ThumbTypesAnswer, SaysWhatIsAssumed) {
  EXPECT_EQ(assumed_words(ten_thumbs()), "Assumed, not measured: IP1 tilt_sd_deg");
}

TEST(ThumbTypesAnswer, HasNothingToSayOfNoDraws) {
  ThumbTypesResult none = ten_thumbs();
  none.types.draws = 0;
  EXPECT_TRUE(share_table(none).rows.empty());
  EXPECT_EQ(order_words(none), "");
}

}  // namespace
}  // namespace thenar
