// Tests for base/nearest_name.cpp.

#include "base/nearest_name.h"

#include <gtest/gtest.h>

#include "tests/message_of.h"

namespace thenar {
namespace {

// Kitten, sitting: two replaced, one inserted, the example of Wagner and Fischer's algorithm.
TEST(NearestName, CountsLetters) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("", "abc"), 3);
}

TEST(NearestName, IsSilentWhereNothingIsAlike) {
  EXPECT_EQ(did_you_mean("FPD", {"FDP", "EDC"}), ", did you mean 'FDP'?");
  EXPECT_EQ(did_you_mean("FPD", {"EDC"}), "");
  EXPECT_EQ(did_you_mean("fingers", {"nets"}), "");
  EXPECT_EQ(did_you_mean("nothere", {"rutgers"}), "");
}

// PIP2 and DIP2 are nearer by letters.
TEST(NearestName, PrefersNamesThatBeginWithTheTypedOne) {
  EXPECT_EQ(nearest_name("MCP2", {"PIP2", "MCP2_FE", "MCP2_AA", "DIP2"}), "MCP2_FE");
  EXPECT_EQ(nearest_name("tip", {"tip_force_axes", "tap", "tip_force"}), "tip_force");
}

TEST(NearestName, TakesNoSingleLetterForABeginning) {
  EXPECT_EQ(nearest_name("", {"MCP2_FE"}), "");
  EXPECT_EQ(nearest_name("M", {"MCP2_FE"}), "");
}

TEST(NearestName, ListsNames) {
  EXPECT_EQ(listed({"a", "b"}), "a, b");
  EXPECT_EQ(listed({}), "none");
}

TEST(IndexOfName, FindsTheName) { EXPECT_EQ(index_of_name("b", {"a", "b", "c"}, "letter"), 1u); }

TEST(IndexOfName, NamesTheNearestAndAllOthers) {
  EXPECT_EQ(message_of([] {
              (void)index_of_name("FPD", {"FDP", "EDC"}, "muscle");
            }),
            "no muscle 'FPD', did you mean 'FDP'? there are FDP, EDC");
  EXPECT_EQ(message_of([] {
              (void)index_of_name("xyz", {"FDP", "EDC"}, "muscle");
            }),
            "no muscle 'xyz'; there are FDP, EDC");
}

}  // namespace
}  // namespace thenar
