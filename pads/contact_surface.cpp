#include "pads/contact_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/lists.h"
#include "base/numbers.h"

namespace thenar {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// Squared gradient by a neighbour up to which it does not matter [1]
constexpr double kNegligibleGradient = 1e-20;
constexpr double kFarGapRatio = 3;  // gap that does not close, over the size of a face [1]

constexpr double kEdgeTurn = 0.17;         // least difference of unit normals around an edge [1]
constexpr double kEdgeRadiusRatio = 0.25;  // largest radius of an edge over the size of a face [1]

// Gauss rule along a side of a face: positions and weights on [0, 1].
constexpr std::array<double, 3> kGaussPositions{0.112701665379258311, 0.5, 0.887298334620741689};
constexpr std::array<double, 3> kGaussWeights{5.0 / 18, 4.0 / 9, 5.0 / 18};

/// Returns the Gauss points of a face, with free nodes of the body; none if a node is fixed.
std::vector<SurfacePoint> face_points(const HexMesh& mesh, const TissueBody& body,
                                      const std::array<int, 4>& nodes, const Matrix3Xd& at_rest) {
  // Compute the area of the quadrilateral from its diagonals.
  const Vector3d diagonal = at_rest.col(nodes[3]) - at_rest.col(nodes[0]);
  const Vector3d other_diagonal = at_rest.col(nodes[2]) - at_rest.col(nodes[1]);
  const double area = 0.5 * diagonal.cross(other_diagonal).norm();
  std::vector<SurfacePoint> out;
  for (std::size_t i = 0; i < kGaussPositions.size(); ++i)
    for (std::size_t j = 0; j < kGaussPositions.size(); ++j) {
      const double x = kGaussPositions[i], y = kGaussPositions[j];
      const Eigen::Vector4d shape = face_shape(x, y);
      // Interpolate the point, its position in the chart, and the weights of free nodes.
      Vector3d chart(0, 0, 0), mean(0, 0, 0);
      std::map<int, double> weights;
      for (std::size_t k = 0; k < 4; ++k) {
        const double share = shape[k];
        chart += share * mesh.chart_point(nodes[k]);
        mean += share * at_rest.col(nodes[k]);
        for (const NodeWeight& each : mesh.support(nodes[k]))
          weights[body.free_index(each.node)] += share * each.weight;
      }
      if (weights.count(-1) != 0) return {};  // a node is fixed
      // The true surface is where the chart maps the point.
      SurfacePoint point{mesh.chart().place(chart) - mean,
                         {},
                         area * kGaussWeights[i] * kGaussWeights[j],
                         std::sqrt(area)};
      for (const auto& [node, weight] : weights) point.nodes.push_back({node, weight});
      out.push_back(std::move(point));
    }
  return out;
}

}  // namespace

VectorXd node_areas(const HexMesh& mesh, const std::vector<HexFace>& faces, const Matrix3Xd& at) {
  VectorXd area = VectorXd::Zero(mesh.nodes());
  for (const HexFace& face : faces) {
    // Assign a quarter of the face's area to each corner.
    const Vector3d diagonal = at.col(face.nodes[3]) - at.col(face.nodes[0]);
    const Vector3d other_diagonal = at.col(face.nodes[2]) - at.col(face.nodes[1]);
    const double share = 0.125 * diagonal.cross(other_diagonal).norm();
    for (const int node : face.nodes)
      for (const NodeWeight& each : mesh.support(node)) area[each.node] += share * each.weight;
  }
  return area;
}

