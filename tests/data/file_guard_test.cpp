// Tests for data/io/file_guard.cpp.

#include "data/io/file_guard.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "data/io/toml_node.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

std::string times(const std::string& text, int n) {
  std::string all;
  for (int i = 0; i < n; ++i) all += text;
  return all;
}

/// What the guard says of a text; "" if it lets it pass.
std::string verdict(const std::string& text, GuardedKind kind) {
  try {
    guard_text(text, "a", kind);
    return "";
  } catch (const DataError& e) {
    return e.what();
  }
}

bool passes(const std::string& text, GuardedKind kind) { return verdict(text, kind).empty(); }

TEST(FileGuard, NamesTheLineWhereNestingPassesItsLimit) {
  const std::string text = "a = 1\nb = " + times("[", 100'000);
  EXPECT_EQ(verdict(text, GuardedKind::kToml),
            "a:2: wanted TOML that nests at most 32 deep, got more");
}

TEST(FileGuard, LimitsAreExact) {
  for (const auto& [kind, open, close] :
       {std::tuple{GuardedKind::kToml, "[", "]"}, std::tuple{GuardedKind::kJson, "[", "]"},
        std::tuple{GuardedKind::kScene, "{", "}"}, std::tuple{GuardedKind::kXml, "<a>", "</a>"}}) {
    const int most = limit_of(kind).depth;
    const std::string start = kind == GuardedKind::kToml ? "k = " : "";
    EXPECT_TRUE(passes(start + times(open, most) + times(close, most), kind)) << open;
    EXPECT_FALSE(passes(start + times(open, most + 1) + times(close, most + 1), kind)) << open;
  }
}

TEST(FileGuard, WhatIsClosedDoesNotNest) {
  EXPECT_TRUE(passes(times("<a b='1>2'></a><c/>", 1000), GuardedKind::kXml));
  EXPECT_TRUE(passes("[" + times("[{}],", 1000) + "0]", GuardedKind::kJson));
  EXPECT_TRUE(passes(times("[[a.b]]\nc.d = {e.f = [1.5, 2.5]}\n", 1000), GuardedKind::kToml));
  EXPECT_TRUE(passes(times("A { b [ 1 2 ] }\n", 1000), GuardedKind::kScene));
}

// Each dot of a key is a table within a table.
TEST(FileGuard, CountsDottedKeysOfToml) {
  EXPECT_FALSE(passes("a" + times(".a", 10'000) + " = 1", GuardedKind::kToml));
  EXPECT_FALSE(passes("[a" + times(".a", 10'000) + "]", GuardedKind::kToml));
  EXPECT_TRUE(passes("[a" + times(".a", 15) + "]\nb" + times(".b", 15) + "=1", GuardedKind::kToml));
  EXPECT_FALSE(
      passes("[a" + times(".a", 15) + "]\nb" + times(".b", 18) + "=1", GuardedKind::kToml));
  EXPECT_FALSE(passes(times("a.a.a.a.a = {", 8), GuardedKind::kToml));
}

TEST(FileGuard, TextsAndCommentsDoNotNest) {
  const std::string deep = times("[", 1000) + times("a.", 1000) + times("<a>", 1000);
  EXPECT_TRUE(passes("a = \"" + deep + "\\\"" + deep + "\"", GuardedKind::kToml));
  EXPECT_TRUE(passes("a = '" + deep + "\\'", GuardedKind::kToml));
  EXPECT_TRUE(passes("a = \"\"\"\n" + deep + "\"\n" + deep + "\"\"\"", GuardedKind::kToml));
  EXPECT_TRUE(passes("a = '''\n" + deep + "'\n" + deep + "'''", GuardedKind::kToml));
  EXPECT_TRUE(passes("a = 1 # " + deep, GuardedKind::kToml));
  EXPECT_TRUE(passes("[\"" + deep + "\"]", GuardedKind::kJson));
  EXPECT_TRUE(passes("A { # " + deep + "\n}", GuardedKind::kScene));
  EXPECT_TRUE(passes("<!-- " + deep + "--><a><![CDATA[" + deep + "]]></a>", GuardedKind::kXml));
}

TEST(FileGuard, WhatFollowsTextsAndCommentsNests) {
  const std::string deep = times("[", 1000), tags = times("<a>", 1000);
  for (const std::string text : {"a = \"\\\\\" \nb = ", "a = '\\' \nb = ", "a = '''\\''' \nb = ",
                                 "a = \"\"\"x\"\"\"\"\" \nb = ", "a = 1 # ' \" \nb = "})
    EXPECT_FALSE(passes(text + deep, GuardedKind::kToml)) << text;
  EXPECT_FALSE(passes("[\"\\\\\", " + deep, GuardedKind::kJson));
  EXPECT_FALSE(passes("# \" \n" + deep, GuardedKind::kScene));
  // Parsers do not agree on where declarations end.
  for (const std::string text :
       {"<!-- -->", "<!DOCTYPE a '>", "<?xml '>", "<![CDATA[]]>", "<b c='>'>"})
    EXPECT_FALSE(passes(text + tags, GuardedKind::kXml)) << text;
}

TEST(FileGuard, CountsValues) {
  const int most = static_cast<int>(limit_of(GuardedKind::kToml).values);
  EXPECT_TRUE(passes("a = [" + times("1,", most - 10) + "]", GuardedKind::kToml));
  EXPECT_EQ(verdict("\na = [" + times("1,", most + 10) + "]", GuardedKind::kToml),
            fmt::format("a:2: wanted TOML of at most {} values, got more", most));
  EXPECT_FALSE(passes("[" + times("[],", static_cast<int>(limit_of(GuardedKind::kJson).values)),
                      GuardedKind::kJson));
}

TEST(FileGuard, RefusesTextsThatAreTooLong) {
  const std::string text(limit_of(GuardedKind::kToml).bytes + 1, '#');
  EXPECT_EQ(
      verdict(text, GuardedKind::kToml),
      fmt::format("a:1: wanted TOML of at most {} bytes, got {}", text.size() - 1, text.size()));
}

// The parser recursed over every dot: 30,000 of them ended the program.
TEST(FileGuard, StandsBeforeTheParserOfToml) {
  EXPECT_EQ(
      message_of<DataError>([] { (void)parse_toml("a" + times(".a", 200'000) + " = 1", "a"); }),
      "a:1: wanted TOML that nests at most 32 deep, got more");
}

}  // namespace
}  // namespace thenar
