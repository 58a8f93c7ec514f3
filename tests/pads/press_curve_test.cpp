#include "pads/press_curve.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "geometry/primitives.h"
#include "pads/contact_area.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

PadModel layered_pad(double factor) {
  PadModel pad;
  pad.cells = {2, 1, 2};
  pad.shape.layers = {{1e-3}};
  Tissue pulp, skin;
  pulp.shear_modulus = factor * 6e3;
  pulp.relaxation = {{0.3, 0.05}, {0.2, 1}};
  skin.law = TissueLaw::kVerondaWestmann;
  skin.shear_modulus = factor * 30e3;
  skin.exponent = 1;
  pad.tissues = {pulp, skin};
  return pad;
}

PressCourse wall() {
  PressCourse course;
  course.object = {build_box({0.1, 0.1, 0.1}), 0};
  course.X_PO.p = {0, 0, 0.07};
  return course;
}

// Twice as stiff everywhere, under twice the force, a pad has the same shape at every time.
TEST(PressCurve, MoreStiffnessIsLessForce) {
  PressCourse once = wall(), twice = wall();
  for (const double force : {0.3, 1.0, 2.0}) {
    once.loads.push_back({force, 0, 0.1});
    twice.loads.push_back({2 * force, 0, 0.1});
  }
  const PressCurves a = press_curves({layered_pad(1)}, once);
  const PressCurves b = press_curves({layered_pad(2)}, twice);
  ASSERT_EQ(a.status, Status::kSolved) << a.message;
  ASSERT_EQ(b.status, Status::kSolved) << b.message;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(b.points[0][i].indentation / a.points[0][i].indentation, 1, 1e-6);
    EXPECT_NEAR(b.points[0][i].area / a.points[0][i].area, 1, 1e-6);
    EXPECT_NEAR(a.points[0][i].force / *once.loads[i].force, 1, 1e-8);
  }
}

TEST(PressCurve, ANeighbourIsWhatItIsAlone) {
  PressCourse course = wall();
  for (const double mm : {0.3, 0.8, 1.5}) course.loads.push_back({{}, mm * 1e-3, 0.05});
  const PressCurves both = press_curves({layered_pad(1), layered_pad(1.001)}, course);
  const PressCurves alone = press_curves({layered_pad(1.001)}, course);
  ASSERT_EQ(both.status, Status::kSolved) << both.message;
  ASSERT_EQ(alone.status, Status::kSolved) << alone.message;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(both.points[1][i].force / alone.points[0][i].force, 1, 1e-7);
    // A thousandth stiffer.
    EXPECT_NEAR(both.points[1][i].force / both.points[0][i].force, 1.001, 1e-7);
  }
}

// With an odd count of cells no node is where the object touches first.
TEST(PressCurve, ForcesAreFoundOnAnyMesh) {
  PressCourse course = wall();
  course.loads = {{0.05, 0, 0}, {0.5, 0, 0}};
  for (const int across : {3, 5}) {
    PadModel pad = layered_pad(1);
    pad.cells = {across, 2, 2};
    const PressCurves out = press_curves({pad}, course);
    ASSERT_EQ(out.status, Status::kSolved) << out.message;
    EXPECT_NEAR(out.points[0][0].force, 0.05, 1e-8);
  }
}

TEST(PressCurve, NonsenseIsRefused) {
  PressCourse course = wall();
  EXPECT_THROW((void)press_curves({}, course), InputError);
  course.loads = {{-1.0, 0, 0}};
  EXPECT_THROW((void)press_curves({layered_pad(1)}, course), InputError);
  course.loads = {{1.0, 0, 0}};
  PadModel other = layered_pad(1);
  other.cells = {3, 1, 2};
  EXPECT_THROW((void)press_curves({layered_pad(1), other}, course), InputError);
}

TEST(PressCurve, ALoadOutOfReachIsNamed) {
  PressCourse course = wall();
  course.loads = {{{}, 1e-3, 0}, {{}, 9e-3, 0}};  // into the bone
  const PressCurves out = press_curves({layered_pad(1)}, course);
  EXPECT_EQ(out.status, Status::kStalled);
  EXPECT_EQ(out.message.rfind("at 9 mm: ", 0), 0U) << out.message;
  EXPECT_EQ(out.points[0].size(), 1U);
}

