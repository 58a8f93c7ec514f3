#include "geometry/repair_to_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "base/cache.h"
#include "base/error.h"
#include "base/lists.h"
#include "geometry/cached_mesh.h"
#include "geometry/mesh_check.h"
#include "geometry/mesh_faults.h"
#include "geometry/mesh_parts.h"

namespace thenar {
namespace {

using Eigen::Vector3d, Eigen::Vector3i;

const char* const kLeftOut = "part(s) that enclose nothing left out";

/// Corners within `near` of one that came before become that one [m].
TriangleMesh welded(const TriangleMesh& mesh, double near) {
  std::map<std::array<long, 3>, std::vector<int>> cells;
  std::vector<int> stands_for(static_cast<std::size_t>(mesh.vertices.cols()));
  const Vector3d low = mesh.vertices.rowwise().minCoeff();
  // Use cells of the tolerance's size: only neighbouring cells can contain a corner that is near.
  for (int i = 0; i < static_cast<int>(stands_for.size()); ++i) {
    const Vector3d p = mesh.vertices.col(i);
    const Eigen::Array<long, 3, 1> cell = ((p - low) / near).array().floor().cast<long>();
    int found = i;
    for (int n = 0; n < 27 && found == i; ++n) {
      const auto at =
          cells.find({cell(0) + n % 3 - 1, cell(1) + n / 3 % 3 - 1, cell(2) + n / 9 - 1});
      if (at == cells.end()) continue;
      for (const int other : at->second)
        if ((mesh.vertices.col(other) - p).norm() <= near) found = other;
    }
    stands_for[i] = found;
    if (found == i) cells[{cell(0), cell(1), cell(2)}].push_back(i);
  }
  // Keep triangles with three different corners.
  std::vector<Vector3i> kept;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Vector3i v = mesh.triangles.col(t).unaryExpr([&](int i) { return stands_for[i]; });
    if (v(0) != v(1) && v(1) != v(2) && v(2) != v(0)) kept.push_back(v);
  }
  return {mesh.vertices, as_columns(kept)};
}

/// Edges of one triangle only, and that triangle.
std::map<std::pair<int, int>, int> open_edges(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, std::pair<int, int>> uses;  // how often, and by whom
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    for (int k = 0; k < 3; ++k) {
      auto& use = uses[std::minmax({mesh.triangles(k, t), mesh.triangles((k + 1) % 3, t)})];
      ++use.first;
      use.second = static_cast<int>(t);
    }
  std::map<std::pair<int, int>, int> open;
  for (const auto& [edge, use] : uses)
    if (use.first == 1) open.emplace(edge, use.second);
  return open;
}

/// Finds the smallest tolerance that leaves the fewest edges open.
TriangleMesh best_welded(const TriangleMesh& mesh) {
  TriangleMesh best;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const double share : {1e-6, 1e-5, 1e-4}) {
    TriangleMesh now = welded(mesh, share * diagonal_of(mesh));
    const std::size_t open = open_edges(now).size();
    if (open < least && !now.empty()) {
      best = std::move(now);
      least = open;
    }
  }
  return best;
}

/// Vertices of open edges, by x.
using Loose = std::multimap<double, int>;

/// Returns the vertices within `near` of the inside of an edge, in order along it.
std::vector<int> vertices_on(const TriangleMesh& mesh, const Loose& loose, int a, int b,
                             double near) {
  // Visit loose vertices whose x lies in the range of the edge.
  const Vector3d p = mesh.vertices.col(a), way = mesh.vertices.col(b) - p;
  const double length = way.norm();
  std::vector<std::pair<double, int>> on;
  const auto last = loose.upper_bound(std::max(p.x(), p.x() + way.x()) + near);
  for (auto at = loose.lower_bound(std::min(p.x(), p.x() + way.x()) - near); at != last; ++at) {
    // Keep those along the edge's inside, and near it.
    const Vector3d r = mesh.vertices.col(at->second) - p;
    const double along = r.dot(way) / length;
    if (at->second != a && at->second != b && along > near && along < length - near &&
        (r - along / length * way).norm() <= near)
      on.emplace_back(along, at->second);
  }
  std::sort(on.begin(), on.end());
  return transformed(on, [](const auto& each) { return each.second; });
}

