// Contacts of moving bodies, one update each, along motions of small steps.

#include <cmath>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>

#include "api/named/worlds.h"
#include "base/units.h"
#include "data/io/mesh/mesh_file.h"
#include "geometry/manifold/collision_world.h"
#include "geometry/tessellate.h"
#include "grasp/closing/close_hand.h"
#include "grasp/contact/contact_patch.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

std::shared_ptr<const CollisionBody> primitive(ShapeKind kind, const Vector3d& size) {
  ShapeSpec spec;
  spec.kind = kind;
  spec.size = size;
  return collision_body(build_solid({spec}));
}

std::shared_ptr<const CollisionBody> of_mesh(const TriangleMesh& mesh) {
  ShapeSpec spec;
  spec.kind = ShapeKind::kMesh;
  spec.mesh = mesh;
  return collision_body(build_solid({spec}));
}

constexpr double kMargin = 5e-4;  // [m]

/// Updates along poses of A, there and back.
void run(benchmark::State& state, const std::shared_ptr<const CollisionBody>& a,
         const std::shared_ptr<const CollisionBody>& b, const std::vector<Pose<double>>& way) {
  CollisionPair pair(a, b);
  // Distance grids fill where they are asked.
  for (int pass = 0; pass < 300; ++pass)
    for (std::size_t i = 0; i < way.size(); i += 7) pair.update(way[i], {}, kMargin);
  std::size_t i = 0;
  double points = 0;
  for ([[maybe_unused]] auto _ : state) {
    const std::size_t at = i++ % (2 * way.size());
    const ContactManifold& manifold =
        pair.update(way[at < way.size() ? at : 2 * way.size() - 1 - at], {}, kMargin);
    points += manifold.count;
    benchmark::DoNotOptimize(manifold.points.data());
  }
  state.counters["points"] = points / static_cast<double>(state.iterations());
}

/// Slides by 0.01 mm a step, turning a little, in touch with z = height.
std::vector<Pose<double>> sliding(const Vector3d& from, const Vector3d& axis, double angle) {
  std::vector<Pose<double>> way;
  for (int i = 0; i < 400; ++i)
    way.push_back(
        {rotation_about<double>(axis, angle) * rotation_about<double>(Vector3d::UnitZ(), 1e-4 * i),
         from + 1e-5 * i * Vector3d::UnitX()});
  return way;
}

void BM_BoxOverAnEdge(benchmark::State& state) {
  run(state, primitive(ShapeKind::kBox, {0.04, 0.03, 0.02}),
      primitive(ShapeKind::kBox, {0.1, 0.08, 0.02}),
      sliding({0.028, 0.003, 0.02 - 1e-5}, Vector3d::UnitY(), 0));
}
void BM_SphereOnSphere(benchmark::State& state) {
  const auto ball = primitive(ShapeKind::kSphere, {0.01, 0, 0});
  run(state, ball, ball, sliding({-0.002, 0, 0.02 - 1e-5}, Vector3d::UnitY(), 0));
}
void BM_SphereOnBox(benchmark::State& state) {
  run(state, primitive(ShapeKind::kSphere, {0.01, 0, 0}),
      primitive(ShapeKind::kBox, {0.1, 0.08, 0.02}),
      sliding({0, 0, 0.02 - 1e-5}, Vector3d::UnitY(), 0));
}
void BM_CapsuleOnCapsule(benchmark::State& state) {
  const auto capsule = primitive(ShapeKind::kCapsule, {0.008, 0.03, 0});
  run(state, capsule, capsule, sliding({-0.002, 0, 0.0159}, Vector3d::UnitX(), kPi / 3));
}
void BM_CapsuleOnBox(benchmark::State& state) {
  run(state, primitive(ShapeKind::kCapsule, {0.008, 0.03, 0}),
      primitive(ShapeKind::kBox, {0.1, 0.08, 0.02}),
      sliding({0.02, 0, 0.018 - 1e-5}, Vector3d::UnitX(), kPi / 2));
}
void BM_CapsuleOnCylinder(benchmark::State& state) {
  run(state, primitive(ShapeKind::kCapsule, {0.008, 0.03, 0}),
      primitive(ShapeKind::kCylinder, {0.04, 0.02, 0}),
      sliding({0.0, 0, 0.018 - 1e-5}, Vector3d::UnitX(), kPi / 2));
}
void BM_CylinderOnBox(benchmark::State& state) {
  run(state, primitive(ShapeKind::kCylinder, {0.03, 0.02, 0}),
      primitive(ShapeKind::kBox, {0.2, 0.2, 0.02}),
      sliding({0, 0, 0.02 - 1e-5}, Vector3d::UnitY(), 0));
}
void BM_CylinderOnCylinder(benchmark::State& state) {
  run(state, primitive(ShapeKind::kCylinder, {0.03, 0.02, 0}),
      primitive(ShapeKind::kCylinder, {0.04, 0.02, 0}),
      sliding({0.02, 0, 0.02 - 1e-5}, Vector3d::UnitY(), 0));
}
void BM_EllipsoidOnBox(benchmark::State& state) {
  run(state, primitive(ShapeKind::kEllipsoid, {0.03, 0.02, 0.01}),
      primitive(ShapeKind::kBox, {0.2, 0.2, 0.02}),
      sliding({0, 0, 0.02 - 1e-5}, Vector3d::UnitY(), 0));
}

