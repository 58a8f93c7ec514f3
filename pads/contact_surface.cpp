#include "pads/contact_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace thenar {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double kFar = 10;  // gap that cannot matter, over distances of points of a surface [1]

// Cosine of the angle between normals of the object at nodes of a point beyond which an edge of the
// object lies between them.
constexpr double kEdgeCosine = 0.2;

/// Gauss points of a face, by nodes of the mesh; an empty list of nodes: some are fixed.
std::vector<SurfacePoint> face_points(const HexMesh& mesh, const TissueBody& body,
                                      const std::array<int, 4>& nodes, const Matrix3Xd& at_rest) {
  constexpr std::array<double, 3> kAt{0.112701665379258311, 0.5, 0.887298334620741689};
  constexpr std::array<double, 3> kShare{5.0 / 18, 4.0 / 9, 5.0 / 18};
  const Vector3d one = at_rest.col(nodes[3]) - at_rest.col(nodes[0]);
  const Vector3d other = at_rest.col(nodes[2]) - at_rest.col(nodes[1]);
  const double area = 0.5 * one.cross(other).norm();
  std::vector<SurfacePoint> out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const double x = kAt[i], y = kAt[j];
      const std::array<double, 4> shape{(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y};
      Vector3d chart(0, 0, 0), mean(0, 0, 0);
      std::map<int, double> weights;
      for (std::size_t k = 0; k < 4; ++k) {
        chart += shape[k] * mesh.chart_point(nodes[k]);
        mean += shape[k] * at_rest.col(nodes[k]);
        for (const NodeWeight& each : mesh.support(nodes[k]))
          weights[body.free_place(each.node)] += shape[k] * each.weight;
      }
      if (weights.count(-1) != 0) return {};
      SurfacePoint point{mesh.chart().place(chart) - mean, {}, area * kShare[i] * kShare[j]};
      for (const auto& [node, weight] : weights) point.nodes.push_back({node, weight});
      out.push_back(std::move(point));
    }
  return out;
}

/// Where a point of a surface is. @param places  of the nodes [m] (3, nodes)
Vector3d place_of(const SurfacePoint& point, const Matrix3Xd& places) {
  Vector3d p = point.offset;
  for (const NodeWeight& each : point.nodes) p += each.weight * places.col(each.node);
  return p;
}

}  // namespace

VectorXd node_areas(const HexMesh& mesh, const std::vector<HexFace>& faces, const Matrix3Xd& at) {
  VectorXd area = VectorXd::Zero(mesh.nodes());
  for (const HexFace& face : faces) {
    const Vector3d one = at.col(face.nodes[3]) - at.col(face.nodes[0]);
    const Vector3d other = at.col(face.nodes[2]) - at.col(face.nodes[1]);
    const double share = 0.125 * one.cross(other).norm();
    for (const int node : face.nodes)
      for (const NodeWeight& each : mesh.support(node)) area[each.node] += share * each.weight;
  }
  return area;
}

ContactSurface contact_surface(const HexMesh& mesh, const TissueBody& body,
                               const std::vector<bool>& marked) {
  ContactSurface surface;
  const Matrix3Xd at_rest = places_at_rest(mesh);
  const std::vector<HexFace> faces = marked_faces(mesh, marked);
  const VectorXd area = node_areas(mesh, faces, at_rest);
  // Free nodes that have a share.
  std::vector<int> index(body.free_nodes().size(), -1);
  for (std::size_t free = 0; free < index.size(); ++free) {
    if (!(area[body.free_nodes()[free]] > 0)) continue;
    index[free] = static_cast<int>(surface.nodes.size());
    surface.nodes.push_back(static_cast<int>(free));
  }
  const auto count = static_cast<Eigen::Index>(surface.nodes.size());
  surface.places.resize(3, count);
  surface.area.resize(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const int node = mesh_node(body, surface, static_cast<std::size_t>(k));
    surface.places.col(k) = mesh.place(node);
    surface.area[k] = area[node];
  }
  if (body.is_quadratic()) return surface;
  for (const HexFace& face : faces)
    for (SurfacePoint& point : face_points(mesh, body, face.nodes, at_rest)) {
      for (NodeWeight& each : point.nodes) each.node = index[static_cast<std::size_t>(each.node)];
      surface.points.push_back(std::move(point));
    }
  return surface;
}

int mesh_node(const TissueBody& body, const ContactSurface& surface, std::size_t k) {
  return body.free_nodes()[static_cast<std::size_t>(surface.nodes[k])];
}

Matrix3Xd places_of(const ContactSurface& surface, const VectorXd& x) {
  Matrix3Xd places = surface.places;
  for (Eigen::Index k = 0; k < places.cols(); ++k)
    places.col(k) += x.segment<3>(3 * surface.nodes[static_cast<std::size_t>(k)]);
  return places;
}

double smallest_gap(const ContactSurface& surface, const Shape& object, const Pose<double>& X_PO,
                    const VectorXd& x) {
  const Pose<double> X_OP = X_PO.inverse();
  const Matrix3Xd places = places_of(surface, x);
  double gap = 1e300;
  for (Eigen::Index k = 0; k < places.cols(); ++k)
    gap = std::min(gap, object.distance(X_OP * Vector3d(places.col(k))));
  for (const SurfacePoint& point : surface.points)
    gap = std::min(gap, object.distance(X_OP * place_of(point, places)));
  return gap;
}

