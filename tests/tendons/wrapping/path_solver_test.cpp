// Tests for tendons/wrapping/path_solver.cpp: lengths against closed forms.

#include "tendons/wrapping/path_solver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "tests/tendons/wrapping/wrap_samples.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using sample::shape_of;
using sample::string_over;
using sample::surface;

constexpr double kRounding = 1e-15;  // [m], on lengths of 0.1 m

const BoneSurface kCylinder = surface(SurfaceShape::kCylinder, {0.005, 0, 0});
const BoneSurface kSphere = surface(SurfaceShape::kSphere, {0.005, 0, 0});
const BoneSurface kCapsule = surface(SurfaceShape::kCapsule, {0.005, 0.01, 0});
const BoneSurface kTorus = surface(SurfaceShape::kTorus, {0.002, 0.005, 0});

// Both ends level with the top of the circle's centre at a distance of 2 r: tangents of r sqrt(3),
// each 60 deg from its end, so 60 deg are left for the arc.
const double kOverTop = 0.005 * (2 * std::sqrt(3.0) + kPi / 3);
const Vector3d kLeft(-0.01, 0, 0), kRight(0.01, 0, 0), kUp(0, 0.02, 0);

TEST(PathSolver, GoesOverACylinder) {
  EXPECT_NEAR(shape_of(string_over({kCylinder}, kLeft, kRight, kUp)).length, kOverTop, kRounding);
}

TEST(PathSolver, TakesTheGivenSideOfACylinder) {
  const Vector3d left(-0.01, -0.001, 0), right(0.01, -0.001, 0);
  const PathShape over = shape_of(string_over({kCylinder}, left, right, kUp));
  const PathShape under = shape_of(string_over({kCylinder}, left, right, -kUp));
  EXPECT_GT(over.spans[0].b.y(), 0);
  EXPECT_LT(under.spans[0].b.y(), 0);
  // 1 mm lower is atan(0.1) on either end.
  const double rho = std::hypot(0.01, 0.001), free = std::sqrt(rho * rho - 0.005 * 0.005);
  const double arc = kPi + 2 * std::atan(0.1) - 2 * std::acos(0.005 / rho);
  EXPECT_NEAR(over.length, 2 * free + 0.005 * arc, kRounding);
}

// Unrolled, the helix is the hypotenuse of the way round and the way along.
TEST(PathSolver, ClimbsACylinderAsAHelix) {
  const PathShape shape =
      shape_of(string_over({kCylinder}, kLeft, kRight + Vector3d(0, 0, 0.012), kUp));
  EXPECT_NEAR(shape.length, std::hypot(kOverTop, 0.012), kRounding);
}

TEST(PathSolver, RunsStraightPastACylinderThatIsNotInTheWay) {
  const PathShape shape = shape_of(
      string_over({kCylinder}, kLeft + Vector3d(0, 0.006, 0), kRight + Vector3d(0, 0.006, 0), kUp));
  EXPECT_EQ(shape.arcs.size(), 0U);
  EXPECT_EQ(shape.length, 0.02);
}

TEST(PathSolver, GoesOverASphereTheShorterWay) {
  const PathShape shape = shape_of(
      string_over({kSphere}, kLeft - Vector3d(0, 1e-3, 0), kRight - Vector3d(0, 1e-3, 0), kUp));
  EXPECT_LT(shape.spans[0].b.y(), 0);
}

TEST(PathSolver, TakesTheGivenSideBetweenAntipodalPoints) {
  const PathShape shape = shape_of(string_over({kSphere}, kLeft, kRight, kUp));
  EXPECT_NEAR(shape.length, kOverTop, kRounding);
  EXPECT_GT(shape.spans[0].b.y(), 0.004);
}

TEST(PathSolver, GoesOverTheMiddleOfACapsuleAsOverACylinder) {
  const PathShape shape =
      shape_of(string_over({kCapsule}, kLeft, kRight + Vector3d(0, 0, 0.006), kUp));
  EXPECT_EQ(shape.status, PathStatus::kTaut);
  EXPECT_NEAR(shape.length, std::hypot(kOverTop, 0.006), kRounding);
}

