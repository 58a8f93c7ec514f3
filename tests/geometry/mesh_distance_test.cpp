// Tests for geometry/mesh_distance.cpp, against brute force written anew: the nearest of all
// triangles, the sign from how often the surface winds around the point.

#include "geometry/mesh_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <malloc.h>

#include "geometry/mesh_parts.h"
#include "geometry/nearest_grid.h"
#include "geometry/surface_crossings.h"
#include "geometry/triangle_tree.h"
#include "tests/geometry/random_points.h"
#include "tests/geometry/sample_meshes.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

double to_segment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const double share = (p - a).dot(b - a) / (b - a).squaredNorm();
  return (p - a - std::clamp(share, 0.0, 1.0) * (b - a)).norm();
}

/// The plane's distance where the foot is a blend of the corners with no negative share.
double to_triangle(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  Eigen::Matrix<double, 3, 2> sides;
  sides << b - a, c - a;
  const Eigen::Vector2d share = sides.colPivHouseholderQr().solve(p - a);
  if (share.x() >= 0 && share.y() >= 0 && share.sum() <= 1) return (sides * share - (p - a)).norm();
  return std::min({to_segment(p, a, b), to_segment(p, b, c), to_segment(p, c, a)});
}

/// Signed solid angle that a triangle covers, seen from the origin.
/// tan(angle / 2) = a . (b x c) / (abc + (a.b) c + (b.c) a + (c.a) b). Source: [VanOosterom1983].
double solid_angle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const double u = a.norm(), v = b.norm(), w = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), u * v * w + a.dot(b) * w + b.dot(c) * u + c.dot(a) * v);
}

double brute_force(const TriangleMesh& mesh, const Vector3d& p) {
  double least = std::numeric_limits<double>::infinity(), angle = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Vector3d a = mesh.vertices.col(mesh.triangles(0, t));
    const Vector3d b = mesh.vertices.col(mesh.triangles(1, t));
    const Vector3d c = mesh.vertices.col(mesh.triangles(2, t));
    least = std::min(least, to_triangle(p, a, b, c));
    angle += solid_angle(a - p, b - p, c - p);
  }
  return angle > 2 * kPi ? -least : least;
}

/// At random anywhere, and at random close to the surface.
Vector3d somewhere(const TriangleMesh& mesh, const Eigen::AlignedBox3d& box, int i,
                   std::mt19937& rng) {
  if (i % 2) return box.center() + 1.5 * random_in_cube(rng).cwiseProduct(box.sizes());
  const auto t = static_cast<Eigen::Index>(uniform(rng) * mesh.triangles.cols());
  const double u = uniform(rng), v = (1 - u) * uniform(rng);
  const Vector3d on = u * mesh.vertices.col(mesh.triangles(0, t)) +
                      v * mesh.vertices.col(mesh.triangles(1, t)) +
                      (1 - u - v) * mesh.vertices.col(mesh.triangles(2, t));
  return on + 0.1 * std::pow(uniform(rng), 4) * random_in_cube(rng);
}

void expect_brute_force(const TriangleMesh& mesh, int count) {
  std::mt19937 rng(1);
  const auto shape = build_mesh_distance(mesh);
  for (int i = 0; i < count; ++i) {
    const Vector3d p = somewhere(mesh, shape->bounds(), i, rng);
    EXPECT_NEAR(shape->distance(p), brute_force(mesh, p), 1e-14) << p.transpose();
  }
}

