// Tests for data/io/scene/scene_pad.cpp.

#include "data/io/scene/scene_pad.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/units.h"
#include "data/io/scene/scene.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// [[pad]] stands on line 21.
const std::string kTwoBodies = R"(name = "press"
source = "Mine"
[sources]
Mine = "Own"
[[body]]
name = "finger"
mass_g = 10
[[body.shape]]
kind = "sphere"
size_mm = [10]
[[body]]
name = "mug"
mass_g = 100
position_mm = [0, 0, 50]
[[body.shape]]
kind = "sphere"
size_mm = [10]
[stepping]
duration_s = 1

[[pad]]
)";
const std::string kPair = "on = \"finger\"\nagainst = [\"mug\"]\n";

ScenePadSpec pad_of(const std::string& text) {
  return parse_scene(kTwoBodies + text, "s.toml").pads.at(0);
}
std::string error_of(const std::string& text) {
  return message_of<DataError>([&] { (void)pad_of(text); });
}

TEST(ScenePad, IsTheBuiltInOneAsElementsUnlessStated) {
  const ScenePadSpec pad = pad_of(kPair);
  EXPECT_EQ(pad.on, "finger");
  EXPECT_THAT(pad.against, testing::ElementsAre("mug"));
  EXPECT_EQ(pad.rung, "elements");
  EXPECT_EQ(pad.spec.name, "index_pad");
  EXPECT_NEAR(pad.spec.width, 16e-3, 1e-12);
  ASSERT_TRUE(pad.law.has_value());
  EXPECT_EQ(pad.law->name, "index_pad");
  EXPECT_FALSE(pad.X_BP || pad.scale || pad.friction);
  EXPECT_TRUE(pad.files.empty());
  EXPECT_EQ(pad.line, 21);
}

TEST(ScenePad, ReadsAllThatIsStated) {
  const ScenePadSpec pad =
      pad_of(kPair +
             "rung = \"soft-finger\"\nposition_mm = [1, 2, 3]\naxis = [1, 0, 0]\nangle_deg = 90\n"
             "scale = 0.8\nforce_error = 0.01\nfriction = 0.6\n");
  EXPECT_EQ(pad.rung, "soft-finger");
  ASSERT_TRUE(pad.X_BP && pad.scale && pad.friction);
  EXPECT_LT((pad.X_BP->p - Eigen::Vector3d(1e-3, 2e-3, 3e-3)).norm(), 1e-15);
  EXPECT_LT((pad.X_BP->R.col(2) - Eigen::Vector3d(0, -1, 0)).norm(), 1e-15);
  EXPECT_EQ(*pad.scale, 0.8);
  EXPECT_EQ(pad.force_error, 0.01);
  EXPECT_EQ(*pad.friction, 0.6);
}

TEST(ScenePad, SaysAtItsLineWhatIsWrong) {
  EXPECT_THAT(error_of("on = \"finger\"\nagainst = [\"mugg\"]\n"),
              StartsWith("s.toml:21: there is no body or hand 'mugg', did you mean 'mug'?"));
  EXPECT_THAT(error_of("on = \"finger\"\nagainst = []\n"), StartsWith("s.toml:23: "));
  EXPECT_THAT(error_of("on = \"finger\"\nagainst = [\"finger\"]\n"),
              HasSubstr("'finger' cannot press on its own pad"));
  EXPECT_THAT(error_of("on = \"finger\"\nagainst = [\"mug\", \"mug\"]\n"),
              HasSubstr("'mug' is named twice"));
  EXPECT_THAT(error_of(kPair + "rung = \"soft-fingr\"\n"), StartsWith("s.toml:24: "));
  EXPECT_THAT(error_of(kPair + "rung = \"soft-fingr\"\n"), HasSubstr("soft-finger"));
  EXPECT_THAT(error_of(kPair + "pad = \"no.toml\"\n"),
              StartsWith("s.toml:24: there is no file 'no.toml'"));
  EXPECT_THAT(error_of(kPair + "pad = \"index_pd\"\n"), HasSubstr("did you mean 'index_pad'?"));
  EXPECT_THAT(error_of(kPair + "angle_deg = 3\naxis = [1, 0, 0]\n"), HasSubstr("'position'"));
  EXPECT_THAT(error_of(kPair + "scale = 0\n"), StartsWith("s.toml:24: "));
  EXPECT_THAT(error_of(kPair + "force_error = 0\n"), StartsWith("s.toml:24: "));
  EXPECT_THAT(error_of(kPair + "depth_mm = 1\n"), HasSubstr("depth_mm"));
}

