// Tests for geometry/shape_mass.cpp and convex_body.cpp, against closed forms.

#include "geometry/shape_mass.h"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "base/units.h"
#include "geometry/convex_body.h"
#include "geometry/mesh_parts.h"
#include "geometry/repair_to_solid.h"
#include "geometry/tessellate.h"
#include "tests/geometry/random_points.h"
#include "tests/geometry/sample_meshes.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

ShapeSpec spec(ShapeKind kind, const Vector3d& size, const Vector3d& at) {
  ShapeSpec made;
  made.kind = kind;
  made.size = size;
  made.X_BS.p = at;
  return made;
}

ShapeSpec mesh_of(const TriangleMesh& mesh) {
  ShapeSpec made;
  made.kind = ShapeKind::kMesh;
  made.mesh = mesh;
  return made;
}

TriangleMesh box_between(const Vector3d& low, const Vector3d& high) {
  TriangleMesh box = box_mesh(high - low);
  box.vertices.colwise() += (low + high) / 2;
  return box;
}

void expect_mass(const MassProperties& found, const MassProperties& wanted, double relative) {
  EXPECT_NEAR(found.mass, wanted.mass, relative * wanted.mass);
  EXPECT_TRUE(matrix_near(found.centre, wanted.centre, relative * 0.1));
  EXPECT_TRUE(matrix_near(found.inertia, wanted.inertia, relative * wanted.inertia.trace()));
}

ShapeSpec superellipsoid(const Vector3d& size, double e1, double e2) {
  ShapeSpec made = spec(ShapeKind::kSuperellipsoid, size, {0, 0, 0});
  made.exponents = {e1, e2};
  return made;
}

// Exponents of 1: an ellipsoid. Of 2: an octahedron, 4/3 abc, with 2/15 a^3 bc as the integral of
// x^2. Of 2 and 1: two cones base to base, 2 pi/3 abc, with pi/10 a^3 bc and of z^2 pi/15 ab c^3.
TEST(UnionMass, OfSuperellipsoidsIsThatOfTheSolidsAmongThem) {
  const Vector3d s(0.02, 0.03, 0.05), q = s.cwiseAbs2();
  const double abc = s.prod();
  const UnionMass round = union_mass({superellipsoid(s, 1, 1)});
  EXPECT_EQ(round.error, 0);
  expect_mass(round.mass, mass_at_unit_density(spec(ShapeKind::kEllipsoid, s, {0, 0, 0})), 1e-12);
  const Vector3d octahedron = 2 * abc / 15 * Vector3d(q.y() + q.z(), q.x() + q.z(), q.x() + q.y());
  expect_mass(union_mass({superellipsoid(s, 2, 2)}).mass,
              {4 * abc / 3, {0, 0, 0}, Matrix3d(octahedron.asDiagonal())}, 1e-12);
  const double x = q.x() / 10, y = q.y() / 10, z = q.z() / 15;
  const Vector3d cones = kPi * abc * Vector3d(y + z, x + z, x + y);
  expect_mass(union_mass({superellipsoid(s, 2, 1)}).mass,
              {2 * kPi * abc / 3, {0, 0, 0}, Matrix3d(cones.asDiagonal())}, 1e-12);
}

// Radii of 40 and 10 mm whose centres are 50 mm apart: sin = 3/5 of the side's slope, so that it
// touches the balls at z = -1 and 31 mm, with radii of 32 and 8 mm. Between z = -65, -1, 31 and 35
// the square of the radius is 1600 - (z + 25)^2, (125 - 3 z)^2 / 16 and 100 - (z - 25)^2 [mm^2].
// Integrals of it, and of it times z and z^2, and of its square, over pi:
//   272800/3 mm^3,  -2036000 mm^4,  247707680/3 mm^5,  335536640/3 mm^5.
TEST(UnionMass, OfATaperedCapsuleIsThatOfTwoCapsAndAFrustum) {
  const double volume = 272800e-9 / 3 * kPi, z = -7635e-3 / 341;
  const double axial = 335536640e-15 / 3 * kPi / 2;
  const double across = axial / 2 + 247707680e-15 / 3 * kPi - volume * z * z;
  const MassProperties wanted{
      volume, {0, 0, z}, Matrix3d(Vector3d(across, across, axial).asDiagonal())};
  ShapeSpec tapered = spec(ShapeKind::kTaperedCapsule, {0.04, 0.01, 0.05}, {0, 0, 0});
  const UnionMass found = union_mass({tapered});
  EXPECT_EQ(found.error, 0);
  expect_mass(found.mass, wanted, 1e-13);
  // Upside down, and moved.
  tapered.size = {0.01, 0.04, 0.05};
  tapered.X_BS = {Vector3d(1, -1, -1).asDiagonal(), {0.1, 0.2, 0.3}};
  expect_mass(union_mass({tapered}).mass, {volume, Vector3d(0.1, 0.2, 0.3 + z), wanted.inertia},
              1e-12);
}