TEST(MeshDistance, IsBruteForceOnAMug) { expect_brute_force(mug(), queries(2000)); }
TEST(MeshDistance, IsBruteForceOnAHandledMug) {
  expect_brute_force(handled_mug(0.006), queries(200));
}
TEST(MeshDistance, IsBruteForceOnAThinPlate) { expect_brute_force(thin_plate(), queries(20000)); }
TEST(MeshDistance, IsBruteForceOnARing) { expect_brute_force(ring(), queries(2000)); }
TEST(MeshDistance, IsBruteForceOnAFewBigAndManySmallTriangles) {
  TriangleMesh both = box_mesh({0.3, 0.3, 0.01});
  const TriangleMesh little = ring();
  const Eigen::Index vertices = both.vertices.cols(), triangles = both.triangles.cols();
  both.vertices.conservativeResize(3, vertices + little.vertices.cols());
  both.vertices.rightCols(little.vertices.cols()) =
      little.vertices.colwise() + Vector3d(0, 0, 0.02);
  both.triangles.conservativeResize(3, triangles + little.triangles.cols());
  both.triangles.rightCols(little.triangles.cols()) =
      little.triangles.array() + static_cast<int>(vertices);
  expect_brute_force(both, queries(1000));
}

// By hand: 10 mm from the wall's inside in the middle of the mug, and in the wall itself.
TEST(MeshDistance, IsPositiveInAnOpenCavity) {
  const auto shape = build_mesh_distance(mug(180));
  EXPECT_NEAR(shape->distance({0.026, 0, 0}), 0.010, 1e-5);
  EXPECT_NEAR(shape->distance({0.038, 0, 0}), -0.002, 1e-5);
  EXPECT_NEAR(shape->distance({0, 0, 0}), 0.036, 1e-5);
  EXPECT_NEAR(shape->distance({0, 0, -0.049}), -0.001, 1e-14);
}

TEST(MeshDistance, MeasuresABoxAsABox) {
  std::mt19937 rng(2);
  const Vector3d edges(0.02, 0.05, 0.08);
  const auto mesh = build_mesh_distance(box_mesh(edges)), box = build_box(edges);
  for (int i = 0; i < 20000; ++i) {
    const Vector3d p = 0.1 * random_in_cube(rng);
    const NearestSurface near = mesh->nearest(p);
    EXPECT_NEAR(near.distance, box->distance(p), 1e-16);
    EXPECT_NEAR(box->distance(p - near.distance * near.normal), 0, 1e-15);
  }
}

TEST(MeshDistance, HasANormalOnItsEdgesAndCorners) {
  const auto mesh = build_mesh_distance(box_mesh({0.02, 0.02, 0.02}));
  EXPECT_TRUE(matrix_near(mesh->nearest({0.01, 0.003, 0.001}).normal, Vector3d::UnitX(), 1e-12));
  // One of the faces that meet, or what lies between them.
  for (const Vector3d& p : {Vector3d(0.01, 0.01, 0.001), Vector3d(0.01, 0.01, 0.01)}) {
    EXPECT_NEAR(mesh->nearest(p).normal.norm(), 1, 1e-12);
    EXPECT_GE(mesh->nearest(p).normal.dot(p.normalized()), std::sqrt(1.0 / 3) - 1e-12);
  }
  EXPECT_TRUE(matrix_near(mesh->nearest({0.011, 0.011, 0.001}).normal,
                          Vector3d(1, 1, 0).normalized(), 1e-12));
}

// Needles and slivers: a corner of each is nearly in line with the two others.
TEST(MeshDistance, KeepsItsDigitsOnSlivers) {
  TriangleMesh sliver{Eigen::Matrix3Xd(3, 4), Eigen::Matrix3Xi(3, 4)};
  sliver.vertices << 0, 0.1, 0.04, 0.05, 0, 0, 1e-9, 0.02, 0, 0, 0, 0.03;
  sliver.triangles << 0, 0, 1, 2, 2, 1, 2, 0, 1, 3, 3, 3;
  std::mt19937 rng(3);
  const auto shape = build_mesh_distance(sliver);
  for (int i = 0; i < 20000; ++i) {
    const Vector3d p = 0.1 * random_in_cube(rng);
    EXPECT_NEAR(std::abs(shape->distance(p)), std::abs(brute_force(sliver, p)), 1e-12);
  }
}

TEST(MeshDistance, ChangesNoMoreThanTheWayGone) {
  std::mt19937 rng(4);
  const TriangleMesh mesh = handled_mug(0.006);
  const auto shape = build_mesh_distance(mesh);
  for (int i = 0; i < queries(10000); ++i) {
    const Vector3d p = somewhere(mesh, shape->bounds(), i, rng);
    const Vector3d q = p + 0.01 * uniform(rng) * random_in_cube(rng);
    EXPECT_LE(std::abs(shape->distance(p) - shape->distance(q)), (p - q).norm() + 1e-14);
  }
}

