// Tests for data/io/subject.cpp: the exact words for every way a subject can be wrong.

#include <gtest/gtest.h>

#include "base/error.h"
#include "data/io/subject.h"

namespace thenar {
namespace {

// Line 1 is "name"; a test breaks one line of it.
const std::string kGoodSubject = R"(name = "small"
side = "right"
base = "MC2"
source = "An1983"
[[segment]]
name = "MC2"
[[segment]]
name = "PP2"
mass_g = 12
proximal_mm = [20, 0, 0]
[[joint]]
name = "MCP2"
parent = "MC2"
child = "PP2"
direction = [0, 0, 1]
point_mm = [20, 0, 0]
range_deg = [-20, 90]
[[strand]]
name = "TE"
path = [{segment = "PP2", point_mm = [0, 0, 0]}, {segment = "MC2", point_mm = [9, 0, 0]}]
arms_mm = {MCP2 = 8}
[[muscle]]
name = "TE"
max_force_N = 9
[[digit]]
name = "index"
tip_segment = "PP2"
tip_mm = [0, 0, 0]
proximal = [1, 0, 0]
dorsal = [0, 1, 0]
[digit.hood]
central_slip = "TE"
radial_band = "TE"
ulnar_band = "TE"
terminal_slip = "TE"
branches = [{muscle = "TE", side = "both", into_hood = 0.5}]
[[tip_map]]
name = "A"
digit = "index"
muscles = ["TE"]
rows = {Fx = [1]}
)";

/// What the reader says of kGoodSubject with `from` replaced by `to`.
std::string subject_refusal(const std::string& from, const std::string& to) {
  std::string text = kGoodSubject;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  try {
    (void)parse_subject(text, "s.toml");
  } catch (const DataError& e) {
    return e.what();
  }
  return "";
}

TEST(SubjectErrors, GoodFileReads) { EXPECT_EQ(subject_refusal("small", "small"), ""); }

TEST(SubjectErrors, Header) {
  EXPECT_EQ(subject_refusal("name = \"small\"\n", ""),
            "s.toml:1: the top level needs 'name' (a text)");
  EXPECT_EQ(subject_refusal("right", "up"),
            "s.toml:2: wanted 'side' to be one of right, left, got 'up'");
  EXPECT_EQ(subject_refusal("base = \"MC2\"", "base = \"MC3\""),
            "s.toml:3: 'base' names the unknown segment 'MC3', did you mean 'MC2'?");
}

TEST(SubjectErrors, Calibration) {
  const auto with = [](const std::string& rows) {
    return subject_refusal("base = \"MC2\"\n",
                           "base = \"MC2\"\ncalibrated_on = [\n" + rows + "]\n");
  };
  EXPECT_EQ(with("{experiment = 'a', specimen = 'A'},\n{experiment = 'b', specimen = 'A'},\n"), "");
  EXPECT_EQ(with("{experiment = 'a'},\n"), "s.toml:5: [[calibrated_on]] needs 'specimen' (a text)");
  EXPECT_EQ(with("{specimen = 'A'},\n"), "s.toml:5: [[calibrated_on]] needs 'experiment' (a text)");
  EXPECT_EQ(with("{experiment = 'a', specimen = 'A'},\n{experiment = 'a', specimen = 'B'},\n"),
            "s.toml:6: experiment 'a' is named twice");
  EXPECT_EQ(with("{source = 'An1979'},\n{source = 'An1979'},\n"),
            "s.toml:6: source 'An1979' is named twice");
  EXPECT_EQ(with("{source = 'An1979', specimen = 'A'},\n"), "s.toml:5: unknown key 'specimen'");
  EXPECT_EQ(with("{experiment = 'a', specimens = 'A'},\n"),
            "s.toml:5: unknown key 'specimens', did you mean 'specimen'?");
  EXPECT_EQ(with("{experiment = 'a', specimen = 'A', trials = 3},\n"),
            "s.toml:5: unknown key 'trials'");
}

TEST(SubjectErrors, UnknownParent) {
  EXPECT_EQ(subject_refusal("parent = \"MC2\"", "parent = \"MC4\""),
            "s.toml:13: 'parent' names the unknown segment 'MC4', did you mean 'MC2'?");
}

TEST(SubjectErrors, MissingParent) {
  EXPECT_EQ(subject_refusal("parent = \"MC2\"\n", ""),
            "s.toml:11: [[joint]] needs 'parent' (a text)");
}

TEST(SubjectErrors, WrongUnit) {
  EXPECT_EQ(subject_refusal("point_mm = [20, 0, 0]", "point_deg = [20, 0, 0]"),
            "s.toml:16: wanted a length (point_mm, point_cm, point_m), got 'point_deg'");
}

TEST(SubjectErrors, MisspeltKey) {
  EXPECT_EQ(subject_refusal("point_mm = [20, 0, 0]", "pont_mm = [20, 0, 0]"),
            "s.toml:16: unknown key 'pont_mm', did you mean 'point_mm'?");
}

TEST(SubjectErrors, LimitsTheWrongWayRound) {
  EXPECT_EQ(subject_refusal("[-20, 90]", "[90, -20]"),
            "s.toml:11: wanted the range of joint 'MCP2' as [lower, upper], got lower above upper");
}

TEST(SubjectErrors, JointsOutOfOrder) {
  EXPECT_EQ(
      subject_refusal("parent = \"MC2\"\nchild = \"PP2\"", "parent = \"PP2\"\nchild = \"MC2\""),
      "s.toml:14: joint 'MCP2' moves the base 'MC2'");
  EXPECT_EQ(subject_refusal("parent = \"MC2\"", "parent = \"PP2\""),
            "s.toml:13: joint 'MCP2' hangs on segment 'PP2', which no earlier joint moves: joints "
            "must be in order from the base 'MC2'");
}

TEST(SubjectErrors, SegmentMovedTwice) {
  const std::string again =
      "[[joint]]\nname = \"AA\"\nparent = \"MC2\"\nchild = \"PP2\"\ndirection = [0, 1, 0]\n"
      "point_mm = [0, 0, 0]\n[[strand]]";
  EXPECT_EQ(subject_refusal("[[strand]]", again),
            "s.toml:21: joint 'AA' moves segment 'PP2', which joint 'MCP2' moves already");
}

TEST(SubjectErrors, SegmentLeftHanging) {
  EXPECT_EQ(subject_refusal("[[joint]]", "[[segment]]\nname = \"DP2\"\n[[joint]]"),
            "s.toml:1: segment 'DP2' is not the base and no joint moves it");
}

TEST(SubjectErrors, DuplicateNames) {
  EXPECT_EQ(subject_refusal("name = \"PP2\"", "name = \"MC2\""),
            "s.toml:8: [[segment]] 'MC2' is given twice");
}

TEST(SubjectErrors, ImpossibleInertia) {
  EXPECT_EQ(subject_refusal("mass_g = 12", "inertia_g_mm2 = [1, 1, 3]"),
            "s.toml:7: no body has the principal moments of inertia 1e-09, 1e-09, 3e-09 kg m^2: "
            "the largest exceeds the sum of the others");
  EXPECT_EQ(subject_refusal("mass_g = 12", "inertia_g_mm2 = [1, 1, 2]"),
            "s.toml:7: segment 'PP2' has 'inertia' but no 'mass'");
  EXPECT_EQ(subject_refusal("mass_g = 12", "mass_g = -12"),
            "s.toml:9: wanted 'mass_g' >= 0, got -12");
}

TEST(SubjectErrors, ZeroAxis) {
  EXPECT_EQ(subject_refusal("[0, 0, 1]", "[0, 0, 0]"),
            "s.toml:15: wanted 'direction' as a direction, got a zero vector");
}

TEST(SubjectErrors, PathOnUnknownSegment) {
  EXPECT_EQ(subject_refusal("{segment = \"PP2\"", "{segment = \"PP3\""),
            "s.toml:20: 'segment' names the unknown segment 'PP3', did you mean 'PP2'?");
}

TEST(SubjectErrors, PathOfOnePoint) {
  EXPECT_EQ(subject_refusal(", {segment = \"MC2\", point_mm = [9, 0, 0]}", ""),
            "s.toml:18: the path of strand 'TE' needs at least 2 points, got 1");
}

TEST(SubjectErrors, ArmOfUnknownJoint) {
  EXPECT_EQ(subject_refusal("{MCP2 = 8}", "{MCP3 = 8}"),
            "s.toml:21: 'arms' names the unknown joint 'MCP3', did you mean 'MCP2'?");
}

TEST(SubjectErrors, MuscleWithoutStrand) {
  EXPECT_EQ(subject_refusal("[[muscle]]\nname = \"TE\"", "[[muscle]]\nname = \"TF\""),
            "s.toml:23: 'name' names the unknown strand 'TF', did you mean 'TE'?");
}

TEST(SubjectErrors, SlantedDirections) {
  EXPECT_EQ(subject_refusal("dorsal = [0, 1, 0]", "dorsal = [1, 1, 0]"),
            "s.toml:30: 'dorsal' of digit 'index' is not perpendicular to 'proximal': their cosine "
            "is 0.707, wanted at most 0.05 either way");
  EXPECT_EQ(subject_refusal("dorsal = [0, 1, 0]", "dorsal = [0, 1, 0]\nradial = [0, 0, -1]"),
            "s.toml:31: 'radial' of digit 'index' does not complete 'proximal' and 'dorsal' of a "
            "right hand");
}

TEST(SubjectErrors, HoodOfUnknownStrand) {
  EXPECT_EQ(subject_refusal("radial_band = \"TE\"", "radial_band = \"RB\""),
            "s.toml:33: 'radial_band' names the unknown strand 'RB'");
}

TEST(SubjectErrors, HoodFractionAboveOne) {
  EXPECT_EQ(subject_refusal("into_hood = 0.5", "into_hood = 1.5"),
            "s.toml:36: wanted 'into_hood' in 0..1, got 1.5");
}

TEST(SubjectErrors, TipMapOfTheWrongShape) {
  EXPECT_EQ(subject_refusal("{Fx = [1]}", "{Fx = [1, 2]}"),
            "s.toml:41: row 'Fx' of tip map 'A' needs 1 numbers, one a muscle, got 2");
  EXPECT_EQ(subject_refusal("{Fx = [1]}", "{Fw = [1]}"),
            "s.toml:41: 'rows' names the unknown wrench component 'Fw', did you mean 'Fx'?");
}

TEST(SubjectErrors, RatioWithoutLength) {
  EXPECT_EQ(subject_refusal("[[strand]]\nname = \"TE\"\npath = [{segment = \"PP2\", point_mm",
                            "[[frame]]\nname = \"f\"\nsegment = \"PP2\"\norigin_mm = [0, 0, 0]\n"
                            "[[strand]]\nname = \"TE\"\npath = [{frame = \"f\", point_ratio"),
            "s.toml:24: 'point_ratio' needs 'unit_mm' in its frame or 'reference_length_mm' at the "
            "top");
}

}  // namespace
}  // namespace thenar