TEST(PathSolver, GoesOverTheCapOfACapsuleAsOverASphere) {
  const Vector3d cap(0, 0, 0.01), up(0, 0.003, 0.02);
  const Vector3d a = cap + Vector3d(-0.01, 0, 0.001), b = cap + Vector3d(0.01, 0, 0.001);
  BoneSurface sphere = kSphere;
  sphere.X.p = cap;
  const PathShape shape = shape_of(string_over({kCapsule}, a, b, cap + up));
  EXPECT_EQ(shape.status, PathStatus::kTaut);
  EXPECT_NEAR(shape.length, shape_of(string_over({sphere}, a, b, cap + up)).length, kRounding);
}

TEST(PathSolver, GoesOverARoundEllipsoidAsOverASphere) {
  const Vector3d a(-0.01, 0.001, 0.002), b(0.011, 0.0005, -0.001);
  const BoneSurface ball = surface(SurfaceShape::kEllipsoid, {0.005, 0.005, 0.005});
  const PathShape shape = shape_of(string_over({ball}, a, b, kUp));
  EXPECT_EQ(shape.status, PathStatus::kTaut);
  EXPECT_NEAR(shape.length, shape_of(string_over({kSphere}, a, b, kUp)).length, kRounding);
}

// In a plane of symmetry the geodesic is the ellipse  (6 cos u, 4 sin u) mm. From (10, 0) mm its
// tangent touches at cos u = 6 / 10; the arc between is integrated by the midpoint rule, which for
// this smooth integrand over u0 .. pi - u0 is good to h^2.
TEST(PathSolver, FollowsAnEllipseInAPlaneOfSymmetry) {
  const BoneSurface egg = surface(SurfaceShape::kEllipsoid, {0.006, 0.004, 0.009});
  const PathShape shape = shape_of(string_over({egg}, kLeft, kRight, kUp));
  const double u0 = std::acos(0.6);
  const Vector3d touch(0.006 * std::cos(u0), 0.004 * std::sin(u0), 0);
  constexpr int kSteps = 400000;
  const double h = (kPi - 2 * u0) / kSteps;
  double arc = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double u = u0 + (i + 0.5) * h;
    arc += h * std::hypot(0.006 * std::sin(u), 0.004 * std::cos(u));
  }
  EXPECT_EQ(shape.status, PathStatus::kTaut);
  EXPECT_NEAR(shape.length, 2 * (kRight - touch).norm() + arc, 1e-13);
}

// In a half plane of the axis the tube is a circle of 2 mm about (5, 0) mm.
TEST(PathSolver, PassesThroughASleeveOverItsInnerWall) {
  const Vector3d a(0.0045, 0, 0.01), b(0.0045, 0, -0.01);
  const PathShape shape = shape_of(string_over({kTorus}, a, b, Vector3d::Zero()));
  BoneSurface tube = surface(SurfaceShape::kCylinder, {0.002, 0, 0});
  tube.X.p = {0.005, 0, 0};
  tube.X.R << 1, 0, 0, 0, 0, 1, 0, -1, 0;  // its axis along y
  const PathShape flat = shape_of(string_over({tube}, a, b, Vector3d::Zero()));
  EXPECT_EQ(shape.status, PathStatus::kTaut);
  EXPECT_NEAR(shape.length, flat.length, kRounding);
}

TEST(PathSolver, RunsStraightThroughTheHoleOfASleeve) {
  const PathShape shape =
      shape_of(string_over({kTorus}, {0, 0, 0.01}, {0.001, 0, -0.01}, Vector3d::Zero()));
  EXPECT_EQ(shape.arcs.size(), 0U);
}

// A belt over two equal wheels: between them it runs level, outside it is half of kOverTop.
TEST(PathSolver, GoesOverTwoWheelsInARow) {
  BoneSurface first = kCylinder, second = kCylinder;
  first.X.p.x() = -0.02;
  second.X.p.x() = 0.02;
  const PathShape shape =
      shape_of(string_over({first, second}, {-0.03, 0, 0}, {0.03, 0, 0}, {0, 0.02, 0}));
  EXPECT_EQ(shape.status, PathStatus::kTaut);
  EXPECT_NEAR(shape.length, kOverTop + 0.04, kRounding);
}

// Of three wheels the middle one is too low to be touched.
TEST(PathSolver, LeavesOutAWheelThatIsTooLow) {
  BoneSurface first = kCylinder, low = kCylinder, second = kCylinder;
  first.X.p.x() = -0.02;
  low.X.p.y() = -0.001;
  second.X.p.x() = 0.02;
  const PathShape shape =
      shape_of(string_over({first, low, second}, {-0.03, 0, 0}, {0.03, 0, 0}, {0, 0.02, 0}));
  EXPECT_EQ(shape.arcs.size(), 2U);
  EXPECT_NEAR(shape.length, kOverTop + 0.04, kRounding);
}