/// A vertex more, which no triangle has: another content, the same surface.
std::shared_ptr<const Shape> unshared(TriangleMesh mesh) {
  mesh.vertices.conservativeResize(3, mesh.vertices.cols() + 1);
  mesh.vertices.rightCols(1).setZero();
  return build_mesh_distance(mesh);
}

/// Points around a surface, each five times near together so that cubes are asked for again.
std::vector<Vector3d> points_about(const TriangleMesh& mesh, int count) {
  std::mt19937 rng(5);
  const Eigen::AlignedBox3d box = build_mesh_distance(mesh)->bounds();
  std::vector<Vector3d> points;
  for (int i = 0; i < count / 5; ++i) {
    const Vector3d p = somewhere(mesh, box, i, rng);
    for (int k = 0; k < 5; ++k) points.emplace_back(p + 1e-4 * k * random_in_cube(rng));
  }
  // And those at which several triangles are equally near, but for rounding.
  for (Eigen::Index v = 0; v < mesh.vertices.cols() && v < count / 2; ++v) {
    const Vector3d a = mesh.vertices.col(v), b = mesh.vertices.col((v + 1) % mesh.vertices.cols());
    points.insert(points.end(), {a, (a + b) / 2, 1.1 * a, 0.9 * b, (0.3 * a + 0.7 * b)});
  }
  return points;
}

std::vector<double> answers(const Shape& shape, const std::vector<Vector3d>& points) {
  std::vector<double> all;
  for (const Vector3d& p : points) {
    const NearestSurface near = shape.nearest(p);
    all.insert(all.end(), {near.distance, near.normal.x(), near.normal.y(), near.normal.z()});
    EXPECT_EQ(near.distance, shape.distance(p));
  }
  return all;
}

// A grid that was asked everything before, one that was asked backwards, one for each point alone.
TEST(MeshDistance, HasTheSameBitsWhateverWasAskedBefore) {
  for (const TriangleMesh& mesh : {mug(), ring(), handled_mug(0.006)}) {
    std::vector<Vector3d> points = points_about(mesh, queries(2000));
    const auto used = build_mesh_distance(mesh), backwards = unshared(mesh);
    const std::vector<double> first = answers(*used, points);
    EXPECT_EQ(answers(*used, points), first);
    std::reverse(points.begin(), points.end());
    std::vector<double> last = answers(*backwards, points);
    for (std::size_t i = 0; 2 * i + 4 < last.size(); i += 4)
      std::swap_ranges(last.begin() + static_cast<std::ptrdiff_t>(i),
                       last.begin() + static_cast<std::ptrdiff_t>(i + 4),
                       last.end() - static_cast<std::ptrdiff_t>(i + 4));
    EXPECT_EQ(last, first);
  }
}

// Surfaces that go through themselves.

/// A ring whose hole is narrower than the ring is thick: its inner side lies in the ring.
TriangleMesh spindle() {
  TriangleMesh mesh = ring();
  for (auto p : mesh.vertices.colwise()) p.head<2>() -= 0.024 * p.head<2>().normalized();
  return mesh;
}

/// A ring whose corners were moved at random by up to 4 mm, half of its thickness.
TriangleMesh crumpled(unsigned seed) {
  std::mt19937 rng(seed);
  TriangleMesh mesh = ring();
  for (auto p : mesh.vertices.colwise()) p += 0.004 * random_in_cube(rng);
  return mesh;
}

TriangleMesh box_around(const Vector3d& centre, double edge, bool inside_out = false) {
  TriangleMesh box = box_mesh(Vector3d::Constant(edge));
  box.vertices.colwise() += centre;
  if (inside_out) box.triangles.row(0).swap(box.triangles.row(1));
  return box;
}

