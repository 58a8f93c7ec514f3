// Tests for geometry/manifold: points, gaps and ids along motions of small steps, and the heap.

#include <array>
#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "base/units.h"
#include "data/io/mesh/mesh_file.h"
#include "geometry/manifold/collision_world.h"
#include "geometry/tessellate.h"
#include "tests/counted_heap.h"
#include "tests/data_folder.h"
#include "tests/geometry/manifold/manifold_samples.h"

namespace thenar {
namespace {

/// What changed from step to step of a motion.
struct Changes {
  double jump = 0;  // of a point with the same id, in the frame of A or of B, less the motion [m]
  double gap_jump = 0;  // of its gap, less the motion [m]
  double turn = 0;      // of its normal [rad]
  double born = 0;      // deepest gap at which an id appeared or went [m]
  int changes = 0;      // ids that appeared or went
};

/// Follows A along a way past B, which rests at the origin.
template <typename Way>
Changes follow(const SampleBody& a, const SampleBody& b, const Way& way, int steps, double margin) {
  CollisionPair pair(a.body, b.body);
  Changes changes;
  changes.born = margin;
  std::map<int, ManifoldPoint> last;
  for (int i = 0; i <= steps; ++i) {
    const Pose<double> X = way(i), before = way(i - 1);
    std::map<int, ManifoldPoint> now;
    for (const ManifoldPoint& point : pair.update(X, {}, margin)) now[point.id] = point;
    const double motion = motion_bound(a.body->ball, b.body->ball, before, X);
    for (const auto& [id, point] : now) {
      const auto old = last.find(id);
      if (old == last.end()) {
        if (i > 0) ++changes.changes, changes.born = std::min(changes.born, point.gap);
        continue;
      }
      const double on_b = (point.on_b - old->second.on_b).norm();
      const double on_a = (X.inverse() * point.on_a - before.inverse() * old->second.on_a).norm();
      changes.jump = std::max(changes.jump, std::min(on_a, on_b) - motion);
      changes.gap_jump = std::max(changes.gap_jump, std::abs(point.gap - old->second.gap) - motion);
      changes.turn = std::max(changes.turn, (point.normal - old->second.normal).norm());
    }
    for (const auto& [id, point] : last)
      if (now.count(id) == 0) ++changes.changes, changes.born = std::min(changes.born, point.gap);
    last = now;
  }
  return changes;
}

constexpr double kStep = 1e-5;  // [m]

// A box slides flat over the edge of another by 4 mm, in steps of 0.01 mm: no point jumps; the two
// that leave the face become the crossings at the edge.
TEST(ManifoldMotion, BoxOverAnEdgeDoesNotJump) {
  const SampleBody box(ShapeKind::kBox, {0.04, 0.03, 0.02}),
      table(ShapeKind::kBox, {0.1, 0.08, 0.02});
  for (const double turn : {0.0, 0.3, kPi / 4})
    for (const double depth : {-1e-5, 1e-5}) {
      const Changes changes = follow(
          box, table,
          [&](int i) {
            return Pose<double>{rotation_about<double>(Eigen::Vector3d::UnitZ(), turn),
                                {0.02 + kStep * i, 0.004, 0.02 - depth}};
          },
          4000, 1e-4);
      // Edges that cross at an angle do so at a point that runs along the one of A.
      const double runs = turn > 0 ? std::max(0.0, 1 / std::tan(turn) - 1) * kStep : 0;
      EXPECT_LT(changes.jump, runs + 1e-9) << turn;
      EXPECT_LT(changes.gap_jump, 1e-12) << turn;
      EXPECT_LT(changes.turn, 1e-12) << turn;
    }
}

// It tips over the edge: ids last until they leave the margin.
TEST(ManifoldMotion, BoxThatRocksKeepsItsIds) {
  const SampleBody box(ShapeKind::kBox, {0.04, 0.03, 0.02}),
      table(ShapeKind::kBox, {0.1, 0.08, 0.02});
  const Changes changes = follow(
      box, table,
      [](int i) {
        // About its lower edge at x = 20 mm, by up to 0.1 rad and back.
        const double angle = 0.05 * (1 - std::cos(2e-3 * kPi * i));
        const Eigen::Matrix3d R = rotation_about<double>(Eigen::Vector3d::UnitY(), angle);
        return Pose<double>{R,
                            Eigen::Vector3d(0.02, 0, 0.01) + R * Eigen::Vector3d(-0.02, 0, 0.01)};
      },
      1000, 1e-4);
  EXPECT_LT(changes.jump, 1e-9);
  EXPECT_LT(changes.turn, 1e-9);
  // Two corners leave the margin and come back: with the margin's gap, but for a step.
  EXPECT_EQ(changes.changes, 4);
  EXPECT_GT(changes.born, 1e-4 - 2e-5);
}

// Capsules, cylinders and eggs that roll and slide over a box's face and edge.
TEST(ManifoldMotion, RoundBodiesDoNotJump) {
  const SampleBody table(ShapeKind::kBox, {0.1, 0.08, 0.02});
  const SampleBody capsule(ShapeKind::kCapsule, {0.008, 0.03, 0}),
      ball(ShapeKind::kSphere, {0.01, 0, 0});
  const SampleBody egg(ShapeKind::kEllipsoid, {0.012, 0.011, 0.01});
  const auto over = [](double height) {
    return [height](int i) {
      const Eigen::Matrix3d lying = rotation_about<double>(Eigen::Vector3d::UnitX(), kPi / 2);
      return Pose<double>{rotation_about<double>(Eigen::Vector3d::UnitZ(), 2e-4 * i) *
                              rotation_about<double>(Eigen::Vector3d::UnitY(), 1e-3 * i) * lying,
                          {0.045 + kStep * i, 0, height}};
    };
  };
  for (const auto& [body, height] : {std::pair{&capsule, 0.018}, {&ball, 0.02}, {&egg, 0.0205}}) {
    const Changes changes = follow(*body, table, over(height), 1500, 1e-3);
    EXPECT_LT(changes.jump, 2e-4);
    EXPECT_LT(changes.gap_jump, 1e-6);
    EXPECT_LT(changes.turn, 5e-3);
  }
}

// A tilted coin whose axis turns: its points follow the lowest one without a jump.
TEST(ManifoldMotion, WobblingCoinDoesNotJump) {
  const SampleBody coin(ShapeKind::kCylinder, {0.012, 0.002, 0}),
      table(ShapeKind::kBox, {1, 1, 0.02});
  for (const double tilt : {1e-5, 3e-4, 0.01, 0.5}) {
    const Changes changes = follow(
        coin, table,
        [&](int i) {
          const Eigen::Vector3d axis(std::cos(2e-3 * i), std::sin(2e-3 * i), 0);
          return Pose<double>{rotation_about<double>(axis, tilt),
                              {0, 0, 0.01 + 0.012 * std::sin(tilt) + 0.001 * std::cos(tilt)}};
        },
        4000, 1e-4);
    // The lowest point goes round by 2e-3 radians a step.
    EXPECT_LT(changes.jump, 2e-3 * 0.012 * 1.01) << tilt;
    EXPECT_LT(changes.gap_jump, 1e-7) << tilt;
    EXPECT_LT(changes.turn, 1e-12) << tilt;
  }
}

// A mesh on a mesh: the mug's wall against a box of triangles, and a ball of triangles that rolls.
TEST(ManifoldMotion, MeshesKeepTheirIds) {
  ShapeSpec spec;
  spec.kind = ShapeKind::kMesh;
  spec.mesh = read_mesh(kData + "/objects/mug.obj", 0.001);
  const SampleBody mug(std::vector<ShapeSpec>{spec});
  spec.mesh = box_mesh({0.3, 0.2, 0.02});
  const SampleBody table(std::vector<ShapeSpec>{spec});
  const double low = mug.body->box.min().z();
  const Changes changes = follow(
      mug, table,
      [&](int i) {
        return Pose<double>{rotation_about<double>(Eigen::Vector3d::UnitZ(), 1e-4 * i),
                            {kStep * i, 0, 0.01 - low - 1e-5}};
      },
      1000, 1e-4);
  EXPECT_LT(changes.jump, 1e-9);
  EXPECT_LT(changes.turn, 1e-9);
  EXPECT_LT(changes.changes, 10);
}

// A ball of triangles along the mug's wall: ids are passed on from feature to feature, no farther
// than 0.1 mm and twice the motion, and to normals no farther than 20 degrees.
TEST(ManifoldMotion, BallOfTrianglesOnTheMugPassesItsIdsOn) {
  ShapeSpec spec;
  spec.kind = ShapeKind::kMesh;
  spec.mesh = read_mesh(kData + "/objects/mug.obj", 0.001);
  const SampleBody mug(std::vector<ShapeSpec>{spec});
  std::vector<Eigen::Vector2d> profile;
  for (int i = 0; i <= 20; ++i)
    profile.emplace_back(0.01 * std::cos(kPi * (i / 20.0 - 0.5)),
                         0.01 * std::sin(kPi * (i / 20.0 - 0.5)));
  profile.front().x() = profile.back().x() = 0;
  spec.mesh = surface_of_revolution(profile, 30);
  const SampleBody ball(std::vector<ShapeSpec>{spec});
  const double off = 0.0509;
  const Changes changes = follow(
      ball, mug,
      [&](int i) {
        const double angle = kPi / 2 + kStep * i / off;
        return Pose<double>{rotation_about<double>(Eigen::Vector3d::UnitZ(), angle),
                            {off * std::cos(angle), off * std::sin(angle), 0.05 + 5e-6 * i}};
      },
      2000, 5e-4);
  EXPECT_LT(changes.jump, 1e-4 + 2 * kStep);
  EXPECT_LT(changes.turn, 0.35);
  // The wall of 2 cm that it passes has facets of 3 mm and ridges between them.
  EXPECT_LT(changes.changes, 200);
}

// Two capsules whose axes pass through each other keep the side from which they came.
TEST(ManifoldMotion, CrossingCapsulesKeepTheirSide) {
  const SampleBody capsule(ShapeKind::kCapsule, {0.004, 0.04, 0});
  CollisionPair pair(capsule.body, capsule.body);
  const Eigen::Matrix3d across = rotation_about<double>(Eigen::Vector3d::UnitX(), kPi / 2);
  for (int i = 0; i < 1000; ++i) {
    const double x = 0.009 - 1.5e-5 * i;
    const ContactManifold& manifold = pair.update({across, {x, 0, 0}}, {}, 0.002);
    ASSERT_EQ(manifold.count, 1);
    ASSERT_NEAR(manifold.points[0].gap, x - 0.008, 1e-12);
    ASSERT_NEAR(manifold.points[0].normal.x(), 1, 1e-12);
    ASSERT_EQ(manifold.points[0].age, i);
  }
}

/// Bodies that roll over each other in a tray.
struct Tray {
  std::vector<SampleBody> samples;
  std::vector<std::shared_ptr<const CollisionBody>> bodies;