// Every convex kind on an arch, off any plane: the string is tangent to all of them.
TEST(PathSolver, IsTangentToAllSurfacesOfARow) {
  std::vector<BoneSurface> row{kCylinder, kSphere, kCapsule,
                               surface(SurfaceShape::kEllipsoid, {0.006, 0.005, 0.008})};
  for (std::size_t i = 0; i < row.size(); ++i) {
    row[i].X.p = {0.02 * static_cast<double>(i), i % 3 == 0 ? 0 : 0.006,
                  0.001 * static_cast<double>(i)};
    row[i].X.R =
        rotation_about(Vector3d(Vector3d(1, 0.5, 0.2).normalized()), 0.1 * static_cast<double>(i));
  }
  const PathShape shape =
      shape_of(string_over(row, {-0.02, -0.001, 0.002}, {0.08, -0.008, 0.001}, {0.03, 0.1, 0}));
  EXPECT_EQ(shape.status, PathStatus::kTaut);
  EXPECT_EQ(shape.arcs.size(), 4U);
  EXPECT_LT(shape.error, 1e-13);
  for (const PathArc& arc : shape.arcs) {
    const BoneSurface& on = row[static_cast<std::size_t>(arc.surface)];
    const auto after = static_cast<std::size_t>(arc.after);
    const Vector3d arrives = (shape.spans[after].b - shape.spans[after].a).normalized();
    const Vector3d leaves = (shape.spans[after + 1].b - shape.spans[after + 1].a).normalized();
    const GeodesicEnd end = follow_geodesic(on, arc.arc.start, arc.arc.length);
    EXPECT_LT((arrives - on.X.R * arc.arc.start.t).norm(), 1e-12);
    EXPECT_LT((leaves - on.X.R * end.ray.t).norm(), 1e-12);
  }
}

TEST(PathSolver, SaysHowDeepAPointHasMovedIn) {
  const PathShape shape = shape_of(string_over({kCylinder}, {-0.004, 0, 0}, kRight, kUp));
  EXPECT_EQ(shape.status, PathStatus::kPointInside);
  EXPECT_NEAR(shape.depth, 0.001, kRounding);
  EXPECT_TRUE(std::isfinite(shape.length));
}

// Ends, centre and side in line leave the start without a plane to bend in.
class PathSolverInLine : public testing::TestWithParam<BoneSurface> {};
TEST_P(PathSolverInLine, NeverTakesAStringThroughBoneForTaut) {
  const PathShape shape = shape_of(string_over({GetParam()}, kLeft, kRight, {0.02, 0, 0}));
  EXPECT_TRUE(shape.status == PathStatus::kStalled || !shape.arcs.empty());
  EXPECT_TRUE(shape.status == PathStatus::kStalled || shape.length > 0.021);
}
INSTANTIATE_TEST_SUITE_P(AnyShape, PathSolverInLine,
                         testing::Values(kCapsule,
                                         surface(SurfaceShape::kEllipsoid, {0.007, 0.005, 0.006})),
                         [](const auto& test) { return "Shape" + std::to_string(test.index); });

// From the top, seen from the far end at twice the radius: 90 deg less the 60 deg of its tangent.
TEST(PathSolver, StartsTheArcAtAnEndThatLiesOnTheSurface) {
  const Vector3d top(0, 0.005, 0);
  std::vector<ChainArc> chain{{&kSphere, {}, {{top, Vector3d::UnitX()}, 0.001}}};
  EXPECT_LT(solve_tangency(top, kRight, chain).error, 1e-11);
  EXPECT_NEAR(chain[0].arc.length, 0.005 * kPi / 6, kRounding);
}

TEST(PathSolver, NeverTakesALengthThatIsNoNumberForTaut) {
  const Vector3d nowhere(std::nan(""), 0, 0);
  EXPECT_EQ(shape_of(string_over({}, kLeft, nowhere, kUp)).status, PathStatus::kStalled);
}

/// A carrier over a surface, and a rider from beside it to the middle of its last run.
PathShape rider_of(PathSet set) {
  WrappedPath rider;
  rider.name = "rider";
  rider.points = {{-1, {0.02, 0.02, 0}}, {-1, {0, 0, 0}}};
  rider.bends.resize(1);
  rider.carrier = 0;
  rider.ride = 0.001;
  set.paths.push_back(rider);
  return PathSolver(set).solve({})[1];
}

