#include "geometry/tessellate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/units.h"

namespace thenar {
namespace {

using Eigen::Vector2d, Eigen::Vector3d, Eigen::Vector3i;

/// Grows a corner or a triangle at a time.
struct Growing {
  std::vector<Vector3d> vertices;
  std::vector<Vector3i> triangles;

  int add(const Vector3d& vertex) {
    vertices.push_back(vertex);
    return static_cast<int>(vertices.size()) - 1;
  }
  [[nodiscard]] TriangleMesh mesh() const { return {as_columns(vertices), as_columns(triangles)}; }
};

/// Returns the point where a ray from the origin leaves the solid.
Vector3d on_ray(const Shape& convex, const Vector3d& direction) {
  double inside = 0, outside = convex.bounds().sizes().norm();
  for (int i = 0; i < 30; ++i) {
    const double middle = (inside + outside) / 2;
    (convex.distance(middle * direction) < 0 ? inside : outside) = middle;
  }
  return inside * direction;
}

using Edge = std::pair<int, int>;
Edge edge_of(int a, int b) { return std::minmax(a, b); }

/// Corners in the middle of edges that were halved.
using Halves = std::map<Edge, int>;

/// One triangle as the halves of its edges demand: left alone, or cut in two,
/// three or four.
void cut(const Vector3i& triangle, const Halves& halves, Growing& out) {
  // Find the halved sides of the triangle.
  std::array<int, 3> middle{};
  int marked = 0, corner = 0;
  for (int k = 0; k < 3; ++k) {
    const auto half = halves.find(edge_of(triangle(k), triangle((k + 1) % 3)));
    middle[k] = half == halves.end() ? -1 : half->second;
    marked += middle[k] >= 0 ? 1 : 0;
  }
  // Turn it such that a lone halved edge, or a lone whole one's successor,
  // comes first.
  for (int k = 0; k < 3; ++k)
    if ((marked == 1 && middle[k] >= 0) || (marked == 2 && middle[(k + 2) % 3] < 0)) corner = k;
  const auto v = [&](int k) { return triangle((corner + k) % 3); };
  const auto m = [&](int k) { return middle[(corner + k) % 3]; };
  const auto add = [&](int a, int b, int c) { out.triangles.emplace_back(a, b, c); };
  if (marked == 0) add(v(0), v(1), v(2));
  if (marked == 1) add(v(0), m(0), v(2)), add(m(0), v(1), v(2));
  if (marked == 2) {
    add(m(0), v(1), m(1));
    const auto& p = out.vertices;
    if ((p[m(0)] - p[v(2)]).norm() < (p[m(1)] - p[v(0)]).norm())
      add(v(0), m(0), v(2)), add(m(0), m(1), v(2));
    else
      add(v(0), m(0), m(1)), add(v(0), m(1), v(2));
  }
  if (marked == 3)
    add(v(0), m(0), m(2)), add(m(0), v(1), m(1)), add(m(2), m(1), v(2)), add(m(0), m(1), m(2));
}

/// Halves every edge for which place(a, b) has a point; true if there was any.
template <typename Place>
bool halve(Growing& surface, const Place& place_middle) {
  // Visit each edge once.
  Halves halves;
  std::map<Edge, bool> seen;
  for (const Vector3i& triangle : surface.triangles)
    for (int k = 0; k < 3; ++k) {
      const Edge edge = edge_of(triangle(k), triangle((k + 1) % 3));
      if (!seen.emplace(edge, true).second) continue;
      Vector3d middle = (surface.vertices[edge.first] + surface.vertices[edge.second]) / 2;
      if (place_middle(middle)) halves.emplace(edge, surface.add(middle));
    }
  // Cut the triangles as their edges demand.
  std::vector<Vector3i> before;
  before.swap(surface.triangles);
  for (const Vector3i& triangle : before) cut(triangle, halves, surface);
  return !halves.empty();
}

/// @param sides  1: the first octant only; 2: all
Growing octahedron(const Shape& convex, int sides) {
  Growing surface;
  // Add six corners on the axes, or three.
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < sides; ++side)
      surface.add(on_ray(convex, (side ? -1 : 1) * Vector3d::Unit(axis)));
  // Add one triangle in each octant.
  for (int x = 0; x < sides; ++x)
    for (int y = 0; y < sides; ++y)
      for (int z = 0; z < sides; ++z) {
        Vector3i triangle(x, sides + y, 2 * sides + z);
        if ((x + y + z) % 2) std::swap(triangle.y(), triangle.z());
        surface.triangles.push_back(triangle);
      }
  return surface;
}

/// Corners move out by half of what the deepest triangle around them sinks in.
void push_out(const Shape& convex, Growing& surface) {
  // Find the depth of the deepest triangle at each corner.
  std::vector<double> depth(surface.vertices.size(), 0.0);
  for (const Vector3i& t : surface.triangles) {
    const Vector3d centre =
        (surface.vertices[t.x()] + surface.vertices[t.y()] + surface.vertices[t.z()]) / 3;
    const double sunk = -convex.distance(centre);
    for (int k = 0; k < 3; ++k) depth[t(k)] = std::max(depth[t(k)], sunk);
  }
  for (std::size_t i = 0; i < surface.vertices.size(); ++i)
    surface.vertices[i] += depth[i] / 2 * convex.nearest(surface.vertices[i]).normal;
}

TriangleMesh refined(const Shape& convex, Growing surface, double tolerance) {
  // Halve twice for a first shape.
  for (int i = 0; i < 2; ++i)
    halve(surface, [&](Vector3d& middle) {
      middle = on_ray(convex, middle.normalized());
      return true;
    });
  // An edge sinks in three quarters as deep as its triangles; both sides share what is left.
  const double sunk = 0.75 * 0.8 * 2 * tolerance;
  // Halve edges whose middles lie too deep, until there are none.
  for (int pass = 0; pass < 16; ++pass)
    if (!halve(surface, [&](Vector3d& middle) {
          const NearestSurface near = convex.nearest(middle);
          middle -= near.distance * near.normal;
          if (!(std::abs(convex.distance(middle)) < 0.01 * tolerance))
            middle = on_ray(convex, middle.normalized());
          return -near.distance > sunk;
        }))
      break;
  push_out(convex, surface);
  return surface.mesh();
}

}  // namespace