MeanGaps::MeanGaps(const ContactSurface& surface) : surface_(surface) {
  const auto count = static_cast<Eigen::Index>(surface.nodes.size());
  gap_ = more_ = VectorXd::Zero(count);
  normal_ = mean_normal_ = own_slope_ = Matrix3Xd::Zero(3, count);
}

double MeanGaps::share_of(const SurfacePoint& point, const NodeWeight& node) const {
  return node.weight * point.area / surface_.area[node.node];
}

void MeanGaps::find(const Shape& object, const Pose<double>& X_PO, const VectorXd& x) {
  const Pose<double> X_OP = X_PO.inverse();
  const Matrix3Xd places = places_of(surface_, x);
  for (Eigen::Index k = 0; k < places.cols(); ++k) {
    const NearestSurface at = object.nearest(X_OP * Vector3d(places.col(k)));
    gap_[k] = at.distance;
    normal_.col(k) = X_PO.R * at.normal;
  }
  if (counts_.empty()) find_edges();
  mean_normal_ = own_slope_ = normal_;
  more_.setZero();
  near_.clear();
  neighbours_matter_ = false;
  for (std::size_t i = 0; i < surface_.points.size(); ++i) {
    const SurfacePoint& point = surface_.points[i];
    Vector3d mean(0, 0, 0);
    double nearest = 1e300, distance = 0;
    for (const NodeWeight& each : point.nodes) {
      distance += each.weight * gap_[each.node];
      mean += each.weight * normal_.col(each.node);
      nearest = std::min(nearest, gap_[each.node]);
    }
    if (!counts_[i] || nearest > kFar * std::sqrt(point.area)) continue;
    const NearestSurface at = object.nearest(X_OP * place_of(point, places));
    near_.push_back({i, X_PO.R * at.normal});
    const Near& here = near_.back();
    // A node's share of the point, and what it makes of gap and normals there.
    for (const NodeWeight& each : point.nodes) {
      const double share = share_of(point, each);
      more_[each.node] += share * (at.distance - distance);
      mean_normal_.col(each.node) += share * (here.normal - mean);
      const Vector3d turned = here.normal - normal_.col(each.node);
      own_slope_.col(each.node) += share * each.weight * turned;
      neighbours_matter_ = neighbours_matter_ || turned.squaredNorm() > 1e-20;
    }
  }
  gap_ += more_;
  for (Eigen::Index k = 0; k < places.cols(); ++k)
    if (mean_normal_.col(k).squaredNorm() > 0) mean_normal_.col(k).normalize();
}

void MeanGaps::find_edges() {
  for (const SurfacePoint& point : surface_.points) {
    double alike = 1;
    for (const NodeWeight& each : point.nodes)
      for (const NodeWeight& other : point.nodes)
        alike = std::min(alike, normal_.col(each.node).dot(normal_.col(other.node)));
    counts_.push_back(alike > kEdgeCosine);
  }
}

VectorXd MeanGaps::change(const Matrix3Xd& moved) const {
  VectorXd out = normal_.cwiseProduct(moved).colwise().sum();
  for (const Near& near : near_) {
    const SurfacePoint& point = surface_.points[near.point];
    double more = 0;
    for (const NodeWeight& each : point.nodes)
      more += each.weight * (near.normal - normal_.col(each.node)).dot(moved.col(each.node));
    for (const NodeWeight& each : point.nodes) out[each.node] += share_of(point, each) * more;
  }
  return out;
}

std::vector<MeanGaps::Slope> MeanGaps::slopes(const std::vector<int>& nodes) const {
  std::vector<int> rows(surface_.nodes.size(), -1);
  std::vector<Slope> out;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    rows[static_cast<std::size_t>(nodes[i])] = static_cast<int>(i);
    out.push_back({static_cast<int>(i), nodes[i], normal_.col(nodes[i])});
  }
  if (!neighbours_matter_) return out;
  for (const Near& near : near_) {
    const SurfacePoint& point = surface_.points[near.point];
    for (const NodeWeight& each : point.nodes) {
      const int row = rows[static_cast<std::size_t>(each.node)];
      if (row < 0) continue;
      const double share = share_of(point, each);
      for (const NodeWeight& other : point.nodes)
        out.push_back(
            {row, other.node, share * other.weight * (near.normal - normal_.col(other.node))});
    }
  }
  // One of each pair.
  std::stable_sort(out.begin(), out.end(), [](const Slope& a, const Slope& b) {
    return std::pair(a.row, a.node) < std::pair(b.row, b.node);
  });
  std::size_t last = 0;
  for (std::size_t i = 1; i < out.size(); ++i) {
    if (out[i].row == out[last].row && out[i].node == out[last].node)
      out[last].by += out[i].by;
    else
      out[++last] = out[i];
  }
  out.resize(std::min(out.size(), last + 1));
  return out;
}

Matrix3Xd MeanGaps::spread(const VectorXd& push) const {
  Matrix3Xd out = normal_ * push.asDiagonal();
  for (const Near& near : near_) {
    const SurfacePoint& point = surface_.points[near.point];
    double more = 0;
    for (const NodeWeight& each : point.nodes) more += share_of(point, each) * push[each.node];
    if (more == 0) continue;
    for (const NodeWeight& each : point.nodes)
      out.col(each.node) += more * each.weight * (near.normal - normal_.col(each.node));
  }
  return out;
}

}  // namespace thenar