/// Returns the number of a triangle's edge between two of its vertices.
int edge_number(const TriangleMesh& mesh, int t, const std::pair<int, int>& edge) {
  int k = 0;
  while (std::minmax({mesh.triangles(k, t), mesh.triangles((k + 1) % 3, t)}) != edge) ++k;
  return k;
}

/// Ends of edges, by x.
Loose ends_of(const TriangleMesh& mesh, const std::map<std::pair<int, int>, int>& open) {
  std::set<int> ends;
  for (const auto& [edge, t] : open) ends.insert({edge.first, edge.second});
  Loose loose;
  for (const int v : ends) loose.emplace(mesh.vertices(0, v), v);
  return loose;
}

/// Cuts triangles whose open edge others end on; returns how many.
int cut_at_corners(TriangleMesh& mesh) {
  const double near = 2e-6 * diagonal_of(mesh);
  int cuts = 0;
  // Repeat, because cutting makes new edges.
  for (int round = 0; round < 8; ++round) {
    const auto open = open_edges(mesh);
    const Loose loose = ends_of(mesh, open);
    std::set<int> cut;
    std::vector<Vector3i> made;
    // Cut each triangle once per round, at its first edge that contains other corners.
    for (const auto& [edge, t] : open) {
      if (cut.count(t) != 0) continue;
      const int k = edge_number(mesh, t, edge);
      const int a = mesh.triangles(k, t), b = mesh.triangles((k + 1) % 3, t),
                c = mesh.triangles((k + 2) % 3, t);
      std::vector<int> on = vertices_on(mesh, loose, a, b, near);
      erase_where(on, [&](int vertex) { return vertex == c; });
      if (on.empty()) continue;
      cut.insert(t);
      on.push_back(b);
      int from = a;
      for (const int to : on) made.emplace_back(from, to, c), from = to;
    }
    // Keep triangles that were not cut.
    if (cut.empty()) break;
    cuts += static_cast<int>(cut.size());
    for (int t = 0; t < static_cast<int>(mesh.triangles.cols()); ++t)
      if (cut.count(t) == 0) made.emplace_back(mesh.triangles.col(t));
    mesh.triangles = as_columns(made);
  }
  return cuts;
}

/// Pairs of triangles on the same corners that face each other: a wall within, or a sheet.
TriangleMesh without_walls(const TriangleMesh& mesh) {
  std::map<std::array<int, 3>, std::array<std::vector<int>, 2>> at;  // by the way they face
  // Group triangles by their corners and the side that they face.
  for (int t = 0; t < static_cast<int>(mesh.triangles.cols()); ++t) {
    const Vector3i v = mesh.triangles.col(t);
    std::array<int, 3> sorted{v(0), v(1), v(2)};
    std::sort(sorted.begin(), sorted.end());
    const bool even = (v(0) < v(1)) == (v(1) < v(2)) ? v(0) < v(1) : v(2) < v(0);
    at[sorted][even ? 0 : 1].push_back(t);
  }
  // Keep one of those on the same corners, and none if they face both sides.
  std::vector<Vector3i> kept;
  for (const auto& [corners, ways] : at) {
    if (!ways[0].empty() && !ways[1].empty()) continue;
    kept.emplace_back(mesh.triangles.col((ways[0].empty() ? ways[1] : ways[0]).front()));
  }
  return {mesh.vertices, as_columns(kept)};
}