TriangleMesh box_mesh(const Vector3d& edges) {
  TriangleMesh mesh{Eigen::Matrix3Xd(3, 8), Eigen::Matrix3Xi(3, 12)};
  for (int i = 0; i < 8; ++i)
    mesh.vertices.col(i) =
        edges.cwiseProduct(Vector3d(i & 1, i >> 1 & 1, i >> 2 & 1) - Vector3d::Constant(0.5));
  mesh.triangles << 0, 0, 4, 4, 0, 0, 2, 2, 0, 0, 1, 1,  //
      2, 3, 5, 7, 1, 5, 6, 7, 4, 6, 3, 7,                //
      3, 1, 7, 6, 5, 4, 7, 3, 6, 2, 7, 5;
  return mesh;
}

int sides_of_circle(double radius, double tolerance) {
  // Sinks in by r (1 - cos(pi / n)), half of which goes outside.
  const double angle = std::acos(std::clamp(1 - 2 * tolerance / radius, 0.0, 1.0));
  return std::max(12, 4 * static_cast<int>(std::ceil(kPi / angle / 4)));
}

double corner_overshoot(int sides) { return 2 / (1 + std::cos(kPi / sides)) - 1; }

TriangleMesh surface_of_revolution(const std::vector<Vector2d>& profile, int sides) {
  // Add rings of corners between the two poles.
  Growing surface;
  const int rings = static_cast<int>(profile.size()) - 2;
  const int bottom = surface.add({0, 0, profile.front().y()});
  for (int ring = 1; ring <= rings; ++ring)
    for (int k = 0; k < sides; ++k) {
      const double angle = 2 * kPi * k / sides, rho = profile[ring].x();
      surface.add({rho * std::cos(angle), rho * std::sin(angle), profile[ring].y()});
    }
  const int top = surface.add({0, 0, profile.back().y()});
  const auto at = [&](int ring, int k) { return 1 + ring * sides + k % sides; };
  // Add fans at the poles, and quadrilaterals between rings.
  for (int k = 0; k < sides; ++k) {
    surface.triangles.emplace_back(bottom, at(0, k + 1), at(0, k));
    for (int ring = 0; ring + 1 < rings; ++ring) {
      surface.triangles.emplace_back(at(ring, k), at(ring, k + 1), at(ring + 1, k + 1));
      surface.triangles.emplace_back(at(ring, k), at(ring + 1, k + 1), at(ring + 1, k));
    }
    surface.triangles.emplace_back(top, at(rings - 1, k), at(rings - 1, k + 1));
  }
  return surface.mesh();
}

TriangleMesh tessellate(const Shape& convex, double tolerance) {
  return refined(convex, octahedron(convex, 2), tolerance);
}

TriangleMesh tessellate_octant(const Shape& convex, double tolerance) {
  return refined(convex, octahedron(convex, 1), tolerance);
}

}  // namespace thenar