/// Whether the surface winds more often outwards than inwards around a point.
void expect_sign_of_windings(const TriangleMesh& mesh, int count) {
  std::mt19937 rng(6);
  const auto shape = build_mesh_distance(mesh);
  for (int i = 0; i < count; ++i) {
    const Vector3d p = somewhere(mesh, shape->bounds(), i, rng);
    const double expected = brute_force(mesh, p);
    if (std::abs(expected) < 1e-9) continue;  // a sum of angles does not tell the side there
    EXPECT_EQ(shape->distance(p) < 0, expected < 0) << p.transpose();
    EXPECT_EQ(shape->nearest(p).distance, shape->distance(p));
  }
}

TEST(CrossedMeshDistance, IsTakenWhereASurfaceGoesThroughItself) {
  EXPECT_TRUE(goes_through_itself(*build_mesh_distance(spindle())));
  EXPECT_FALSE(goes_through_itself(*build_mesh_distance(ring())));
}

TEST(CrossedMeshDistance, HasTheSignOfWindings) {
  expect_sign_of_windings(spindle(), queries(2000));
  for (unsigned seed = 0; seed < 5; ++seed) expect_sign_of_windings(crumpled(seed), queries(1000));
  expect_sign_of_windings(joined({box_around({0, 0, 0}, 0.02), box_around({0.01, 0.003, 0}, 0.02)}),
                          queries(2000));
}

// Boxes face to face: the wall between them is inside, and no feature of it tells a side.
TEST(CrossedMeshDistance, TakesBoxesThatShareAFace) {
  const TriangleMesh both = joined({box_around({0, 0, 0}, 0.02), box_around({0.02, 0, 0}, 0.02)});
  expect_sign_of_windings(both, queries(4000));
  const auto shape = build_mesh_distance(both);
  EXPECT_LT(shape->distance({0.0101, 0.001, 0}), 0);
  EXPECT_LT(shape->distance({0.0099, 0.001, 0}), 0);
}

// A box in a box, both outward, and a box inside out beside one: neither is a boundary. By hand.
TEST(CrossedMeshDistance, LeavesOutWhatHasTheSameOnBothSides) {
  // The third box crosses a corner of the first, so that windings are asked at all.
  const TriangleMesh crossing = box_around({0.017, 0.017, 0.02}, 0.004);
  const auto twice = build_mesh_distance(
      joined({box_around({0, 0, 0}, 0.04), box_around({0, 0, 0}, 0.01), crossing}));
  EXPECT_NEAR(twice->distance({0, 0, -0.001}), -0.019, 1e-15);
  EXPECT_NEAR(twice->distance({0, 0.006, -0.002}), -0.014, 1e-15);
  const auto beside = build_mesh_distance(
      joined({box_around({0, 0, 0}, 0.04), box_around({0.05, 0, 0}, 0.02, true), crossing}));
  EXPECT_NEAR(beside->distance({0.05, 0, -0.001}), 0.03, 1e-15);
  EXPECT_NEAR(beside->distance({0.041, 0, -0.001}), 0.021, 1e-15);
}

TEST(CrossedMeshDistance, ChangesNoMoreThanTheWayGone) {
  std::mt19937 rng(7);
  for (const TriangleMesh& mesh : {spindle(), crumpled(1), crumpled(2)}) {
    const auto shape = build_mesh_distance(mesh);
    for (int i = 0; i < queries(5000); ++i) {
      const Vector3d p = somewhere(mesh, shape->bounds(), i, rng);
      const Vector3d q = p + 0.01 * uniform(rng) * random_in_cube(rng);
      EXPECT_LE(std::abs(shape->distance(p) - shape->distance(q)), (p - q).norm() + 1e-14);
    }
  }
}

