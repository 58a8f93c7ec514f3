// Tests for pads/skin_springs.cpp: presses by objects with edges and corners.

#include "pads/skin_springs.h"

#include <cmath>
#include <optional>
#include <ostream>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "geometry/primitives.h"
#include "pads/pad_press.h"
#include "tests/pads/tissue_samples.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// A block whose edge along y points down.
const Matrix3d kOnEdge =
    Eigen::AngleAxisd(std::acos(-1.0) / 4, Vector3d::UnitY()).toRotationMatrix();

/// A pad under an object that touches it.
class EdgePress {
 public:
  EdgePress(std::shared_ptr<const Shape> object, const Matrix3d& R, double friction, double error,
            int max_elements) {
    PadModel model;
    model.tissues = {neo_hookean(12e3, 0.49)};
    PadPressOptions options;
    options.force_error = error;
    options.max_elements = max_elements;
    options.max_penetration = 5e-5;
    Pose<double> X;
    X.R = R;
    X.p = {0, 0, 0.1};
    press_.emplace(model, RigidObject{std::move(object), friction}, X, options);
    (void)press_->touch({0, 0, -1});
    touch_ = press_->state().X_PO;
  }

  PadPressResult go_to(const Vector3d& way) {
    PressGoal goal;
    goal.X_PO = touch_;
    goal.X_PO.p += way;
    return press_->step(goal);
  }
  PadPress& press() { return *press_; }
  [[nodiscard]] Vector3d push() const { return press_->state().push.force; }

 private:
  std::optional<PadPress> press_;
  Pose<double> touch_;
};

std::shared_ptr<const Shape> cube() { return build_box({6e-3, 6e-3, 6e-3}); }
std::shared_ptr<const Shape> block() { return build_box({0.05, 0.2, 0.05}); }

class CubePress : public testing::TestWithParam<double> {};

// As long as the patch is within its face, a cube presses as a plane; beyond, with less.
TEST_P(CubePress, IsThatOfAPlaneUntilThePatchReachesTheEdges) {
  EdgePress small(cube(), Matrix3d::Identity(), GetParam(), 0.05, 20000);
  EdgePress large(build_box({0.2, 0.2, 0.1}), Matrix3d::Identity(), GetParam(), 0.05, 20000);
  for (const double depth : {0.25e-3, 0.5e-3, 0.75e-3, 1e-3}) {
    const PadPressResult by_cube = small.go_to({0, 0, -depth});
    const PadPressResult by_plane = large.go_to({0, 0, -depth});
    ASSERT_EQ(by_cube.solved.status, Status::kSolved) << depth << ' ' << by_cube.solved.message;
    ASSERT_EQ(by_plane.solved.status, Status::kSolved);
    const double ratio = small.push()[2] / large.push()[2];
    if (depth < 0.6e-3)
      EXPECT_NEAR(ratio, 1, 0.02);
    else
      EXPECT_LT(ratio, 0.99);
    EXPECT_LT(by_cube.area, 36e-6);
    EXPECT_LE(by_cube.force_error, 0.05);
  }
}

INSTANTIATE_TEST_SUITE_P(Friction, CubePress, testing::Values(0.0, 0.6));

// All of the small face touches, and nothing beside it does: within 3 %.
TEST(CubeArea, IsThatOfTheFaceOnceAllOfItTouches) {
  EdgePress press(build_box({4e-3, 4e-3, 4e-3}), Matrix3d::Identity(), 0, 0.05, 20000);
  for (const double depth : {0.3e-3, 0.6e-3, 0.9167e-3, 1e-3}) {
    const PadPressResult result = press.go_to({0, 0, -depth});
    ASSERT_EQ(result.solved.status, Status::kSolved) << depth;
    EXPECT_LE(result.area, 1.03 * 16e-6) << depth;
    if (depth > 0.8e-3) {
      EXPECT_GE(result.area, 0.97 * 16e-6) << depth;
    }
  }
}