ContactSurface build_contact_surface(const HexMesh& mesh, const TissueBody& body,
                                     const std::vector<bool>& marked) {
  ContactSurface surface;
  const Matrix3Xd at_rest = rest_positions(mesh);
  const std::vector<HexFace> faces = marked_faces(mesh, marked);
  const VectorXd area = node_areas(mesh, faces, at_rest);
  // List the free nodes with a share of the area.
  std::vector<int> index(body.free_nodes().size(), -1);
  for (std::size_t free = 0; free < index.size(); ++free) {
    if (!(area[body.free_nodes()[free]] > 0)) continue;
    index[free] = static_cast<int>(surface.nodes.size());
    surface.nodes.push_back(static_cast<int>(free));
  }
  const auto count = static_cast<Eigen::Index>(surface.nodes.size());
  surface.rest_positions.resize(3, count);
  surface.area.resize(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const int node = mesh_node(body, surface, static_cast<std::size_t>(k));
    surface.rest_positions.col(k) = mesh.place(node);
    surface.area[k] = area[node];
  }
  if (body.is_quadratic()) return surface;
  // Add faces and their Gauss points, with indices of surface nodes.
  for (const HexFace& face : faces) {
    std::vector<SurfacePoint> points = face_points(mesh, body, face.nodes, at_rest);
    if (points.empty()) continue;
    SurfaceFace whole{{}, FaceCorners::Zero(), 0, face.cell};
    for (SurfacePoint& point : points) {
      for (NodeWeight& each : point.nodes) each.node = index[each.node];
      whole.area += point.area;
      surface.points.push_back(std::move(point));
    }
    for (std::size_t k = 0; k < 4; ++k)
      for (const NodeWeight& each : mesh.support(face.nodes[k]))
        whole.corners[k].push_back({index[body.free_index(each.node)], each.weight});
    surface.faces.push_back(std::move(whole));
  }
  // Move the corners of faces by the mean offset of the true surface around their nodes.
  Matrix3Xd mean_offsets = Matrix3Xd::Zero(3, count);
  for (const SurfacePoint& point : surface.points)
    for (const NodeWeight& each : point.nodes)
      mean_offsets.col(each.node) +=
          each.weight * point.area / surface.area[each.node] * point.offset;
  for (SurfaceFace& face : surface.faces) face.offsets = corner_positions(face, mean_offsets);
  return surface;
}

int mesh_node(const TissueBody& body, const ContactSurface& surface, std::size_t k) {
  return body.free_nodes()[surface.nodes[k]];
}

Matrix3Xd deformed_positions(const ContactSurface& surface, const VectorXd& x) {
  Matrix3Xd places = surface.rest_positions;
  for (Eigen::Index k = 0; k < places.cols(); ++k)
    places.col(k) += x.segment<3>(3 * surface.nodes[k]);
  return places;
}

Vector3d point_position(const SurfacePoint& point, const Matrix3Xd& places) {
  Vector3d p = point.offset;
  for (const NodeWeight& each : point.nodes) p += each.weight * places.col(each.node);
  return p;
}

FaceCorners corner_positions(const SurfaceFace& face, const Matrix3Xd& places) {
  FaceCorners out = face.offsets;
  for (Eigen::Index k = 0; k < 4; ++k)
    for (const NodeWeight& each : face.corners[k])
      out.col(k) += each.weight * places.col(each.node);
  return out;
}

double min_gap(const ContactSurface& surface, const Shape& object, const Pose<double>& X_PO,
               const VectorXd& x) {
  const Pose<double> X_OP = X_PO.inverse();
  const Matrix3Xd places = deformed_positions(surface, x);
  double gap = kInfinity;
  for (Eigen::Index k = 0; k < places.cols(); ++k)
    gap = std::min(gap, object.distance(X_OP * Vector3d(places.col(k))));
  for (const SurfacePoint& point : surface.points)
    gap = std::min(gap, object.distance(X_OP * point_position(point, places)));
  return gap;
}

bool has_edge_nearby(const ContactSurface& surface, const Shape& object, const Pose<double>& X_PO,
                     const VectorXd& x) {
  const Pose<double> X_OP = X_PO.inverse();
  const Matrix3Xd places = deformed_positions(surface, x);
  // Nearest point of the object, and its normal there, in the object's frame.
  struct Nearest {
    double distance;
    Vector3d position, normal;
  };
  const auto nearest = [&](const Vector3d& p) {
    const NearestSurface at = object.nearest(X_OP * p);
    return Nearest{at.distance, X_OP * p - at.distance * at.normal, at.normal};
  };
  std::vector<Nearest> at_nodes;
  for (Eigen::Index k = 0; k < places.cols(); ++k)
    at_nodes.push_back(nearest(Vector3d(places.col(k))));
  return any_of(surface.points, [&](const SurfacePoint& point) {
    const auto at = [&](const NodeWeight& each) -> const Nearest& { return at_nodes[each.node]; };
    // Skip points whose nodes are all far from the object.
    const bool far = all_of(point.nodes, [&](const NodeWeight& each) {
      return at(each).distance > kFarGapRatio * point.size;
    });
    if (far) return false;
    // Look for normals that turn much between nearby points of the object.
    const Nearest here = nearest(point_position(point, places));
    return any_of(point.nodes, [&](const NodeWeight& each) {
      const Vector3d turn = at(each).normal - here.normal;
      const double along = std::abs(turn.dot(at(each).position - here.position));
      return turn.norm() > kEdgeTurn && along < kEdgeRadiusRatio * point.size * turn.squaredNorm();
    });
  });
}

