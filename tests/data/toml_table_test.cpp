// Tests for data/io/toml_table.cpp: units, sources, and the exact words of every refusal.

#include "data/io/toml_table.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/units.h"
#include "data/io/toml_text.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

const std::string kSource = "source = 'An1983'\n";

/// What a function that reads the top level of `text` says when it refuses; "" if it does not.
template <typename Read>
std::string refusal(const std::string& text, Read read) {
  try {
    const TomlFile file(text, "a.toml");
    TomlTable top = file.top();
    read(top);
    top.done();
  } catch (const DataError& e) {
    return e.what();
  }
  return "";
}

double length_in(const std::string& text) {
  const TomlFile file(kSource + text, "a.toml");
  TomlTable top = file.top();
  return top.number(Dimension::kLength, "radius");
}

const auto kReadRadius = [](TomlTable& top) { (void)top.number(Dimension::kLength, "radius"); };
const auto kReadMass = [](TomlTable& top) {
  (void)top.number(Dimension::kMass, "mass", Range::kNotNegative);
};
const auto kReadNothing = [](TomlTable&) {};

TEST(TomlTable, ConvertsEveryLengthToMetres) {
  EXPECT_DOUBLE_EQ(length_in("radius_mm = 7"), 0.007);
  EXPECT_DOUBLE_EQ(length_in("radius_cm = 7"), 0.07);
  EXPECT_DOUBLE_EQ(length_in("radius_m = 7"), 7);
}

TEST(TomlTable, ConvertsCompoundUnits) {
  const TomlFile file(
      kSource + "range_deg = 180\ninertia_g_mm2 = 2\nk_Nmm_per_deg = 1\nt_N_cm2 = 45", "a.toml");
  TomlTable top = file.top();
  EXPECT_DOUBLE_EQ(top.number(Dimension::kAngle, "range"), kPi);
  EXPECT_DOUBLE_EQ(top.number(Dimension::kInertia, "inertia"), 2e-9);
  EXPECT_DOUBLE_EQ(top.number(Dimension::kAngularStiffness, "k"), 0.18 / kPi);
  EXPECT_DOUBLE_EQ(top.number(Dimension::kStress, "t"), 450000);
}

TEST(TomlTable, NamesTheMisspeltKey) {
  EXPECT_EQ(refusal(kSource + "radus_mm = 1", kReadRadius),
            "a.toml:2: unknown key 'radus_mm', did you mean 'radius_mm'?");
}

TEST(TomlTable, RefusesAKeyNobodyAskedFor) {
  EXPECT_EQ(refusal("colour = 'red'", kReadNothing), "a.toml:1: unknown key 'colour'");
}

TEST(TomlTable, RefusesAUnitOfAnotherDimension) {
  EXPECT_EQ(refusal(kSource + "radius_deg = 1", kReadRadius),
            "a.toml:2: wanted a length (radius_mm, radius_cm, radius_m), got 'radius_deg'");
}

TEST(TomlTable, RefusesAnOptionalQuantityInAnotherDimension) {
  const auto read = [](TomlTable& top) { (void)top.number_or(Dimension::kMass, "mass", 0); };
  EXPECT_EQ(refusal(kSource + "mass_mm = 1", read),
            "a.toml:2: wanted a mass (mass_g, mass_kg), got 'mass_mm'");
}

TEST(TomlTable, RefusesAQuantityWithoutUnit) {
  EXPECT_EQ(refusal(kSource + "radius = 1", kReadRadius),
            "a.toml:2: wanted a length (radius_mm, radius_cm, radius_m), got 'radius'");
}

TEST(TomlTable, RefusesAQuantityGivenTwice) {
  EXPECT_EQ(refusal(kSource + "radius_mm = 1\nradius_m = 1", kReadRadius),
            "a.toml:3: given twice: 'radius_mm' and 'radius_m'");
}

TEST(TomlTable, NamesWhatIsMissing) {
  EXPECT_EQ(refusal(kSource, kReadRadius),
            "a.toml:1: the top level needs a length (radius_mm, radius_cm, radius_m)");
}

TEST(TomlTable, RefusesNumbersWithoutSource) {
  EXPECT_EQ(refusal("radius_mm = 1", kReadRadius),
            "a.toml:1: 'radius_mm' has no source: add source = \"Key\" to its table or to the top "
            "of the file");
}

TEST(TomlTable, RefusesAnUnknownSource) {
  EXPECT_EQ(refusal("source = 'An1984'\n", kReadNothing),
            "a.toml:1: source 'An1984' is neither in data/sources.bib nor in this file's "
            "[sources], did you mean 'An1983'?");
}

TEST(TomlTable, AcceptsTheFilesOwnSource) {
  EXPECT_EQ(refusal("source = 'Mine'\nradius_mm = 1\n[sources]\nMine = 'my own tape measure'",
                    kReadRadius),
            "");
}

TEST(TomlTable, InnerTableInheritsTheSource) {
  const TomlFile file(kSource + "[a]\nradius_mm = 1\n[b]\nradius_mm = 1\nsource = 'Chao1989'", "");
  TomlTable top = file.top();
  EXPECT_EQ(top.table("a")->source(), "An1983");
  EXPECT_EQ(top.table("b")->source(), "Chao1989");
}

