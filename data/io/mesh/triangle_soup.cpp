#include "data/io/mesh/triangle_soup.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "base/error.h"
#include "geometry/mesh_parts.h"

namespace thenar {
namespace {

// Largest coordinate of a corner; its squares and products stay finite [m]
constexpr int kMaxCoordinate = 1'000'000;
using Eigen::Vector3d, Eigen::Vector3i;

// Distance of corners, over the diagonal of their box, that are equal up to rounding [1]
constexpr double kNearCornerRatio = 1e-6;

struct HashNumbers {
  template <typename T, std::size_t n>
  std::size_t operator()(const std::array<T, n>& key) const {
    std::uint64_t hash = 0;
    for (const T& number : key) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &number, sizeof(T));
      hash = (hash ^ bits) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 29;
    }
    return hash;
  }
};

/// Numbers places: equal places get one number.
class Vertices {
 public:
  int index_of(const Vector3d& p) {
    const std::array<double, 3> key{p.x() + 0.0, p.y() + 0.0, p.z() + 0.0};  // -0 is 0
    const auto [at, is_new] = index_.emplace(key, static_cast<int>(places_.size()));
    if (is_new) places_.push_back(p);
    return at->second;
  }
  [[nodiscard]] const std::vector<Vector3d>& places() const { return places_; }

 private:
  std::unordered_map<std::array<double, 3>, int, HashNumbers> index_;
  std::vector<Vector3d> places_;
};

/// Numbers places: a place within `near` of an earlier one gets its number. Places that are kept
/// lie farther than `near` apart, so that a cell of 4 near has fewer than 200 of them (balls of
/// radius near / 2 do not overlap), however many come.
class NearPlaces {
 public:
  /// @param corner  origin of the cells, below all places and within 1e6 near of them [m]
  NearPlaces(double near, Vector3d corner)
      : near_(near), cell_(4 * near), corner_(std::move(corner)) {}

  /// @param number  for p, if it is not near an earlier place
  int index_of(const Vector3d& p, int number) {
    const Eigen::Array3d from_corner = (p - corner_).array();
    const Cell low = cell_at(from_corner - near_), high = cell_at(from_corner + near_);
    // Look in all cells that the ball around p touches.
    for (int x = low[0]; x <= high[0]; ++x)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int z = low[2]; z <= high[2]; ++z) {
          const auto found = cells_.find({x, y, z});
          if (found == cells_.end()) continue;
          for (const auto& [place, index] : found->second)
            if ((place - p).norm() <= near_) return index;
        }
    cells_[cell_at(from_corner)].push_back({p, number});
    return number;
  }

 private:
  using Cell = std::array<int, 3>;

  [[nodiscard]] Cell cell_at(const Eigen::Array3d& from_corner) const {
    const Eigen::Array3i cell = (from_corner / cell_).floor().cast<int>();
    return {cell.x(), cell.y(), cell.z()};
  }

  double near_, cell_;  // [m]
  Vector3d corner_;
  std::unordered_map<Cell, std::vector<std::pair<Vector3d, int>>, HashNumbers> cells_;
};

TriangleMesh mesh_of(const std::vector<Vector3d>& vertices,
                     const std::vector<Vector3i>& triangles) {
  TriangleMesh mesh{Eigen::Matrix3Xd(3, vertices.size()), Eigen::Matrix3Xi(3, triangles.size())};
  for (std::size_t i = 0; i < vertices.size(); ++i)
    mesh.vertices.col(static_cast<Eigen::Index>(i)) = vertices[i];
  for (std::size_t i = 0; i < triangles.size(); ++i)
    mesh.triangles.col(static_cast<Eigen::Index>(i)) = triangles[i];
  return mesh;
}

using Corners = std::array<Vector3d, 3>;

/// Mesh of some triangles, with corners at exactly the same place merged.
TriangleMesh merged(const std::vector<Corners>& soup, const std::vector<std::size_t>& numbers) {
  Vertices vertices;
  std::vector<Vector3i> triangles;
  for (const std::size_t i : numbers) {
    Vector3i t;
    for (int k = 0; k < 3; ++k) t(k) = vertices.index_of(soup[i][k]);
    // Triangles with two equal corners have no area.
    if (t(0) != t(1) && t(1) != t(2) && t(2) != t(0)) triangles.push_back(t);
  }
  return mesh_of(vertices.places(), triangles);
}

struct Defects {
  int open = 0;     // edges of a single triangle
  int crowded = 0;  // edges of more than two triangles
};

