// Tests for data/io/pad/pad.cpp.

#include "data/io/pad/pad.h"

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/data/broken_files.h"
#include "tests/data_folder.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// [shape] stands on line 5, [pulp] on line 12.
const std::string kHead = R"(name = "mine"
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
)";
const std::string kPulp = R"([pulp]
law = "neo-hookean"
shear_modulus_kPa = 9
poisson_ratio = 0.48
)";

PadSpec pad_of(const std::string& text) { return parse_pad(text, "pad.toml"); }
std::string complaint(const std::string& text) {
  return message_of<DataError>([&] { (void)pad_of(text); });
}
/// The text with one piece changed.
std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(PadFile, IsReadInSi) {
  const PadSpec pad = pad_of(kHead + kPulp + R"(relaxation_share = [0.25, 0.5]
relaxation_time_ms = [4, 1400]
assumed = ["law", "poisson_ratio"]
[[layer]]
thickness_mm = 0.15
law = "ogden"
shear_modulus_MPa = 0.2
exponent = -4
poisson_ratio = 0.3
assumed = ["exponent"]
[[layer]]
thickness_mm = 1
law = "veronda-westmann"
shear_modulus_Pa = 3e4
exponent = 2
poisson_ratio = 0.49
[cells]
element = "F-bar"
across = 6
through = 2
)");
  EXPECT_EQ(pad.name, "mine");
  EXPECT_DOUBLE_EQ(pad.length, 0.02);
  EXPECT_DOUBLE_EQ(pad.bone_height, 0.004);
  EXPECT_EQ(pad.shape_source, "Me");
  EXPECT_EQ(pad.pulp.law, "neo-hookean");
  EXPECT_DOUBLE_EQ(pad.pulp.shear_modulus, 9e3);
  EXPECT_EQ(pad.pulp.thickness, 0);
  EXPECT_THAT(pad.pulp.relaxation_share, ElementsAre(0.25, 0.5));
  EXPECT_THAT(pad.pulp.relaxation_time,
              ElementsAre(testing::DoubleEq(4e-3), testing::DoubleEq(1.4)));
  ASSERT_EQ(pad.layers.size(), 2U);
  EXPECT_DOUBLE_EQ(pad.layers[0].thickness, 0.15e-3);
  EXPECT_DOUBLE_EQ(pad.layers[0].shear_modulus, 2e5);
  EXPECT_EQ(pad.layers[0].exponent, -4);
  EXPECT_EQ(pad.layers[1].law, "veronda-westmann");
  EXPECT_EQ(pad.element, "F-bar");
  EXPECT_EQ(pad.across, 6);
  EXPECT_EQ(pad.around, 2);  // as no key says otherwise
  EXPECT_EQ(pad.through, 2);
  EXPECT_THAT(assumed_words(pad),
              ElementsAre("law of [pulp]", "poisson_ratio of [pulp]", "exponent of [[layer]] 1"));
}

TEST(PadFile, OfTheIndexSaysWhatIsAssumed) {
  const PadSpec pad = read_pad(kData + "/pads/index_pad.toml");
  EXPECT_EQ(pad.name, "index_pad");
  // Approximate time constants in the abstract of [PawlukHowe1999]: 4 ms, 70 ms, 1.4 s.
  EXPECT_THAT(pad.pulp.relaxation_time, ElementsAre(0.004, 0.07, 1.4));
  EXPECT_THAT(pad.pulp.source, HasSubstr("PawlukHowe1999"));
  EXPECT_THAT(assumed_words(pad), testing::Contains("shear_modulus_kPa of [pulp]"));
  EXPECT_THAT(assumed_words(pad), testing::Not(testing::Contains(HasSubstr("relaxation_time"))));
  EXPECT_EQ(pad.files.size(), 1U);
}

TEST(PadFile, NamesTheLineOfWhatIsWrong) {
  EXPECT_EQ(complaint("name = \"x\"\n"),
            "pad.toml:1: wanted [shape], the lengths of skin and bone, got none");
  EXPECT_EQ(complaint(kHead),
            "pad.toml:1: wanted [pulp], the tissue between bone and skin, got none");
  EXPECT_THAT(complaint(with(kHead, "length_mm = 20", "length = 20") + kPulp),
              HasSubstr("pad.toml:6: wanted a length (length_mm, length_cm, length_m), got"));
  EXPECT_EQ(complaint(with(kHead, "length_mm = 20", "length_m = 20") + kPulp),
            "pad.toml:6: wanted 'length' of at most 0.2 m, got 20 m");
  EXPECT_THAT(complaint(with(kHead, "bone_width_mm = 6", "bone_width_mm = 14") + kPulp),
              HasSubstr("pad.toml:10: wanted 'bone_width' below that of the skin, 0.014 m, got"));
  EXPECT_THAT(complaint(with(kHead, "height_mm = 8", "height_mm = -8") + kPulp),
              HasSubstr("pad.toml:8: wanted 'height_mm' > 0, got -8"));
  EXPECT_THAT(complaint(kHead + with(kPulp, "neo-hookean", "mooney")),
              HasSubstr("pad.toml:13: wanted 'law' to be one of neo-hookean, ogden"));
  EXPECT_THAT(complaint(kHead + with(kPulp, "neo-hookean", "ogden")),
              HasSubstr("pad.toml:12: [pulp] needs a plain number (exponent)"));
  EXPECT_THAT(complaint(kHead + with(kPulp, "0.48", "0.5")),
              HasSubstr("pad.toml:15: wanted 'poisson_ratio' in -0.999..0.4999999, got 0.5"));
  EXPECT_THAT(complaint(kHead + with(kPulp, "0.48", "nan")), HasSubstr("pad.toml:15: wanted"));
  EXPECT_THAT(complaint(kHead + with(kPulp, "= 9", "= 9e9")),
              HasSubstr("pad.toml:14: wanted 'shear_modulus' of at most 1e+09 Pa"));
  EXPECT_THAT(complaint(kHead + kPulp + "colour = \"pink\"\n"),
              HasSubstr("pad.toml:16: unknown key 'colour'"));
  EXPECT_THAT(complaint(kHead + kPulp + "assumed = [\"exponent\"]\n"),
              HasSubstr("pad.toml:16: there is no 'exponent' to assume"));
}

