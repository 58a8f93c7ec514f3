// Links of robots as solids: outside their boxes everything is outside, inside them the winding
// number decides, computed anew from solid angles. Robots of data/, made-up hands of meshes with
// faults, and what import writes of these. THENAR_HANDS hands, 4 unless it is set: long_solids.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "api/grasp.h"
#include "api/import.h"
#include "api/validate.h"
#include "geometry/mesh_from_distance.h"
#include "geometry/primitives.h"
#include "geometry/solid.h"
#include "grasp/closing/clearance.h"
#include "tests/api/made_up_mesh_hands.h"
#include "tests/data_folder.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// How often a surface goes round a point: solid angles of its triangles over 4 pi.
/// Source: [VanOosterom1983].
double turns_about(const TriangleMesh& mesh, const Vector3d& p) {
  double sum = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Vector3d a = mesh.vertices.col(mesh.triangles(0, t)) - p;
    const Vector3d b = mesh.vertices.col(mesh.triangles(1, t)) - p;
    const Vector3d c = mesh.vertices.col(mesh.triangles(2, t)) - p;
    sum += 2 * std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                                 b.dot(c) * a.norm() + c.dot(a) * b.norm());
  }
  return sum / (4 * kPi);
}

/// Inside one of the surfaces that a solid consists of, balls and capsules by their cores.
bool is_inside(const Solid& solid, const Vector3d& p) {
  for (const RoundedMesh& part : solid.collision) {
    if (part.radius == 0 && turns_about(part.core, p) > 0.5) return true;
    if (part.radius == 0) continue;
    const Vector3d a = part.core.vertices.col(0);
    const Vector3d along = Vector3d(part.core.vertices.rightCols(1)) - a;
    const double share = along.isZero(0) ? 0 : (p - a).dot(along) / along.squaredNorm();
    if ((p - a - std::clamp(share, 0.0, 1.0) * along).norm() < part.radius) return true;
  }
  return false;
}

struct Count {
  int points = 0;
  int wrong = 0;
};

/// 1,000 points outside of the box, up to a thousand of its lengths away, and 1,000 in it.
/// @param near  where points say nothing: the surface of windings differs by so much [m]
void count_signs(const Solid& solid, double near, std::mt19937& rng, Count& count) {
  const Eigen::AlignedBox3d box = solid.shape->bounds();
  const double longest = box.sizes().maxCoeff();
  for (int i = 0; i < 1000;) {
    const double far = std::pow(1000.0, uniform(rng));
    const Vector3d p = box.center() + far * longest * random_in_cube(rng);
    if (box.contains(p)) continue;
    ++i, ++count.points;
    count.wrong += solid.shape->distance(p) < 0 ? 1 : 0;
  }
  for (int i = 0; i < 1000; ++i) {
    const Vector3d p = box.center() + 0.5 * random_in_cube(rng).cwiseProduct(box.sizes());
    const double distance = solid.shape->distance(p);
    if (std::abs(distance) < near) continue;
    ++count.points;
    count.wrong += (distance < 0) != is_inside(solid, p) ? 1 : 0;
  }
}

Count signs_of(const RobotSpec& robot, double near) {
  Count count;
  std::mt19937 rng(1);
  for (const RobotLink& link : robot.links)
    if (!link.shapes.empty()) count_signs(build_solid(link.shapes), near, rng, count);
  return count;
}

Imported imported(const std::string& file) {
  ImportRequest request;
  request.file = file;
  return import_file(request);
}

const RobotSpec& robot_of(const Imported& imported) { return std::get<RobotSpec>(imported.thing); }

// Curved primitives are tessellated to 0.02 mm or 1.5e-4 of their extent.
TEST(LinkSolids, OfEveryRobotHaveTheSignOfWindings) {
  for (const auto& entry : std::filesystem::directory_iterator(kData + "/robots")) {
    const Count count = signs_of(robot_of(imported(entry.path().string())), 1.5e-4);
    EXPECT_EQ(count.wrong, 0) << "of " << count.points << ", " << entry.path();
  }
}

int hulls_named(const std::vector<std::string>& warnings) {
  int hulls = 0;
  for (const std::string& warning : warnings)
    for (std::size_t at = 0; (at = warning.find("convex hull", at)) != std::string::npos; ++at)
      ++hulls;
  return hulls;
}

