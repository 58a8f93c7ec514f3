#include "pads/contact_area.h"

#include <algorithm>
#include <cmath>

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kFacePoints = 8;  // points along one side of a face at which contact is sampled
// Least cosine of the normals of skin and object that face each other [1]
constexpr double kFacingCosine = 0.7;
// Mean length of a cell's side across an edge over the side's length, pi / 4 [1]
constexpr double kMeanSideShare = 0.7854;
// Length of the mean unit vector to open nodes below which the patch is a strip at a node [1]
constexpr double kStripMean = 0.5;
constexpr int kEdgeHalvings = 30;  // bisections for the position of an edge
constexpr double kEdgeScale = 12;  // ratio of pressure to gap at an edge over mu / h [1]

/// Returns the pressure of the nodes of a mesh [Pa] (nodes); hanging nodes have the mean of their
/// masters.
VectorXd node_pressures(const HexMesh& mesh, const TissueBody& body, const ContactSurface& surface,
                        const PressState& state) {
  VectorXd pressure = VectorXd::Zero(mesh.nodes());
  for (std::size_t k = 0; k < surface.nodes.size(); ++k) {
    pressure[mesh_node(body, surface, k)] = state.normal_force[k] / surface.area[k];
  }
  for (int node = 0; node < mesh.nodes(); ++node)
    for (const NodeWeight& each : mesh.masters(node))
      pressure[node] += each.weight * pressure[each.node];
  return pressure;
}