// Equal radii: a capsule. A ball that holds the other, just or by far: a ball.
TEST(UnionMass, OfATaperedCapsuleIsThatOfACapsuleOrABall) {
  expect_mass(union_mass({spec(ShapeKind::kTaperedCapsule, {0.012, 0.012, 0.04}, {0, 0, 0})}).mass,
              mass_at_unit_density(spec(ShapeKind::kCapsule, {0.012, 0.04, 0}, {0, 0, 0})), 1e-13);
  for (const double length : {0.03, 0.01}) {
    const MassProperties below =
        mass_at_unit_density(spec(ShapeKind::kSphere, {0.04, 0, 0}, {0, 0, -length / 2}));
    expect_mass(
        union_mass({spec(ShapeKind::kTaperedCapsule, {0.04, 0.01, length}, {0, 0, 0})}).mass, below,
        1e-13);
  }
}

// Boxes of a third of a cube's edge, so many that each overlaps with dozens, against random points.
TEST(UnionMass, OfHundredsOfBoxesIsThatOfRandomPoints) {
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> along(0, 0.1), across(0, 0.15);
  std::vector<TriangleMesh> boxes;
  std::vector<Vector3d> lows;
  for (int i = 0; i < 400; ++i) {
    lows.emplace_back(along(rng), along(rng), along(rng));
    boxes.push_back(box_between(lows.back(), lows.back() + Vector3d(0.05, 0.05, 0.05)));
  }
  const UnionMass found = union_mass({mesh_of(joined(boxes))});
  EXPECT_EQ(found.error, 0);
  const int count = 100000;
  int hits = 0;
  for (int i = 0; i < count; ++i) {
    const Vector3d p(across(rng), across(rng), across(rng));
    hits += std::any_of(lows.begin(), lows.end(), [&](const Vector3d& low) {
      return (p.array() >= low.array()).all() && (p.array() <= low.array() + 0.05).all();
    });
  }
  const double share = static_cast<double>(hits) / count;
  EXPECT_NEAR(found.mass.mass / std::pow(0.15, 3), share,
              4 * std::sqrt(share * (1 - share) / count));
}

// Boxes of 40 x 20 x 20 mm and 20 x 20 x 60 mm that share 20 x 20 x 20 mm: an L of 32 cm^3.
// By hand: a box from 0 to 40 along x, and one of 20 x 20 x 40 on top of its last half.
TEST(UnionMass, OfTwoOverlappingBoxesIsThatOfTheL) {
  const MassProperties L = sum_of_masses(
      {mass_at_unit_density(spec(ShapeKind::kBox, {0.04, 0.02, 0.02}, {0.02, 0, 0})),
       mass_at_unit_density(spec(ShapeKind::kBox, {0.02, 0.02, 0.04}, {0.03, 0, 0.03}))});
  EXPECT_NEAR(L.mass, 3.2e-5, 1e-18);
  EXPECT_TRUE(matrix_near(L.centre, Vector3d(0.025, 0, 0.015), 1e-15));
  const Vector3d low(0, -0.01, -0.01), high(0.04, 0.01, 0.01);
  const TriangleMesh two =
      joined({box_between(low, high), box_between({0.02, -0.01, -0.01}, {0.04, 0.01, 0.05})});
  const UnionMass of_mesh = union_mass({mesh_of(two)});
  EXPECT_EQ(of_mesh.error, 0);
  expect_mass(of_mesh.mass, L, 1e-12);
  const UnionMass of_shapes =
      union_mass({spec(ShapeKind::kBox, {0.04, 0.02, 0.02}, {0.02, 0, 0}),
                  spec(ShapeKind::kBox, {0.02, 0.02, 0.06}, {0.03, 0, 0.02})});
  EXPECT_EQ(of_shapes.error, 0);
  expect_mass(of_shapes.mass, L, 1e-12);
}