// The pad is its own mirror image; one node on an edge would have to take either face's normal.
TEST(SharpEdge, PushesToNoSideOfWhatIsSymmetric) {
  for (const double friction : {0.0, 0.6}) {
    EdgePress press(block(), kOnEdge, friction, 0.05, 700);
    for (const double depth : {0.25e-3, 0.5e-3, 0.75e-3, 1e-3}) {
      const PadPressResult result = press.go_to({0, 0, -depth});
      ASSERT_EQ(result.solved.status, Status::kSolved) << depth << ' ' << result.solved.message;
      EXPECT_NEAR(press.push()[0] / press.push()[2], 0, friction > 0 ? 0.01 : 1e-4) << depth;
    }
    EXPECT_LT(press.push()[2], -0.05);
  }
}

/// An object that is pressed in, moved aside, and lifted.
struct Loop {
  const char* name;
  std::shared_ptr<const Shape> object;
  Matrix3d R;
  double depth, aside;  // [m]
};
std::ostream& operator<<(std::ostream& out, const Loop& loop) { return out << loop.name; }

class EdgeLoop : public testing::TestWithParam<Loop> {};

TEST_P(EdgeLoop, GivesBackItsWorkWithoutFriction) {
  const Loop& loop = GetParam();
  EdgePress press(loop.object, loop.R, 0, 100, 1);
  std::vector<Vector3d> way;
  constexpr int kSteps = 30;
  const int off = static_cast<int>(kSteps * 1e-3 / loop.depth);
  for (int k = -off; k <= kSteps; ++k) way.emplace_back(0, 0, -loop.depth * k / kSteps);
  for (int k = 1; k <= kSteps; ++k) way.emplace_back(loop.aside * k / kSteps, 0, -loop.depth);
  for (int k = kSteps - 1; k >= -off; --k)
    way.emplace_back(loop.aside, 0, -loop.depth * k / kSteps);
  double work = 0, most = 0;
  Vector3d place = way.front(), before(0, 0, 0);
  for (const Vector3d& to : way) {
    const PadPressResult result = press.go_to(to);
    ASSERT_EQ(result.solved.status, Status::kSolved) << to.transpose() << result.solved.message;
    work += 0.5 * (before + press.push()).dot(to - place);
    most = std::max(most, work);
    before = press.push();
    place = to;
  }
  EXPECT_GT(most, 1e-5);
  EXPECT_LT(std::abs(work), 0.005 * most);
}

const Matrix3d kTilted = (Eigen::AngleAxisd(0.3, Vector3d(1, 0.3, 0).normalized()) *
                          Eigen::AngleAxisd(0.6, Vector3d::UnitZ()))
                             .toRotationMatrix();
const Matrix3d kOnCorner =
    Eigen::Quaterniond::FromTwoVectors(Vector3d(-1, -1, -1), Vector3d(0, 0, -1)).toRotationMatrix();

INSTANTIATE_TEST_SUITE_P(
    Objects, EdgeLoop,
    testing::Values(
        Loop{"in and out", block(), kOnEdge, 1e-3, 0},
        Loop{"cube", cube(), Matrix3d::Identity(), 1e-3, 2e-3},
        Loop{"tilted cube", cube(), kTilted, 1e-3, 1e-3},
        Loop{"edge", block(), kOnEdge, 1e-3, 2e-3},
        Loop{"edge along", block(),
             Eigen::AngleAxisd(std::acos(0.0), Vector3d::UnitZ()).toRotationMatrix() * kOnEdge,
             1e-3, 1e-3},
        Loop{"corner", cube(), kOnCorner, 1e-3, 1e-3},
        Loop{"thin blade", build_box({0.5e-3, 0.2, 0.05}), Matrix3d::Identity(), 0.5e-3, 1e-3},
        Loop{"coin", build_cylinder(6e-3, 2e-3), Matrix3d::Identity(), 1e-3, 1e-3}));