/// Description of the repairs that were made.
class Done {
 public:
  void add(int count, const std::string& what) {
    if (count > 0) add(fmt::format("{} {}", count, what));
  }
  void add(const std::string& what) { text_ += (text_.empty() ? "" : ", ") + what; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

RepairedSolid hull_of(const TriangleMesh& mesh) {
  RepairedSolid hull{hull_mesh(mesh.vertices), "replaced by its convex hull"};
  require(
      !hull.mesh.empty(),
      "a mesh bounds no solid, and its convex hull is thinner than a ten-thousandth of its extent");
  return hull;
}

/// A part of a mesh that bounds a solid.
struct SoundPart {
  TriangleMesh mesh;  // empty: the part encloses nothing
  bool hull = false;  // it is the part's convex hull
  int holes = 0;      // that were closed
};

/// A part as it is, repaired, or its hull if it cannot be closed.
/// @param whole  diagonal of the mesh [m]
SoundPart sound_part(const TriangleMesh& part, const MeshReport& before, double whole) {
  MeshRepair repair = repair_mesh(part);
  const MeshReport report = check_mesh(repair.mesh);
  if (!report.watertight()) return {hull_mesh(part.vertices), /*hull=*/true, 0};
  if (is_sliver(report.volume, diagonal_of(repair.mesh), whole)) return {};
  // Keep the sense of a part that was closed: it may be a cavity.
  if (before.watertight()) return {part, /*hull=*/false, repair.closed_holes};
  return {std::move(repair.mesh), /*hull=*/false, repair.closed_holes};
}

/// "part 2 of 5, 18 x 9 x 4 mm about (1, 2, 3) mm, replaced by its convex hull".
std::string hull_words(const TriangleMesh& part, std::size_t number, std::size_t count) {
  const Vector3d low = part.vertices.rowwise().minCoeff(),
                 high = part.vertices.rowwise().maxCoeff();
  const Vector3d size = 1e3 * (high - low), centre = 1e3 * (high + low) / 2;
  return fmt::format(
      "part {} of {}, {:.3g} x {:.3g} x {:.3g} mm about ({:.4g}, {:.4g}, {:.4g}) mm, replaced by "
      "its convex hull",
      number, count, size.x(), size.y(), size.z(), centre.x(), centre.y(), centre.z());
}

/// Part for part: closed, or its hull, or left out.
RepairedSolid closed(const TriangleMesh& mesh, const TriangleMesh& given, Done done) {
  std::vector<TriangleMesh> solids;
  double left_out = 0;  // area [m^2]
  int flat = 0, holes = 0;
  double longest = 0;  // hole [m]
  std::vector<std::string> hulls;
  const double all = area_of(mesh), whole = diagonal_of(mesh);
  // Repair each part, replace it by its hull, or leave it out.
  const std::vector<TriangleMesh> parts = connected_parts(mesh);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const MeshReport before = check_mesh(parts[i]);
    for (const MeshHole& hole : before.holes) longest = std::max(longest, hole.length);
    SoundPart sound = sound_part(parts[i], before, whole);
    if (sound.mesh.empty()) {
      ++flat;
      left_out += area_of(parts[i]);
      continue;
    }
    solids.push_back(std::move(sound.mesh));
    if (sound.hull) hulls.push_back(hull_words(parts[i], i + 1, parts.size()));
    holes += sound.holes;
  }
  // Return the hull if too little is left of the mesh.
  if (solids.empty() || left_out > 0.5 * all) return hull_of(given);
  if (holes > 0)
    done.add(fmt::format("{} hole(s) closed, the longest {:.4g} mm around", holes, 1e3 * longest));
  done.add(flat, kLeftOut);
  for (const std::string& hull : hulls) done.add(hull);
  return {joined(solids), done.text()};
}

/// A mesh that bounds no solid, whatever it takes.
RepairedSolid mended(const TriangleMesh& mesh) {
  // Merge corners at the same place first.
  const TriangleMesh merged = best_welded(mesh);
  if (merged.empty()) return hull_of(mesh);
  Done merging;
  if (merged.triangles.cols() != mesh.triangles.cols() || merged.triangles != mesh.triangles)
    merging.add("corners at the same place joined");
  std::vector<RepairedSolid> tries;
  // Try with inner walls, then without them.
  for (const bool walls : {true, false}) {
    Done done = merging;
    const MeshRepair repair = repair_mesh(walls ? merged : without_walls(merged), MeshHoles::kKeep);
    if (repair.mesh.empty()) break;
    done.add(repair.dropped, "triangle(s) of no area or there twice dropped");
    done.add(repair.turned, "triangle(s) turned");
    if (!walls) done.add("walls within left out");
    // Cut triangles at corners of others; is it a solid now?
    TriangleMesh now = repair.mesh;
    done.add(cut_at_corners(now), "triangle(s) cut where corners of others lie on them");
    if (const auto solids = solids_or_none(now); !solids.empty())
      return {joined(solids), done.text()};
    // NOLINTNEXTLINE(readability-suspicious-call-argument): `now` was made from `mesh`
    tries.push_back(closed(now, mesh, done));
  }
  // Otherwise part by part, and at last the hull of the whole.
  for (RepairedSolid& mended : tries)
    if (const auto solids = solids_or_none(mended.mesh); !solids.empty())
      return {joined(solids), std::move(mended.done)};
  return hull_of(mesh);
}

/// A mesh that solid_parts() takes, without slivers that this has left out.
RepairedSolid without_slivers(const TriangleMesh& mesh, const std::vector<TriangleMesh>& solids) {
  Eigen::Index triangles = 0;
  for (const TriangleMesh& solid : solids) triangles += solid.triangles.cols();
  if (triangles == mesh.triangles.cols() || !check_mesh(mesh).watertight()) return {mesh, ""};
  TriangleMesh kept = joined(solids);
  Done done;
  done.add(static_cast<int>(connected_parts(mesh).size() - connected_parts(kept).size()), kLeftOut);
  return {std::move(kept), done.text()};
}

}  // namespace