/// Returns the argument in (low, high) at which the decreasing function f has a value, by
/// bisection.
template <typename Function>
double falling_root(double value, double low, double high, const Function& f) {
  for (int k = 0; k < kEdgeHalvings; ++k) {
    const double middle = (low + high) / 2;
    (f(middle) > value ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Returns the distance of a patch's edge from a touching node towards an open neighbour, over the
/// distance h of the two nodes [1]. It follows from the ratio r = E* gap / (p h). Within and beyond
/// the edge pressure is K s^1/2 and the gap 4/3 K s^3/2 / E* at a distance s; a node's pressure is
/// the mean over half a cell on both sides, so that it touches from -1/2 on:
///   r(a) = 2 (1 - a)^3/2 / [(a + 1/2)^3/2 - max(0, a - 1/2)^3/2],  -1/2 < a < 1.  [1]
double edge_distance(double ratio) {
  return falling_root(ratio, -0.5, 1, [](double a) {
    return 2 * std::pow(1 - a, 1.5) /
           (std::pow(a + 0.5, 1.5) - std::pow(std::max(0.0, a - 0.5), 1.5));
  });
}

/// Returns the half width of a patch that nodes of one row alone touch, over h, by the same ratio:
/// a strip [-b h, b h] under a parabola, with all of its push on the row (Hertz):
///   r(b) = 2 [(1 - b^2)^1/2 - b^2 arcosh(1 / b)] / (pi b^2),  0 < b < 1.  [1]
double strip_half_width(double ratio) {
  return falling_root(ratio, 0, 1, [](double b) {
    return 2 * (std::sqrt(1 - b * b) - b * b * std::acosh(1 / b)) / (EIGEN_PI * b * b);
  });
}

/// Returns the corners of a face in order around it.
std::array<int, 4> corners_in_order(const HexFace& face) {
  return {face.nodes[0], face.nodes[1], face.nodes[3], face.nodes[2]};
}

/// Returns the shear modulus of the tangent of stretched tissue [Pa].
double stretched_shear_modulus(const Tissue& tissue, const Eigen::Matrix3d& F) {
  if (!(F.determinant() > 0)) return tissue.shear_modulus;
  IsochoricResponse response;
  isochoric_response(tissue, F, true, response);
  return tangent_shear_modulus(tissue, response);
}

/// Side of a face between a touching and an open node.
struct EdgeCrossing {
  int in, out;    // nodes of the mesh
  Vector3d side;  // vector from the touching to the open node [m] (3)
  double ratio;   // argument of edge_distance() [1]
};

/// Rest positions of nodes and their displacements [m] (3, nodes).
struct MovedNodes {
  const Matrix3Xd &at_rest, &u;
};

/// Finds the sides of faces that the edge of the patch crosses.
std::vector<EdgeCrossing> find_crossings(const HexMesh& mesh, const std::vector<Tissue>& tissues,
                                         const std::vector<HexFace>& faces, const MovedNodes& nodes,
                                         const VectorXd& pressure, const RigidObject& object,
                                         const PressState& state) {
  const Pose<double> X_OP = state.X_PO.inverse();
  const auto place = [&](int node) {
    return Vector3d(nodes.at_rest.col(node) + nodes.u.col(node));
  };
  std::vector<EdgeCrossing> crossings;
  for (const HexFace& face : faces) {
    // Take faces that touch at some corners, with  E* = 2 mu / (1 - nu)  of the stretched tissue.
    const std::array<int, 4> corners = corners_in_order(face);
    const auto touching =
        std::count_if(corners.begin(), corners.end(), [&](int node) { return pressure[node] > 0; });
    if (touching == 0 || touching == 4) continue;
    const HexCell& cell = mesh.cells()[face.cell];
    const Tissue& tissue = tissues[cell.region];
    const double modulus =
        2 / (1 - tissue.poisson_ratio) *
        stretched_shear_modulus(tissue, mean_deformation(cell, nodes.at_rest, nodes.u));
    // Add sides from a touching corner to an open one, with the ratio  E* gap / (p h).
    for (std::size_t i = 0; i < 4; ++i) {
      const int one = corners[i], other = corners[(i + 1) % 4];
      if ((pressure[one] > 0) == (pressure[other] > 0)) continue;
      const int in = pressure[one] > 0 ? one : other, out = in == one ? other : one;
      const Vector3d side = place(out) - place(in);
      const double gap = std::max(0.0, object.shape->distance(X_OP * place(out)));
      crossings.push_back(
          {in, out, side, modulus * gap / (pressure[in] * kMeanSideShare * side.norm())});
    }
  }
  return crossings;
}

/// Returns the depth of each node inside the patch, over the size of a face [1] (nodes): the mean
/// over the node's crossings, negative outside, 1 or -1 for nodes without a crossing.
/// @param pressure  (nodes)
std::vector<double> depths_inside(const std::vector<EdgeCrossing>& crossings,
                                  const VectorXd& pressure) {
  // Sum the directions from touching to open nodes.
  Matrix3Xd direction = Matrix3Xd::Zero(3, pressure.size());
  VectorXd count = VectorXd::Zero(pressure.size());
  for (const EdgeCrossing& each : crossings) {
    direction.col(each.in) += each.side.normalized();
    count[each.in] += 1;
    count[each.out] += 1;
  }
  std::vector<double> inside(static_cast<std::size_t>(pressure.size()), 0);
  for (const EdgeCrossing& each : crossings) {
    // Average the distances over crossings. Between open nodes on opposite sides lies a strip.
    const bool is_strip = direction.col(each.in).norm() < kStripMean * count[each.in];
    const double edge = is_strip ? strip_half_width(each.ratio) : edge_distance(each.ratio);
    inside[each.in] += edge / count[each.in];
    inside[each.out] += (edge - 1) / count[each.out];
  }
  // Nodes without a crossing are all inside or all outside.
  for (Eigen::Index node = 0; node < pressure.size(); ++node)
    if (count[node] == 0) inside[node] = pressure[node] > 0 ? 1 : -1;
  return inside;
}

/// Returns the area of sampled points of faces that are inside the object, or so near to it that
/// the pressure around them shows contact [m^2].
double sampled_area(const HexMesh& mesh, const TissueBody& body, const std::vector<Tissue>& tissues,
                    const ContactSurface& surface, const RigidObject& object,
                    const PressState& state) {
  const Pose<double> X_OP = state.X_PO.inverse();
  const Matrix3Xd u = body.node_displacements(state.x, {}), at_rest = rest_positions(mesh);
  const Matrix3Xd places = deformed_positions(surface, state.x);
  const VectorXd pressure = state.normal_force.cwiseQuotient(surface.area);
  double area = 0;
  for (const SurfaceFace& face : surface.faces) {
    // Take faces with pressure at some corner.
    Eigen::Vector4d pressures = Eigen::Vector4d::Zero();
    for (std::size_t k = 0; k < 4; ++k)
      for (const NodeWeight& each : face.corners[k])
        pressures[k] += each.weight * pressure[each.node];
    if (!(pressures.array() > 0).any()) continue;
    // Compute the ratio of pressure to gap at an edge: skin with a smaller gap touches.
    const HexCell& cell = mesh.cells()[face.cell];
    const double scale =
        kEdgeScale *
        stretched_shear_modulus(tissues[cell.region], mean_deformation(cell, at_rest, u)) /
        std::sqrt(face.area);
    const FaceCorners corners = corner_positions(face, places);
    const Vector3d between =
        Vector3d(corners.col(3) - corners.col(0)).cross(Vector3d(corners.col(2) - corners.col(1)));
    const Vector3d across = between.normalized();
    // Sum the share of the face's points that are inside or near enough.
    double share = 0;
    for (int i = 0; i < kFacePoints; ++i)
      for (int j = 0; j < kFacePoints; ++j) {
        const double x = (i + 0.5) / kFacePoints, y = (j + 0.5) / kFacePoints;
        const Eigen::Vector4d shape = face_shape(x, y);
        // Exclude skin beside the object's edge, which does not face it.
        const NearestSurface nearest = object.shape->nearest(X_OP * Vector3d(corners * shape));
        const double facing = std::abs(across.dot(state.X_PO.R * nearest.normal));
        if (nearest.distance < 0 ||
            (nearest.distance < pressures.dot(shape) / scale && facing > kFacingCosine))
          share += 1.0 / (kFacePoints * kFacePoints);
      }
    area += share * 0.5 * between.norm();
  }
  return area;
}

}  // namespace

double positive_share(const std::array<double, 3>& values) {
  const auto above = std::count_if(values.begin(), values.end(), [](double v) { return v > 0; });
  if (above == 0) return 0;
  if (above == 3) return 1;
  // The corner alone on its side of 0 cuts off a triangle, whose share is a product of two parts.
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
  if (state.uses_skin_springs) return sampled_area(mesh, body, tissues, surface, object, state);
  const Matrix3Xd at_rest = rest_positions(mesh), u = body.node_displacements(state.x, {});
  const VectorXd pressure = node_pressures(mesh, body, surface, state);
  const std::vector<HexFace> faces = marked_faces(mesh, skin);
  const std::vector<double> inside = depths_inside(
      find_crossings(mesh, tissues, faces, {at_rest, u}, pressure, object, state), pressure);
  double area = 0;
  for (const HexFace& face : faces) {
    // Collect the deformed corners of the face and their depths inside the patch.
    const std::array<int, 4> corners = corners_in_order(face);
    std::array<Vector3d, 4> at;
    std::array<double, 4> value{};
    for (std::size_t i = 0; i < 4; ++i) {
      at[i] = at_rest.col(corners[i]) + u.col(corners[i]);
      value[i] = inside[corners[i]];
    }
    const Vector3d middle = (at[0] + at[1] + at[2] + at[3]) / 4;
    const double mean = (value[0] + value[1] + value[2] + value[3]) / 4;
    // Add four triangles around the middle.
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t j = (i + 1) % 4;
      area += positive_share({value[i], value[j], mean}) * 0.5 *
              (at[i] - middle).cross(at[j] - middle).norm();
    }
  }
  return area;
}

}  // namespace thenar
