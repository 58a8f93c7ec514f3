// Tests for dynamics/human/tendon_group.cpp: which digits pull as one.

#include "dynamics/human/tendon_group.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

using Groups = std::vector<std::vector<int>>;

// Four digits in a row: each shares a muscle with the next.
const std::vector<std::vector<std::string>> kRow{{"a", "ab"}, {"ab", "bc"}, {"bc", "cd"}, {"cd"}};

TEST(ContractingGroups, DigitsThatDoNotContractStandAlone) {
  EXPECT_EQ(contracting_groups(kRow, {false, false, false, false}), (Groups{{0}, {1}, {2}, {3}}));
}

// What joins a digit that contracts contracts as well: both ways along the row, whichever begins.
TEST(ContractingGroups, WhatJoinsMakesTheNextJoin) {
  for (std::size_t i = 0; i < 4; ++i) {
    std::vector<bool> excited(4, false);
    excited[i] = true;
    EXPECT_EQ(contracting_groups(kRow, excited), (Groups{{0, 1, 2, 3}})) << i;
  }
}

TEST(ContractingGroups, AMuscleThatIsNotSharedJoinsNothing) {
  EXPECT_EQ(contracting_groups({{"a"}, {"b", "bd"}, {"c"}, {"bd"}}, {true, true, false, false}),
            (Groups{{0}, {1, 3}, {2}}));
}

}  // namespace
}  // namespace thenar
