// Tests for hand/skin/skin_body.cpp and the meshes made of it: does it have the measures of a hand?

#include "hand/skin/skin_body.h"

#include <map>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "base/error.h"
#include "hand/skin/human_surfaces.h"
#include "tests/hand/skin/human_subjects.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

class SkinOf : public testing::TestWithParam<const char*> {
 protected:
  Subject subject =
      std::string(GetParam()) == "scaled" ? sample::scaled() : sample::subject(GetParam());
  HandAnatomy hand = find_anatomy(subject);
  std::map<std::string, SoftBody> bodies = skin_bodies(hand);
};

/// Way from a point within to the skin.
double way_out(const SoftBody& body, const Vector3d& from, const Vector3d& direction) {
  double way = 0;
  while (soft_height(body, from + way * direction) < 0) way += 5e-5;
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
      EXPECT_LT(soft_height(bodies.at(digit.bones[i].segment), joint), least) << digit.name << i;
      const std::string& inner = i > 0 ? digit.bones[i - 1].segment : digit.root;
      if (bodies.count(inner) == 0) continue;
      EXPECT_LT(soft_height(bodies.at(inner), joint), least) << digit.name << i;
    }
}

// Skin ends where the subject says that the tip is.
TEST_P(SkinOf, EndsAtTheTip) {
  for (const DigitAnatomy& digit : hand.digits) {
    const DigitBone& bone = digit.bones.back();
    EXPECT_NEAR(soft_height(bodies.at(bone.segment), bone.distal), 0, 1e-3) << digit.name;
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
  const SoftBody& body = bodies.at("PP2");
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
    const SoftBody palm = skin_bodies(hand).at("Palm");
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
      EXPECT_LT(
          std::min(soft_height(bodies.at("MC1"), drawn), soft_height(bodies.at("Palm"), drawn)), 0)
          << subject.name << " " << part;
    }
  }
}

TEST(SkinMesh, RefusesTooFewTriangles) {
  const auto bodies = skin_bodies(find_anatomy(sample::scaled()));
  EXPECT_THROW((void)skin_mesh(bodies.at("PP2"), 99), InputError);
}

}  // namespace
}  // namespace thenar