// Balls of radius r whose centres are d apart share a lens of  pi (4 r + d) (2 r - d)^2 / 12.
TEST(UnionMass, OfTwoBallsLacksTheLens) {
  const double r = 0.03, d = 0.04;
  const double lens = kPi * (4 * r + d) * std::pow(2 * r - d, 2) / 12;
  const double exact = 2 * 4 * kPi / 3 * r * r * r - lens;
  const UnionMass found = union_mass({spec(ShapeKind::kSphere, {r, 0, 0}, {0, 0, 0}),
                                      spec(ShapeKind::kSphere, {r, 0, 0}, {d, 0, 0})});
  EXPECT_NEAR(found.mass.mass / exact, 1, 2e-5);
  EXPECT_LT(std::abs(found.mass.mass / exact - 1), 2 * found.error);
  EXPECT_LT(found.error, 1e-4);
  EXPECT_TRUE(matrix_near(found.mass.centre, Vector3d(d / 2, 0, 0), 1e-6));
}

TEST(UnionMass, OfTheSameShapesAgainIsThatOfOne) {
  std::mt19937 rng(1);
  Eigen::Matrix3Xd points(3, 30);
  for (int i = 0; i < 30; ++i) points.col(i) = 0.03 * random_in_cube(rng);
  const ShapeSpec hull = mesh_of(hull_mesh(points));
  const UnionMass found = union_mass({hull, hull, hull});
  EXPECT_EQ(found.error, 0);
  expect_mass(found.mass, mass_at_unit_density(hull), 1e-9);
}

/// Corners at the origin and at `edge` on the axes.
TriangleMesh corner_of(double edge) {
  TriangleMesh mesh{Eigen::Matrix3Xd(3, 4), Eigen::Matrix3Xi(3, 4)};
  mesh.vertices << 0, edge, 0, 0, 0, 0, edge, 0, 0, 0, 0, edge;
  mesh.triangles << 0, 0, 0, 1, 2, 1, 3, 2, 1, 3, 2, 3;
  return mesh;
}

// A mesh of n solids that coincide is one of them: e^3 / 6. Half of them lie within the others.
TEST(UnionMass, OfSolidsThatCoincideIsThatOfOne) {
  for (const int n : {2, 24, 200}) {
    std::vector<TriangleMesh> solids;
    for (int i = 0; i < n; ++i) solids.push_back(corner_of(i % 2 == 0 ? 0.03 : 0.02));
    const UnionMass found = union_mass({mesh_of(joined(solids))});
    EXPECT_EQ(found.error, 0) << n;
    EXPECT_NEAR(found.mass.mass / (0.03 * 0.03 * 0.03 / 6), 1, 1e-12) << n;
    expect_mass(found.mass, signed_moments(corner_of(0.03)), 1e-12);
  }
}

// Unit boxes each shifted by a hundredth of the one before: a bar.
TEST(UnionMass, OfABarOfOverlappingBoxesIsThatOfTheBar) {
  std::vector<ShapeSpec> boxes;
  for (int i = 0; i < 100; ++i)
    boxes.push_back(spec(ShapeKind::kBox, {0.1, 0.1, 0.1}, {0.05 + 0.001 * i, 0, 0}));
  const UnionMass found = union_mass(boxes);
  EXPECT_EQ(found.error, 0);
  expect_mass(found.mass,
              mass_at_unit_density(spec(ShapeKind::kBox, {0.199, 0.1, 0.1}, {0.0995, 0, 0})),
              1e-11);
}

