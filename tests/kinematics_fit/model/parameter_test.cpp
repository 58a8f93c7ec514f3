// Tests for kinematics_fit/model/parameter.cpp: names, units and globs.

#include "kinematics_fit/model/parameter.h"

#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/units.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar {
namespace {

using sample::middle_finger;

TEST(Globs, StarIsAnyRunAndQuestionMarkOneCharacter) {
  EXPECT_TRUE(matches_glob("path/*/dorsal", "path/FDP/3/dorsal"));
  EXPECT_TRUE(matches_glob("*", ""));
  EXPECT_TRUE(matches_glob("a*b*c", "a-b-b-c"));
  EXPECT_TRUE(matches_glob("gain/?I", "gain/UI"));
  EXPECT_FALSE(matches_glob("gain/?I", "gain/I"));
  EXPECT_FALSE(matches_glob("path/*", "Path/FDP"));
  EXPECT_FALSE(matches_glob("", "x"));
  EXPECT_FALSE(matches_glob("a*b", "a-b-c"));
}

TEST(Parameters, EveryKindIsNamedOnce) {
  const std::vector<Parameter> all = list_parameters(middle_finger("").digit, {"Hook"});
  std::set<std::string> names;
  for (const Parameter& parameter : all) names.insert(parameter.name);
  EXPECT_EQ(names.size(), all.size());
  for (const char* name :
       {"axis/MCP3_FE/direction/1", "axis/DIP3/point/along", "length/PIP3", "friction/FDP",
        "path/FDS/1/proximal", "path/RI/2/radial", "hood/RI/into", "hood/EDC/central",
        "hood/UI/slope", "tip/dorsal", "sensor/radial", "angle/MCP3_AA", "angle/PIP3/Hook",
        "hold/out_of_plane", "gain/LU", "force/FDS/radial"})
    EXPECT_EQ(names.count(name), 1U) << name;
}

TEST(Parameters, PathsReplaceArms) {
  for (const Parameter& parameter : list_parameters(middle_finger("").digit))
    EXPECT_FALSE(matches_glob("arm/*", parameter.name)) << parameter.name;
  const SourceText text = sample::source("subjects/arms_thumb");
  const TendonDigit thumb = build_tendon_digit(parse_subject(text.text, text.path), "thumb");
  int arms = 0;
  for (const Parameter& parameter : list_parameters(thumb))
    if (parameter.name == "arm/FPL/IP1") {
      EXPECT_DOUBLE_EQ(parameter.mean, 6.3e-3);  // the subject's own [m]
      ++arms;
    }
  EXPECT_EQ(arms, 1);
}

// Display units per SI unit: 1000 mm in a metre, 180/pi degrees in a radian.
TEST(Parameters, AreShownInUnitsOfTheirKind) {
  Parameter parameter;
  parameter.kind = ParameterKind::kPathPoint;
  EXPECT_EQ(display_unit(parameter), "mm");
  EXPECT_DOUBLE_EQ(display_scale(parameter), 1000);
  parameter.kind = ParameterKind::kSensorTilt;
  EXPECT_EQ(display_unit(parameter), "deg");
  EXPECT_DOUBLE_EQ(display_scale(parameter), 180 / kPi);
  parameter.kind = ParameterKind::kHoodSlope;
  EXPECT_EQ(display_unit(parameter), "1/rad");
  EXPECT_EQ(display_scale(parameter), 1);
}

}  // namespace
}  // namespace thenar
