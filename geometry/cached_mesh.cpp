#include "geometry/cached_mesh.h"

#include <cstdint>
#include <cstring>

#include "base/cache.h"

namespace thenar {
namespace {

using Counts = std::uint64_t[2];  // of vertices and triangles

}  // namespace

std::string bytes_of(const TriangleMesh& mesh) {
  const Counts counts{static_cast<std::uint64_t>(mesh.vertices.cols()),
                      static_cast<std::uint64_t>(mesh.triangles.cols())};
  std::string bytes;
  bytes.reserve(sizeof(Counts) + 3 * sizeof(double) * counts[0] + 3 * sizeof(int) * counts[1]);
  append_bytes(bytes, counts, 2);
  append_bytes(bytes, mesh.vertices.data(), 3 * counts[0]);
  append_bytes(bytes, mesh.triangles.data(), 3 * counts[1]);
  return bytes;
}

std::optional<TriangleMesh> mesh_of(const std::string& bytes) {
  // Read the counts, and check them against the length.
  Counts counts{};
  if (bytes.size() < sizeof(Counts)) return std::nullopt;
  std::memcpy(counts, bytes.data(), sizeof(Counts));
  constexpr std::uint64_t kMax = 100'000'000;
  if (counts[0] > kMax || counts[1] > kMax || counts[1] == 0) return std::nullopt;
  const std::size_t vertices = 3 * sizeof(double) * counts[0],
                    triangles = 3 * sizeof(int) * counts[1];
  if (bytes.size() != sizeof(Counts) + vertices + triangles) return std::nullopt;
  // Copy vertices and triangles, and check the triangles' indices.
  TriangleMesh mesh{Eigen::Matrix3Xd(3, counts[0]), Eigen::Matrix3Xi(3, counts[1])};
  std::memcpy(mesh.vertices.data(), bytes.data() + sizeof(Counts), vertices);
  std::memcpy(mesh.triangles.data(), bytes.data() + sizeof(Counts) + vertices, triangles);
  const bool sound = mesh.triangles.minCoeff() >= 0 &&
                     mesh.triangles.maxCoeff() < static_cast<int>(counts[0]) &&
                     mesh.vertices.allFinite();
  return sound ? std::optional<TriangleMesh>(std::move(mesh)) : std::nullopt;
}

TriangleMesh cached_mesh(const std::string& kind, const std::string& input,
                         const std::function<TriangleMesh()>& make) {
  if (const std::optional<std::string> bytes = find_cached(kind, input))
    if (std::optional<TriangleMesh> mesh = mesh_of(*bytes)) return std::move(*mesh);
  TriangleMesh mesh = make();
  store_cached(kind, input, bytes_of(mesh));
  return mesh;
}

}  // namespace thenar