RepairedSolid repair_to_solid(const TriangleMesh& mesh) {
  require(!mesh.empty(), "a mesh has no triangle");
  (void)check_mesh(mesh);
  if (const auto solids = solids_or_none(mesh); !solids.empty())
    return without_slivers(mesh, solids);
  require(
      !is_flat(mesh),
      "the mesh is flat: all its triangles lie in one plane, and no repair gives it a thickness");
  // Large meshes are kept on disk with the words of their repair.
  // Triangles from which mending takes longer than looking up
  constexpr Eigen::Index kManyTriangles = 2000;
  if (mesh.triangles.cols() < kManyTriangles) return mended(mesh);
  const std::string input = bytes_of(mesh), kind = "mended mesh 2";
  if (const std::optional<std::string> entry = find_cached(kind, input)) {
    const std::size_t end = std::min(entry->find('\n'), entry->size() - 1);
    if (std::optional<TriangleMesh> known = mesh_of(entry->substr(end + 1)))
      return {std::move(*known), entry->substr(0, end)};
  }
  RepairedSolid now = mended(mesh);
  store_cached(kind, input, now.done + "\n" + bytes_of(now.mesh));
  return now;
}

RepairedSolid watertight_mesh(const TriangleMesh& mesh) {
  RepairedSolid mended = repair_to_solid(mesh);
  // Check whether it needs more repair.
  const MeshReport before = check_mesh(mended.mesh);
  TriangleMesh sound = joined(solid_parts(mended.mesh));
  const double volume = check_mesh(sound).volume;
  if (before.watertight() && std::abs(volume - before.volume) <= 1e-12 * volume) return mended;
  Done done;
  if (!mended.done.empty()) done.add(mended.done);
  done.add(before.watertight() ? "turned right side out" : "put right: " + describe(before));
  return {std::move(sound), done.text()};
}

}  // namespace thenar
