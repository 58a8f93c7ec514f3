#include "pads/contact_area.h"

#include <algorithm>
#include <cmath>

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kFacing = 0.7;  // cosine between normals of skin and object that face each other
constexpr double kEdge = 20;     // of mu / h, the scale of pressure over gap at an edge [1]

/// Pressure of the nodes of a mesh [Pa] (nodes); of hanging ones the mean of their masters.
VectorXd pressures_of(const HexMesh& mesh, const TissueBody& body, const ContactSurface& surface,
                      const PressState& state) {
  VectorXd pressure = VectorXd::Zero(mesh.nodes());
  for (std::size_t k = 0; k < surface.nodes.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    pressure[mesh_node(body, surface, k)] = state.normal[column] / surface.area[column];
  }
  for (int node = 0; node < mesh.nodes(); ++node)
    for (const NodeWeight& each : mesh.masters(node))
      pressure[node] += each.weight * pressure[each.node];
  return pressure;
}

/// Shear modulus of tissue as it is stretched [Pa].
double modulus_of(const Tissue& tissue, const Eigen::Matrix3d& F) {
  if (!(F.determinant() > 0)) return tissue.shear_modulus;
  IsochoricResponse response;
  isochoric_response(tissue, F, true, response);
  return tangent_shear_modulus(tissue, response);
}

/// Area where points of the grid are inside the object, or so near that the pressure around them
/// tells of contact: the rule of nodes at a point.
double grid_area(const HexMesh& mesh, const TissueBody& body, const std::vector<Tissue>& tissues,
                 const ContactSurface& surface, const RigidObject& object,
                 const PressState& state) {
  constexpr std::size_t kPoints = kGridPoints * kGridPoints;
  const Pose<double> X_OP = state.X_PO.inverse();
  const Matrix3Xd u = body.spread(state.x, {}), at_rest = places_at_rest(mesh);
  const Matrix3Xd places = places_of(surface, state.x);
  const VectorXd pressure = state.normal.cwiseQuotient(surface.area);
  double area = 0;
  for (std::size_t first = 0; first < surface.grid.size(); first += kPoints) {
    const SurfacePoint* points = &surface.grid[first];
    const HexCell& cell = mesh.cells()[static_cast<std::size_t>(points[0].cell)];
    const bool touches = std::any_of(points, points + kPoints, [&](const SurfacePoint& point) {
      return std::any_of(point.nodes.begin(), point.nodes.end(),
                         [&](const NodeWeight& each) { return pressure[each.node] > 0; });
    });
    if (!touches) continue;
    const double scale = kEdge *
                         modulus_of(tissues[static_cast<std::size_t>(cell.region)],
                                    mean_deformation(cell, at_rest, u)) /
                         points[0].size;
    // The face between its outermost points, which are 1 - 1 / kGridPoints of its sides apart.
    const auto at = [&](std::size_t i) { return place_of(points[i], places); };
    const Vector3d between =
        (at(kPoints - 1) - at(0)).cross(at(kPoints - kGridPoints) - at(kGridPoints - 1));
    const double part = 1 - 1.0 / kGridPoints;
    const Vector3d across = between.normalized();
    double share = 0;
    for (std::size_t i = 0; i < kPoints; ++i) {
      double here = 0;
      for (const NodeWeight& each : points[i].nodes) here += each.weight * pressure[each.node];
      // What is beside an edge has it beside, and not below.
      const NearestSurface nearest = object.shape->nearest(X_OP * at(i));
      const double facing = std::abs(across.dot(state.X_PO.R * nearest.normal));
      if (nearest.distance < 0 || (nearest.distance < here / scale && facing > kFacing))
        share += 1.0 / kPoints;
    }
    area += share * 0.5 / (part * part) * between.norm();
  }
  return area;
}

}  // namespace

double positive_share(const std::array<double, 3>& values) {
  const auto above = std::count_if(values.begin(), values.end(), [](double v) { return v > 0; });
  if (above == 0) return 0;
  if (above == 3) return 1;
  // The corner that is alone on its side: its part of the triangle.
  for (std::size_t i = 0; i < 3; ++i) {
    const double own = values[i], a = values[(i + 1) % 3], b = values[(i + 2) % 3];
    if ((own > 0) == (a > 0) || (own > 0) == (b > 0)) continue;
    const double part = own / (own - a) * (own / (own - b));
    return above == 1 ? part : 1 - part;
  }
  return 0;
}

double contact_area(const HexMesh& mesh, const TissueBody& body, const std::vector<Tissue>& tissues,
                    const std::vector<bool>& skin, const ContactSurface& surface,
                    const RigidObject& object, const PressState& state) {
  if (state.by_springs) return grid_area(mesh, body, tissues, surface, object, state);
  const Matrix3Xd u = body.spread(state.x, {}), places = places_at_rest(mesh);
  const Pose<double> X_OP = state.X_PO.inverse();
  const VectorXd pressure = pressures_of(mesh, body, surface, state);
  double area = 0;
  for (const HexFace& face : marked_faces(mesh, skin)) {
    const HexCell& cell = mesh.cells()[static_cast<std::size_t>(face.cell)];
    // The face's corners in a round, and their mean.
    std::array<Vector3d, 4> at;
    std::array<double, 4> value{};
    for (std::size_t i = 0; i < 4; ++i) {
      const int node = face.nodes[i < 2 ? i : 5 - i];
      at[i] = places.col(node) + u.col(node);
      value[i] = pressure[node];
    }
    const double size = std::sqrt(0.5 * (at[2] - at[0]).cross(at[3] - at[1]).norm());
    const Tissue& tissue = tissues[static_cast<std::size_t>(cell.region)];
    const bool edge = std::any_of(value.begin(), value.end(), [](double p) { return p > 0; }) &&
                      std::any_of(value.begin(), value.end(), [](double p) { return p <= 0; });
    const double modulus =
        edge ? modulus_of(tissue, mean_deformation(cell, places, u)) : tissue.shear_modulus;
    const double scale = kEdge * modulus / size;
    for (std::size_t i = 0; i < 4; ++i)
      value[i] =
          value[i] > 0 ? value[i] / scale : -std::max(0.0, object.shape->distance(X_OP * at[i]));
    const Vector3d middle = (at[0] + at[1] + at[2] + at[3]) / 4;
    const double mean = (value[0] + value[1] + value[2] + value[3]) / 4;
    // Four triangles around the mean.
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t j = (i + 1) % 4;
      area += positive_share({value[i], value[j], mean}) * 0.5 *
              (at[i] - middle).cross(at[j] - middle).norm();
    }
  }
  return area;
}

}  // namespace thenar
