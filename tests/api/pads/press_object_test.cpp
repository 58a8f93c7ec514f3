// Tests for api/pads/press_object.cpp.

#include "api/pads/press_object.h"

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

constexpr double kPadLength = 24e-3;  // [m]

PressObject object_of(const std::string& name, std::optional<double> radius = {}) {
  return open_press_object({name, radius}, kPadLength);
}
double distance_of(const PressObject& object, const Vector3d& p_mm) {
  return object.shape->distance(kMm * p_mm) / kMm;
}

TEST(PressObject, HasItsTopAtTheOrigin) {
  for (const std::string& name : press_object_names()) {
    const PressObject object = object_of(name);
    EXPECT_NEAR(distance_of(object, {0, 0, 0}), 0, 1e-12) << name;
    EXPECT_NEAR(distance_of(object, {0, 0, 3}), 3, 1e-12) << name;
    EXPECT_LT(distance_of(object, {0, 0, -0.1}), 0) << name;
    EXPECT_LT(object.picture.vertices.row(2).maxCoeff(), 1e-4) << name;
    EXPECT_GT(object.picture.vertices.row(2).maxCoeff(), -1e-4) << name;
  }
}

TEST(PressObject, IsWhatItsNameSays) {
  EXPECT_NEAR(distance_of(object_of("plane"), {40, -30, 2}), 2, 1e-12);
  // A ball about (0, 0, -5) of 5.
  EXPECT_NEAR(distance_of(object_of("sphere", 5e-3), {3, 4, -5}), 0, 1e-12);
  EXPECT_NEAR(distance_of(object_of("sphere", 5e-3), {6, 8, -5}), 5, 1e-12);
  // A cylinder along y.
  EXPECT_NEAR(distance_of(object_of("cylinder", 5e-3), {6, 60, 3}), 5, 1e-12);
  // An edge along y: a rounding about z = -1, then faces 45 degrees down, tangent to it.
  const PressObject edge = object_of("edge", 1e-3);
  EXPECT_NEAR(distance_of(edge, {0, 50, 1}), 1, 1e-12);
  const double s = std::sqrt(0.5);
  EXPECT_NEAR(distance_of(edge, {3 * s + 5 * s, 0, -1 + 3 * s - 5 * s}), 2, 1e-12);
  EXPECT_NEAR(distance_of(edge, {-2 * s - 4 * s, 9, -1 + 2 * s - 4 * s}), 1, 1e-12);
}

TEST(PressObject, OfANameOrRadiusThatIsNoneIsRefused) {
  EXPECT_THAT(message_of([] { (void)object_of("sphear"); }),
              HasSubstr("there is no object 'sphear', did you mean 'sphere'?"));
  EXPECT_EQ(message_of([] { (void)object_of("plane", 1e-3); }), "an object 'plane' has no radius");
  for (const double radius : {0.0, -1e-3, 2.0, double(NAN)})
    EXPECT_THAT(message_of([&] { (void)object_of("sphere", radius); }),
                HasSubstr("wanted a radius above 0"));
}

class PressMesh : public TemporaryFolder {};

TEST_F(PressMesh, PressesWithTheMiddleOfItsTop) {
  // A block of 10 x 20 x 30 mm, off its file's origin.
  std::ofstream(path("block.off")) << "OFF\n8 6 0\n"
                                   << "5 5 5\n15 5 5\n15 25 5\n5 25 5\n"
                                   << "5 5 35\n15 5 35\n15 25 35\n5 25 35\n"
                                   << "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n"
                                   << "4 3 0 4 7\n";
  const PressObject block = object_of(path("block.off"));
  EXPECT_NEAR(distance_of(block, {0, 0, 2}), 2, 1e-9);
  EXPECT_NEAR(distance_of(block, {8, 0, -15}), 3, 1e-9);
  EXPECT_NEAR(distance_of(block, {0, 14, 0}), 4, 1e-9);
  EXPECT_EQ(block.files.size(), 1U);
  EXPECT_THROW((void)open_press_object({path("block.off"), {}, 0}, kPadLength), InputError);
}

/// Distance of the supporting plane of a half ellipsoid from its middle: sqrt(sum (e_i n_i)^2).
double support(const PadShape& shape, double angle) {
  return std::hypot(shape.length / 2 * std::sin(angle), shape.height * std::cos(angle));
}

TEST(PadTouch, OfAPlaneIsTheSupportOfTheEllipsoid) {
  const PadShape shape;
  const PressObject plane = object_of("plane");
  for (const double angle : {0.0, 0.3, -0.5, 1.0}) {
    const PadTouch touch = touch_pad(shape, *plane.shape, angle, 0);
    EXPECT_TRUE(touch.along.isApprox(-Vector3d(std::sin(angle), 0, std::cos(angle))));
    // Samples of the skin lie 2 um below it at most, as their distance of 0.2 mm has it.
    EXPECT_NEAR(-touch.along.dot(touch.X_PO.p), support(shape, angle), 2e-6) << angle;
    EXPECT_TRUE((touch.X_PO.R * Vector3d::UnitZ()).isApprox(touch.along));
    EXPECT_NEAR(touch.X_PO.R.determinant(), 1, 1e-12);
  }
}

TEST(PadTouch, OfABallIsAtTheApex) {
  const PadTouch touch = touch_pad({}, *object_of("sphere").shape, 0, 0);
  EXPECT_TRUE(touch.X_PO.p.isApprox(Vector3d(0, 0, 10e-3), 1e-6)) << touch.X_PO.p.transpose();
}

TEST(PadTouch, TurnsTheObjectAboutItsWay) {
  const PadTouch across = touch_pad({}, *object_of("cylinder").shape, 0.4, 0);
  const PadTouch along = touch_pad({}, *object_of("cylinder").shape, 0.4, kPi / 2);
  EXPECT_TRUE((across.X_PO.R * Vector3d::UnitY()).isApprox(Vector3d::UnitY()));
  EXPECT_NEAR((along.X_PO.R * Vector3d::UnitY()).y(), 0, 1e-12);
  EXPECT_TRUE((along.X_PO.R * Vector3d::UnitZ()).isApprox(along.along));
}

TEST(PadTouch, RefusesAnglesAtWhichTheNailTouches) {
  const PressObject plane = object_of("plane");
  EXPECT_THAT(message_of([&] { (void)touch_pad({}, *plane.shape, radians(61), 0); }),
              HasSubstr("within 60 deg either way, got 61 deg"));
  EXPECT_THROW((void)touch_pad({}, *plane.shape, NAN, 0), InputError);
  EXPECT_THROW((void)touch_pad({}, *plane.shape, 0, INFINITY), InputError);
}

}  // namespace
}  // namespace thenar
