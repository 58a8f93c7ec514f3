#include "geometry/convex_body.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.h"
#include "base/stop_scope.h"

namespace thenar {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;
using Polygon = std::vector<Vector3d>;

/// Returns the part of a polygon within a half space. @param cuts  gets the two points of its rim
/// @param height  of each corner above the plane, 0 where it is on it [m]
Polygon cut_polygon(const Polygon& polygon, const std::vector<double>& height, Polygon& cuts) {
  Polygon kept;
  kept.reserve(polygon.size() + 1);
  const std::size_t count = polygon.size();
  // Keep corners inside, and add a point where a side crosses the plane.
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = i + 1 == count ? 0 : i + 1;
    if (height[i] <= 0) kept.push_back(polygon[i]);
    if (height[i] == 0) cuts.push_back(polygon[i]);
    if ((height[i] < 0 && height[next] > 0) || (height[i] > 0 && height[next] < 0)) {
      // Go from the inner corner outwards, so that both faces of an edge find the same point.
      const std::size_t in = height[i] < 0 ? i : next, out = height[i] < 0 ? next : i;
      const double share = height[in] / (height[in] - height[out]);
      kept.push_back(polygon[in] + share * (polygon[out] - polygon[in]));
      cuts.push_back(kept.back());
    }
  }
  return kept;
}

/// Returns the face on a clipping plane: the points of its boundary in order.
Polygon cap_of(const Polygon& cuts, const Vector3d& n) {
  if (cuts.size() < 3) return {};
  // Order the points by their angle about the middle.
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& p : cuts) middle += p / static_cast<double>(cuts.size());
  const Vector3d u = n.unitOrthogonal(), v = n.cross(u);
  std::vector<std::pair<double, Vector3d>> turned;
  turned.reserve(cuts.size());
  for (const Vector3d& p : cuts)
    turned.emplace_back(std::atan2(v.dot(p - middle), u.dot(p - middle)), p);
  std::sort(turned.begin(), turned.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  // Merge neighbours that coincide.
  Polygon cap;
  for (const auto& [angle, p] : turned)
    if (cap.empty() || p != cap.back()) cap.push_back(p);
  return cap;
}

/// Adds the tetrahedron between the origin and three corners; signed.
void add_tetrahedron(const Vector3d& a, const Vector3d& b, const Vector3d& c, Moments& sum) {
  const double det = a.dot(b.cross(c));
  const Vector3d s = a + b + c;
  sum.volume += det / 6;
  sum.first += det / 24 * s;
  sum.second +=
      det / 120 * (s * s.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
}

/// Moments of what is described from a point other than the origin.
Moments moved(const Moments& m, const Vector3d& by) {
  Moments to = m;
  to.first += m.volume * by;
  to.second += m.first * by.transpose() + by * m.first.transpose() + m.volume * by * by.transpose();
  return to;
}

}  // namespace

Moments& Moments::operator+=(const Moments& other) {
  volume += other.volume;
  first += other.first;
  second += other.second;
  return *this;
}

Moments& Moments::operator-=(const Moments& other) {
  volume -= other.volume;
  first -= other.first;
  second -= other.second;
  return *this;
}

Moments moments_of(const MassProperties& mass) {
  const Matrix3d& I = mass.inertia;
  const Matrix3d about_centre = I.trace() / 2 * Matrix3d::Identity() - I;
  return moved({mass.mass, Vector3d::Zero(), about_centre}, mass.centre);
}

MassProperties mass_of(const Moments& moments) {
  if (!(moments.volume > 0)) return {};
  const Vector3d centre = moments.first / moments.volume;
  const Matrix3d second = moved(moments, -centre).second;
  return {moments.volume, centre, second.trace() * Matrix3d::Identity() - second};
}

