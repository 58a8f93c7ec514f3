#include "data/io/mesh/triangle_soup.h"

#include <array>
#include <map>

#include "base/error.h"

namespace thenar {
namespace {

constexpr int kFarthest = 1'000'000;  // of a corner; squares and products stay numbers [m]

/// Hands out one number for each place.
class Vertices {
 public:
  int index_of(const Eigen::Vector3d& p) {
    const std::array<double, 3> key{p.x() + 0.0, p.y() + 0.0, p.z() + 0.0};  // -0 is 0
    const auto [at, is_new] = index_.emplace(key, static_cast<int>(places_.size()));
    if (is_new) places_.push_back(p);
    return at->second;
  }
  [[nodiscard]] const std::vector<Eigen::Vector3d>& places() const { return places_; }

 private:
  std::map<std::array<double, 3>, int> index_;
  std::vector<Eigen::Vector3d> places_;
};

}  // namespace

TriangleMesh merge_corners(const TriangleSoup& soup, double scale, const std::string& path) {
  Vertices vertices;
  std::vector<Eigen::Vector3i> triangles;
  for (std::size_t i = 0; i + 2 < soup.corners.size(); i += 3) {
    Eigen::Vector3i t;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d p = scale * soup.corners[i + static_cast<std::size_t>(k)];
      if (!p.allFinite())
        throw DataError(path, 1, fmt::format("triangle {} has a corner that is not finite", i / 3));
      if (p.cwiseAbs().maxCoeff() > kFarthest)
        throw DataError(path, 1,
                        fmt::format("triangle {} has a corner beyond {} m", i / 3, kFarthest));
      t(k) = vertices.index_of(p);
    }
    if (t(0) != t(1) && t(1) != t(2) && t(2) != t(0)) triangles.push_back(t);
  }
  if (triangles.empty()) throw DataError(path, 1, "wanted a surface, got a file without triangles");

  TriangleMesh mesh;
  mesh.vertices.resize(3, static_cast<Eigen::Index>(vertices.places().size()));
  for (Eigen::Index i = 0; i < mesh.vertices.cols(); ++i)
    mesh.vertices.col(i) = vertices.places()[static_cast<std::size_t>(i)];
  mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i)
    mesh.triangles.col(i) = triangles[static_cast<std::size_t>(i)];
  return mesh;
}

}  // namespace thenar
