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

/// Corners of the faces of a mesh all of whose nodes are marked.
std::vector<std::array<int, 4>> marked_faces(const HexMesh& mesh, const std::vector<bool>& marked) {
  std::vector<std::array<int, 4>> out;
  for (const int index : mesh.active())
    for (const std::array<int, 4>& face : hex_faces()) {
      std::array<int, 4> nodes{};
      for (std::size_t i = 0; i < 4; ++i)
        nodes[i] = mesh.cells()[static_cast<std::size_t>(index)]
                       .corners[static_cast<std::size_t>(face[i])];
      if (std::all_of(nodes.begin(), nodes.end(),
                      [&](int node) { return marked[static_cast<std::size_t>(node)]; }))
        out.push_back(nodes);
    }
  return out;
}

/// Gauss points of a face, by nodes of the mesh; an empty list of nodes: some are fixed.
std::vector<SurfacePoint> face_points(const HexMesh& mesh, const TissueBody& body,
                                      const std::array<int, 4>& nodes, double area) {
  constexpr std::array<double, 3> kAt{0.112701665379258311, 0.5, 0.887298334620741689};
  constexpr std::array<double, 3> kShare{5.0 / 18, 4.0 / 9, 5.0 / 18};
  std::vector<SurfacePoint> out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const double x = kAt[i], y = kAt[j];
      const std::array<double, 4> shape{(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y};
      Vector3d chart(0, 0, 0), mean(0, 0, 0);
      std::map<int, double> weights;
      for (std::size_t k = 0; k < 4; ++k) {
        chart += shape[k] * mesh.chart_point(nodes[k]);
        mean += shape[k] * mesh.place(nodes[k]);
        if (mesh.masters(nodes[k]).empty()) weights[body.free_place(nodes[k])] += shape[k];
        for (const NodeWeight& each : mesh.masters(nodes[k]))
          weights[body.free_place(each.node)] += shape[k] * each.weight;
      }
      if (weights.count(-1) != 0) return {};
      SurfacePoint point{mesh.chart().place(chart) - mean, {}, area * kShare[i] * kShare[j]};
      for (const auto& [node, weight] : weights) point.nodes.push_back({node, weight});
      out.push_back(std::move(point));
    }
  return out;
}

}  // namespace

ContactSurface contact_surface(const HexMesh& mesh, const TissueBody& body,
                               const std::vector<bool>& marked) {
  ContactSurface surface;
  std::map<int, double> area;  // by free place
  for (const std::array<int, 4>& nodes : marked_faces(mesh, marked)) {
    // A quarter of the face for each of its nodes.
    const double all = 0.5 * (mesh.place(nodes[3]) - mesh.place(nodes[0]))
                                 .cross(mesh.place(nodes[2]) - mesh.place(nodes[1]))
                                 .norm();
    for (const int node : nodes) {
      if (mesh.masters(node).empty()) area[body.free_place(node)] += all / 4;
      for (const NodeWeight& each : mesh.masters(node))
        area[body.free_place(each.node)] += all / 4 * each.weight;
    }
    if (!body.is_quadratic())
      for (SurfacePoint& point : face_points(mesh, body, nodes, all))
        surface.points.push_back(std::move(point));
  }
  area.erase(-1);
  const auto count = static_cast<Eigen::Index>(area.size());
  surface.places.resize(3, count);
  surface.area.resize(count);
  std::map<int, int> index;
  for (const auto& [node, share] : area) {
    const auto column = static_cast<Eigen::Index>(surface.nodes.size());
    surface.places.col(column) = mesh.place(body.free_nodes()[static_cast<std::size_t>(node)]);
    surface.area[column] = share;
    index[node] = static_cast<int>(column);
    surface.nodes.push_back(node);
  }
  for (SurfacePoint& point : surface.points)
    for (NodeWeight& each : point.nodes) each.node = index.at(each.node);
  return surface;
}

