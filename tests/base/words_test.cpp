// Tests for base/words.cpp.

#include "base/words.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

TEST(Words, CountThings) {
  EXPECT_EQ(counted(1, "joint") + counted(2, "joint"), "1 joint2 joints");
  EXPECT_EQ(counted(0, "joint"), "0 joints");
}

TEST(Words, CutListsShort) {
  EXPECT_EQ(some_of({"a", "b", "c"}), "a, b, c");
  EXPECT_EQ(some_of({"a", "b", "c"}, 2), "a, b and 1 more");
  EXPECT_EQ(some_of({}), "");
}

}  // namespace
}  // namespace thenar
