// Tests for data/io/toml_node.cpp.

#include "data/io/toml_node.h"

#include <gmock/gmock.h>

#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::StartsWith;

TEST(TomlNode, KeepsTheOrderOfTheFile) {
  const TomlNode top = parse_toml("zebra = 1\nape = 2\n[mouse]\nb = 3\na = 4\n", "t.toml");
  std::vector<std::string> names;
  for (const auto& [name, node] : top.members) names.push_back(name);
  EXPECT_THAT(names, testing::ElementsAre("zebra", "ape", "mouse"));
  EXPECT_EQ(top.find("mouse")->members[0].first, "b");
  EXPECT_EQ(top.find("mouse")->find("a")->number, 4);
  EXPECT_EQ(top.find("cat"), nullptr);
}

TEST(TomlNode, RemembersLinesAndKinds) {
  const TomlNode top =
      parse_toml("a = 1\n\nb = [\"x\",\n 2.5]\nc = true\nd = 2020-01-01\n", "t.toml");
  EXPECT_EQ(top.find("a")->line, 1);
  EXPECT_EQ(top.find("b")->line, 3);
  EXPECT_EQ(top.find("b")->items[0].kind, TomlKind::kText);
  EXPECT_EQ(top.find("b")->items[1].number, 2.5);
  EXPECT_EQ(top.find("b")->items[1].line, 4);
  EXPECT_EQ(top.find("c")->line, 5);
  EXPECT_TRUE(top.find("c")->flag);
  EXPECT_EQ(kind_name(top.find("d")->kind), "a date");
}

TEST(TomlNode, NamesTheLineOfASyntaxError) {
  const auto refusal = [](const std::string& text) {
    return message_of<DataError>([&] { (void)parse_toml(text, "t.toml"); });
  };
  EXPECT_THAT(refusal("a = 1\nb = = 2\n"), StartsWith("t.toml:2: "));
  EXPECT_THAT(refusal("a = 1\na = 2\n"), StartsWith("t.toml:2: "));
}

}  // namespace
}  // namespace thenar