// Boxes with corners at whole numbers fill whole cells, which are counted.
TEST(ConvexBody, UnionOfBoxesIsThatOfTheirCells) {
  std::mt19937 rng(5);
  std::uniform_int_distribution<int> corner(0, 9), edge(1, 5);
  constexpr int kCells = 15;
  std::vector<ConvexBody> boxes;
  std::vector<bool> filled(kCells * kCells * kCells, false);
  for (int i = 0; i < 60; ++i) {
    const Eigen::Vector3i low(corner(rng), corner(rng), corner(rng)),
        high = low + Eigen::Vector3i(edge(rng), edge(rng), edge(rng));
    boxes.push_back(convex_box({low.cast<double>(), high.cast<double>()}));
    for (int x = low.x(); x < high.x(); ++x)
      for (int y = low.y(); y < high.y(); ++y)
        for (int z = low.z(); z < high.z(); ++z) filled[(x * kCells + y) * kCells + z] = true;
  }
  Moments cells;
  for (int x = 0; x < kCells; ++x)
    for (int y = 0; y < kCells; ++y)
      for (int z = 0; z < kCells; ++z)
        if (filled[(x * kCells + y) * kCells + z])
          cells += moments_of(convex_box({Vector3d(x, y, z), Vector3d(x + 1, y + 1, z + 1)}));
  const UnionMoments found = union_moments(boxes, 1e-12, 1e7);
  ASSERT_TRUE(found.complete);
  EXPECT_NEAR(found.moments.volume / cells.volume, 1, 1e-12);
  EXPECT_TRUE(matrix_near(found.moments.first / cells.volume, cells.first / cells.volume, 1e-10));
  EXPECT_TRUE(matrix_near(found.moments.second / cells.volume, cells.second / cells.volume, 1e-9));
}

// Four faces against four sides for each pair, not a subset of all; and no more than is allowed.
TEST(ConvexBody, UnionsTakeWorkByPairsAndEndWhereItIsTooMuch) {
  std::vector<ConvexBody> same(60, convex_body(corner_of(1)));
  const UnionMoments found = union_moments(same, 1e-12, 1e7);
  EXPECT_TRUE(found.complete);
  EXPECT_LT(found.work, 60 * 60 * 4 * 4);
  std::mt19937 rng(6);
  std::vector<ConvexBody> boxes;
  for (int i = 0; i < 200; ++i) {
    ShapeSpec box = spec(ShapeKind::kBox, {1, 1, 1}, 0.2 * random_in_cube(rng));
    boxes.push_back(convex_box({box.X_BS.p - box.size / 2, box.X_BS.p + box.size / 2}));
    for (int k = 0; k < 20; ++k)  // 26 sides each
      clip(boxes.back(), {random_in_cube(rng).normalized(), 0.5 + random_in_cube(rng).x() / 10},
           1e-12);
  }
  const UnionMoments cut_short = union_moments(boxes, 1e-12, 1e5);
  EXPECT_FALSE(cut_short.complete);
  EXPECT_LT(cut_short.work, 1.2e5);
}

// Neither balls nor mugs are polyhedra that can be cut; of shapes that are there again, one counts.
TEST(UnionMass, OfRoundSolidsThatCoincideIsThatOfOne) {
  const ShapeSpec ball = spec(ShapeKind::kSphere, {0.03, 0, 0}, {0.01, 0, 0}), cup = mesh_of(mug());
  for (const ShapeSpec& one : {ball, cup})
    for (const std::size_t n : {2u, 20u, 200u}) {
      const UnionMass found = union_mass(std::vector<ShapeSpec>(n, one));
      EXPECT_EQ(found.error, 0);
      expect_mass(found.mass, mass_at_unit_density(one), 1e-14);
    }
}

// Balls about one middle, all but one a little smaller: cubes count them, as finely as the work for
// so many allows, and say how well.
TEST(UnionMass, OfBallsWithinABallIsThatOfTheBallWithinItsError) {
  const MassProperties wanted =
      mass_at_unit_density(spec(ShapeKind::kSphere, {0.03, 0, 0}, {0.01, 0, 0}));
  for (const int n : {2, 200}) {
    std::vector<ShapeSpec> balls;
    for (int i = 0; i < n; ++i)
      balls.push_back(spec(ShapeKind::kSphere, {0.03 * (1 - 1e-3 * i / n), 0, 0}, {0.01, 0, 0}));
    const UnionMass found = union_mass(balls);
    EXPECT_GT(found.error, 0) << n;
    EXPECT_LT(found.error, 0.02) << n;
    EXPECT_LT(std::abs(found.mass.mass / wanted.mass - 1), found.error) << n;
    const double trace = wanted.inertia.trace();
    EXPECT_TRUE(matrix_near(found.mass.inertia / trace, wanted.inertia / trace, 2 * found.error))
        << n;
  }
}

