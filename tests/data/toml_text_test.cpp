// Tests for data/io/toml_text.cpp.

#include "data/io/toml_text.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "data/io/toml_node.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

TEST(TomlText, NumbersReadBackToTheBit) {
  using Limits = std::numeric_limits<double>;
  for (const double value :
       {0.0, -0.0, 0.1, 1.0 / 3, 1e-7, -2.5e300, Limits::max(), Limits::denorm_min(), 5.0}) {
    const double back = parse_toml("x = " + toml_number(value), "t.toml").find("x")->number;
    EXPECT_EQ(back, value) << toml_number(value);
    EXPECT_EQ(std::signbit(back), std::signbit(value)) << toml_number(value);
  }
}

TEST(TomlText, RefusesWhatIsNoNumber) {
  EXPECT_THROW((void)toml_number(std::nan("")), InputError);
  EXPECT_THROW((void)toml_number(std::numeric_limits<double>::infinity()), InputError);
}

TEST(TomlText, QuotedTextsReadBack) {
  const std::string text = "a \"quote\", a back\\slash,\n a line, a tab\t and \x01";
  EXPECT_EQ(parse_toml("x = " + toml_quoted(text), "t.toml").find("x")->text, text);
}

TEST(TomlText, MatricesAreListsOfRows) {
  Eigen::Matrix3d matrix;
  matrix << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  EXPECT_EQ(toml_rows(matrix), "[[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]]");
}

TEST(TomlText, CitationKeysAreSplitAtCommas) {
  EXPECT_THAT(keys_in("An1983, Howe1996"), testing::ElementsAre("An1983", "Howe1996"));
  EXPECT_EQ(toml_keys("An1983, Howe1996"), "[\"An1983\", \"Howe1996\"]");
}

TEST(TomlText, KeysOfABibliographyStandInItsOrder) {
  const std::string bibtex = "@article{B, title = {x}}\n@book{A,\n  year = 1}\nno @entry here";
  EXPECT_THAT(citation_keys(bibtex), testing::ElementsAre("B", "A"));
  EXPECT_THAT(known_sources(), testing::Contains("Johnson1985"));
}

}  // namespace
}  // namespace thenar