TEST(PathSolver, SaysThatTheCarrierOfAStringIsBuried) {
  const PathShape shape = rider_of(string_over({kCylinder}, {-0.004, 0, 0}, kRight, kUp));
  EXPECT_EQ(shape.status, PathStatus::kPointInside);
  EXPECT_NEAR(shape.depth, 0.001, kRounding);
}

TEST(PathSolver, SaysThatTheCarrierOfAStringIsStalled) {
  const Vector3d nowhere(std::nan(""), 0, 0);
  EXPECT_EQ(rider_of(string_over({}, kLeft, nowhere, kUp)).status, PathStatus::kStalled);
}

TEST(PathSolver, LeavesARiderOfATautCarrierTaut) {
  EXPECT_EQ(rider_of(string_over({}, kLeft, kRight, kUp)).status, PathStatus::kTaut);
}

// As an end rises, the string lifts off: neither its length nor its slope jumps. The second
// derivative of the length by the end's height is at most 1 / (free run) ~ 100 / m.
class PathSolverLiftsOff : public testing::TestWithParam<BoneSurface> {};
TEST_P(PathSolverLiftsOff, WithoutAJump) {
  const auto at = [&](double y) {
    return shape_of(
        string_over({GetParam()}, {-0.0101, y, 0.0003}, {0.0102, y + 0.0002, -0.0004}, kUp));
  };
  const auto slope = [](const PathShape& shape) {
    return (shape.spans[0].a - shape.spans[0].b).normalized().y() +
           (shape.spans.back().b - shape.spans.back().a).normalized().y();
  };
  double low = 0, high = 0.008;  // touching, clear
  for (int i = 0; i < 60; ++i)
    (at(0.5 * (low + high)).arcs.empty() ? high : low) = 0.5 * (low + high);
  EXPECT_NEAR(at(low).length, at(high).length, kRounding);
  EXPECT_NEAR(slope(at(low)), slope(at(high)), 1e-7);  // sqrt of the bisection's last step
  EXPECT_LT(std::abs(at(low).arcs.at(0).arc.length), 1e-6);
}
INSTANTIATE_TEST_SUITE_P(AnyShape, PathSolverLiftsOff,
                         testing::Values(kCylinder, kSphere, kCapsule,
                                         surface(SurfaceShape::kEllipsoid, {0.007, 0.005, 0.006})),
                         [](const auto& test) { return "Shape" + std::to_string(test.index); });

// Held on the side +x, a string whose end goes on over the half plane opposite jumps to the other
// way round, from 3.6 rad to 2.6 apart. It says so, on all of the far side, and not
// where the same place is reached over the side.
TEST(PathSolver, SaysWhereAPointWentRoundTheFarSide) {
  const Tree<double> tree{{-1, 0, 1, 0, Vector3d::UnitZ(), {0, 0, 0}}};
  PathSet set = sample::string_over({{"pulley", -1, SurfaceShape::kCylinder, {0.008, 1, 0}, {}}},
                                    {0.02 * std::cos(1.0), 0.02 * std::sin(1.0), 0},
                                    {0.02 * std::cos(-0.5), 0.02 * std::sin(-0.5), 0}, {1, 0, 0});
  set.paths[0].points[0].link = 0;
  PathSolver solver(set);
  const auto at = [&](double angle) -> const PathShape& {
    return solver.solve(pose_tree(tree, Eigen::VectorXd::Constant(1, angle - 1)))[0];
  };
  const double before = at(3.1).length;
  EXPECT_EQ(at(3.1).status, PathStatus::kTaut);
  EXPECT_LT(at(3.2).length, before - 0.005);
  EXPECT_EQ(at(3.2).status, PathStatus::kFarSideWrap);
  EXPECT_EQ(at(3.9).status, PathStatus::kFarSideWrap);
  EXPECT_EQ(at(-1.0).status, PathStatus::kTaut);
  EXPECT_EQ(at(-2.0).status, PathStatus::kTaut);
}

// A solver points at its set, so it takes none that is about to vanish.
static_assert(!std::is_constructible_v<PathSolver, PathSet>);
static_assert(std::is_constructible_v<PathSolver, const PathSet&>);

}  // namespace
}  // namespace thenar