// Which triangles meet, by hand.
TEST(SurfaceCrossings, FindsWhatMeetsAndNothingElse) {
  const auto meeting = [](const TriangleMesh& mesh) {
    const std::vector<bool> found =
        internal::crossing_triangles(mesh, internal::TriangleTree(mesh));
    return std::count(found.begin(), found.end(), true);
  };
  for (const TriangleMesh& sound : {mug(), thin_plate(), ring(), handled_mug(0.006)})
    EXPECT_EQ(meeting(sound), 0);
  // A cube that pokes through the top of another: its four sides, and the top's two triangles.
  EXPECT_EQ(meeting(joined({box_around({0, 0, 0}, 0.04), box_around({0.011, 0.002, 0.02}, 0.01)})),
            8 + 2);
  // A fin folded onto its neighbour.
  TriangleMesh folded{Eigen::Matrix3Xd(3, 4), Eigen::Matrix3Xi(3, 2)};
  folded.vertices << 0, 1, 0, 0.2, 0, 0, 1, 0.3, 0, 0, 0, 0;
  folded.triangles << 0, 1, 1, 0, 2, 3;
  EXPECT_EQ(meeting(folded), 2);
  folded.vertices(1, 3) = -0.3;
  EXPECT_EQ(meeting(folded), 0);
}

TEST(MeshDistance, HasTheSameBitsInSeveralThreads) {
  const TriangleMesh mesh = handled_mug(0.006);
  const std::vector<Vector3d> points = points_about(mesh, queries(2000));
  const std::vector<double> alone = answers(*unshared(mesh), points);
  const auto shared = build_mesh_distance(mesh);
  std::vector<std::vector<double>> found(4);
  std::vector<std::thread> threads;
  for (std::vector<double>& all : found)
    threads.emplace_back([&] { all = answers(*shared, points); });
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<double>& all : found) EXPECT_EQ(all, alone);
}

TEST(MeshDistance, IsBuiltOnceForMeshesOfTheSameContent) {
  TriangleMesh moved = mug();
  EXPECT_EQ(build_mesh_distance(mug()), build_mesh_distance(mug()));
  moved.vertices(0, 0) += 1e-15;
  EXPECT_NE(build_mesh_distance(mug()), build_mesh_distance(moved));
  EXPECT_NE(build_mesh_distance(mug()), unshared(mug()));
}

// The tree alone, from any first guess, finds what the cubes find.
TEST(NearestGrid, FindsWhatTheTreeFinds) {
  const TriangleMesh mesh = ring();
  const internal::TriangleTree tree(mesh);
  const internal::NearestGrid grid(tree);
  const auto last = static_cast<int>(mesh.triangles.cols()) - 1;
  for (int again = 0; again < 3; ++again)
    for (const Vector3d& p : points_about(mesh, queries(2000))) {
      internal::NearestTriangle guess;
      tree.update_nearest(last, p, guess);
      const internal::NearestTriangle by_tree = tree.nearest(p, guess),
                                      by_cubes = grid.nearest(p, tree);
      EXPECT_EQ(by_tree.triangle, by_cubes.triangle);
      EXPECT_EQ(by_tree.foot.squared, by_cubes.foot.squared);
    }
}

/// What this process holds of its heap [bytes]; sanitizers, whose heap is their own, count nothing.
std::size_t heap_in_use() { return mallinfo2().uordblks + mallinfo2().hblkhd; }

// Lists of triangles take memory as they are filled: none for one question, some for many of places
// nearby.
TEST(MeshDistance, FillsNoCubeThatNobodyAsksFor) {
  const TriangleMesh fine =
      surface_of_revolution({{0, -0.05}, {0.04, -0.05}, {0.04, 0.05}, {0, 0.05}}, 25000);
  ASSERT_EQ(fine.triangles.cols(), 100000);
  const auto shape = build_mesh_distance(fine);
  const std::size_t built = heap_in_use();
  if (built == 0) GTEST_SKIP() << "this heap does not count";
  EXPECT_NEAR(shape->distance({0.05, 0, 0}), 0.01, 1e-9);
  const std::size_t asked_once = heap_in_use();
  for (int i = 0; i < 100'000; ++i)
    (void)shape->distance({0.041 + 1e-5 * (i % 100), 1e-4 * (i % 97), 1e-3 * (i % 40)});
  EXPECT_LT(20 * (asked_once - built), heap_in_use() - asked_once);
}

}  // namespace
}  // namespace thenar
