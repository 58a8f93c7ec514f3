// Tests for data/io/world/materials.cpp and read_materials.cpp.

#include "data/io/world/materials.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file_io.h"
#include "pad_laws/contact_law.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::HasSubstr;

const std::string kHead =
    "source = \"Seo2009\"\n[[material]]\nname = \"a\"\n[[material]]\nname = \"b\"\n";

std::string refusal(const std::string& text) {
  return message_of<DataError>([&] { (void)parse_materials(text, "m.toml"); });
}

// Numbers of World::setDefaults in [GraspItWorld].
TEST(Materials, HoldThePublishedTable) {
  const Materials& materials = built_in_materials();
  EXPECT_EQ(materials.between("glass", "metal").static_coefficient, 0.2);
  EXPECT_EQ(materials.between("stone", "rubber").static_coefficient, 1.5);
  EXPECT_EQ(materials.between("rubber", "stone").kinetic_coefficient, 1.4);
  EXPECT_EQ(materials.between("wood", "plastic").static_coefficient, 0.4);
  for (const auto& [pair, friction] : materials.friction)
    if (pair.first != "skin" && pair.second != "skin" && pair.first != "frictionless" &&
        pair.second != "frictionless") {
      EXPECT_NEAR(friction.static_coefficient - friction.kinetic_coefficient, 0.1, 1e-15)
          << pair.first << " " << pair.second;
    }
}

TEST(Materials, HoldMeasuredSkin) {
  const Materials& materials = built_in_materials();
  EXPECT_EQ(materials.between("skin", "metal").static_coefficient, 0.6);       // [Seo2009]
  EXPECT_EQ(materials.between("skin", "rubber").static_coefficient, 0.9);      // [Seo2009]
  EXPECT_EQ(materials.between("skin", "sandpaper").static_coefficient, 0.96);  // [Savescu2008]
  EXPECT_EQ(materials.at("skin").young, 25e3);
  EXPECT_EQ(materials.at("skin").layer_thickness, 3e-3);
  EXPECT_EQ(materials.at("metal").young, 0);
}

TEST(Materials, KnowEveryPairThatAHandMeets) {
  const Materials& materials = built_in_materials();
  for (const char* hand : {"skin", "fingertip", "rubber", "plastic", "metal", "frictionless"})
    for (const char* object : {"glass", "metal", "plastic", "wood", "rubber", "stone", "skin"})
      EXPECT_NO_THROW((void)materials.between(hand, object)) << hand << " " << object;
}

TEST(Materials, NameWhatIsMissing) {
  EXPECT_THAT(message_of([] { (void)built_in_materials().at("cheese"); }),
              HasSubstr("no material 'cheese'; there are frictionless, glass, metal"));
  EXPECT_EQ(message_of([] { (void)built_in_materials().between("sandpaper", "glass"); }),
            "no friction between 'sandpaper' and 'glass': give it in a materials file");
  EXPECT_EQ(message_of([] { (void)built_in_materials().between("", "glass"); }),
            "no friction between '' and 'glass': one of these links or bodies has no 'material'");
}

TEST(Materials, StandOverOthers) {
  const Materials materials = parse_materials(
      "source = \"Seo2009\"\nfriction = [{between = [\"felt\", \"glass\"], static = 0.5, kinetic = "
      "0.25},\n {between = [\"metal\", \"glass\"], static = 0.125, kinetic = 0.125}]\n"
      "[[material]]\nname = \"felt\"\ndensity_g_cm3 = 0.25\n",
      "m.toml", built_in_materials());
  EXPECT_EQ(materials.at("felt").density, 250);
  EXPECT_EQ(materials.between("glass", "felt").kinetic_coefficient, 0.25);
  EXPECT_EQ(materials.between("glass", "metal").static_coefficient, 0.125);
  EXPECT_EQ(materials.between("glass", "glass").static_coefficient, 0.2);
}

// A fingertip is skin by friction and softness, and knows its pad.
TEST(Materials, HoldThePadOfAFingertip) {
  const Materials& materials = built_in_materials();
  const Material& tip = materials.at("fingertip");
  EXPECT_EQ(tip.young, materials.at("skin").young);
  EXPECT_EQ(tip.layer_thickness, materials.at("skin").layer_thickness);
  ASSERT_NE(tip.law, nullptr);
  EXPECT_EQ(tip.law->relaxation().size(), 3U);
  EXPECT_EQ(materials.at("skin").law, nullptr);
  EXPECT_EQ(materials.between("fingertip", "metal").static_coefficient, 0.6);
  EXPECT_EQ(materials.between("fingertip", "fingertip").static_coefficient, 0.9);
}

const std::string kLike =
    "source = \"Seo2009\"\n[[material]]\nname = \"a\"\nyoung_kPa = 10\nlayer_thickness_mm = "
    "2\n[[material]]\nname = \"b\"\nlike = \"a\"\n[[material]]\nname = \"c\"\nlike = "
    "\"b\"\ndensity_g_cm3 = 2\n";

