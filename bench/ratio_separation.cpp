// How far a point, a capsule and a fingertip of 224 triangles are from a bumpy object of 5,100, on
// their way past, at 0.05 mm: against FCL's OBBRSS distance.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/units.h"
#include "bench/ratios.h"
#include "geometry/collision/signed_distance.h"
#include "geometry/mesh_distance.h"
#include "geometry/tessellate.h"
#include "tests/geometry/collision/fcl_distance.h"

namespace thenar::bench {
namespace {

constexpr double kTolerance = 5e-5;  // [m]
constexpr int kPoses = 32;

/// A surface of revolution of `rings` times `sides` strips.
TriangleMesh turned(double length, int rings, int sides, double (*radius)(double)) {
  std::vector<Eigen::Vector2d> profile{{0, -length / 2}};
  for (int i = 0; i < rings; ++i) {
    const double s = (i + 0.5) / rings;
    profile.emplace_back(radius(s), length * (s - 0.5));
  }
  profile.emplace_back(0, length / 2);
  return surface_of_revolution(profile, sides);
}

/// A vase about 12 cm high: 51 x 50 strips, 5,100 triangles.
TriangleMesh vase() {
  return turned(0.12, 51, 50, [](double s) { return 0.03 + 0.008 * std::sin(4 * kPi * s); });
}

constexpr double kRadius = 0.008, kHalf = 0.01;  // of a fingertip, a capsule [m]

/// A capsule whose corners lie on it, within 0.05 mm: `sides` about, an arc of `steps` at each end.
TriangleMesh capsule_mesh(int sides, int steps) {
  std::vector<Eigen::Vector2d> profile;
  for (int end : {-1, 1})
    for (int i = 0; i <= steps; ++i) {
      const double up = kPi / 2 * (end < 0 ? i - steps : i) / steps;
      profile.emplace_back(kRadius * std::cos(up), end * kHalf + kRadius * std::sin(up));
    }
  profile.front().x() = profile.back().x() = 0;
  return surface_of_revolution(profile, sides);
}

Solid capsule() {
  Eigen::Matrix3Xd ends = Eigen::Matrix3Xd::Zero(3, 2);
  ends.row(2) << -kHalf, kHalf;
  return {nullptr, {{{ends, Eigen::Vector3i(0, 1, 1)}, kRadius}}, {}};
}

/// Around the vase, between 1 and 20 mm off.
std::vector<Pose<double>> poses() {
  std::vector<Pose<double>> poses;
  for (int i = 0; i < kPoses; ++i) {
    const double angle = 0.4 * i, off = 0.05 + 0.015 * (i % 8) / 8;
    poses.push_back({rotation_about<double>(Eigen::Vector3d(1, 2, 3).normalized(), 0.7 * i),
                     {off * std::cos(angle), off * std::sin(angle), 0.05 * std::sin(1.3 * i)}});
  }
  return poses;
}

/// @param mesh_A  as FCL takes A;  @param solid_A  as we do
Row against_fcl(const std::string& name, double required, const TriangleMesh& mesh_A,
                const Solid& solid_A) {
  const TriangleMesh mesh_B = vase();
  const CollisionTree a = collision_tree(solid_A);
  const auto b = build_mesh_distance(mesh_B);
  const FclMesh fcl_A(mesh_A), fcl_B(mesh_B);
  const std::vector<Pose<double>> at = poses();

  SignedDistanceOptions options;
  options.tolerance = kTolerance;
  Duel duel{name, {}, {}, required, 0, 2 * kTolerance};  // ours, and the mesh's
  for (const Pose<double>& X : at) {
    const double ours = signed_distance(a, X, *b, options).distance;
    // FCL's has no sign: an overlap is 0.
    duel.error = std::max(
        duel.error, std::abs(std::max(0.0, ours) - fcl_distance(fcl_A, X, fcl_B, {}, kTolerance)));
  }
  for (int pass = 0; pass < 300; ++pass)  // until all cubes are filled that will be
    for (const Pose<double>& X : at) keep(signed_distance(a, X, *b, options));
  duel.ours = [&, i = 0U]() mutable { keep(signed_distance(a, at[i++ % kPoses], *b, options)); };
  duel.rival = [&, i = 0U]() mutable {
    keep(fcl_distance(fcl_A, at[i++ % kPoses], fcl_B, {}, kTolerance));
  };
  return measure(duel, {41, 0.002});
}

/// Points along the same way, some of them inside; FCL's is a triangle of 1 micrometre.
Row point_against_fcl(const std::string& name, double required) {
  const TriangleMesh mesh_B = vase();
  TriangleMesh speck{Eigen::Matrix3Xd::Zero(3, 3), Eigen::Vector3i(0, 1, 2)};
  speck.vertices(0, 1) = speck.vertices(1, 2) = 1e-6;
  const auto b = build_mesh_distance(mesh_B);
  const FclMesh fcl_A(speck), fcl_B(mesh_B);
  const std::vector<Pose<double>> at = poses();

  Duel duel{name, {}, {}, required, 0, kTolerance};
  for (const Pose<double>& X : at)  // FCL's distance to the surface has no sign
    duel.error = std::max(duel.error, std::abs(std::abs(b->distance(X.p)) -
                                               fcl_distance(fcl_A, X, fcl_B, {}, kTolerance)));
  for (int pass = 0; pass < 2500; ++pass)  // until all cubes are filled that will be
    for (const Pose<double>& X : at) keep(b->distance(X.p));
  duel.ours = [&, i = 0U]() mutable { keep(b->distance(at[i++ % kPoses].p)); };
  duel.rival = [&, i = 0U]() mutable {
    keep(fcl_distance(fcl_A, at[i++ % kPoses], fcl_B, {}, kTolerance));
  };
  return measure(duel, {41, 0.002});
}

}  // namespace

Row ratio_separation() {
  return against_fcl("capsule to the same mesh: FCL's, 1,600", 50, capsule_mesh(40, 10), capsule());
}

Row ratio_separation_mesh() {
  const TriangleMesh mesh = capsule_mesh(14, 4);
  return against_fcl("mesh of 224 triangles to the same", 0, mesh, {nullptr, {{mesh, 0}}, {}});
}

Row ratio_distance_of_point() {
  return point_against_fcl("point to mesh of 5,100: FCL's OBBRSS", 50);
}

}  // namespace thenar::bench
