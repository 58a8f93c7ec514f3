// Tests for tendons/vanishing_arms.cpp.

#include "tendons/vanishing_arms.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "data/io/subject.h"
#include "tendons/linear_tendons.h"
#include "tendons/name_conventions.h"

namespace thenar {
namespace {

/// Where FDP's arm at the PIP joint of the index finger is told to have collapsed.
std::vector<VanishingArm> at_pip(double degrees) {
  const Subject subject = read_subject(THENAR_DATA_DIR "/subjects/mirakhorlo2016.toml");
  const auto tendons = build_linear_tendons(subject, "index", {Path::kViaPoint, Hood::kSeparate});
  const auto& joints = tendons->digit().names.coordinates;
  Eigen::VectorXd q = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(joints.size()));
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (joints[j] == "PIP2") q[static_cast<Eigen::Index>(j)] = radians(degrees);
  std::vector<VanishingArm> found;
  for (const VanishingArm& arm : vanishing_arms(*tendons, q))
    if (arm.muscle.rfind("FDP", 0) == 0 && arm.joint == "PIP2") found.push_back(arm);
  return found;
}

// 7.4 mm at 45 degrees, 0.6 mm at 90: the straight run cuts the corner.
TEST(CollapsedArms, AreToldWhereAStraightRunCutsThroughTheJoint) {
  const std::vector<VanishingArm> bent = at_pip(90);
  ASSERT_EQ(bent.size(), 1U);
  EXPECT_LT(std::abs(bent[0].arm), 1e-3);
  EXPECT_GT(bent[0].max_arm, 7e-3);
  EXPECT_TRUE(at_pip(45).empty());
}

TEST(CollapsedArms, AreOfLongFlexorsOnly) {
  EXPECT_TRUE(is_long_flexor("FDP2") && is_long_flexor("FDS") && is_long_flexor("FPL"));
  EXPECT_FALSE(is_long_flexor("DI4") || is_long_flexor("FDM") || is_long_flexor("FPB"));
}

/// A finger of one joint whose extensor's points are 10 mm beyond it and 15 mm before it: it runs
/// at 4 and 9 mm from the joint when straight, and across it when bent far enough.
constexpr const char* kFlip = R"(
name = "flip"
side = "right"
base = "MC2"
source = "Mine"
sources = {Mine = "Made up for a test"}
[[segment]]
name = "MC2"
[[segment]]
name = "PP2"
proximal_mm = [0, 0, 0]
distal_mm = [-40, 0, 0]
radius_mm = 8
[[joint]]
name = "J"
parent = "MC2"
child = "PP2"
direction = [0, 0, 1]
point_mm = [0, 0, 0]
range_deg = [-60, 170]
[[digit]]
name = "index"
tip_segment = "PP2"
tip_mm = [-40, 0, 0]
proximal = [1, 0, 0]
dorsal = [0, 1, 0]
[[strand]]
name = "EDC"
path = [{segment = "PP2", point_mm = [-10, 4, 0]}, {segment = "MC2", point_mm = [15, 9, 0]}]
[[strand]]
name = "FDP"
path = [{segment = "PP2", point_mm = [-10, -4, 0]}, {segment = "MC2", point_mm = [15, -9, 0]}]
[[muscle]]
name = "EDC"
[[muscle]]
name = "FDP"
)";

std::vector<ReversedArm> reversed_at(const Subject& subject, double degrees) {
  const TendonDigit digit = build_tendon_digit(subject, "index");
  const Eigen::VectorXd q = Eigen::VectorXd::Constant(1, radians(degrees));
  return reversed_arms(digit, tip_statics(digit, q).R);
}

// By hand: the far point is at 158.2 degrees from x, the near one at 31.0, so the run passes the
// joint on its palmar side once they are more than 180 degrees apart: beyond 180 - 127.2 = 52.8.
// For the flexor, mirrored, that is -52.8.
TEST(ReversedArms, AreToldOfExtensorsAndFlexorsAlike) {
  const Subject subject = parse_subject(kFlip, "flip.toml");
  EXPECT_TRUE(reversed_at(subject, 0).empty());
  EXPECT_TRUE(reversed_at(subject, 50).empty());
  const std::vector<ReversedArm> bent = reversed_at(subject, 60), back = reversed_at(subject, -60);
  ASSERT_EQ(bent.size(), 1U);
  EXPECT_EQ(bent[0].muscle, "EDC");
  EXPECT_GT(bent[0].arm, 0);
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back[0].muscle, "FDP");
  EXPECT_LT(back[0].arm, 0);
}

// What the subject states goes before the name.
TEST(ReversedArms, FollowTheSignOfStatedArms) {
  Subject subject = parse_subject(kFlip, "flip.toml");
  subject.strands[0].arms = {{"J", 0.004}};
  const std::vector<ReversedArm> straight = reversed_at(subject, 0);
  ASSERT_EQ(straight.size(), 1U);
  EXPECT_EQ(straight[0].muscle, "EDC");
  EXPECT_TRUE(reversed_at(subject, 60).empty());
}

// A joint that turns the other way round has the other signs.
TEST(ReversedArms, FollowTheSenseOfTheJoint) {
  Subject subject = parse_subject(kFlip, "flip.toml");
  subject.joints[0].direction *= -1;
  subject.joints[0].lower = -kPi;
  EXPECT_TRUE(reversed_at(subject, 0).empty());
  EXPECT_EQ(reversed_at(subject, -60).size(), 1U);
}

TEST(NamedAction, IsThatOfTheHand) {
  EXPECT_EQ(named_action("EDC2", "PIP2"), -1);
  EXPECT_EQ(named_action("EIP", "MCP2_FE"), -1);
  EXPECT_EQ(named_action("FDP3", "DIP3"), 1);
  EXPECT_EQ(named_action("EPL", "IP1"), -1);
  EXPECT_EQ(named_action("LU1", "PIP2"), -1);
  EXPECT_EQ(named_action("LU1", "MCP2_FE"), 0);
  EXPECT_EQ(named_action("DI1", "MCP2_FE"), 1);
  EXPECT_EQ(named_action("DI3", "PIP3"), -1);
  EXPECT_EQ(named_action("EDC2", "MCP2_AA"), 0);
  EXPECT_EQ(named_action("FPL", "CMC1_FE"), 0);
  EXPECT_EQ(named_action("ADD", "MCP1_FE"), 0);
}

}  // namespace
}  // namespace thenar