Defects defects_of(const TriangleMesh& mesh) {
  Defects found;
  for_each_edge(sides_by_edge(mesh), [&](const MeshSide* first, const MeshSide* last) {
    found.open += last - first == 1 ? 1 : 0;
    found.crowded += last - first > 2 ? 1 : 0;
  });
  return found;
}

/// The mesh with corners on open edges merged that are equal up to rounding, if that is an
/// improvement.
TriangleMesh closed_up(TriangleMesh mesh, double near) {
  const Defects before = defects_of(mesh);
  if (before.open == 0 || !(near > 0)) return mesh;
  // Only corners on open edges may move.
  std::vector<bool> loose(static_cast<std::size_t>(mesh.vertices.cols()), false);
  for_each_edge(sides_by_edge(mesh), [&](const MeshSide* first, const MeshSide* last) {
    if (last - first == 1) loose[first->low] = true;
    if (last - first == 1) loose[first->high] = true;
  });
  // Each such corner stands for the first one near it.
  NearPlaces places(near, mesh.vertices.rowwise().minCoeff());
  std::vector<int> stands_for(loose.size());
  for (std::size_t i = 0; i < loose.size(); ++i) {
    const auto v = static_cast<int>(i);
    stands_for[i] = loose[i] ? places.index_of(mesh.vertices.col(v), v) : v;
  }
  // Renumber the triangles; short edges vanish.
  Vertices kept;
  std::vector<Vector3i> triangles;
  for (const auto& old : mesh.triangles.colwise()) {
    const Vector3i t = old.unaryExpr([&](int v) { return stands_for[v]; });
    if (t(0) == t(1) || t(1) == t(2) || t(2) == t(0)) continue;  // an edge shorter than `near`
    triangles.emplace_back(t.unaryExpr([&](int v) { return kept.index_of(mesh.vertices.col(v)); }));
  }
  if (triangles.empty()) return mesh;
  // Keep the result only if edges were closed and none crowded.
  TriangleMesh welded = mesh_of(kept.places(), triangles);
  const Defects after = defects_of(welded);
  return after.open < before.open && after.crowded <= before.crowded ? welded : mesh;
}

/// Divides triangles into parts: first the closed surfaces that the vertex numbers of the file
/// separate, then those that consecutive triangles close, then the rest.
class PartFinder {
 public:
  /// @param near  distance within which corners are equal; 0: exactly the same place [m]
  /// @param numbers  vertex numbers of the file, three a triangle; may be empty
  /// @param corner  lower corner of the box around the soup [m]
  PartFinder(const std::vector<Corners>& soup, const std::vector<int>& numbers, double near,
             const Vector3d& corner) {
    Vertices vertices;
    NearPlaces places(near, corner);
    // Number the corners, near ones alike.
    std::vector<int> stands_for;  // of each vertex
    for (const Corners& corners : soup)
      for (std::size_t k = 0; k < 3; ++k) {
        const int v = vertices.index_of(corners[k]);
        if (v == static_cast<int>(stands_for.size()))
          stands_for.push_back(near > 0 ? places.index_of(corners[k], v) : v);
        corners_.push_back(static_cast<std::uint64_t>(stands_for[v]));
      }
    // Groups by the file's own vertices are parts if they are closed.
    std::vector<std::size_t> rest;
    for (std::vector<std::size_t>& group : groups_by(numbers, soup.size())) {
      if (is_closed(group))
        parts_.push_back(std::move(group));
      else
        rest.insert(rest.end(), group.begin(), group.end());
    }
    // The rest is divided where consecutive triangles close a surface.
    std::sort(rest.begin(), rest.end());
    split_where_closed(rest);
  }

  /// Indices of the triangles of each part.
  [[nodiscard]] const std::vector<std::vector<std::size_t>>& parts() const { return parts_; }

 private:
  using OpenEdges = std::unordered_set<std::uint64_t>;  // edges of an odd number of triangles

