#include "base/field_names.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

// Values of matlab.lang.makeValidName, from its documentation and its rules.
TEST(FieldNames, AreThoseOfMatlab) {
  EXPECT_EQ(field_name("PIP3"), "PIP3");
  EXPECT_EQ(field_name("left/opening"), "left_opening");
  EXPECT_EQ(field_name("box.x"), "box_x");
  EXPECT_EQ(field_name("Item_#"), "Item__");
  EXPECT_EQ(field_name("Price/Unit"), "Price_Unit");
  EXPECT_EQ(field_name("1st order"), "x1stOrder");
  EXPECT_EQ(field_name("Contact"), "Contact");
  EXPECT_EQ(field_name("end"), "xEnd");
  EXPECT_EQ(field_name("_under"), "x_under");
  EXPECT_EQ(field_name(""), "x");
  EXPECT_EQ(field_name(std::string(80, 'a')).size(), 63U);
}

TEST(FieldNames, LeadBackWhereOnlyOneNameHasThem) {
  const std::vector<std::string> names{"left/opening", "a b", "a-b", "a_b", "c-d"};
  EXPECT_EQ(name_of_field("left/opening", names), "left/opening");
  EXPECT_EQ(name_of_field("left_opening", names), "left/opening");
  EXPECT_EQ(name_of_field("c_d", names), "c-d");
  EXPECT_EQ(name_of_field("a_b", names), "a_b");  // is a name itself
  EXPECT_EQ(name_of_field("aB", names), "a b");
  EXPECT_EQ(name_of_field("e", names), "");
  EXPECT_EQ(name_of_field("x_y", {"x/y", "x-y"}), "");
}

}  // namespace
}  // namespace thenar