TEST(UnionMass, OfShapesApartIsTheirSum) {
  const std::vector<ShapeSpec> apart{spec(ShapeKind::kSphere, {0.01, 0, 0}, {0, 0, 0}),
                                     spec(ShapeKind::kCapsule, {0.01, 0.03, 0}, {0.05, 0, 0}),
                                     spec(ShapeKind::kBox, {0.01, 0.02, 0.03}, {0, 0.05, 0})};
  const UnionMass found = union_mass(apart);
  EXPECT_EQ(found.error, 0);
  expect_mass(found.mass,
              sum_of_masses({mass_at_unit_density(apart[0]), mass_at_unit_density(apart[1]),
                             mass_at_unit_density(apart[2])}),
              1e-13);
}

// A ball in the wall of a mug, which is not convex: by columns through the ball, outside the wall.
// The surface_of_revolution's corners stand at multiples of the sector, normals of its faces half a
// sector on.
TEST(UnionMass, OfPartsThatAreNotConvexIsThatOfColumns) {
  const ShapeSpec cup = mesh_of(mug(40)),
                  ball = spec(ShapeKind::kSphere, {0.02, 0, 0}, {0.04, 0, 0});
  const UnionMass found = union_mass({cup, ball});
  const double sector = 2 * kPi / 40, apothem = std::cos(sector / 2);
  const int n = 400;
  double outside = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double x = 0.02 + 0.04 * (i + 0.5) / n, y = 0.02 * (2 * (j + 0.5) / n - 1);
      const double up = 4e-4 - (x - 0.04) * (x - 0.04) - y * y;
      if (up <= 0) continue;
      const double from_corner = std::abs(std::remainder(std::atan2(y, x), sector));
      const double across = std::hypot(x, y) * std::cos(sector / 2 - from_corner);
      const bool in_wall = across <= 0.04 * apothem && across >= 0.036 * apothem;
      if (!in_wall) outside += 2 * std::sqrt(up) * 0.04 * 0.04 / n / n;
    }
  EXPECT_NEAR(found.mass.mass / (mass_at_unit_density(cup).mass + outside), 1, 3e-4);
  EXPECT_GT(found.error, 0);
  EXPECT_LT(found.error, 1e-3);
}

// Against Monte Carlo: 12 random boxes through each other.
TEST(UnionMass, OfManyBoxesIsThatOfRandomPoints) {
  std::mt19937 rng(3);
  std::vector<ShapeSpec> boxes;
  for (int i = 0; i < 12; ++i) {
    boxes.push_back(spec(ShapeKind::kBox, Vector3d(0.02, 0.02, 0.02) + 0.01 * random_in_cube(rng),
                         0.02 * random_in_cube(rng)));
    boxes.back().X_BS.R = random_rotation(rng);
  }
  const UnionMass found = union_mass(boxes);
  EXPECT_EQ(found.error, 0);
  const int count = 200000;
  int hits = 0;
  for (int i = 0; i < count; ++i) {
    const Vector3d p = 0.045 * random_in_cube(rng);
    bool in = false;
    for (const ShapeSpec& box : boxes) {
      const Vector3d q = box.X_BS.R.transpose() * (p - box.X_BS.p);
      in = in || (q.cwiseAbs().array() <= box.size.array() / 2).all();
    }
    hits += in ? 1 : 0;
  }
  const double share = static_cast<double>(hits) / count;
  const double sigma = std::sqrt(share * (1 - share) / count);
  EXPECT_NEAR(found.mass.mass / std::pow(0.09, 3), share, 4 * sigma);
}

TEST(ConvexBody, OfABoxCutAcrossACornerIsATetrahedronLess) {
  ConvexBody box = convex_box({Vector3d(0, 0, 0), Vector3d(1, 1, 1)});
  clip(box, {Vector3d(1, 1, 1).normalized(), 2.5 / std::sqrt(3)}, 1e-12);
  EXPECT_NEAR(moments_of(box).volume, 1 - 0.125 / 6, 1e-15);
  clip(box, {-Vector3d::UnitX(), -2}, 1e-12);
  EXPECT_TRUE(box.empty());
}

TEST(ConvexBody, IsEmptyForAMug) {
  EXPECT_TRUE(convex_body(mug()).empty());
  EXPECT_FALSE(convex_body(box_mesh({0.1, 0.2, 0.3})).empty());
}

}  // namespace
}  // namespace thenar