TEST(Materials, SlideAsWhatTheyAreLike) {
  const Materials materials = parse_materials(
      kLike +
          "[[friction]]\nbetween = [\"a\", \"glass\"]\nstatic = 0.5\nkinetic = 0.5\n"
          "[[friction]]\nbetween = [\"b\", \"metal\"]\nstatic = 0.25\nkinetic = 0.25\n"
          "[[friction]]\nbetween = [\"a\", \"metal\"]\nstatic = 0.75\nkinetic = 0.75\n",
      "m.toml", built_in_materials());
  EXPECT_EQ(materials.at("c").young, 10e3);
  EXPECT_EQ(materials.at("c").layer_thickness, 2e-3);
  EXPECT_EQ(materials.at("c").density, 2000);
  EXPECT_EQ(materials.between("glass", "c").static_coefficient, 0.5);
  EXPECT_EQ(materials.between("c", "metal").static_coefficient, 0.25);
  EXPECT_THROW((void)materials.between("c", "wood"), InputError);
  // Skin replaced is what a fingertip slides as.
  const Materials oily = parse_materials(
      "source = \"Seo2009\"\nfriction = [{between = [\"skin\", \"glass\"], static = 0.125, "
      "kinetic = 0.125}]",
      "m.toml", built_in_materials());
  EXPECT_EQ(oily.between("fingertip", "glass").static_coefficient, 0.125);
}

// Below, b is like a; here a is like b.
TEST(Materials, LikeEachOtherEndTheirSearch) {
  const Materials below = parse_materials(kLike, "m.toml");
  const Materials ring = parse_materials(
      "source = \"Seo2009\"\n[[material]]\nname = \"a\"\nlike = \"b\"\n", "n.toml", below);
  EXPECT_THROW((void)ring.between("a", "c"), InputError);
}

TEST(Materials, RefuseWrongLikenessesAndLaws) {
  EXPECT_THAT(refusal(kHead + "like = \"skim\""), HasSubstr(":6: no material 'skim' before it"));
  EXPECT_THAT(refusal(kHead + "like = \"b\""), HasSubstr(":6: no material 'b' before it"));
  EXPECT_THAT(refusal(kHead + "laws = \"x.toml\""), HasSubstr(":6: wanted 'young'"));
  EXPECT_THAT(refusal(kHead + "young_kPa = 3\nlayer_thickness_mm = 1\nlaws = \"x.toml\""),
              HasSubstr("m.toml:8: there is no file 'x.toml'"));
}

using MaterialFiles = TemporaryFolder;

// The default pad's laws, beside a materials file.
TEST_F(MaterialFiles, HaveLawsBesideThem) {
  std::filesystem::copy_file(std::string(THENAR_DATA_DIR) + "/pads/laws/index_pad.toml",
                             path("pad.toml"));
  write_file(path("m.toml"),
             kHead + "young_kPa = 3\nlayer_thickness_mm = 1\nlaws = \"pad.toml\"\n");
  const Materials materials = read_materials(path("m.toml"), built_in_materials());
  ASSERT_NE(materials.at("b").law, nullptr);
  const RelativeCurvatures gap{100, 50};
  EXPECT_EQ(materials.at("b").law->at_force(gap, 1, 0.6).patch.torsion,
            materials.at("fingertip").law->at_force(gap, 1, 0.6).patch.torsion);
  EXPECT_EQ(materials.files, digests_of({path("pad.toml")}));
  // A broken one is named by its own line.
  write_file(path("pad.toml"), "name = 3\n");
  EXPECT_THAT(message_of<DataError>([&] { (void)read_materials(path("m.toml")); }),
              HasSubstr("pad.toml:1: "));
}

TEST(Materials, RefuseWhatIsWrong) {
  const auto pair = [](const std::string& keys) {
    return refusal(kHead + "[[friction]]\n" + keys);
  };
  EXPECT_THAT(pair("between = [\"a\", \"c\"]\nstatic = 1\nkinetic = 1"),
              HasSubstr("m.toml:7: no material 'c'"));
  EXPECT_THAT(pair("between = [\"a\"]\nstatic = 1\nkinetic = 1"), HasSubstr(":7: wanted 2"));
  EXPECT_THAT(pair("between = [\"a\", \"b\"]\nstatic = 1\nkinetic = 2"),
              HasSubstr(":9: kinetic friction 2 is above the static 1"));
  EXPECT_THAT(pair("between = [\"a\", \"b\"]\nstatic = -1\nkinetic = -2"), HasSubstr(":8: "));
  EXPECT_THAT(pair("between = [\"a\", \"b\"]\nstatic = 1\nkinetic = 1\n[[friction]]\nbetween = "
                   "[\"b\", \"a\"]\nstatic = 1\nkinetic = 1"),
              HasSubstr("between a and b is given twice"));
  EXPECT_THAT(refusal(kHead + "[[material]]\nname = \"a\""),
              HasSubstr(":7: material 'a' is given"));
  EXPECT_THAT(refusal(kHead + "young_kPa = 3"), HasSubstr("layer_thickness"));
  EXPECT_THAT(refusal(kHead + "densty_g_cm3 = 3"), HasSubstr("m.toml:6: "));
}

}  // namespace
}  // namespace thenar
