#include "geometry/mesh_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "base/error.h"
#include "geometry/mesh_faults.h"
#include "geometry/triangle_tree.h"
#include "geometry/winding_number.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

// Parts with a smaller volume over their own diagonal cubed are slivers [1]
constexpr double kFlatVolume = 1e-9;
// Parts with a smaller volume over the whole diagonal cubed are slivers [1]
constexpr double kLostVolume = 1e-13;

/// @param number  of each vertex of the mesh, -1; left so
TriangleMesh taken_out(const TriangleMesh& mesh, const std::vector<int>& triangles,
                       std::vector<int>& number) {
  // Number corners as they occur.
  TriangleMesh part{{}, Eigen::Matrix3Xi(3, triangles.size())};
  std::vector<int> vertices;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const int old = mesh.triangles(k, triangles[i]);
      int& now = number[old];
      if (now < 0) {
        now = static_cast<int>(vertices.size());
        vertices.push_back(old);
      }
      part.triangles(k, static_cast<Eigen::Index>(i)) = now;
    }
  // Copy the vertices in that order, and reset the numbers.
  part.vertices = mesh.vertices(Eigen::all, vertices);
  for (const int vertex : vertices) number[vertex] = -1;
  return part;
}

void turn(TriangleMesh& mesh) { mesh.triangles.row(1).swap(mesh.triangles.row(2)); }

/// A closed surface, and what it encloses.
struct Part {
  TriangleMesh mesh;
  double volume = 0;  // negative: it faces inwards [m^3]
  Eigen::AlignedBox3d box = {};
  std::optional<internal::TriangleTree> tree = {};  // made when it is asked for
};

/// Returns whether a part lies within another, by the box and up to 64 of its vertices.
bool is_within(const Part& inner, Part& outer) {
  // Compare boxes first, then winding numbers of some vertices.
  if (!outer.box.contains(inner.box)) return false;
  if (!outer.tree) outer.tree.emplace(outer.mesh);
  const Eigen::Index count = inner.mesh.vertices.cols();
  const Eigen::Index step = std::max<Eigen::Index>(1, count / 64);
  for (Eigen::Index i = 0; i < count; i += step)
    if (internal::winding_number(*outer.tree, inner.mesh.vertices.col(i)) < 1) return false;
  return true;
}

/// @throws InputError saying why a mesh without holes encloses nothing
[[noreturn]] void fail_without_volume(const TriangleMesh& mesh) {
  throw InputError("a mesh bounds no solid: " +
                   (is_flat(mesh) ? describe(find_mesh_faults(mesh)) : "no volume"));
}

Part closed_part(TriangleMesh mesh) {
  const MeshReport report = check_mesh(mesh);
  require(report.watertight(), "a mesh bounds no solid: {}", describe(report));
  Part part{std::move(mesh), report.volume};
  for (const auto& p : part.mesh.vertices.colwise()) part.box.extend(Vector3d(p));
  return part;
}

/// Puts cavities to the smallest part around them, turns all else outwards.
std::vector<TriangleMesh> outward(std::vector<Part> parts) {
  // Sort smaller parts first, so that a cavity finds the smallest part around it.
  std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
    return std::abs(a.volume) < std::abs(b.volume);
  });
  std::vector<std::vector<std::size_t>> cavities(parts.size());
  std::vector<bool> is_cavity(parts.size(), false);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = i + 1; j < parts.size() && parts[i].volume < 0 && !is_cavity[i]; ++j)
      if (parts[j].volume > 0 && is_within(parts[i], parts[j])) {
        cavities[j].push_back(i);
        is_cavity[i] = true;
      }
    if (parts[i].volume < 0 && !is_cavity[i]) turn(parts[i].mesh);
  }
  // Join each solid with its cavities.
  std::vector<TriangleMesh> solids;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (is_cavity[i]) continue;
    std::vector<TriangleMesh> shells{std::move(parts[i].mesh)};
    for (const std::size_t cavity : cavities[i]) shells.push_back(std::move(parts[cavity].mesh));
    solids.push_back(joined(shells));
  }
  return solids;
}

}  // namespace

