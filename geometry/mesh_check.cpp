#include "geometry/mesh_check.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Vector3d, Eigen::Vector3i;

constexpr std::size_t kMaxListedHoles =
    8;  // number of holes that are described; more are only counted

using Edge = std::pair<int, int>;

/// Edges that triangles walk in one direction only, and only one does.
std::vector<Edge> open_edges(const std::vector<MeshSide>& sides) {
  std::vector<Edge> open;
  for_each_edge(sides, [&](const MeshSide* first, const MeshSide* last) {
    if (last - first > 1 || first->low == first->high) return;
    open.emplace_back(first->low, first->high);
    if (!first->upwards) std::swap(open.back().first, open.back().second);
  });
  return open;
}

void check_entries(const TriangleMesh& mesh) {
  require(mesh.vertices.allFinite(), "a mesh has a coordinate that is not finite");
  const auto n = static_cast<int>(mesh.vertices.cols());
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    for (int k = 0; k < 3; ++k)
      require(mesh.triangles(k, t) >= 0 && mesh.triangles(k, t) < n,
              "triangle {} of a mesh names vertex {} of {}", t, mesh.triangles(k, t), n);
}

/// Thinner than a billionth of its longest edge.
bool is_degenerate(const TriangleMesh& mesh, const Vector3i& t) {
  // Compare the area with the largest that rounding leaves.
  const Vector3d a = mesh.vertices.col(t(0)), b = mesh.vertices.col(t(1)),
                 c = mesh.vertices.col(t(2));
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  const Vector3d u = b - a, v = c - a, w = c - b;
  const double area = std::max({u.cross(v).norm(), u.cross(w).norm(), v.cross(w).norm()});
  return !(area > 1e-10 * longest);
}

MeshHole hole_around(const TriangleMesh& mesh, std::vector<int> loop) {
  MeshHole hole;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vector3d p = mesh.vertices.col(loop[i]);
    hole.length += (mesh.vertices.col(loop[(i + 1) % loop.size()]) - p).norm();
    hole.centre += p / static_cast<double>(loop.size());
  }
  hole.loop = std::move(loop);
  return hole;
}

/// Walks along open edges; where it comes back to a vertex the loop since then is a hole.
std::vector<MeshHole> holes_of(const TriangleMesh& mesh, const std::vector<MeshSide>& sides) {
  // Open edges by their start.
  std::vector<Edge> edges = open_edges(sides);
  std::sort(edges.begin(), edges.end());
  std::multimap<int, int> open(edges.begin(), edges.end());  // by where they begin
  std::vector<MeshHole> holes;
  // Follow them; a vertex that comes again closes a loop.
  while (!open.empty()) {
    std::vector<int> way{open.begin()->first};
    for (auto next = open.begin(); next != open.end(); next = open.find(way.back())) {
      const int to = next->second;
      open.erase(next);
      const auto before = std::find(way.begin(), way.end(), to);
      if (before != way.end()) {
        holes.push_back(hole_around(mesh, {before, way.end()}));
        way.erase(before, way.end());
      }
      way.push_back(to);
    }
    if (way.size() > 1) holes.push_back(hole_around(mesh, std::move(way)));  // a way with two ends
  }
  return holes;
}

double volume_of(const TriangleMesh& mesh) {
  double volume = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Vector3d a = mesh.vertices.col(mesh.triangles(0, t));
    const Vector3d b = mesh.vertices.col(mesh.triangles(1, t));
    const Vector3d c = mesh.vertices.col(mesh.triangles(2, t));
    volume += a.dot(b.cross(c)) / 6;
  }
  return volume;
}

/// Returns whether a triangle walks edge k of another in the same direction as this one.
bool same_way(const TriangleMesh& mesh, int t, int k, int other) {
  const int from = mesh.triangles(k, t), to = mesh.triangles((k + 1) % 3, t);
  for (int j = 0; j < 3; ++j)
    if (mesh.triangles(j, other) == from && mesh.triangles((j + 1) % 3, other) == to) return true;
  return false;
}

/// Turns triangles until neighbours across each edge of two agree; returns how many.
int make_agree(TriangleMesh& mesh) {
  const Eigen::Matrix3Xi across = neighbours_across(mesh);
  const auto count = static_cast<int>(mesh.triangles.cols());
  // Visit neighbours breadth-first, from every triangle not seen yet.
  std::vector<bool> seen(count, false), to_turn(count, false);
  for (int first = 0; first < count; ++first) {
    std::vector<int> waiting;
    if (!seen[first]) waiting.push_back(first), seen[first] = true;
    while (!waiting.empty()) {
      const int t = waiting.back();
      waiting.pop_back();
      for (int k = 0; k < 3; ++k) {
        const int other = across(k, t);
        if (other < 0 || seen[other]) continue;
        seen[other] = true;
        waiting.push_back(other);
        to_turn[other] = same_way(mesh, t, k, other) != to_turn[t];
      }
    }
  }
  // Turn those that disagree.
  for (int t = 0; t < count; ++t)
    if (to_turn[t]) std::swap(mesh.triangles(1, t), mesh.triangles(2, t));
  return static_cast<int>(std::count(to_turn.begin(), to_turn.end(), true));
}