/// A vase of 51 x 50 strips, 5,100 triangles.
TriangleMesh vase() {
  std::vector<Eigen::Vector2d> profile{{0, -0.06}};
  for (int i = 0; i < 51; ++i) {
    const double s = (i + 0.5) / 51;
    profile.emplace_back(0.03 + 0.008 * std::sin(4 * kPi * s), 0.12 * (s - 0.5));
  }
  profile.emplace_back(0, 0.06);
  return surface_of_revolution(profile, 50);
}

/// Round a body of revolution, in touch at z = 0.
std::vector<Pose<double>> round(double off, double height) {
  std::vector<Pose<double>> way;
  for (int i = 0; i < 400; ++i) {
    const double angle = kPi / 2 + 1e-5 * i / off;
    way.push_back({rotation_about<double>(Vector3d::UnitZ(), angle),
                   {off * std::cos(angle), off * std::sin(angle), height + 5e-6 * i}});
  }
  return way;
}

void BM_CapsuleOnMesh(benchmark::State& state) {
  run(state, primitive(ShapeKind::kCapsule, {0.008, 0.03, 0}), of_mesh(vase()), round(0.046, 0.03));
}
TriangleMesh mug_mesh() { return read_mesh(THENAR_DATA_DIR "/objects/mug.obj", 0.001); }
void BM_BoxOnMug(benchmark::State& state) {
  run(state, primitive(ShapeKind::kBox, {0.02, 0.03, 0.02}), of_mesh(mug_mesh()),
      round(0.0509, 0.05));
}
void BM_MeshBallOnMug(benchmark::State& state) {
  std::vector<Eigen::Vector2d> profile;
  for (int i = 0; i <= 20; ++i)
    profile.emplace_back(0.01 * std::cos(kPi * (i / 20.0 - 0.5)),
                         0.01 * std::sin(kPi * (i / 20.0 - 0.5)));
  profile.front().x() = profile.back().x() = 0;
  run(state, of_mesh(surface_of_revolution(profile, 30)), of_mesh(mug_mesh()), round(0.0509, 0.05));
}

void BM_MugOnTable(benchmark::State& state) {
  const auto mug = of_mesh(mug_mesh());
  const double low = mug->box.min().z();
  run(state, mug, primitive(ShapeKind::kBox, {0.6, 0.4, 0.02}),
      sliding({0, 0, 0.01 - low - 1e-5}, Vector3d::UnitY(), 0));
}

/// Contact patches along the same way, which know nothing of the step before.
void run_patches(benchmark::State& state, const ShapeSpec& a, const ShapeSpec& b,
                 const std::vector<Pose<double>>& way) {
  const CollisionTree tree = collision_tree(build_solid({a}));
  const Solid solid = build_solid({b});
  for (std::size_t i = 0; i < way.size(); i += 7)
    benchmark::DoNotOptimize(contact_patches(tree, way[i], solid, {}, 0.5));
  std::size_t i = 0;
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(contact_patches(tree, way[i++ % way.size()], solid, {}, 0.5));
}
ShapeSpec spec_of(ShapeKind kind, const Vector3d& size, const TriangleMesh& mesh = {}) {
  ShapeSpec spec;
  spec.kind = kind;
  spec.size = size;
  spec.mesh = mesh;
  return spec;
}
void BM_PatchesOfBoxOverAnEdge(benchmark::State& state) {
  run_patches(state, spec_of(ShapeKind::kBox, {0.04, 0.03, 0.02}),
              spec_of(ShapeKind::kBox, {0.1, 0.08, 0.02}),
              sliding({0.028, 0.003, 0.02 - 1e-5}, Vector3d::UnitY(), 0));
}
void BM_PatchesOfCapsuleOnMesh(benchmark::State& state) {
  run_patches(state, spec_of(ShapeKind::kCapsule, {0.008, 0.03, 0}),
              spec_of(ShapeKind::kMesh, {0, 0, 0}, vase()), round(0.046, 0.03));
}
void BM_PatchesOfBoxOnMug(benchmark::State& state) {
  run_patches(state, spec_of(ShapeKind::kBox, {0.02, 0.03, 0.02}),
              spec_of(ShapeKind::kMesh, {0, 0, 0}, mug_mesh()), round(0.0509, 0.05));
}