ConvexBody convex_box(const Eigen::AlignedBox3d& box) {
  ConvexBody body;
  body.box = box;
  const Vector3d &low = box.min(), &high = box.max();
  // Add a pair of faces across each axis, counterclockwise seen from outside.
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      Polygon face(4, low);
      for (Vector3d& p : face) p[axis] = upper ? high[axis] : low[axis];
      face[1][u] = face[2][u] = high[u];
      face[2][v] = face[3][v] = high[v];
      if (!upper) std::reverse(face.begin(), face.end());
      body.faces.push_back(std::move(face));
      const Vector3d n = (upper ? 1 : -1) * Vector3d::Unit(axis);
      body.sides.push_back({n, n.dot(upper ? high : low)});
    }
  return body;
}

ConvexBody convex_body(const TriangleMesh& mesh) {
  // Do not test a mesh that is too large.
  if (static_cast<double>(mesh.vertices.cols()) * static_cast<double>(mesh.triangles.cols()) > 3e7)
    return {};
  ConvexBody body;
  for (const auto& p : mesh.vertices.colwise()) body.box.extend(Vector3d(p));
  const double extent = body.box.diagonal().norm();
  // Require that no corner is above the plane of any triangle.
  for (const auto& t : mesh.triangles.colwise()) {
    const Vector3d a = mesh.vertices.col(t(0)), b = mesh.vertices.col(t(1)),
                   c = mesh.vertices.col(t(2));
    const Vector3d n = (b - a).cross(c - a).normalized();
    const double offset = n.dot(a);
    if (!((n.transpose() * mesh.vertices).maxCoeff() - offset <= 1e-6 * extent)) return {};
    body.faces.push_back({a, b, c});
    // Add one side for all triangles of a plane.
    const bool there = std::any_of(body.sides.begin(), body.sides.end(), [&](const HalfSpace& s) {
      return (s.n - n).squaredNorm() < 1e-24 && std::abs(s.offset - offset) < 1e-12 * extent;
    });
    if (!there) body.sides.push_back({n, offset});
  }
  return body;
}

namespace {

/// Keeps what lies below a plane: faces below stay, faces across are cut.
/// @param above  height of a point above the plane [m]
/// @return points on the plane
template <typename Height>
Polygon cut_faces(std::vector<Polygon>& faces, const Height& above) {
  std::vector<Polygon> kept;
  kept.reserve(faces.size() + 1);
  Polygon cuts;
  std::vector<double> height;
  for (Polygon& face : faces) {
    height.clear();
    for (const Vector3d& p : face) height.push_back(above(p));
    const auto [least, most] = std::minmax_element(height.begin(), height.end());
    if (*least < 0 && *most > 0) {
      kept.push_back(cut_polygon(face, height, cuts));
      continue;
    }
    for (std::size_t i = 0; i < face.size(); ++i)
      if (height[i] == 0) cuts.push_back(face[i]);
    if (*least < 0) kept.push_back(std::move(face));
  }
  faces = std::move(kept);
  return cuts;
}

}  // namespace

void clip(ConvexBody& body, const HalfSpace& side, double tolerance) {
  // Compare the box with the plane first, which decides without corners.
  const double middle = side.n.dot(body.box.center()) - side.offset;
  const double reach = side.n.cwiseAbs().dot(body.box.sizes()) / 2;
  if (middle + reach <= tolerance) return;
  // Compute heights above the plane, zero within the tolerance.
  const auto above = [&](const Vector3d& p) {
    const double h = side.n.dot(p) - side.offset;
    return std::abs(h) <= tolerance ? 0 : h;
  };
  const bool beyond = std::any_of(body.faces.begin(), body.faces.end(), [&](const Polygon& face) {
    return std::any_of(face.begin(), face.end(), [&](const Vector3d& p) { return above(p) > 0; });
  });
  if (!beyond) return;
  // Close the cut by a cap, unless nothing is left.
  Polygon cap = cap_of(cut_faces(body.faces, above), side.n);
  if (body.faces.size() < 3 || cap.size() < 3) {
    body = {};
    return;
  }
  body.faces.push_back(std::move(cap));
  body.sides.push_back(side);
  // Update the box.
  body.box.setEmpty();
  for (const Polygon& face : body.faces)
    for (const Vector3d& p : face) body.box.extend(p);
}