  Tray() {
    ShapeSpec mesh;
    mesh.kind = ShapeKind::kMesh;
    mesh.mesh = box_mesh({0.02, 0.03, 0.015});
    samples.emplace_back(ShapeKind::kBox, Eigen::Vector3d(0.2, 0.2, 0.02));
    samples.emplace_back(ShapeKind::kBox, Eigen::Vector3d(0.02, 0.03, 0.02));
    samples.emplace_back(ShapeKind::kSphere, Eigen::Vector3d(0.01, 0, 0));
    samples.emplace_back(ShapeKind::kCapsule, Eigen::Vector3d(0.008, 0.02, 0));
    samples.emplace_back(ShapeKind::kTaperedCapsule, Eigen::Vector3d(0.008, 0.006, 0.02));
    samples.emplace_back(ShapeKind::kCylinder, Eigen::Vector3d(0.01, 0.02, 0));
    samples.emplace_back(ShapeKind::kEllipsoid, Eigen::Vector3d(0.012, 0.011, 0.01));
    samples.emplace_back(std::vector<ShapeSpec>{mesh});
    for (const SampleBody& sample : samples) bodies.push_back(sample.body);
  }
  [[nodiscard]] std::vector<Pose<double>> at(int step) const {
    std::vector<Pose<double>> poses(bodies.size());
    for (std::size_t i = 1; i < poses.size(); ++i) {
      const double phase = 0.01 * step + 0.9 * static_cast<double>(i);
      poses[i].R = rotation_about<double>(Eigen::Vector3d(1, 2, 2) / 3, phase);
      poses[i].p = {0.022 * std::cos(phase), 0.022 * std::sin(phase),
                    0.021 + 0.004 * std::sin(3 * phase)};
    }
    return poses;
  }
};

TEST(ManifoldMotion, LeavesTheHeapAloneAfterTheFirstRound) {
  const Tray tray;
  CollisionWorld world(tray.bodies);
  std::vector<std::vector<Pose<double>>> steps;
  for (int i = 0; i < 315; ++i) steps.push_back(tray.at(2 * i));
  for (int round = 0; round < 3; ++round)  // distance grids of meshes fill where they are asked
    for (const auto& poses : steps) world.update(poses, 5e-4);
  const std::size_t before = allocations;
  std::size_t contacts = 0;
  for (const auto& poses : steps) contacts += world.update(poses, 5e-4).size();
  EXPECT_EQ(allocations, before);
  EXPECT_GT(contacts, 1000U);
}

TEST(ManifoldMotion, HeapIsCountedHere) {
  const std::size_t before = allocations;
  std::vector<double> block(100);
  EXPECT_GT(allocations, before) << block.size();
}

// Two worlds on the same way agree to the last bit, ids included.
TEST(ManifoldMotion, IsTheSameEveryTime) {
  const Tray tray;
  CollisionWorld one(tray.bodies), other(tray.bodies);
  other.exclude(0, 1);
  other = CollisionWorld(tray.bodies);
  for (int i = 0; i < 150; ++i) {
    const auto& a = one.update(tray.at(i), 5e-4);
    const auto& b = other.update(tray.at(i), 5e-4);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
      ASSERT_EQ(a[k].a, b[k].a);
      ASSERT_EQ(a[k].b, b[k].b);
      ASSERT_EQ(a[k].manifold->count, b[k].manifold->count);
      for (int m = 0; m < a[k].manifold->count; ++m) {
        const auto at = static_cast<std::size_t>(m);
        ASSERT_EQ(a[k].manifold->points[at].id, b[k].manifold->points[at].id);
        ASSERT_EQ(a[k].manifold->points[at].gap, b[k].manifold->points[at].gap);
        ASSERT_EQ(a[k].manifold->points[at].on_a, b[k].manifold->points[at].on_a);
      }
    }
  }
}

// Whatever a world skips by its bounds, a pair without memory does not find either.
TEST(ManifoldMotion, NothingIsMissed) {
  const Tray tray;
  CollisionWorld world(tray.bodies);
  for (int i = 0; i < 120; ++i) {
    const auto poses = tray.at(9 * i);
    std::map<std::pair<int, int>, double> found;
    for (const BodyContact& contact : world.update(poses, 5e-4))
      found[{contact.a, contact.b}] = least_gap(*contact.manifold);
    for (int a = 0; a < static_cast<int>(tray.bodies.size()); ++a)
      for (int b = a + 1; b < static_cast<int>(tray.bodies.size()); ++b) {
        const auto ia = static_cast<std::size_t>(a), ib = static_cast<std::size_t>(b);
        CollisionPair fresh(tray.bodies[ia], tray.bodies[ib]);
        const double least = least_gap(fresh.update(poses[ia], poses[ib], 5e-4));
        const auto known = found.find({a, b});
        ASSERT_EQ(known != found.end(), least < 1)
            << i << " " << a << " " << b << " " << least << " "
            << (known != found.end() ? known->second : 1);
      }
  }
}

}  // namespace
}  // namespace thenar