  void walk(std::size_t triangle, OpenEdges& open) const {
    const std::uint64_t* v = &corners_[3 * triangle];
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) return;
    // Every second triangle at an edge closes it.
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t a = v[k], b = v[(k + 1) % 3];
      const std::uint64_t edge = std::min(a, b) << 32U | std::max(a, b);
      if (!open.insert(edge).second) open.erase(edge);
    }
  }

  [[nodiscard]] bool is_closed(const std::vector<std::size_t>& triangles) const {
    if (triangles.size() < 4) return false;
    OpenEdges open;
    for (const std::size_t t : triangles) walk(t, open);
    return open.empty();
  }

  /// Triangles connected by the file's vertices; each by itself if it has none.
  static std::vector<std::vector<std::size_t>> groups_by(const std::vector<int>& numbers,
                                                         std::size_t count) {
    std::vector<std::vector<std::size_t>> groups;
    if (numbers.size() != 3 * count) {
      for (std::size_t t = 0; t < count; ++t) groups.push_back({t});
      return groups;
    }
    // Union-find over the vertex numbers.
    std::vector<int> above(static_cast<std::size_t>(
        count == 0 ? 0 : *std::max_element(numbers.begin(), numbers.end()) + 1));
    std::iota(above.begin(), above.end(), 0);
    const auto top = [&](int v) {
      for (auto i = static_cast<std::size_t>(v); above[i] != v; i = static_cast<std::size_t>(v))
        v = above[i] = above[above[i]];
      return v;
    };
    for (std::size_t i = 0; i < numbers.size(); ++i)
      above[top(numbers[i])] = top(numbers[i - i % 3]);
    // One group for each root, in the order of the triangles.
    std::unordered_map<int, std::size_t> group_of;
    for (std::size_t t = 0; t < count; ++t) {
      const auto [at, is_new] = group_of.emplace(top(numbers[3 * t]), groups.size());
      if (is_new) groups.emplace_back();
      groups[at->second].push_back(t);
    }
    return groups;
  }

  void split_where_closed(const std::vector<std::size_t>& triangles) {
    OpenEdges open;
    std::vector<std::size_t> part;
    for (const std::size_t t : triangles) {
      walk(t, open);
      part.push_back(t);
      if (!open.empty() || part.size() < 4) continue;
      parts_.push_back(std::move(part));
      part.clear();
    }
    if (!part.empty()) parts_.push_back(std::move(part));
  }

  std::vector<std::uint64_t> corners_;  // three a triangle
  std::vector<std::vector<std::size_t>> parts_;
};

/// Mesh in which every part has vertices of its own.
TriangleMesh in_parts(const std::vector<Corners>& soup, const std::vector<int>& numbers,
                      double part_near, double near, const Vector3d& corner) {
  std::vector<TriangleMesh> parts;
  const PartFinder finder(soup, numbers, part_near, corner);
  for (const std::vector<std::size_t>& triangles : finder.parts()) {
    TriangleMesh part = merged(soup, triangles);
    if (!part.empty()) parts.push_back(closed_up(std::move(part), near));
  }
  return parts.empty() ? TriangleMesh{} : joined(parts);
}

/// Triangles of scaled corners, all finite and not too far away.
std::vector<Corners> scaled(const TriangleSoup& soup, double scale, const std::string& path) {
  std::vector<Corners> triangles;
  for (std::size_t i = 0; i + 2 < soup.corners.size(); i += 3) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = scale * soup.corners[i + k];
      if (!corners[k].allFinite())
        throw DataError(path, 1, fmt::format("triangle {} has a corner that is not finite", i / 3));
      if (corners[k].cwiseAbs().maxCoeff() > kMaxCoordinate)
        throw DataError(path, 1,
                        fmt::format("triangle {} has a corner beyond {} m", i / 3, kMaxCoordinate));
    }
    triangles.push_back(corners);
  }
  return triangles;
}

}  // namespace

TriangleMesh weld_vertices(const TriangleSoup& soup, double scale, const std::string& path) {
  const std::vector<Corners> triangles = scaled(soup, scale, path);
  Eigen::AlignedBox3d box;
  for (const Corners& corners : triangles)
    for (const Vector3d& corner : corners) box.extend(corner);
  const double near = triangles.empty() ? 0 : kNearCornerRatio * box.diagonal().norm();
  // Three attempts: parts by exact corners, parts by near corners, and everything merged, as a
  // surface may continue from one that was closed before. The fewest open edges win.
  std::vector<std::size_t> all(triangles.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  TriangleMesh best;
  int least = std::numeric_limits<int>::max();
  for (int attempt = 0; attempt < 3 && least > 0 && near > 0; ++attempt) {
    TriangleMesh mesh =
        attempt < 2 ? in_parts(triangles, soup.vertices, attempt == 0 ? 0 : near, near, box.min())
                    : closed_up(merged(triangles, all), near);
    const int open = defects_of(mesh).open;
    if (mesh.empty() || open >= least) continue;
    best = std::move(mesh);
    least = open;
  }
  if (best.empty()) throw DataError(path, 1, "wanted a surface, got a file without triangles");
  return best;
}

}  // namespace thenar
