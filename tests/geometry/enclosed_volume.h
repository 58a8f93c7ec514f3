#pragma once

/// Whether a surface is closed, by the plainest means.

#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "geometry/triangle_mesh.h"

namespace thenar {

/// Volume a surface encloses, positive if it faces outwards [m^3]. Expects that every edge is
/// walked once each way and that the triangles around each vertex form one ring.
inline double enclosed_volume(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> next;  // (centre, from) to the vertex after it in the ring
  std::vector<int> triangles_at(mesh.vertices.cols(), 0);
  double volume = 0;
  bool once = true;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Eigen::Vector3i v = mesh.triangles.col(t);
    for (int k = 0; k < 3; ++k) {
      once = next.emplace(std::make_pair(v(k), v((k + 1) % 3)), v((k + 2) % 3)).second && once;
      ++triangles_at[v(k)];
    }
    const Eigen::Vector3d a = mesh.vertices.col(v(0)), b = mesh.vertices.col(v(1));
    volume += a.dot(b.cross(Eigen::Vector3d(mesh.vertices.col(v(2))))) / 6;
  }
  EXPECT_TRUE(once) << "an edge is walked twice in one direction";
  bool closed = true, one_ring = true;
  for (const auto& [edge, after] : next) {
    closed = next.count({edge.second, edge.first}) == 1 && closed;
    // Round the centre once; the first entry of each centre is enough.
    if (triangles_at[edge.first] == 0) continue;
    int steps = 0, at = edge.second;
    do {
      const auto found = next.find({edge.first, at});
      if (found == next.end()) break;
      at = found->second;
    } while (++steps < triangles_at[edge.first] && at != edge.second);
    one_ring = steps == triangles_at[edge.first] && at == edge.second && one_ring;
    triangles_at[edge.first] = 0;
  }
  EXPECT_TRUE(closed) << "an edge is walked one way only";
  EXPECT_TRUE(one_ring) << "two sheets meet in a vertex";
  return volume;
}

}  // namespace thenar