double diagonal_of(const TriangleMesh& mesh) {
  return (mesh.vertices.rowwise().maxCoeff() - mesh.vertices.rowwise().minCoeff()).norm();
}

bool is_sliver(double volume, double own, double whole) {
  return std::abs(volume) <=
         std::max(kFlatVolume * std::pow(own, 3), kLostVolume * std::pow(whole, 3));
}

TriangleMesh joined(const std::vector<TriangleMesh>& parts) {
  if (parts.size() == 1) return parts.front();
  // Allocate vertices and triangles of all parts.
  Eigen::Index vertices = 0, triangles = 0;
  for (const TriangleMesh& part : parts) {
    vertices += part.vertices.cols();
    triangles += part.triangles.cols();
  }
  TriangleMesh whole{Eigen::Matrix3Xd(3, vertices), Eigen::Matrix3Xi(3, triangles)};
  // Shift vertex numbers by the number of those before.
  vertices = triangles = 0;
  for (const TriangleMesh& part : parts) {
    whole.vertices.middleCols(vertices, part.vertices.cols()) = part.vertices;
    whole.triangles.middleCols(triangles, part.triangles.cols()) =
        part.triangles.array() + static_cast<int>(vertices);
    vertices += part.vertices.cols();
    triangles += part.triangles.cols();
  }
  return whole;
}

std::vector<TriangleMesh> connected_parts(const TriangleMesh& mesh) {
  const Eigen::Matrix3Xi across = neighbours_across(mesh);
  std::vector<bool> seen(static_cast<std::size_t>(mesh.triangles.cols()), false);
  std::vector<int> number(static_cast<std::size_t>(mesh.vertices.cols()), -1);
  std::vector<TriangleMesh> parts;
  // Visit neighbours breadth-first.
  for (std::size_t first = 0; first < seen.size(); ++first) {
    if (seen[first]) continue;
    std::vector<int> members{static_cast<int>(first)};
    seen[first] = true;
    for (std::size_t i = 0; i < members.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const int other = across(k, members[i]);
        if (other < 0 || seen[other]) continue;
        seen[other] = true;
        members.push_back(other);
      }
    // Return a mesh that is one part as a whole.
    if (members.size() == seen.size()) return {mesh};
    std::sort(members.begin(), members.end());
    parts.push_back(taken_out(mesh, members, number));
  }
  return parts;
}

std::string explain_open_mesh(const TriangleMesh& mesh, const MeshReport& found) {
  const MeshFaults faults = find_mesh_faults(mesh);
  const std::string cause = describe(faults);
  if (cause.empty()) return describe(found);
  return faults.holes == 0 ? cause : fmt::format("{}; {}", cause, describe(found));
}

std::vector<TriangleMesh> solid_parts(const TriangleMesh& mesh) {
  // Require a closed mesh.
  require(!mesh.empty(), "a mesh has no triangle");
  const MeshReport found = check_mesh(mesh);
  if (!found.holes.empty())
    throw InputError("a mesh bounds no solid: " + explain_open_mesh(mesh, found));
  const bool sound = found.watertight() && found.volume > 0;
  // Put right first, if it is not sound.
  std::vector<TriangleMesh> meshes =
      connected_parts(sound ? mesh : repair_mesh(mesh, MeshHoles::kKeep).mesh);
  if (meshes.empty()) fail_without_volume(mesh);
  if (sound && meshes.size() == 1) return meshes;
  // Skip slivers, which enclose nothing that could be touched.
  const double whole = diagonal_of(mesh);
  std::vector<Part> parts;
  parts.reserve(meshes.size());
  for (TriangleMesh& closed : meshes) {
    Part part = closed_part(std::move(closed));
    if (!is_sliver(part.volume, part.box.diagonal().norm(), whole))
      parts.push_back(std::move(part));
  }
  if (parts.empty()) fail_without_volume(mesh);
  return outward(std::move(parts));
}

std::vector<TriangleMesh> solids_or_none(const TriangleMesh& mesh) {
  try {
    return solid_parts(mesh);
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace thenar