TEST(ContactArea, SharesOfATriangle) {
  EXPECT_EQ(positive_share({1, 2, 3}), 1);
  EXPECT_EQ(positive_share({-1, -2, 0}), 0);
  // Cut at the middles of two sides; a quarter is on the corner's side.
  EXPECT_NEAR(positive_share({1, -1, -1}), 0.25, 1e-15);
  EXPECT_NEAR(positive_share({-1, 1, 1}), 0.75, 1e-15);
  EXPECT_NEAR(positive_share({3, -1, 0}), 0.75, 1e-15);
}

// Hertz: a^2 = R d on a half space, here a slab of 25 times a, five cells. Its floor, to which it
// sticks, holds the surface up by e = 2/3 1.133 a / h of the depth, all of it alike, as it makes
// the force (1 + e)^3/2 = 1 + 1.133 a / h times Hertz's [Dimitriadis2002]: a^2 = R d (1 + e).
TEST(ContactArea, OfABallIsThatOfHertz) {
  constexpr double kSize = 0.1, kRadius = 0.02, kDepth = 2e-4;
  HexMesh mesh = box_mesh({kSize, kSize, kSize / 2}, {4, 4, 2});
  const Vector3d top(kSize / 2, kSize / 2, kSize / 2);
  for (int level = 0; level < 6; ++level) {
    std::vector<int> marked;
    for (const int index : mesh.active()) {
      const HexCell& cell = mesh.cells()[static_cast<std::size_t>(index)];
      const Vector3d low = mesh.place(cell.corners[0]), high = mesh.place(cell.corners[7]);
      const double away = (top.cwiseMax(low).cwiseMin(high) - top).norm();
      if (away < std::max(3e-3, 0.6 * (high - low)[0])) marked.push_back(index);
    }
    mesh.refine(marked);
  }
  std::vector<bool> floor, on_top;
  for (int node = 0; node < mesh.nodes(); ++node) {
    floor.push_back(mesh.place(node)[2] < 1e-9);
    on_top.push_back(mesh.place(node)[2] > kSize / 2 - 1e-9);
  }
  Tissue tissue;
  tissue.shear_modulus = 1e4;
  const TissueBody body(mesh, HexElement::kMeanDilatation, {tissue}, floor);
  const ContactSurface surface = build_contact_surface(mesh, body, on_top);
  PressFactors factors(body);
  const RigidObject ball{build_sphere(kRadius), 0};
  Pose<double> X;
  X.p = top + Vector3d(0, 0, kRadius);
  PressState state = rest_state(body, surface, X);
  PressGoal goal;
  goal.X_PO = X;
  goal.X_PO.p[2] -= kDepth;
  ASSERT_EQ(press_step(body, surface, ball, goal, {}, factors, state).status, Status::kSolved);
  EXPECT_NEAR(contact_area(mesh, body, {tissue}, on_top, surface, ball, state) /
                  (EIGEN_PI * kRadius * kDepth),
              1 + 2.0 / 3 * 1.133 * std::sqrt(kRadius * kDepth) / (kSize / 2), 0.03);
}

// No jumps where a node comes to touch: each of many small steps adds about as much as the next.
TEST(ContactArea, GrowsWithoutJumps) {
  PressCourse course = wall();
  constexpr int kSteps = 120;
  for (int k = 1; k <= kSteps; ++k) course.loads.push_back({{}, 0.3e-3 + k * 1e-5, 0});
  PadModel pad = layered_pad(1);
  const PressCurves out = press_curves({pad}, course);
  ASSERT_EQ(out.status, Status::kSolved) << out.message;
  const double mean = (out.points[0].back().area - out.points[0].front().area) / (kSteps - 1);
  double most = 0;
  for (std::size_t k = 1; k < kSteps; ++k)
    most = std::max(most, std::abs(out.points[0][k].area - out.points[0][k - 1].area));
  EXPECT_LT(most, 6 * mean);
}

}  // namespace
}  // namespace thenar