TEST(TomlTable, RefusesNanAndInfinity) {
  EXPECT_EQ(refusal(kSource + "radius_mm = nan", kReadRadius),
            "a.toml:2: wanted 'radius_mm' as a finite number, got nan");
  EXPECT_EQ(refusal(kSource + "radius_mm = -inf", kReadRadius),
            "a.toml:2: wanted 'radius_mm' as a finite number, got -inf");
}

TEST(TomlTable, RefusesNumbersOutOfRange) {
  EXPECT_EQ(refusal(kSource + "mass_g = -3", kReadMass), "a.toml:2: wanted 'mass_g' >= 0, got -3");
  const auto fraction = [](TomlTable& top) {
    (void)top.number(Dimension::kNumber, "part", Range::kFraction);
  };
  EXPECT_EQ(refusal(kSource + "part = 1.5", fraction), "a.toml:2: wanted 'part' in 0..1, got 1.5");
}

TEST(TomlTable, RefusesAnotherKindOfValue) {
  EXPECT_EQ(refusal(kSource + "radius_mm = 'wide'", kReadRadius),
            "a.toml:2: wanted 'radius_mm' as a number, got a text");
  const auto name = [](TomlTable& top) { (void)top.text("name"); };
  EXPECT_EQ(refusal("name = 5", name), "a.toml:1: wanted 'name' as a text, got a number");
}

TEST(TomlTable, RefusesTheWrongCount) {
  const auto point = [](TomlTable& top) { (void)top.vector(Dimension::kLength, "point"); };
  EXPECT_EQ(refusal(kSource + "point_mm = [1, 2]", point),
            "a.toml:2: wanted 3 numbers in 'point_mm', got 2");
}

TEST(TomlTable, RefusesAZeroDirection) {
  const auto direction = [](TomlTable& top) { (void)read_direction(top, "axis"); };
  EXPECT_EQ(refusal(kSource + "axis = [0, 0, 0]", direction),
            "a.toml:2: wanted 'axis' as a direction, got a zero vector");
}

TEST(TomlTable, KeepsTheOrderOfLists) {
  const TomlFile file(kSource + "rows = {b = [1], a = [2], c = [3]}", "a.toml");
  std::string order;
  for (const NamedNumbers& list : file.top().lists("rows")) order += list.name;
  EXPECT_EQ(order, "bac");
}

TEST(TomlTable, SyntaxErrorNamesItsLine) {
  const std::string said = refusal("name = 'x'\nmass_g = = 3", kReadNothing);
  EXPECT_EQ(said.substr(0, 10), "a.toml:2: ") << said;
}

// Texts on which the parser's own assertions would end the program.
TEST(TomlTable, BrokenKeysAreErrorsToo) {
  for (const char* const text : {"a = 1\nb.[c] = 2", "a = 1\nb.= 2", "a = 1\n[b.[c]]"}) {
    const std::string said = refusal(text, kReadNothing);
    EXPECT_EQ(said.substr(0, 10), "a.toml:2: ") << text << ": " << said;
  }
}

TEST(TomlTable, MissingFileIsNamed) {
  try {
    (void)read_text_file("/nowhere/a.toml");
    FAIL() << "expected DataError";
  } catch (const DataError& e) {
    EXPECT_STREQ(e.what(), "/nowhere/a.toml:1: cannot be read: No such file or directory");
  }
}

TEST(NearestName, CountsEdits) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);  // the textbook pair
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(nearest_name("PP9", {"DP3", "PP3", "MC3"}), "PP3");
  EXPECT_EQ(nearest_name("xyzzy", {"DP3", "PP3"}), "");
}

TEST(Sources, ReadsTheKeysOfBibtex) {
  EXPECT_EQ(citation_keys("% @x{No}\n@article{A1,\n title = {B}}\n@book{C2, year = {1}}"),
            (std::vector<std::string>{"A1", "C2"}));
}

// A box of 120 m for one of 120 mm; 1e308 mm, whose square is infinite.
TEST(TomlTable, RefusesSizesThatNothingHas) {
  EXPECT_EQ(refusal(kSource + "radius_m = 120", kReadRadius),
            "a.toml:2: wanted 'radius_m' of at most 100 m in size, got 120");
  EXPECT_EQ(refusal(kSource + "radius_mm = -1e308", kReadRadius),
            "a.toml:2: wanted 'radius_mm' of at most 100 m in size, got -1e+308");
  EXPECT_EQ(refusal(kSource + "mass_g = 1e308", kReadMass),
            "a.toml:2: wanted 'mass_g' of at most 10000 kg in size, got 1e+308");
  EXPECT_EQ(length_in("radius_m = 100"), 100);
}

TEST(TomlTable, TakesManyKeys) {
  std::string text = kSource;
  for (int i = 0; i < 60'000; ++i) text += fmt::format("key{}_mm = 1\n", i);
  EXPECT_EQ(refusal(text, [](TomlTable& top) { (void)top.all(Dimension::kLength); }), "");
}

TEST(TomlTable, TellsTheLineOfALateSyntaxError) {
  std::string text;
  for (int i = 0; i < 20'000; ++i) text += fmt::format("key{} = 1\n", i);
  const std::string said = refusal(text + "a = \x01[", kReadNothing);
  EXPECT_EQ(said.substr(0, 14), "a.toml:20001: ");
}

}  // namespace
}  // namespace thenar
