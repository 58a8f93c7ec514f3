// Tests for data/io/mesh/text_lines.cpp.

#include "data/io/mesh/text_lines.h"

#include <cmath>

#include <gmock/gmock.h>

#include "tests/message_of.h"

namespace thenar {
namespace {

TEST(TextLines, SkipsEmptyLinesAndComments) {
  const std::string path = "f.obj", text = "# head\n\n  \nv 1 2 # tail\r\n\nf 3\n";
  TextLines lines(text, path);
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.line(), 4);
  EXPECT_EQ(lines.word(), "v");
  EXPECT_EQ(lines.number(), 1);
  EXPECT_EQ(lines.whole(0, 2), 2);
  EXPECT_EQ(lines.word(), "");
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.line(), 6);
  EXPECT_EQ(lines.bytes_left(), 0U);
  EXPECT_FALSE(lines.next());
}

TEST(TextLines, GoOnBehindABackslash) {
  const std::string path = "f.obj", text = "f 1 \\\n 2\nv\n";
  TextLines lines(text, path);
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.word(), "f");
  EXPECT_EQ(lines.number(), 1);
  EXPECT_EQ(lines.number(), 2);
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.line(), 3);
}

TEST(TextLines, NameTheLineOfAWrongNumber) {
  const std::string path = "f.obj", text = "v 1\nv x\n";
  TextLines lines(text, path);
  ASSERT_TRUE(lines.next() && lines.next());
  EXPECT_EQ(lines.word(), "v");
  EXPECT_EQ(message_of<DataError>([&] { (void)lines.number(); }),
            "f.obj:2: wanted a finite number, got 'x'");
}

TEST(ParseDecimal, TakesWholeFiniteNumbersAlone) {
  double value = 1;
  EXPECT_TRUE(parse_decimal("+2.5e1", value));
  EXPECT_EQ(value, 25);
  EXPECT_TRUE(parse_decimal("1e-400", value));  // below the range of doubles
  EXPECT_EQ(value, 0);
  for (const char* wrong : {"1e400", "nan", "inf", "1.5x", "", "0x10"})
    EXPECT_FALSE(parse_decimal(wrong, value)) << wrong;
}

TEST(InQuotes, CutsLongWords) {
  EXPECT_EQ(in_quotes("short"), "'short'");
  EXPECT_EQ(in_quotes(std::string(50, 'a')), "'" + std::string(40, 'a') + "..'");
}

}  // namespace
}  // namespace thenar