ConvexBody intersection(const ConvexBody& a, const ConvexBody& b, double tolerance) {
  ConvexBody common = a;
  for (const HalfSpace& side : b.sides) {
    clip(common, side, tolerance);
    if (common.empty()) return {};
  }
  return common;
}

Moments moments_of(const ConvexBody& body) {
  // Sum moments about the centre of its box, so that little cancels out.
  const Vector3d origin = body.box.center();
  Moments sum;
  for (const Polygon& face : body.faces)
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      add_tetrahedron(face[0] - origin, face[i] - origin, face[i + 1] - origin, sum);
  return moved(sum, origin);
}

namespace {

/// Heights of a polyhedron over a plane.
struct HeightRange {
  double least, most;  // [m]
};

HeightRange heights_over(const ConvexBody& body, const HalfSpace& side) {
  HeightRange range{kInfinity, -kInfinity};
  for (const Polygon& face : body.faces)
    for (const Vector3d& p : face) {
      const double h = side.n.dot(p) - side.offset;
      range = {std::min(range.least, h), std::max(range.most, h)};
    }
  return range;
}

/// Puts what of a piece stands outside of another body into `pieces`, as polyhedra that share no
/// more than faces. @return number of faces that were looked at
double add_difference(const ConvexBody& piece, const ConvexBody& other, double tolerance,
                      std::vector<ConvexBody>& pieces) {
  double work = 0;
  const std::size_t before = pieces.size();
  ConvexBody rest = piece;
  end_if_stopped();
  for (const HalfSpace& side : other.sides) {
    work += static_cast<double>(rest.faces.size());
    const HeightRange height = heights_over(rest, side);
    if (height.most <= tolerance) continue;
    // Store the part beyond this side as a piece, and compare the rest with the next side.
    if (height.least < -tolerance) {
      work += static_cast<double>(2 * rest.faces.size());
      ConvexBody beyond = rest;
      clip(beyond, {-side.n, -side.offset}, tolerance);
      if (!beyond.empty()) pieces.push_back(std::move(beyond));
      clip(rest, side, tolerance);
    } else {
      rest = {};
    }
    // Keep the piece whole if they have nothing in common.
    if (rest.empty()) {
      pieces.resize(before);
      pieces.push_back(piece);
      break;
    }
  }
  return work;
}

}  // namespace

UnionMoments union_moments(const std::vector<ConvexBody>& bodies, double tolerance,
                           double max_work) {
  // Sort by volume, the largest first, so that bodies within it are removed early.
  std::vector<std::pair<Moments, const ConvexBody*>> sorted;
  for (const ConvexBody& body : bodies) sorted.emplace_back(moments_of(body), &body);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.first.volume > b.first.volume; });
  UnionMoments result;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    std::vector<ConvexBody> pieces{*sorted[i].second};
    bool whole = true;
    for (std::size_t j = 0; j < i && !pieces.empty(); ++j) {
      const ConvexBody& other = *sorted[j].second;
      result.work += 1;
      if (!other.box.intersects(sorted[i].second->box)) continue;
      // Subtract that body from each piece.
      std::vector<ConvexBody> outside;
      for (ConvexBody& piece : pieces) {
        result.work += 1;
        if (other.box.intersects(piece.box))
          result.work += add_difference(piece, other, tolerance, outside);
        else
          outside.push_back(std::move(piece));
        if (result.work > max_work) return {{}, false, result.work};
      }
      pieces = std::move(outside);
      whole = false;
    }
    if (whole) result.moments += sorted[i].first;
    if (!whole)
      for (const ConvexBody& piece : pieces) result.moments += moments_of(piece);
  }
  return result;
}

}  // namespace thenar
