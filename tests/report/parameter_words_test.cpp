// Tests for report/parameter_words.cpp.

#include "report/parameter_words.h"

#include <gtest/gtest.h>

#include "base/spatial.h"
#include "base/units.h"

namespace thenar {
namespace {

/// A digit of one hinge about `d`, its proximal, dorsal and radial directions x, y and z.
TendonDigit digit_about(const Eigen::Vector3d& d) {
  TendonDigit digit;
  digit.names.hinges = {"DIP3"};
  digit.model.tree.push_back({-1, 0, 1, 0, d, Eigen::Vector3d::Zero()});
  digit.model.tip_axes = Eigen::Matrix3d::Identity();
  return digit;
}

TEST(ParameterWords, SayWhatNamesMean) {
  EXPECT_EQ(meaning_of("path/FDP/1/dorsal"), "FDP, path point 1: shift dorsally");
  EXPECT_EQ(meaning_of("angle/MCP3_FE/Hook"), "goniometer error at MCP flexion in posture Hook");
  EXPECT_EQ(meaning_of("length/PIP3"), "length of the middle phalanx");
  EXPECT_EQ(meaning_of("H01: gain/RI"), "H01: share of the load on RI that reaches the digit");
  EXPECT_EQ(meaning_of("force/FDP/radial"),
            "tip force of FDP that its geometry does not explain, radially");
  EXPECT_EQ(meaning_of("force/FDP/radial/Hook"),
            "tip force of FDP that its geometry does not explain, in posture Hook alone, radially");
  EXPECT_EQ(meaning_of("spread/axis/direction"),
            "scatter between specimens of tilts of axes over that assumed");
  EXPECT_EQ(meaning_of("nonsense"), "");
}

// tangents() of z are x and y: the tilt of z along x turns it about z x x = y, dorsally, and its
// shift along x is proximal.
TEST(ParameterWords, NameTheDirectionsOfTheDigit) {
  const TendonDigit digit = digit_about(Eigen::Vector3d::UnitZ());
  EXPECT_EQ(meaning_of("axis/DIP3/direction/1", digit),
            "DIP axis: tilt about the dorsal direction");
  EXPECT_EQ(meaning_of("axis/DIP3/direction/2", digit), "DIP axis: tilt about the digit's length");
  EXPECT_EQ(meaning_of("axis/DIP3/point/1", digit), "DIP axis: shift proximally");
  EXPECT_EQ(meaning_of("axis/DIP3/point/2", digit), "DIP axis: shift dorsally");
  EXPECT_EQ(meaning_of("axis/DIP3/point/along", digit), "DIP axis: shift along itself (no effect)");
  EXPECT_EQ(meaning_of("axis/DIP3/direction/1"), "DIP axis: tilt 1 of 2");
}

// In a frame turned by 45 degrees about z, x is (1, -1, 0) and y is (1, 1, 0) of the digit, over
// the root of 2: no one direction names them. Turned by 10 degrees the nearest still does.
TEST(ParameterWords, NameObliqueDirectionsByTheirComponents) {
  TendonDigit digit = digit_about(Eigen::Vector3d::UnitZ());
  const auto turn = [&](double degrees) {
    digit.model.tip_axes =
        Eigen::AngleAxisd(radians(degrees), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  };
  turn(45);
  EXPECT_EQ(meaning_of("axis/DIP3/direction/1", digit),
            "DIP axis: tilt about (0.71 proximal, 0.71 dorsal, 0.00 radial)");
  EXPECT_EQ(meaning_of("axis/DIP3/direction/2", digit),
            "DIP axis: tilt about (-0.71 proximal, 0.71 dorsal, 0.00 radial)");
  EXPECT_EQ(meaning_of("axis/DIP3/point/1", digit),
            "DIP axis: shift along (0.71 proximal, -0.71 dorsal, 0.00 radial)");
  turn(10);
  EXPECT_EQ(meaning_of("axis/DIP3/direction/1", digit),
            "DIP axis: tilt about the dorsal direction");
}

TEST(ParameterWords, LeaveJointsOfOtherNamesAsTheyAre) {
  EXPECT_EQ(joint_words("CMC1_AA"), "CMC abduction");
  EXPECT_EQ(joint_words("IP1"), "IP");
  // Numbers tell joints of other names apart.
  EXPECT_EQ(meaning_of("arm/A/J1"), "moment arm of A at J1");
  EXPECT_EQ(meaning_of("arm/A/J2"), "moment arm of A at J2");
  EXPECT_EQ(joint_words("finger_joint"), "finger_joint");
}

}  // namespace
}  // namespace thenar
