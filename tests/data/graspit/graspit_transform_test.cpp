// Tests for data/io/graspit/graspit_transform.cpp and xml_file.cpp.

#include "data/io/graspit/graspit_transform.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include "base/units.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

constexpr double kRounding = 1e-15;

Pose<double> pose_of(const std::string& inside) {
  const XmlFile file("<transform>\n" + inside + "\n</transform>", "world.xml");
  std::vector<std::string> warnings;
  const Pose<double> X = graspit_transform(file, file.root(), warnings);
  EXPECT_TRUE(warnings.empty());
  return X;
}

std::string refusal(const std::string& inside) {
  return message_of<DataError>([&] { (void)pose_of(inside); });
}

TEST(GraspitTransform, ReadsFullTransformInMillimetres) {
  // Half a turn about y: (w x y z) = (0 0 1 0).
  const Pose<double> X = pose_of("<fullTransform>(+0 +0 +1 +0)[+10 -20.5 3e1]</fullTransform>");
  EXPECT_TRUE(matrix_near(X.R, Eigen::Vector3d(-1, 1, -1).asDiagonal().toDenseMatrix(), kRounding));
  EXPECT_TRUE(matrix_near(X.p, Eigen::Vector3d(0.010, -0.0205, 0.030), kRounding));
}

TEST(GraspitTransform, MultipliesItsStepsFromLeftToRight) {
  // A way along the turned axes: 90 deg about z carries x to y.
  const Pose<double> X = pose_of(
      "<translation>5 0 0</translation><rotation>90 z</rotation>"
      "<translation>10 0 0</translation>");
  EXPECT_TRUE(matrix_near(X.p, Eigen::Vector3d(0.005, 0.010, 0), kRounding));
}

TEST(GraspitTransform, ReadsRotationMatricesColumnByColumn) {
  // Carries x to y and y to -x: its first column is y.
  const Pose<double> X = pose_of("<rotationMatrix>0 1 0 -1 0 0 0 0 1</rotationMatrix>");
  EXPECT_TRUE(matrix_near(X.R, rotation_about<double>({0, 0, 1}, kPi / 2), kRounding));
}

TEST(GraspitTransform, TakesTheAxisBeforeOrAfterTheAngleOrInNumbers) {
  const Mat3<double> R = rotation_about<double>({0, 1, 0}, kPi / 6);
  for (const char* text : {"30 y", "y 30", "30 Y", "30 0 2 0"})
    EXPECT_TRUE(
        matrix_near(pose_of(std::string("<rotation>") + text + "</rotation>").R, R, kRounding));
}

TEST(GraspitTransform, LooksIntoTheElementThatHoldsIt) {
  const XmlFile file("<robot><transform><translation>1 2 3</translation></transform></robot>",
                     "world.xml");
  std::vector<std::string> warnings;
  EXPECT_TRUE(matrix_near(graspit_transform(file, file.root(), warnings).p,
                          Eigen::Vector3d(0.001, 0.002, 0.003), kRounding));
}

TEST(GraspitTransform, NamesWhatItDoesNotKnow) {
  const XmlFile file("<transform>\n<!-- fine -->\n<shear>1 2 3</shear></transform>", "world.xml");
  std::vector<std::string> warnings;
  (void)graspit_transform(file, file.root(), warnings);
  EXPECT_THAT(warnings,
              testing::ElementsAre("world.xml:3: <shear> is not understood and was left out"));
}

TEST(GraspitTransform, RefusesWhatIsNoRotation) {
  EXPECT_EQ(refusal("<fullTransform>(1 1 0 0)[0 0 0]</fullTransform>"),
            "world.xml:2: wanted a quaternion of length 1, got 1.41421");
  EXPECT_THAT(refusal("<rotationMatrix>1 0 0 0 1 0 0 0 -1</rotationMatrix>"),
              testing::HasSubstr("world.xml:2: wanted a rotation"));
  EXPECT_EQ(refusal("<rotation>90 w</rotation>"),
            "world.xml:2: wanted an angle and one axis in <rotation>, got '90 w'");
}

TEST(GraspitTransform, RefusesWrongNumbers) {
  EXPECT_EQ(refusal("<translation>1 2</translation>"),
            "world.xml:2: wanted 3 numbers in <translation>, got 2");
  EXPECT_EQ(refusal("<translation>1 2 nan</translation>"),
            "world.xml:2: wanted finite numbers in <translation>, got '1 2 nan'");
  EXPECT_EQ(refusal("<translation>1 2 3x</translation>"),
            "world.xml:2: wanted finite numbers in <translation>, got '1 2 3x'");
}

// What comes out is UTF-8 whatever came in, as TOML and JSON want it, and lines stay.
TEST(XmlFile, ReadsUtf8AndLatin1) {
  for (const std::string e : {"\xC3\xA9", "\xE9"}) {
    const XmlFile file("<a>\n<b name='caf" + e + "'>" + e + "</b>\n<c/></a>", "a.xml");
    EXPECT_EQ(file.root().child("b").attribute("name").value(), std::string("caf\xC3\xA9"));
    EXPECT_EQ(file.text(file.root().child("b")), "\xC3\xA9");
    EXPECT_EQ(file.line(file.root().child("c")), 3);
  }
  EXPECT_EQ(XmlFile("\xEF\xBB\xBF<a/>", "a.xml").root_name(), "a");
  EXPECT_THROW((void)XmlFile(std::string("\xFF\xFE<\0a\0/\0>\0", 10), "a.xml"), DataError);
}

TEST(XmlFile, TellsWhereTheTextIsNoXml) {
  EXPECT_THAT(message_of<DataError>([] { (void)XmlFile("<a>\n<b>\n</a>", "bad.xml"); }),
              testing::StartsWith("bad.xml:3: "));
  EXPECT_THAT(message_of<DataError>([] { (void)XmlFile("/nowhere/bad.xml"); }),
              testing::StartsWith("/nowhere/bad.xml:1: "));
}

}  // namespace
}  // namespace thenar
