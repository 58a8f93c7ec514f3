// Tests for hand/skin/human_surfaces.cpp and bone_surfaces.cpp.

#include "hand/skin/human_surfaces.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "hand/skin/hand_anatomy.h"
#include "hand/skin/skin_body.h"
#include "tests/hand/sample_subjects.h"
#include "tests/hand/skin/human_subjects.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

const LinkSurface& named(const std::vector<LinkSurface>& surfaces, const std::string& name) {
  for (const LinkSurface& surface : surfaces)
    if (surface.name == name) return surface;
  throw InputError("no surface " + name);
}

TEST(HumanSurfaces, CoverEverySegment) {
  const Subject subject = sample::subject("mirakhorlo2016");
  const Skeleton skeleton = build_skeleton(subject);
  const auto surfaces = human_surfaces(subject, skeleton);
  EXPECT_EQ(surfaces.size(), 16U);  // the palm, three bones of each digit
  for (const LinkSurface& surface : surfaces) {
    EXPECT_EQ(surface.link, skeleton.link_of_segment.at(surface.name));
    EXPECT_EQ(surface.material, "skin");
    EXPECT_EQ(surface.digit.empty(), surface.name == "Palm");
    ASSERT_NE(surface.solid, nullptr);
    EXPECT_FALSE(surface.solid->visual.empty());
    EXPECT_FALSE(surface.solid->collision.empty());
  }
  EXPECT_EQ(named(surfaces, "MC1").digit, "thumb");
}

// What is drawn is finer; what touches, and every distance, stays.
TEST(HumanSurfaces, AreDrawnFinerThanTheyTouch) {
  const Subject subject = sample::subject("an_chao_index");
  const Skeleton skeleton = build_skeleton(subject);
  const auto plain = human_surfaces(subject, skeleton);
  SkinOptions options;
  options.drawn = 2500;
  const auto fine = human_surfaces(subject, skeleton, options);
  const Solid &before = *named(plain, "PP2").solid, &after = *named(fine, "PP2").solid;
  EXPECT_EQ(after.collision[0].core.triangles, before.collision[0].core.triangles);
  EXPECT_EQ(after.collision[0].core.vertices, before.collision[0].core.vertices);
  EXPECT_GT(after.visual.triangles.cols(), 1500);
  EXPECT_LE(after.visual.triangles.cols(), 2500);
  for (const Vector3d& p : after.visual.vertices.colwise())
    EXPECT_LT(std::abs(after.shape->distance(p)), 1e-3);  // both within 0.5 mm of the skin
}

// Links of digits are one capsule each, drawn as skin; how far they are from it is told.
// The picture of a palm has a wrist that ends in a plane, across which it is broader than deep;
// what touches is that of a palm without.
TEST(HumanSurfaces, EndInAWristThatIsDrawnOnly) {
  const Subject subject = sample::scaled();
  const Skeleton skeleton = build_skeleton(subject);
  SkinOptions options;
  options.drawn = 2500;
  const PalmAnatomy palm = *find_anatomy(subject).palm;
  const auto palm_of = [&](const SkinOptions& with) {
    for (const LinkSurface& surface : human_surfaces(subject, skeleton, with))
      if (surface.digit.empty()) return surface;
    throw InputError("no palm");
  };
  const LinkSurface plain = palm_of({}), drawn = palm_of(options);
  const auto lowest = [&](const TriangleMesh& mesh) {
    return (palm.distal.transpose() * (mesh.vertices.colwise() - palm.wrist)).minCoeff();
  };
  EXPECT_EQ(plain.solid->shape->bounds().min(), drawn.solid->shape->bounds().min());
  const TriangleMesh& picture = drawn.solid->visual;
  const double end = lowest(picture);
  EXPECT_LT(end, lowest(plain.solid->visual) - 5e-3);
  // Corners in the plane of the end, and how far they reach across it.
  double broad = 0, deep = 0;
  int corners = 0;
  for (const auto& p : picture.vertices.colwise()) {
    const Eigen::Vector3d r = p - palm.wrist;
    if (r.dot(palm.distal) > end + 0.5e-3) continue;
    ++corners;
    broad = std::max(broad, std::abs(r.dot(palm.radial)));
    deep = std::max(deep, std::abs(r.dot(palm.dorsal)));
  }
  EXPECT_GT(corners, 20);
  EXPECT_GT(broad, 0.25 * palm.breadth);
  EXPECT_GT(broad, 1.2 * deep);
}

TEST(HumanSurfaces, AreCapsulesOnRequest) {
  const Subject subject = sample::subject("mirakhorlo2016");
  const Skeleton skeleton = build_skeleton(subject);
  SkinOptions options;
  options.triangles = 150;
  EXPECT_TRUE(capsule_error(human_surfaces(subject, skeleton, options)).worst.empty());
  options.capsules = true;
  const auto surfaces = human_surfaces(subject, skeleton, options);
  double most = 0;
  for (const LinkSurface& surface : surfaces) {
    ASSERT_EQ(surface.solid->parts.size(), 1U);
    EXPECT_EQ(surface.solid->parts[0].spec.kind,
              surface.name == "Palm" ? ShapeKind::kMesh : ShapeKind::kTaperedCapsule);
    EXPECT_GT(surface.solid->visual.triangles.cols(), 50);
    if (surface.name == "Palm") continue;
    for (const Vector3d& p : surface.solid->visual.vertices.colwise())
      most = std::max(most, std::abs(surface.solid->shape->distance(p)));
  }
  const SkinError error = capsule_error(surfaces);
  EXPECT_DOUBLE_EQ(error.largest, most);
  // Sections of skin are up to 1.25 times as broad as deep: radii within 12 % of the mean, some
  // 1 mm; a link with an eminence is farther off.
  EXPECT_LT(error.rms, 1e-3);
  EXPECT_LT(error.largest, 5e-3);
}

