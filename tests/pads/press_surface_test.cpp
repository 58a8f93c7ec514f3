// Tests for pads/press_surface.cpp.

#include "pads/press_surface.h"

#include <numeric>

#include <gtest/gtest.h>

#include "geometry/primitives.h"
#include "pads/pad_press.h"

namespace thenar {
namespace {

constexpr double kSkinFriction = 0.3;

/// A pad on a wall, 1 mm deep, on a mesh that was refined.
class PressedSkinTest : public testing::Test {
 protected:
  PressedSkinTest() {
    model_.tissues.resize(1);
    model_.tissues[0].shear_modulus = 12e3;
    PadPressOptions options;
    options.force_error = 0.2;
    Pose<double> X;
    X.p = {0, 0, model_.shape.height + 0.05};
    press_ = std::make_unique<PadPress>(
        model_, RigidObject{build_box({0.1, 0.1, 0.1}), kSkinFriction}, X, options);
    PressGoal goal;
    goal.X_PO = X;
    goal.X_PO.p[2] -= 1e-3;
    result_ = press_->step(goal);
    EXPECT_EQ(result_.solved.status, Status::kSolved) << result_.solved.message;
    skin_ = pressed_skin(*press_, kSkinFriction);
  }
  [[nodiscard]] Eigen::Vector3d normal_of(const std::array<int, 4>& face) const {
    const auto at = [&](std::size_t i) { return Eigen::Vector3d(skin_.at_rest.col(face[i])); };
    return 0.5 * (at(2) - at(0)).cross(at(3) - at(1));
  }

  PadModel model_;
  std::unique_ptr<PadPress> press_;
  PadPressResult result_;
  PressedSkin skin_;
};

TEST_F(PressedSkinTest, NodesTogetherPressAsTheWhole) {
  // A wall is normal to z: all normal forces are along it.
  EXPECT_NEAR(skin_.normal.sum(), -result_.push.force[2], 1e-9 * skin_.normal.sum());
  const double sticking = [&] {
    double sum = 0;
    for (Eigen::Index k = 0; k < skin_.normal.size(); ++k)
      if (skin_.contact[static_cast<std::size_t>(k)] == SkinContact::kSticks)
        sum += skin_.normal[k];
    return sum;
  }();
  EXPECT_NEAR(sticking / skin_.normal.sum(), result_.stick, 1e-12);
}

TEST_F(PressedSkinTest, PressureTimesAreaIsTheForce) {
  // The integral of the pressure, bilinear within faces, over the deformed skin: a quarter of each
  // face for each corner, exact for plane faces.
  double sum = 0;
  for (const std::array<int, 4>& face : skin_.faces) {
    const auto at = [&](std::size_t i) { return Eigen::Vector3d(skin_.places.col(face[i])); };
    const double area = 0.5 * (at(2) - at(0)).cross(at(3) - at(1)).norm();
    for (const int node : face) sum += 0.25 * area * skin_.pressure[node];
  }
  EXPECT_NEAR(sum / skin_.normal.sum(), 1, 1e-9);
}

TEST_F(PressedSkinTest, NodesThatTouchAreOnTheWall) {
  // But for what the curved skin has more than its faces: in the mean it is on the wall.
  const double wall = press_->state().X_PO.p[2] - 0.05;
  double sagitta = 0;
  for (const SurfacePoint& point : press_->surface().points)
    sagitta = std::max(sagitta, point.offset.norm());
  int touching = 0;
  for (Eigen::Index k = 0; k < skin_.places.cols(); ++k) {
    EXPECT_LE(skin_.places(2, k), wall + 1e-9);
    if (skin_.contact[static_cast<std::size_t>(k)] == SkinContact::kFree) continue;
    ++touching;
    EXPECT_GE(skin_.places(2, k), wall - sagitta);
  }
  EXPECT_GT(touching, 4);
}

TEST_F(PressedSkinTest, FacesLookOutwardAndCoverTheSkin) {
  double area = 0;
  Eigen::Vector3d sum(0, 0, 0);
  for (const std::array<int, 4>& face : skin_.faces) {
    const Eigen::Vector3d n = normal_of(face);
    EXPECT_GT(n.dot(skin_.at_rest.col(face[0]) + skin_.at_rest.col(face[2])), 0);
    area += n.norm();
    sum += n;
  }
  // Below the half ellipsoid's area, and above that of its base: an ellipse of 24 by 16 mm, to
  // which the normals sum, for the mesh's polygon a little less.
  const double base = M_PI * 12e-3 * 8e-3;
  EXPECT_NEAR(sum[2] / base, 1, 0.03);
  EXPECT_LT(sum[2], base);
  EXPECT_GT(area, 1.5 * base);
}

TEST(PressedSkin, AtRestIsFree) {
  PadModel model;
  model.tissues.resize(1);
  model.tissues[0].shear_modulus = 12e3;
  Pose<double> X;
  X.p = {0, 0, model.shape.height + 0.06};
  const PadPress press(model, {build_box({0.1, 0.1, 0.1}), 0}, X, {});
  const PressedSkin skin = pressed_skin(press, 0);
  EXPECT_TRUE(skin.pressure.isZero(0));
  EXPECT_TRUE(skin.places == skin.at_rest);
  for (const SkinContact contact : skin.contact) EXPECT_EQ(contact, SkinContact::kFree);
}

}  // namespace
}  // namespace thenar