TEST(PadFile, NeedsASourceForItsNumbers) {
  EXPECT_THAT(complaint(with(kHead, "source = \"Me\"\n", "") + kPulp),
              HasSubstr("'length_mm' has no source"));
  EXPECT_THAT(complaint(with(kHead, "\"Me\"\n", "\"Nobody\"\n") + kPulp),
              HasSubstr("source 'Nobody' is neither in data/sources.bib nor"));
}

TEST(PadFile, RefusesRelaxationThatMakesNoSense) {
  const auto relaxing = [&](const std::string& shares, const std::string& times) {
    return complaint(kHead + kPulp + "relaxation_share = " + shares +
                     "\nrelaxation_time_s = " + times + "\n");
  };
  EXPECT_EQ(relaxing("[0.5, 0.2]", "[1]"),
            "pad.toml:17: wanted as many 'relaxation_time' as 'relaxation_share', 2, got 1");
  EXPECT_EQ(relaxing("[0.5, 0.5]", "[1, 2]"),
            "pad.toml:16: wanted shares of relaxation that sum to less than 1, got 1");
  EXPECT_THAT(relaxing("[-0.5]", "[1]"), HasSubstr("pad.toml:16: wanted 'relaxation_share' >= 0"));
  EXPECT_THAT(relaxing("[0.5]", "[0]"), HasSubstr("pad.toml:17: wanted 'relaxation_time_s' > 0"));
  EXPECT_THAT(complaint(kHead + kPulp + "relaxation_share = [0.5]\n"),
              HasSubstr("[pulp] needs a time (relaxation_time_ms, relaxation_time_s)"));
  EXPECT_THAT(complaint(kHead + kPulp + "relaxation_time_s = [0.5]\n"),
              HasSubstr("[pulp] needs a plain number (relaxation_share)"));
}

TEST(PadFile, RefusesLayersAndCellsThatDoNotFit) {
  const std::string layer = "[[layer]]\nthickness_mm = 2.5\n" + kPulp.substr(7);
  EXPECT_THAT(complaint(kHead + kPulp + layer + layer),
              HasSubstr("pad.toml:22: wanted layers thinner than all over the bone, 4 mm, got 5"));
  EXPECT_THAT(complaint(kHead + kPulp + "[cells]\nacross = 0\n"),
              HasSubstr("pad.toml:17: wanted 'across' as a whole number in 1..64, got 0"));
  EXPECT_THAT(complaint(kHead + kPulp + "[cells]\nacross = 2.5\n"), HasSubstr("got 2.5"));
  EXPECT_THAT(complaint(kHead + kPulp + "[cells]\nelement = \"T4\"\n"),
              HasSubstr("pad.toml:17: wanted 'element' to be one of Q1, Q1P0, F-bar, Q2P1"));
}

class PadSkin : public TemporaryFolder {
 protected:
  [[nodiscard]] std::string written(const std::string& skin) const {
    std::ofstream(path("pad.toml")) << kHead << kPulp << skin;
    return path("pad.toml");
  }
  void write_tetrahedron(bool closed) const {
    std::ofstream(path("skin.off")) << "OFF\n4 " << (closed ? 4 : 3) << " 0\n"
                                    << "0 0 30\n40 0 -10\n-20 30 -10\n-20 -30 -10\n"
                                    << "3 0 1 2\n3 0 2 3\n3 0 3 1\n"
                                    << (closed ? "3 1 3 2\n" : "");
  }
};

TEST_F(PadSkin, IsAClosedMeshBesideTheFile) {
  write_tetrahedron(true);
  const PadSpec pad =
      read_pad(written("[skin]\nkind = \"mesh\"\nfile = \"skin.off\"\nscale = 0.001\n"));
  ASSERT_TRUE(pad.skin.has_value());
  EXPECT_EQ(pad.skin->mesh.triangles.cols(), 4);
  EXPECT_DOUBLE_EQ(pad.skin->mesh.vertices.row(2).maxCoeff(), 0.03);
  EXPECT_EQ(pad.files.size(), 2U);  // the pad and its skin
}

TEST_F(PadSkin, WithHolesOrNotThereIsRefused) {
  write_tetrahedron(false);
  EXPECT_THAT(
      message_of<DataError>([&] {
        (void)read_pad(written("[skin]\nkind = \"mesh\"\nfile = \"skin.off\"\nscale = 0.001\n"));
      }),
      HasSubstr("pad.toml:16: wanted a closed skin: "));
  EXPECT_THAT(message_of<DataError>([&] {
                (void)read_pad(written("[skin]\nkind = \"mesh\"\nfile = \"none.off\"\n"));
              }),
              HasSubstr("pad.toml:18: there is no mesh"));
}

TEST_F(PadSkin, BrokenFilesGiveAResultOrAnError) {
  const std::string text = read_file(kData + "/pads/index_pad.toml", 1'000'000);
  expect_no_harm(text, path("index_pad.toml"),
                 [](const std::string& file) { (void)read_pad(file); });
}

}  // namespace
}  // namespace thenar
