#include "geometry/hull_mesh.h"

#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd, Eigen::Vector3d, Eigen::Vector3i;

struct Facet {
  Vector3i corners;
  Vector3d normal;
  double offset;  // normal . x of its plane
};

Facet facet_of(const Matrix3Xd& p, int a, int b, int c) {
  // Compute its plane from its corners.
  const Vector3d n = (p.col(b) - p.col(a)).cross(p.col(c) - p.col(a)).normalized();
  return {{a, b, c}, n, n.dot(p.col(a))};
}

/// Four points that span as much as they can, one after the other.
std::vector<int> first_tetrahedron(const Matrix3Xd& p) {
  // Find an extreme point, then those farthest from it, from their line, and from their plane.
  Eigen::Index a = 0, b = 0, c = 0, d = 0;
  p.row(0).minCoeff(&a);
  (p.colwise() - p.col(a)).colwise().squaredNorm().maxCoeff(&b);
  const Vector3d along = (p.col(b) - p.col(a)).normalized();
  const Matrix3Xd r = p.colwise() - p.col(a);
  (r - along * (along.transpose() * r)).colwise().squaredNorm().maxCoeff(&c);
  const Vector3d normal = along.cross(Vector3d(r.col(c))).normalized();
  (normal.transpose() * r).cwiseAbs().maxCoeff(&d);
  if (normal.dot(r.col(d)) > 0) std::swap(b, c);
  return {static_cast<int>(a), static_cast<int>(b), static_cast<int>(c), static_cast<int>(d)};
}

/// Facets that see the point give way to those between it and their rim.
void add_point(const Matrix3Xd& p, int point, std::vector<Facet>& facets) {
  // Remove the facets that see the point; edges between them and the rest form the rim.
  std::set<std::pair<int, int>> rim;
  std::vector<Facet> kept;
  for (const Facet& facet : facets) {
    if (facet.normal.dot(p.col(point)) <= facet.offset) {
      kept.push_back(facet);
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      const std::pair<int, int> edge(facet.corners(k), facet.corners((k + 1) % 3));
      if (rim.erase({edge.second, edge.first}) == 0) rim.insert(edge);
    }
  }
  // Ignore a point inside.
  if (kept.size() == facets.size()) return;
  for (const auto& [a, b] : rim) kept.push_back(facet_of(p, a, b, point));
  facets = std::move(kept);
}

/// Uniform in [-1/2, 1/2).
double draw(std::mt19937& random) { return static_cast<double>(random()) / 4294967296.0 - 0.5; }

}  // namespace

TriangleMesh hull_mesh(const Matrix3Xd& points) {
  require(points.allFinite(), "a hull has a point that is not finite");
  // Move the points a little, so that no four lie in a plane.
  if (points.cols() < 4) return {};
  const Vector3d extents = principal_extents(points);
  if (!(extents.minCoeff() / extents.maxCoeff() > 1e-4)) return {};
  Matrix3Xd p = points;
  const double size = (p.rowwise().maxCoeff() - p.rowwise().minCoeff()).norm();
  std::mt19937 random(1);
  for (Eigen::Index i = 0; i < p.size(); ++i) p(i) += 5e-7 * size * draw(random);

  const std::vector<int> first = first_tetrahedron(p);
  const int a = first[0], b = first[1], c = first[2], d = first[3];
  std::vector<Facet> facets{facet_of(p, a, b, c), facet_of(p, a, d, b), facet_of(p, b, d, c),
                            facet_of(p, c, d, a)};
  for (int i = 0; i < static_cast<int>(p.cols()); ++i)
    if (!contains(first, i)) add_point(p, i, facets);

  std::map<int, int> number;
  TriangleMesh hull{{}, Eigen::Matrix3Xi(3, facets.size())};
  for (std::size_t i = 0; i < facets.size(); ++i)
    for (int k = 0; k < 3; ++k)
      hull.triangles(k, static_cast<Eigen::Index>(i)) =
          number.emplace(facets[i].corners(k), static_cast<int>(number.size())).first->second;
  hull.vertices.resize(3, number.size());
  for (const auto& [old, now] : number) hull.vertices.col(now) = p.col(old);
  return hull;
}

}  // namespace thenar
