// Tests for data/io/pad/pad_digest.cpp.

#include "data/io/pad/pad_digest.h"

#include <functional>
#include <set>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "data/io/pad/law_file.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

const std::string kText = R"(name = "mine"
source = "Me"
[sources]
Me = "Own measurement"
[shape]
length_mm = 20
width_mm = 14
height_mm = 8
bone_length_mm = 12
bone_width_mm = 6
bone_height_mm = 4
[skin]
kind = "ellipsoid"
size_mm = [11, 8, 9]
[pulp]
law = "ogden"
exponent = 3
shear_modulus_kPa = 9
poisson_ratio = 0.48
relaxation_share = [0.25, 0.5]
relaxation_time_ms = [4, 1400]
[[layer]]
thickness_mm = 0.15
law = "neo-hookean"
shear_modulus_MPa = 0.2
poisson_ratio = 0.3
)";

std::string digest_of(const std::string& text) { return pad_digest(parse_pad(text, "pad.toml")); }

/// The text with one piece changed.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = kText;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(PadDigest, DiffersWithEachNumberThatMatters) {
  std::set<std::string> digests{digest_of(kText)};
  const std::vector<std::pair<const char*, const char*>> changes{
      {"\nlength_mm = 20", "\nlength_mm = 20.000001"},
      {"\nwidth_mm = 14", "\nwidth_mm = 14.1"},
      {"\nheight_mm = 8", "\nheight_mm = 8.1"},
      {"bone_length_mm = 12", "bone_length_mm = 12.1"},
      {"bone_width_mm = 6", "bone_width_mm = 6.1"},
      {"bone_height_mm = 4", "bone_height_mm = 4.1"},
      {"[11, 8, 9]", "[11, 8, 9.1]"},
      {"size_mm = [11, 8, 9]", "size_mm = [11, 8, 9]\nposition_mm = [0, 0.1, 0]"},
      {"exponent = 3", "exponent = 3.1"},
      {"law = \"ogden\"", "law = \"veronda-westmann\""},
      {"shear_modulus_kPa = 9", "shear_modulus_kPa = 9.1"},
      {"poisson_ratio = 0.48", "poisson_ratio = 0.481"},
      {"[0.25, 0.5]", "[0.25, 0.51]"},
      {"[4, 1400]", "[5, 1400]"},
      {"thickness_mm = 0.15", "thickness_mm = 0.16"},
      {"shear_modulus_MPa = 0.2", "shear_modulus_MPa = 0.21"},
      {"poisson_ratio = 0.3", "poisson_ratio = 0.31"}};
  for (const auto& [from, to] : changes)
    EXPECT_TRUE(digests.insert(digest_of(changed(from, to))).second) << to;
  // Without its layer, and without its own skin.
  EXPECT_TRUE(digests.insert(digest_of(kText.substr(0, kText.find("[[layer]]")))).second);
  EXPECT_TRUE(
      digests.insert(digest_of(changed("[skin]\nkind = \"ellipsoid\"\nsize_mm = [11, 8, 9]\n", "")))
          .second);
}

TEST(PadDigest, IsThatOfThePadNotOfItsFile) {
  const std::string digest = digest_of(kText);
  EXPECT_EQ(digest.size(), 64U);
  const std::vector<std::pair<const char*, const char*>> changes{
      {"length_mm = 20\nwidth_mm = 14", "width_mm = 14\nlength_mm = 20"},
      {"shear_modulus_kPa = 9\npoisson_ratio = 0.48",
       "poisson_ratio = 0.48\nshear_modulus_Pa = 9000"},
      {"\nheight_mm = 8", "\nheight_m = 0.008"},
      {"name = \"mine\"", "name = \"yours\"\ndescription = \"A copy\""},
      {"poisson_ratio = 0.3\n", "poisson_ratio = 0.3\nassumed = [\"law\"]\n"},
      {"poisson_ratio = 0.3\n", "poisson_ratio = 0.3\n[cells]\nacross = 9\nelement = \"Q1\"\n"}};
  for (const auto& [from, to] : changes) EXPECT_EQ(digest_of(changed(from, to)), digest) << to;
  // Through a file and back.
  EXPECT_EQ(digest_of(pad_toml(parse_pad(kText, "pad.toml"))), digest);
}

TEST(PadDigest, LawsOfAnotherVersionAreDoubted) {
  const PadSpec pad = read_pad(kData + "/pads/index_pad.toml");
  CalibratedLaws laws = read_laws(kData + "/pads/laws/index_pad.toml");
  EXPECT_EQ(laws.pad_digest, pad_digest(pad));
  EXPECT_EQ(version_doubt(laws, pad), "");
  PadSpec softer = pad;
  softer.pulp.shear_modulus *= 0.9;
  EXPECT_THAT(version_doubt(laws, softer),
              testing::StartsWith("laws were fitted to another version of pad 'index_pad'"));
  // Files without a digest are taken at their name.
  laws.pad_digest.clear();
  EXPECT_EQ(version_doubt(laws, softer), "");
}

}  // namespace
}  // namespace thenar