/// A human hand closed round the mug, which breathes by a milliradian. The range is how many such
/// hands there are, each turned by a degree about the mug and blind to the others: more near pairs.
void BM_HandRoundMug(benchmark::State& state) {
  const int hands = static_cast<int>(state.range(0));
  WorldRequest request;
  request.world = "human_mug";
  request.data = THENAR_DATA_DIR;
  const WorldCase world = open_world(request, false);
  const Hand& hand = *world.hand.named.hand;
  const CollisionHand collision = collision_hand(hand, world.setup.materials);
  CloseOptions options;
  options.rates = world.hand.named.rates;
  const ClosedHand closed =
      close_hand(collision, world.hand.X_WH, world.hand.q, world.setup, options);
  // Surfaces, then the object, then obstacles.
  std::vector<std::shared_ptr<const CollisionBody>> bodies;
  const int links = static_cast<int>(hand.surfaces().size()), surfaces = hands * links;
  for (int copy = 0; copy < hands; ++copy)
    for (const LinkSurface& surface : hand.surfaces())
      bodies.push_back(collision_body(*surface.solid));
  bodies.push_back(collision_body(world.setup.object.solid));
  for (const GraspBody& body : world.setup.obstacles) bodies.push_back(collision_body(body.solid));
  const int all = static_cast<int>(bodies.size());
  CollisionWorld contacts(bodies);
  // Links that never meet, and obstacles among themselves.
  for (int i = 0; i < surfaces; ++i)
    for (int j = 0; j < i; ++j) {
      bool meet = false;
      for (const SurfacePair& pair : collision.self_pairs)
        meet = meet || (i / links == j / links && ((pair.a == i % links && pair.b == j % links) ||
                                                   (pair.a == j % links && pair.b == i % links)));
      if (!meet) contacts.exclude(i, j);
    }
  for (int i = surfaces + 1; i < all; ++i)
    for (int j = surfaces + 1; j < i; ++j) contacts.exclude(i, j);
  // Postures of 200 steps.
  std::vector<std::vector<Pose<double>>> steps;
  for (int i = 0; i < 200; ++i) {
    const Eigen::VectorXd q = (closed.q.array() + 1e-3 * std::sin(2 * kPi * i / 200)).matrix();
    const std::vector<Pose<double>> link_at = hand.pose(q);
    std::vector<Pose<double>> poses;
    for (int copy = 0; copy < hands; ++copy) {
      Pose<double> turn;
      turn.R = rotation_about<double>(Vector3d::UnitZ(), copy * kDegree);
      turn.p = world.setup.object.X_WB.p - turn.R * world.setup.object.X_WB.p;
      const Pose<double> X_WH = turn * world.hand.X_WH;
      for (const LinkSurface& surface : hand.surfaces())
        poses.push_back(surface.link < 0 ? X_WH
                                         : X_WH * link_at[static_cast<std::size_t>(surface.link)]);
    }
    poses.push_back(world.setup.object.X_WB);
    for (const GraspBody& body : world.setup.obstacles) poses.push_back(body.X_WB);
    steps.push_back(poses);
  }
  for (int pass = 0; pass < 20; ++pass)
    for (const auto& poses : steps) contacts.update(poses, kMargin);
  std::size_t i = 0;
  double points = 0, touching = 0, near = 0;
  for ([[maybe_unused]] auto _ : state) {
    for (const BodyContact& contact : contacts.update(steps[i++ % steps.size()], kMargin))
      points += contact.manifold->count, ++touching;
    near += contacts.near_pairs();
  }
  const auto count = static_cast<double>(state.iterations());
  state.counters["points"] = points / count;
  state.counters["touching"] = touching / count;
  state.counters["near"] = near / count;
}

BENCHMARK(BM_BoxOverAnEdge)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_SphereOnSphere)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_SphereOnBox)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_CapsuleOnCapsule)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_CapsuleOnBox)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_CapsuleOnCylinder)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_CylinderOnBox)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_CylinderOnCylinder)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_EllipsoidOnBox)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_CapsuleOnMesh)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_BoxOnMug)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_MeshBallOnMug)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_MugOnTable)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_PatchesOfBoxOverAnEdge)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_PatchesOfCapsuleOnMesh)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_PatchesOfBoxOnMug)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_HandRoundMug)->DenseRange(1, 3)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace thenar