TEST(ScenePad, RefusesWhatIsNoNumberNoNameAndNoPose) {
  // Each by its line and its key.
  const std::pair<std::string, std::string> bad[] = {
      {"scale = -1", "scale"},
      {"scale = inf", "scale"},
      {"scale = nan", "scale"},
      {"scale = \"1\"", "scale"},
      {"force_error = -0.1", "force_error"},
      {"force_error = nan", "force_error"},
      {"force_error = inf", "force_error"},
      {"force_error = [0.1]", "force_error"},
      {"friction = -0.1", "friction"},
      {"friction = inf", "friction"},
      {"friction = true", "friction"},
      {"rung = 1", "rung"},
      {"rung = \"\"", "rung"},
      {"rung = \"Elements\"", "rung"},
      {"pad = \"\"", "pad"},
      {"pad = 7", "pad"},
      {"pad = \"../../etc/passwd\"", "pad"},
      {"pad = \".toml\"", ".toml"},
      {"laws = \"no_laws\"", "laws"},
      {"laws = \"no.toml\"", "no.toml"},
      {"position_mm = [0, 0]", "position_mm"},
      {"position_mm = [0, 0, nan]", "position_mm"},
      {"position_mm = [0, 0, inf]", "position_mm"},
      {"position = [0, 0, 0]", "position"},
      {"position_mm = [0, 0, 0]\nrotation = [[1, 0, 0], [0, 1, 0], [0, 0, -1]]", "rotation"},
      {"position_mm = [0, 0, 0]\nrotation = [[2, 0, 0], [0, 2, 0], [0, 0, 2]]", "rotation"},
      {"position_mm = [0, 0, 0]\naxis = [0, 0, 0]\nangle_deg = 5", "axis"},
      {"quaternion_wxyz = [1, 0, 0, 0]", "position"}};
  for (const auto& [line, word] : bad) {
    SCOPED_TRACE(line);
    EXPECT_THAT(error_of(kPair + line + "\n"), StartsWith("s.toml:2"));
    EXPECT_THAT(error_of(kPair + line + "\n"), HasSubstr(word));
  }
  // Who carries it, and who presses.
  const std::pair<std::string, std::string> who[] = {
      {"against = [\"mug\"]", "on"},
      {"on = \"finger\"", "against"},
      {"on = \"finger\"\nagainst = \"mug\"", "against"},
      {"on = \"finger\"\nagainst = [1]", "against"},
      {"on = \"finger\"\nagainst = [\"\"]", "there is no body or hand ''"},
      {"on = \"\"\nagainst = [\"mug\"]", "there is no body or hand ''"},
      {"on = \"finger/DP2\"\nagainst = [\"mug\"]", "finger/DP2"},
      {"on = [\"finger\"]\nagainst = [\"mug\"]", "on"}};
  for (const auto& [lines, word] : who) {
    SCOPED_TRACE(lines);
    EXPECT_THAT(error_of(lines + "\n"), StartsWith("s.toml:2"));
    EXPECT_THAT(error_of(lines + "\n"), HasSubstr(word));
  }
}

TEST(ScenePad, RefusesASecondPadBetweenTheSameBodies) {
  EXPECT_THAT(error_of(kPair + "[[pad]]\non = \"mug\"\nagainst = [\"finger\"]\n"),
              StartsWith("s.toml:24: 'mug' and 'finger' meet in two pads"));
}

}  // namespace
}  // namespace thenar