MeanGaps::MeanGaps(const ContactSurface& surface)
    : surface_(surface), gradients_(surface.nodes.size()) {
  const auto count = static_cast<Eigen::Index>(surface.nodes.size());
  gap_ = mean_offset_ = VectorXd::Zero(count);
  normal_ = mean_normal_ = Matrix3Xd::Zero(3, count);
}

void MeanGaps::update(const Shape& object, const Pose<double>& X_PO, const VectorXd& x) {
  const Pose<double> X_OP = X_PO.inverse();
  const Matrix3Xd places = deformed_positions(surface_, x);
  // Start from the distances of the nodes, whose gradients are the object's normals.
  for (Eigen::Index k = 0; k < places.cols(); ++k) {
    const NearestSurface at = object.nearest(X_OP * Vector3d(places.col(k)));
    gap_[k] = at.distance;
    normal_.col(k) = X_PO.R * at.normal;
    const int node = static_cast<int>(k);
    gradients_[k] = {{node, node, normal_.col(k)}};
  }
  mean_normal_ = normal_;
  mean_offset_.setZero();
  depends_on_neighbours_ = false;
  for (const SurfacePoint& point : surface_.points) {
    // Interpolate the distances and normals of the nodes at the point.
    Vector3d mean(0, 0, 0);
    double nearest = kInfinity, distance = 0;
    for (const NodeWeight& each : point.nodes) {
      distance += each.weight * gap_[each.node];
      mean += each.weight * normal_.col(each.node);
      nearest = std::min(nearest, gap_[each.node]);
    }
    if (nearest > kFarGapRatio * point.size) continue;
    const NearestSurface at = object.nearest(X_OP * point_position(point, places));
    const Vector3d normal = X_PO.R * at.normal;
    // Distribute the differences of the true distance and normal to the nodes.
    for (const NodeWeight& each : point.nodes) {
      const double share = each.weight * point.area / surface_.area[each.node];
      mean_offset_[each.node] += share * (at.distance - distance);
      mean_normal_.col(each.node) += share * (normal - mean);
      for (const NodeWeight& other : point.nodes)
        add_gradient(each.node, other.node,
                     share * other.weight * (normal - normal_.col(other.node)));
    }
  }
  gap_ += mean_offset_;
  for (Eigen::Index k = 0; k < places.cols(); ++k)
    if (mean_normal_.col(k).squaredNorm() > 0) mean_normal_.col(k).normalize();
}

void MeanGaps::add_gradient(int row, int node, const Vector3d& value) {
  depends_on_neighbours_ = depends_on_neighbours_ || value.squaredNorm() > kNegligibleGradient;
  std::vector<Gradient>& list = gradients_[row];
  if (Gradient* known = find_where(list, [&](const auto& each) { return each.node == node; }))
    known->value += value;
  else
    list.push_back({row, node, value});
}

VectorXd MeanGaps::gap_changes(const Matrix3Xd& moved) const {
  VectorXd out = VectorXd::Zero(moved.cols());
  for (const std::vector<Gradient>& list : gradients_)
    for (const Gradient& each : list) out[each.row] += each.value.dot(moved.col(each.node));
  return out;
}

std::vector<MeanGaps::Gradient> MeanGaps::gap_gradients(const std::vector<int>& nodes) const {
  std::vector<Gradient> out;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (const Gradient& each : gradients_[nodes[i]])
      if (depends_on_neighbours_ || each.node == each.row)
        out.push_back({static_cast<int>(i), each.node, each.value});
  return out;
}

Matrix3Xd MeanGaps::nodal_forces(const VectorXd& push) const {
  Matrix3Xd out = Matrix3Xd::Zero(3, push.size());
  for (const std::vector<Gradient>& list : gradients_)
    for (const Gradient& each : list)
      if (push[each.row] != 0) out.col(each.node) += push[each.row] * each.value;
  return out;
}

}  // namespace thenar