// Triangles sink in by about the square of their edge over eight radii: 0.5 mm on a finger, less
// the finer they are.
TEST(HumanSurfaces, KeepToTheSkin) {
  const Subject subject = sample::subject("an_chao_index");
  const ImplicitBody body = skin_bodies(find_anatomy(subject)).at("PP2");
  const Skeleton skeleton = build_skeleton(subject);
  const auto worst = [&](int triangles) {
    SkinOptions options;
    options.triangles = triangles;
    const auto surfaces = human_surfaces(subject, skeleton, options);
    const Solid& solid = *named(surfaces, "PP2").solid;
    double most = 0;
    sample::Draw draw(1);
    const DigitBone bone = find_anatomy(subject).digits[0].bones[0];
    for (int i = 0; i < 300; ++i) {
      const Vector3d p = bone.proximal + draw.number(0, 1) * (bone.distal - bone.proximal) +
                         0.012 * draw.direction();
      // Heights are a lower bound of distances, so only points near the skin are compared.
      const double height = implicit_height(body, p);
      if (std::abs(height) < 1e-3)
        most = std::max(most, std::abs(solid.shape->distance(p) - height));
    }
    return most;
  };
  EXPECT_LT(worst(800), 5e-4);
  EXPECT_LT(worst(3000), 2.5e-4);
}

TEST(HumanSurfaces, LeaveOutDigitsThatAreNotKept) {
  const Subject subject = sample::scaled();
  const auto surfaces = human_surfaces(subject, build_skeleton(subject, {{"index"}, {}}));
  EXPECT_EQ(surfaces.size(), 4U);
  EXPECT_EQ(named(surfaces, "Palm").link, -1);
}

// A frozen joint carries the skin beyond it along.
TEST(HumanSurfaces, FollowFrozenJoints) {
  const Subject subject = sample::scaled();
  const Skeleton bent = build_skeleton(subject, {{"index"}, {{"PIP2", 0.7}}});
  const auto straight = human_surfaces(subject, build_skeleton(subject, {{"index"}, {}}));
  const auto moved = human_surfaces(subject, bent);
  const Pose<double> X = bent.segment_at.at("DP2");
  const Eigen::Matrix3Xd& a = named(straight, "DP2").solid->visual.vertices;
  const Eigen::Matrix3Xd& b = named(moved, "DP2").solid->visual.vertices;
  ASSERT_EQ(a.cols(), b.cols());
  EXPECT_LT((((X.R * a).colwise() + X.p) - b).norm(), 1e-12);
}

// -- A user's own meshes ----------------------------------------------------------------------

/// A box about a point.
TriangleMesh box_at(const Vector3d& center, const Vector3d& edges) {
  ShapeSpec box;
  box.kind = ShapeKind::kBox;
  box.size = edges;
  box.X_BS.p = center;
  return build_solid({box}).visual;
}

TEST(HumanSurfaces, TakeTheUsersOwn) {
  const Subject subject = sample::scaled();
  const Skeleton skeleton = build_skeleton(subject, {{"index"}, {}});
  const Vector3d center = find_anatomy(subject).digits[1].bones[1].proximal;
  SkinOptions options;
  options.own["MP2"] = box_at(center, {0.02, 0.04, 0.02});
  const auto surfaces = human_surfaces(subject, skeleton, options);
  EXPECT_EQ(surfaces.size(), 4U);
  const LinkSurface& own = named(surfaces, "MP2");
  EXPECT_EQ(own.digit, "index");
  EXPECT_NEAR(own.solid->shape->distance(center), -0.01, 1e-6);
  EXPECT_NEAR(own.solid->shape->distance(center + Vector3d(0.015, 0, 0)), 0.005, 1e-6);
}

TEST(HumanSurfaces, RefuseLeaks) {
  const Subject subject = sample::scaled();
  const Skeleton skeleton = build_skeleton(subject, {{"index"}, {}});
  SkinOptions options;
  TriangleMesh leaky = box_at({0, 0, 0}, {0.02, 0.02, 0.02});
  leaky.triangles.conservativeResize(3, leaky.triangles.cols() - 1);
  options.own["MP2"] = leaky;
  const std::string said = message_of([&] { (void)human_surfaces(subject, skeleton, options); });
  EXPECT_EQ(said.rfind("skin of segment 'MP2' leaks: 3 edges", 0), 0U) << said;
  options.own = {{"MP9", leaky}};
  EXPECT_EQ(message_of([&] { (void)human_surfaces(subject, skeleton, options); }),
            "a mesh for segment 'MP9', which 'buchholz1992' does not have");
}

// -- Bones ------------------------------------------------------------------------------------

// Every point of a bone lies under the skin of its own segment or of a neighbour.
TEST(BoneSurfaces, LieWithinTheSkin) {
  for (const Subject& subject : {sample::scaled(), sample::subject("mirakhorlo2016")}) {
    const auto bodies = skin_bodies(find_anatomy(subject));
    const auto bones = bone_surfaces(subject, build_skeleton(subject));
    EXPECT_EQ(bones.size(), 16U);
    for (const LinkSurface& bone : bones) {
      EXPECT_EQ(bone.material, "bone");
      double highest = -1;
      for (const Vector3d& p : bone.solid->visual.vertices.colwise()) {
        double height = 1;
        for (const auto& [segment, body] : bodies)
          height = std::min(height, implicit_height(body, p));
        highest = std::max(highest, height);
      }
      EXPECT_LT(highest, -1e-3) << bone.name;  // at least a millimetre of flesh
    }
  }
}

}  // namespace
}  // namespace thenar