/// Whether a coordinate has something on one side of it, or part of the hand on both, that touches.
bool has_partner(const PosedCollisionHand& posed, const std::vector<Clearance>& touching,
                 Eigen::Index coordinate) {
  const auto moves = [&](int surface) {
    return surface >= 0 && posed.collision_hand.moved_by(surface, coordinate);
  };
  return std::any_of(touching.begin(), touching.end(), [&](const Clearance& pair) {
    return moves(pair.surface) != (pair.body == nullptr && moves(pair.other));
  });
}

/// Contacts that stopped a coordinate, where nothing touches.
int stops_without_partner(const GraspResult& result) {
  constexpr double kTouch = 5e-4;  // several times the accuracy of closing [m]
  const Grasp& grasp = result.grasp;
  const PosedCollisionHand posed{result.collision_hand, grasp.approached.X_WH,
                                 result.collision_hand.hand->pose(grasp.closed.q)};
  std::vector<Clearance> pairs = find_clearances(posed, result.setting.setup);
  for (const SurfacePair& pair : result.collision_hand.self_pairs)
    pairs.push_back({pair.a, pair.b});
  std::vector<Clearance> touching;
  for (Clearance& pair : pairs)
    if (measure_clearance(pair, posed, kTouch / 4, 2 * kTouch).distance <= kTouch)
      touching.push_back(pair);
  int alone = 0;
  for (std::size_t j = 0; j < grasp.closed.stopped.size(); ++j)
    if (grasp.closed.stopped[j] == StoppedBy::kContact &&
        !has_partner(posed, touching, static_cast<Eigen::Index>(j)))
      ++alone;
  return alone;
}

/// The hand of a file, whose fingers stand up, over a ball.
GraspResult grasp_of(const std::string& folder, const std::string& hand) {
  write_file(
      folder + "/world.toml",
      "name = 'w'\nsource = 'S'\n[sources]\nS = 'made up'\n[[hand]]\nname = 'h'\nfile = '" + hand +
          "'\nposition_mm = [0, 0, 300]\nrpy_deg = [180, 0, 0]\n[[body]]\nrole = 'object'\n"
          "name = 'ball'\nmaterial = 'wood'\n[[body.shape]]\nkind = 'sphere'\nsize_mm = [20]\n");
  GraspRequest request;
  request.world.world = folder + "/world.toml";
  request.world.data = kData;
  return measure_grasp(request);
}

class MadeUpHands : public TemporaryFolder {};

TEST_F(MadeUpHands, HaveTheSignOfWindingsAlsoAsWritten) {
  const char* asked = std::getenv("THENAR_HANDS");
  const int hands = asked ? std::stoi(asked) : 4;
  int bodies = 0, hulls = 0;
  for (int seed = 0; seed < hands; ++seed) {
    const std::string folder = path(std::to_string(seed));
    bodies += write_made_up_mesh_hand(folder, static_cast<unsigned>(seed));
    const Imported hand = imported(folder + "/hand.urdf");
    const Count read = signs_of(robot_of(hand), 1e-9);
    EXPECT_EQ(read.wrong, 0) << "of " << read.points << ", hand " << seed;
    hulls += hulls_named(hand.outcome.warnings);
    if (std::getenv("SHOW"))
      for (auto& w : hand.outcome.warnings) std::puts(w.c_str());
    // As written: accepted, and the same.
    const std::string out = folder + "/written.toml";
    (void)write_imported(hand, out);
    ValidateRequest request;
    request.things = {out};
    const FileVerdict verdict = validate(request).files.front();
    EXPECT_TRUE(verdict.valid()) << verdict.error << ", hand " << seed;
    if (!verdict.valid()) continue;
    const Count written = signs_of(robot_of(imported(out)), 1e-9);
    EXPECT_EQ(written.wrong, 0) << "of " << written.points << ", hand " << seed;
    EXPECT_EQ(stops_without_partner(grasp_of(folder, "written.toml")), 0) << "hand " << seed;
  }
  EXPECT_LT(hulls, 0.05 * bodies) << "of " << bodies;
}

}  // namespace
}  // namespace thenar
