// Tests for base/error.h.

#include "base/error.h"

#include <gtest/gtest.h>

#include "base/nearest_name.h"

namespace thenar {
namespace {

struct SpecialError : InputError {
  using InputError::InputError;
};

TEST(InField, NamesAFieldWhereTheErrorNamesNone) {
  try {
    in_field("digit", [] { require(false, "no"); });
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.field(), "digit");
    EXPECT_STREQ(error.what(), "no");
  }
}

TEST(InField, KeepsTheFieldAndTheTypeOfAnError) {
  try {
    in_field("digit", [] { throw SpecialError("no", "posture"); });
    FAIL();
  } catch (const SpecialError& error) {
    EXPECT_EQ(error.field(), "posture");
  }
}

TEST(InField, ReturnsTheResult) {
  EXPECT_EQ(in_field("digit", [] { return 3; }), 3);
}

TEST(IndexOfName, NamesTheFieldOfAnUnknownName) {
  try {
    (void)index_of_name("FPD", {"FDP"}, "muscle", "tension");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.field(), "tension");
  }
}

}  // namespace
}  // namespace thenar
