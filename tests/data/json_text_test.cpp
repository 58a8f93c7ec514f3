// Tests for data/io/json_text.cpp.

#include "data/io/json_text.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace thenar {
namespace {

TEST(TextMembers, AreTextsAndListsOfTexts) {
  const std::string text = R"({"a": {"b": "c", "d": ["e", "f"], "g": 1, "h": [1], "i": {}}})";
  const auto members = text_members("a.json", text, {"a"});
  EXPECT_EQ(members.size(), 2U);
  EXPECT_EQ(members.at("b"), std::vector<std::string>{"c"});
  EXPECT_EQ(members.at("d"), (std::vector<std::string>{"e", "f"}));
}

TEST(TextMembers, AreNoneWhereNoObjectStands) {
  EXPECT_TRUE(text_members("a.json", "{\"a\": 1}", {"a"}).empty());
  EXPECT_TRUE(text_members("a.json", "{\"a\": 1}", {"b", "c"}).empty());
  EXPECT_TRUE(text_members("a.json", "[1]", {}).empty());
  EXPECT_THROW((void)text_members("a.json", "{", {}), DataError);
}

}  // namespace
}  // namespace thenar
