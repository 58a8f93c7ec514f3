// Tests for data/io/json_node.cpp.

#include "data/io/json_node.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

const std::string kPath = "a.json";

TEST(JsonNode, KnowsTheLinesOfItsValues) {
  const JsonNode root =
      parse_json(kPath, "{\"a\": [1,\n 2.5],\n\n \"b, c\": \"\\\"x\",\n\"d\":\nnull}", 10);
  EXPECT_EQ(root.line, 10);
  EXPECT_EQ(root.find("a")->line, 10);
  EXPECT_EQ(root.find("a")->items[1].line, 11);
  EXPECT_EQ(root.find("b, c")->line, 13);
  EXPECT_EQ(root.find("d")->line, 15);
}

TEST(JsonNode, KnowsKindsAndWholeNumbers) {
  const JsonNode root = parse_json(kPath, "[1, 1.0, -2, true, \"t\", null, {}]");
  EXPECT_TRUE(root.items[0].whole);
  EXPECT_FALSE(root.items[1].whole);
  EXPECT_EQ(root.items[2].number, -2);
  EXPECT_TRUE(root.items[3].flag);
  EXPECT_EQ(root.items[4].text, "t");
  EXPECT_EQ(root.items[5].kind, JsonKind::kNull);
  EXPECT_EQ(root.items[6].kind, JsonKind::kObject);
}

TEST(JsonNode, RefusesRepeatedMembersAndNumbersBeyondDoublesAtTheirLine) {
  EXPECT_EQ(message_of<DataError>([] { (void)parse_json(kPath, "{\"a\": 1,\n\"a\": 2}"); }),
            "a.json:2: 'a' is given twice");
  EXPECT_NO_THROW((void)parse_json(kPath, "[{\"a\": 1}, {\"a\": 2}]"));
  EXPECT_EQ(message_of<DataError>([] { (void)parse_json(kPath, "[1,\n\n1e999]"); }).substr(0, 37),
            "a.json:3: wanted JSON: number overflo");
}

TEST(JsonNode, IsWrittenInOrderAndSealedInAlphabeticOrder) {
  JsonNode node;
  node.set("b", 1).set("a", JsonNode(std::vector<double>{0.5, 1}));
  EXPECT_EQ(written(node), "{\"b\":1,\"a\":[0.5,1.0]}");
  EXPECT_EQ(canonical_text(node), "{\"a\":[0.5,1.0],\"b\":1}");
  EXPECT_EQ(parse_json(kPath, written(node, 1)), node);
}

TEST(TextMembers, AreTextsAndListsOfTexts) {
  const JsonNode root =
      parse_json(kPath, R"({"a": {"b": "c", "d": ["e", "f"], "g": 1, "h": [1], "i": {}}})");
  const auto members = text_members(root, {"a"});
  EXPECT_EQ(members.size(), 2U);
  EXPECT_EQ(members.at("b"), std::vector<std::string>{"c"});
  EXPECT_EQ(members.at("d"), (std::vector<std::string>{"e", "f"}));
}

TEST(TextMembers, AreNoneWhereNoObjectStands) {
  EXPECT_TRUE(text_members(parse_json(kPath, "{\"a\": 1}"), {"a"}).empty());
  EXPECT_TRUE(text_members(parse_json(kPath, "{\"a\": 1}"), {"b", "c"}).empty());
  EXPECT_TRUE(text_members(parse_json(kPath, "[1]"), {}).empty());
}

TEST(JsonValue, SaysWhatItWantedAndWhatCame) {
  const JsonNode root = parse_json(kPath, "{\"contacts\":\n[{\"friction\": \"much\"}]}");
  const JsonValue contact = JsonValue(kPath, root)["contacts"].entries("a list")[0];
  EXPECT_EQ(message_of<DataError>([&] { (void)contact["friction"].number("a number >= 0"); }),
            "a.json:2: wanted a number >= 0 as contacts.0.friction, got \"much\"");
  EXPECT_EQ(message_of<DataError>([&] { (void)contact["normal"]; }),
            "a.json:2: contacts.0 has no 'normal'");
  EXPECT_EQ(message_of<DataError>([&] { (void)contact.others_than({"frictoin"}); }),
            "a.json:2: contacts.0 knows no 'friction', did you mean 'frictoin'?");
}

}  // namespace
}  // namespace thenar