double smallest_gap(const ContactSurface& surface, const Shape& object, const Pose<double>& X_PO,
                    const VectorXd& x) {
  const Pose<double> X_OP = X_PO.inverse();
  Matrix3Xd places = surface.places;
  double gap = 1e300;
  for (std::size_t k = 0; k < surface.nodes.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    places.col(column) += x.segment<3>(3 * surface.nodes[k]);
    gap = std::min(gap, object.distance(X_OP * Vector3d(places.col(column))));
  }
  for (const SurfacePoint& point : surface.points) {
    Vector3d p = point.offset;
    for (const NodeWeight& each : point.nodes) p += each.weight * places.col(each.node);
    gap = std::min(gap, object.distance(X_OP * p));
  }
  return gap;
}

MeanGaps::MeanGaps(const ContactSurface& surface) : surface_(surface) {
  const auto count = static_cast<Eigen::Index>(surface.nodes.size());
  gap_ = more_ = VectorXd::Zero(count);
  normal_ = mean_normal_ = own_slope_ = Matrix3Xd::Zero(3, count);
}

void MeanGaps::find(const Shape& object, const Pose<double>& X_PO, const VectorXd& x) {
  const Pose<double> X_OP = X_PO.inverse();
  Matrix3Xd places = surface_.places;
  for (Eigen::Index k = 0; k < places.cols(); ++k) {
    places.col(k) += x.segment<3>(3 * surface_.nodes[static_cast<std::size_t>(k)]);
    const NearestSurface at = object.nearest(X_OP * Vector3d(places.col(k)));
    gap_[k] = at.distance;
    normal_.col(k) = X_PO.R * at.normal;
  }
  if (counts_.empty()) find_edges(object, X_OP);
  mean_normal_ = own_slope_ = normal_;
  more_.setZero();
  near_.clear();
  neighbours_matter_ = false;
  for (std::size_t i = 0; i < surface_.points.size(); ++i) {
    const SurfacePoint& point = surface_.points[i];
    Vector3d p = point.offset, mean(0, 0, 0);
    double nearest = 1e300, distance = 0;
    for (const NodeWeight& each : point.nodes) {
      p += each.weight * places.col(each.node);
      distance += each.weight * gap_[each.node];
      mean += each.weight * normal_.col(each.node);
      nearest = std::min(nearest, gap_[each.node]);
    }
    if (!counts_[i] || nearest > kFar * std::sqrt(point.area)) continue;
    const NearestSurface at = object.nearest(X_OP * p);
    near_.push_back({i, X_PO.R * at.normal});
    const Near& here = near_.back();
    // A node's share of the point, and what it makes of gap and normals there.
    for (const NodeWeight& each : point.nodes) {
      const double share = each.weight * point.area / surface_.area[each.node];
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

void MeanGaps::find_edges(const Shape& object, const Pose<double>& X_OP) {
  Matrix3Xd normal = surface_.places;
  for (Eigen::Index k = 0; k < normal.cols(); ++k)
    normal.col(k) = object.nearest(X_OP * Vector3d(surface_.places.col(k))).normal;
  for (const SurfacePoint& point : surface_.points) {
    double alike = 1;
    for (const NodeWeight& each : point.nodes)
      for (const NodeWeight& other : point.nodes)
        alike = std::min(alike, normal.col(each.node).dot(normal.col(other.node)));
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
    for (const NodeWeight& each : point.nodes)
      out[each.node] += each.weight * point.area / surface_.area[each.node] * more;
  }
  return out;
}

Matrix3Xd MeanGaps::spread(const VectorXd& push) const {
  Matrix3Xd out = normal_ * push.asDiagonal();
  for (const Near& near : near_) {
    const SurfacePoint& point = surface_.points[near.point];
    double more = 0;
    for (const NodeWeight& each : point.nodes)
      more += each.weight * point.area / surface_.area[each.node] * push[each.node];
    if (more == 0) continue;
    for (const NodeWeight& each : point.nodes)
      out.col(each.node) += more * each.weight * (near.normal - normal_.col(each.node));
  }
  return out;
}

}  // namespace thenar
