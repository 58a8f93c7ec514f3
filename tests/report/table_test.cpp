// Tests for report/table.cpp.

#include "report/table.h"

#include <limits>

#include <gtest/gtest.h>

namespace thenar {
namespace {

const Table kTwo{{"joint", "angle_deg"}, {{"PIP3", "-5.0"}, {"MCP3_FE", "10.0"}}};

TEST(Table, PutsNumbersFlushRight) {
  EXPECT_EQ(aligned(kTwo),
            "joint    angle_deg\n"
            "PIP3          -5.0\n"
            "MCP3_FE       10.0\n");
}

TEST(Table, HasATitleOnlyWithRows) {
  EXPECT_EQ(titled("Joints", {{"joint"}, {{"PIP3"}}}), "Joints\njoint\nPIP3\n\n");
  EXPECT_EQ(titled("Joints", {{"joint"}, {}}), "");
}

TEST(Table, IsCsv) {
  EXPECT_EQ(csv({{"name", "says"}, {{"a,b", "\"x\""}, {"c", "1"}}}),
            "name,says\n\"a,b\",\"\"\"x\"\"\"\nc,1\n");
}

TEST(Table, ShowsNoNegativeZero) {
  EXPECT_EQ(shown(-0.001, 2), "0.00");
  EXPECT_EQ(shown(-std::numeric_limits<double>::infinity(), 2), "-inf");
}

}  // namespace
}  // namespace thenar