// Drawn forth and back, as half of the angle between its pushes at one place, for skin is not
// level; about so, for it bends around the edge as a rope does. Edges that catch have thrice that.
TEST(SharpEdge, RubsByItsFrictionAsItIsDrawn) {
  for (const double friction : {0.3, 0.6}) {
    EdgePress press(block(), kOnEdge, friction, 100, 1);
    for (int k = 1; k <= 10; ++k) (void)press.go_to({0, 0, -1e-4 * k});
    const auto angle_at = [&](int k) {
      EXPECT_EQ(press.go_to({1e-4 * k, 0, -1e-3}).solved.status, Status::kSolved) << k;
      return std::atan2(press.push()[0], -press.push()[2]);
    };
    constexpr int kPlaces = 21;
    std::vector<double> forth;
    for (int k = 0; k < kPlaces; ++k) forth.push_back(angle_at(k));
    for (int k = kPlaces; k < kPlaces + 10; ++k) (void)angle_at(k);
    for (int k = kPlaces + 10; k >= kPlaces; --k) (void)angle_at(k);
    for (int k = kPlaces - 1; k > 10; --k) {
      const double half = std::abs(forth[static_cast<std::size_t>(k)] - angle_at(k)) / 2;
      EXPECT_NEAR(half / std::atan(friction), 1, 0.25) << k;
    }
  }
}

TEST(SharpEdge, IsFoundWhereThereIsOne) {
  EdgePress press(cube(), Matrix3d::Identity(), 0, 100, 1);
  const ContactSurface& surface = press.press().surface();
  const PressState& state = press.press().state();
  EXPECT_TRUE(has_edge_nearby(surface, *cube(), state.X_PO, state.x));
  Pose<double> X;
  X.p = {0, 0, state.X_PO.p[2] - 3e-3 + 0.1};
  EXPECT_FALSE(has_edge_nearby(surface, *build_box({0.2, 0.2, 0.2}), X, state.x));
  X.p[2] = state.X_PO.p[2] - 3e-3 + 8e-3;
  EXPECT_FALSE(has_edge_nearby(surface, *build_sphere(8e-3), X, state.x));
}

// Against differences of forces, without friction and where it holds all nodes.
TEST(SkinSprings, HaveTheSlopesOfTheirForces) {
  // Beside nodes, over which slopes of forces jump.
  EdgePress press(block(), kOnEdge, 0, 100, 1);
  ASSERT_EQ(press.go_to({1.3e-4, 0, -1e-3}).solved.status, Status::kSolved);
  const PadPress& at = press.press();
  const PressState& state = at.state();
  const std::vector<double> stiffness(at.surface().nodes.size(), 500);
  VectorXd way = VectorXd::Zero(state.x.size());
  Matrix3Xd moved(3, static_cast<Eigen::Index>(at.surface().nodes.size()));
  for (Eigen::Index k = 0; k < moved.cols(); ++k) {
    const auto i = static_cast<double>(k);
    moved.col(k) = Vector3d(std::sin(i), std::cos(2 * i), std::sin(3 * i + 1));
    way.segment<3>(3 * at.surface().nodes[static_cast<std::size_t>(k)]) = moved.col(k);
  }
  for (const double friction : {0.0, 10.0}) {
    const auto force = [&](double step, SkinSprings& springs) {
      springs.update(*block(), state.X_PO, state.x + step * way, stiffness, friction,
                     {state.anchor, state.friction_force});
      return Matrix3Xd(springs.normal_forces() + springs.friction_forces());
    };
    SkinSprings springs(at.body(), at.surface()), beside(at.body(), at.surface());
    constexpr double kStep = 1e-10;
    const Matrix3Xd change = (force(kStep, beside) - force(-kStep, beside)) / (2 * kStep);
    ASSERT_GT(force(0, springs).norm(), 0);
    EXPECT_LT((change + springs.force_loss(moved)).norm(), 1e-4 * change.norm()) << friction;
  }
}

TEST(SpringStiffness, IsTheSlopeOfThePush) {
  EdgePress press(cube(), Matrix3d::Identity(), 0, 100, 1);
  ASSERT_EQ(press.go_to({0, 0, -1e-3}).solved.status, Status::kSolved);
  const double slope = press.press().stiffness()(5, 5);
  constexpr double kStep = 2e-8;
  ASSERT_EQ(press.go_to({0, 0, -1e-3 - kStep}).solved.status, Status::kSolved);
  const double deeper = press.push()[2];
  ASSERT_EQ(press.go_to({0, 0, -1e-3 + kStep}).solved.status, Status::kSolved);
  EXPECT_NEAR(slope * 2 * kStep / (press.push()[2] - deeper), 1, 0.01);
}

}  // namespace
}  // namespace thenar
