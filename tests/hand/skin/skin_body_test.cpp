// Tests for hand/skin/skin_body.cpp and the meshes made of it: does it have the measures of a hand?

#include <cmath>
#include <map>

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "base/error.h"
#include "base/units.h"
#include "hand/skeleton.h"
#include "hand/skin/human_surfaces.h"
#include "hand/skin/skin_body.h"
#include "tests/hand/skin/human_subjects.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

class SkinOf : public testing::TestWithParam<const char*> {
 protected:
  Subject subject =
      std::string(GetParam()) == "scaled" ? sample::scaled() : sample::subject(GetParam());
  HandAnatomy hand = find_anatomy(subject);
  std::map<std::string, ImplicitBody> bodies = skin_bodies(hand);
};

/// Way from a point within to the skin.
double way_out(const ImplicitBody& body, const Vector3d& from, const Vector3d& direction) {
  double way = 0;
  while (implicit_height(body, from + way * direction) < 0) way += 5e-5;
  return way;
}

// Every edge belongs to two triangles, which walk it in opposite ways.
TEST_P(SkinOf, IsWatertightAndSmall) {
  for (const auto& [segment, body] : bodies) {
    const TriangleMesh mesh = skin_mesh(body, 800);
    EXPECT_LE(mesh.triangles.cols(), 800) << segment;
    EXPECT_GE(mesh.triangles.cols(), 500) << segment;
    std::map<std::pair<int, int>, int> edges;
    double volume = 0;
    for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
      const Eigen::Vector3i& corner = mesh.triangles.col(t);
      for (int i = 0; i < 3; ++i) ++edges[{corner[i], corner[(i + 1) % 3]}];
      volume += mesh.vertices.col(corner[0])
                    .cross(mesh.vertices.col(corner[1]))
                    .dot(mesh.vertices.col(corner[2])) /
                6;
    }
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1) << segment;
      EXPECT_EQ(edges.count({edge.second, edge.first}), 1U) << segment;
    }
    EXPECT_GT(volume, 0) << segment << " is inside out";
  }
}

// What a hand's neighbours share: the ball about the joint between them.
TEST_P(SkinOf, LeavesNoGapAtJoints) {
  for (const DigitAnatomy& digit : hand.digits)
    for (std::size_t i = 0; i < digit.bones.size(); ++i) {
      const Vector3d& joint = digit.bones[i].proximal;
      const double least = -0.6 * digit.bones[i].radius;
      EXPECT_LT(implicit_height(bodies.at(digit.bones[i].segment), joint), least)
          << digit.name << i;
      const std::string& inner = i > 0 ? digit.bones[i - 1].segment : digit.root;
      if (bodies.count(inner) == 0) continue;
      EXPECT_LT(implicit_height(bodies.at(inner), joint), least) << digit.name << i;
    }
}

// Skin ends where the subject says that the tip is.
TEST_P(SkinOf, EndsAtTheTip) {
  for (const DigitAnatomy& digit : hand.digits) {
    const DigitBone& bone = digit.bones.back();
    EXPECT_NEAR(implicit_height(bodies.at(bone.segment), bone.distal), 0, 1e-3) << digit.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Subjects, SkinOf,
                         testing::Values("mirakhorlo2016", "scaled", "arms_thumb", "an_chao_index",
                                         "graspit_skewed_thumb", "graspit_orthogonal_thumb"));

// Section of a finger: an ellipse of the radius that the subject says.
TEST(SkinBody, HasFingersOfPlausibleBreadth) {
  const HandAnatomy hand = find_anatomy(sample::scaled());
  const auto bodies = skin_bodies(hand);
  const DigitBone& middle = digit_named(hand, "index")->bones[1];  // its base is the PIP joint
  const ImplicitBody& body = bodies.at("PP2");
  const double breadth = way_out(body, middle.proximal, middle.radial) +
                         way_out(body, middle.proximal, -middle.radial);
  const double depth = way_out(body, middle.proximal, middle.dorsal) +
                       way_out(body, middle.proximal, -middle.dorsal);
  EXPECT_GT(breadth, 0.016);  // of index fingers at the PIP joint in hands of 85 mm
  EXPECT_LT(breadth, 0.020);
  EXPECT_LT(depth, breadth);
}

// Out from the middle of the palm, level with the heads of metacarpals II and V. The knuckles of
// the digitised hand were touched on their sides, so its palm is somewhat broader than the tape
// said.
TEST(SkinBody, HasAPalmOfTheStatedBreadth) {
  const auto breadth_over_stated = [](const Subject& subject) {
    const HandAnatomy hand = find_anatomy(subject);
    const ImplicitBody palm = skin_bodies(hand).at("Palm");
    const Vector3d& index = digit_named(hand, "index")->bones[0].proximal;
    const Vector3d& little = digit_named(hand, "little")->bones[0].proximal;
    const Vector3d across = (index - little).normalized();
    return ((index - little).norm() + way_out(palm, index, across) +
            way_out(palm, little, -across)) /
           hand.palm->breadth;
  };
  EXPECT_NEAR(breadth_over_stated(sample::scaled()), 1, 0.06);
  EXPECT_NEAR(breadth_over_stated(sample::subject("mirakhorlo2016")), 1.1, 0.1);
}

// Pads bulge: from the bone's line there is more flesh on the palmar side than under the nail.
TEST(SkinBody, BulgesAtThePads) {
  const HandAnatomy hand = find_anatomy(sample::subject("mirakhorlo2016"));
  const auto bodies = skin_bodies(hand);
  for (const DigitAnatomy& digit : hand.digits) {
    const DigitBone& bone = digit.bones.back();
    const Vector3d middle = (bone.proximal + bone.distal) / 2;
    EXPECT_GT(way_out(bodies.at(bone.segment), middle, -bone.dorsal),
              1.1 * way_out(bodies.at(bone.segment), middle, bone.dorsal))
        << digit.name;
  }
}

// Between the heads of the thumb's and the index finger's metacarpal there is skin, thinner than
// either and drawn in towards the wrist.
TEST(SkinBody, SpansAWebBetweenThumbAndIndex) {
  for (const Subject& subject : {sample::scaled(), sample::subject("mirakhorlo2016")}) {
    const HandAnatomy hand = find_anatomy(subject);
    const auto bodies = skin_bodies(hand);
    const DigitBone& thumb = digit_named(hand, "thumb")->bones[0];
    const Vector3d index = digit_named(hand, "index")->bones[0].proximal;
    for (double part = 0.1; part < 0.95; part += 0.1) {
      const Vector3d chord = thumb.distal + part * (index - thumb.distal);
      const Vector3d drawn = thumb.proximal + 0.75 * (chord - thumb.proximal);
      EXPECT_LT(std::min(implicit_height(bodies.at("MC1"), drawn),
                         implicit_height(bodies.at("Palm"), drawn)),
                0)
          << subject.name << " " << part;
    }
  }
}

TEST(SkinMesh, RefusesTooFewTriangles) {
  const auto bodies = skin_bodies(find_anatomy(sample::scaled()));
  EXPECT_THROW((void)skin_mesh(bodies.at("PP2"), 99), InputError);
}

}  // namespace
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
    return ImplicitBody{lump};
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
