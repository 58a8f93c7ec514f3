// Tests for hand/skin/skin_mass.cpp.

#include "hand/skin/skin_mass.h"

#include <gtest/gtest.h>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "base/units.h"
#include "hand/segment_mass.h"
#include "tests/hand/skin/human_subjects.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

TEST(SkinMass, WeighsABall) {
  const double r = 0.01;
  Lump ball;
  ball.core = {Vector3d(0.1, 0.2, 0.3), Vector3d(0.1, 0.2, 0.3), Vector3d::Zero()};
  ball.radius = {r, r};
  const LinkMass mass = skin_masses({}, {{"ball", {ball}}}).at("ball");
  const double expected = kHandDensity * 4 / 3 * kPi * r * r * r;
  EXPECT_NEAR(mass.mass, expected, 2e-3 * expected);
  EXPECT_TRUE(matrix_near(mass.com, ball.core[0], 1e-6));
  const Eigen::Matrix3d inertia = 0.4 * expected * r * r * Eigen::Matrix3d::Identity();
  EXPECT_TRUE(matrix_near(mass.inertia, inertia, 5e-3 * inertia(0, 0)));
}

// Two halves of a digit are as heavy as the whole: flesh at a joint counts once.
TEST(SkinMass, CountsFleshAtJointsOnce) {
  HandAnatomy hand;
  DigitBone one{"one", {0, 0, 0}, {0.03, 0, 0}, 0.01, {0, 0, 1}, {0, 1, 0}};
  DigitBone two{"two", {0.03, 0, 0}, {0.06, 0, 0}, 0.01, {0, 0, 1}, {0, 1, 0}};
  hand.digits = {{"index", "", {one, two}}};
  const auto capsule = [](double from, double to) {
    Lump lump;
    lump.core = {Vector3d(from, 0, 0), Vector3d(to, 0, 0), Vector3d::Zero()};
    lump.radius = {0.01, 0.01};
    return SoftBody{lump};
  };
  const auto parts = skin_masses(hand, {{"one", capsule(0, 0.03)}, {"two", capsule(0.03, 0.06)}});
  const LinkMass whole = skin_masses({}, {{"whole", capsule(0, 0.06)}}).at("whole");
  const LinkMass both = combine(parts.at("one"), parts.at("two"));
  EXPECT_NEAR(both.mass, whole.mass, 3e-3 * whole.mass);
  EXPECT_TRUE(matrix_near(both.com, whole.com, 1e-4));
  EXPECT_TRUE(matrix_near(both.inertia, whole.inertia, 0.01 * whole.inertia(2, 2)));
}

// The source's masses are cylinders of 1.00 g/cm^3 about the landmarks, ours are filled with
// kHandDensity, 1.16: volumes are compared. The source doubts where each joint is (point_sd):
// by 6.9 mm on average over the twelve joints of the fingers, 21 % of a phalanx of 32 mm. To move a
// joint lengthens one bone and shortens the next, so that of a whole finger only the doubt of its
// knuckle counts: 5.5 mm of 97 mm, 6 %; and our tips taper where cylinders end square, 4 % of a
// finger.
TEST(SkinMass, AgreesWithMeasuredFingers) {
  const Subject subject = sample::subject("mirakhorlo2016");
  const HandAnatomy hand = find_anatomy(subject);
  const auto masses = skin_masses(hand, skin_bodies(hand));
  double ours = 0, theirs = 0;
  for (const Segment& segment : subject.segments)
    for (const char* kind : {"PP", "MP", "DP"})
      if (segment.name.rfind(kind, 0) == 0 && segment.name.back() != '1') {
        const double volume = masses.at(segment.name).mass / kHandDensity;
        const double stated = segment.mass / 1000;
        ours += volume;
        theirs += stated;
        // A single one: two ends of doubt; of a tip one, and that it tapers to 0.66 of its radius,
        // (1 + 0.66 + 0.66^2) / 3 = 0.70 of the cylinder.
        const bool tip = segment.name.front() == 'D';
        EXPECT_NEAR(volume / stated, 1, tip ? 0.21 + 0.30 : 0.21 * std::sqrt(2)) << segment.name;
      }
  EXPECT_NEAR(ours / theirs, 1, 0.10);
}

// Measured masses win; a hand without any gets all.
TEST(SkinMass, FillsWhatIsNotStated) {
  const Subject measured = with_skin_masses(sample::subject("mirakhorlo2016"));
  for (const Segment& segment : measured.segments)
    if (segment.name == "PP2") {
      EXPECT_DOUBLE_EQ(segment.mass, 13.31e-3);
    }
  double whole = 0;
  for (const Segment& segment : with_skin_masses(sample::scaled()).segments) {
    whole += segment.mass;
    if (segment.mass > 0) {
      EXPECT_GT(segment.inertia.eigenvalues().real().minCoeff(), 0);
    }
  }
  // [Dempster1955]: a hand is 0.6 % of the body; bodies of 50 to 90 kg.
  EXPECT_GT(whole, 0.006 * 50);
  EXPECT_LT(whole, 0.006 * 90);
}

}  // namespace
}  // namespace thenar