/// A fan around the centre of each hole; returns how many.
int close_holes(TriangleMesh& mesh) {
  int closed = 0;
  // Add one vertex and a ring of triangles for each hole.
  for (const MeshHole& hole : holes_of(mesh, sides_by_edge(mesh))) {
    if (hole.loop.size() < 3) continue;
    const auto centre = static_cast<int>(mesh.vertices.cols());
    const auto edges = static_cast<Eigen::Index>(hole.loop.size());
    append_column(mesh.vertices, hole.centre);
    const Eigen::Index old = mesh.triangles.cols();
    mesh.triangles.conservativeResize(3, old + edges);
    for (Eigen::Index i = 0; i < edges; ++i)
      mesh.triangles.col(old + i) << hole.loop[(i + 1) % edges], hole.loop[i], centre;
    ++closed;
  }
  return closed;
}

}  // namespace

MeshReport check_mesh(const TriangleMesh& mesh) {
  check_entries(mesh);
  MeshReport report;
  // Count edges of more than two triangles, and edges that two traverse in the same sense.
  const std::vector<MeshSide> sides = sides_by_edge(mesh);
  for_each_edge(sides, [&](const MeshSide* first, const MeshSide* last) {
    if (first->low == first->high) return;
    if (last - first > 2) ++report.nonmanifold_edges;
    if (last - first == 2 && first->upwards == first[1].upwards) ++report.reversed_edges;
  });
  // Count slivers and holes, and compute the volume of a closed mesh.
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    report.degenerate += is_degenerate(mesh, mesh.triangles.col(t)) ? 1 : 0;
  report.holes = holes_of(mesh, sides);
  if (report.holes.empty()) report.volume = volume_of(mesh);
  return report;
}

std::string describe(const MeshReport& report) {
  std::string text;
  const auto add = [&](int count, const char* what) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : "; ", count, what);
  };
  // List the holes first, the first few in detail.
  add(static_cast<int>(report.holes.size()), "hole(s)");
  for (std::size_t i = 0; i < std::min(report.holes.size(), kMaxListedHoles); ++i) {
    const MeshHole& hole = report.holes[i];
    text += fmt::format("{} {} edges, {:.4g} mm long, about ({:.4g}, {:.4g}, {:.4g}) mm",
                        i == 0 ? ":" : ",", hole.loop.size(), 1e3 * hole.length,
                        1e3 * hole.centre.x(), 1e3 * hole.centre.y(), 1e3 * hole.centre.z());
  }
  if (report.holes.size() > kMaxListedHoles)
    text += fmt::format(" and {} more", report.holes.size() - kMaxListedHoles);
  add(report.nonmanifold_edges, "edge(s) of more than two triangles");
  add(report.reversed_edges, "edge(s) whose triangles face opposite ways");
  add(report.degenerate, "triangle(s) of no area");
  return text;
}

MeshRepair repair_mesh(const TriangleMesh& mesh, MeshHoles holes) {
  check_entries(mesh);
  MeshRepair repair;
  // Sort triangles by their corners, which puts copies next to each other.
  const auto count = static_cast<std::size_t>(mesh.triangles.cols());
  std::vector<std::array<int, 4>> by_corners(count);  // sorted corners, triangle
  for (std::size_t t = 0; t < count; ++t) {
    const Vector3i v = mesh.triangles.col(t);
    by_corners[t] = {v(0), v(1), v(2), static_cast<int>(t)};
    std::sort(by_corners[t].begin(), by_corners[t].begin() + 3);
  }
  std::sort(by_corners.begin(), by_corners.end());
  // Mark the later ones of copies.
  std::vector<bool> again(count, false);
  for (std::size_t i = 1; i < count; ++i)
    if (std::equal(by_corners[i].begin(), by_corners[i].begin() + 3, by_corners[i - 1].begin()))
      again[by_corners[i][3]] = true;
  // Keep the rest, unless it has no area.
  std::vector<Vector3i> kept;
  for (std::size_t t = 0; t < count; ++t) {
    const Vector3i v = mesh.triangles.col(t);
    if (!again[t] && !is_degenerate(mesh, v))
      kept.push_back(v);
    else
      ++repair.dropped;
  }
  repair.mesh = {mesh.vertices, as_columns(kept)};
  // Make triangles agree, close holes, and turn the mesh outwards.
  repair.turned = make_agree(repair.mesh);
  if (holes == MeshHoles::kClose) repair.closed_holes = close_holes(repair.mesh);
  if (volume_of(repair.mesh) < 0) {
    repair.mesh.triangles.row(1).swap(repair.mesh.triangles.row(2));
    repair.turned = static_cast<int>(repair.mesh.triangles.cols()) - repair.turned;
  }
  return repair;
}

}  // namespace thenar
