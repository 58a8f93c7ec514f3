#pragma once

/// Surface of a body that may touch a rigid object, and its gaps.

#include <array>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/shape.h"
#include "pads/pressed_face.h"
#include "pads/tissue_body.h"

namespace thenar {

/// A Gauss point of a face on a curved surface.
struct SurfacePoint {
  Eigen::Vector3d offset;         // from the weighted mean of the nodes, at rest [m] (3)
  std::vector<NodeWeight> nodes;  // nodes of the surface with their shape functions [1]
  double area = 0;                // integration weight, area of the surface [m^2]
  double size = 0;                // size of its face, the root of the face's area [m]
};

/// A bilinear face of a curved surface. Its corners are moved outward by the mean offset of the
/// true surface around them.
struct SurfaceFace {
  std::array<std::vector<NodeWeight>, 4> corners;  // surface nodes whose mean each corner follows
  FaceCorners offsets;                             // offsets of the corners from these means [m]
  double area = 0;                                 // [m^2]
  int cell = 0;                                    // cell of the mesh
};

/// Free nodes of a body that may touch an object.
struct ContactSurface {
  std::vector<int> nodes;           // indices among the free nodes
  Eigen::Matrix3Xd rest_positions;  // reference positions [m] (3, nodes)
  Eigen::VectorXd area;  // area of the reference surface assigned to a node [m^2] (nodes)
  std::vector<SurfacePoint> points;  // Gauss points of faces whose nodes are all free; empty for
                                     // quadratic elements, which use the gaps of nodes alone
  std::vector<SurfaceFace> faces;    // faces of these points
};

/// Builds the surface of the free nodes on faces all of whose nodes are marked. The area of a
/// hanging node is assigned to its masters.
/// @param marked  (nodes of the mesh)
[[nodiscard]] ContactSurface build_contact_surface(const HexMesh& mesh, const TissueBody& body,
                                                   const std::vector<bool>& marked);

/// Returns the mesh node of the k-th node of a surface.
[[nodiscard]] int mesh_node(const TissueBody& body, const ContactSurface& surface, std::size_t k);

/// Returns the deformed positions of the surface nodes [m] (3, nodes).
/// @param x  displacements of the body's free nodes [m] (3 free nodes)
[[nodiscard]] Eigen::Matrix3Xd deformed_positions(const ContactSurface& surface,
                                                  const Eigen::VectorXd& x);

/// Returns the position of a point of a surface [m] (3).
/// @param places  positions of the surface nodes [m] (3, nodes)
[[nodiscard]] Eigen::Vector3d point_position(const SurfacePoint& point,
                                             const Eigen::Matrix3Xd& places);

/// Returns the positions of the corners of a face [m] (3, 4).
/// @param places  positions of the surface nodes [m] (3, nodes)
[[nodiscard]] FaceCorners corner_positions(const SurfaceFace& face, const Eigen::Matrix3Xd& places);

/// Returns the area assigned to each node, a quarter of each of its faces; areas of hanging nodes
/// are assigned to their masters [m^2] (nodes of the mesh).
/// @param at  positions of all nodes [m] (3, nodes of the mesh)
[[nodiscard]] Eigen::VectorXd node_areas(const HexMesh& mesh, const std::vector<HexFace>& faces,
                                         const Eigen::Matrix3Xd& at);

/// Returns the smallest distance of an object to the nodes and points of a surface [m]; below 0:
/// inside the object.
/// @param x  displacements of the body's free nodes [m] (3 free nodes)
[[nodiscard]] double min_gap(const ContactSurface& surface, const Shape& object,
                             const Pose<double>& X_PO, const Eigen::VectorXd& x);

/// Returns whether an edge or a corner of an object lies over a nearby face of the surface: between
/// the nearest points of the object to a node and to a point of the face, the object's normal turns
/// by at least 10 degrees, on a radius below a quarter of the face's size.
/// @param x  displacements of the body's free nodes [m] (3 free nodes)
[[nodiscard]] bool has_edge_nearby(const ContactSurface& surface, const Shape& object,
                                   const Pose<double>& X_PO, const Eigen::VectorXd& x);

/// Gaps of nodes, averaged over the true surface around them:
///   g_k = d(x_k) + sum_q w_kq [d(X_q + u_q) - sum_B N_B(q) d(x_B)],
///   w_kq = N_k(q) area_q / sum_q N_k(q) area_q,
/// where d is the distance to the object and q are the points of the surface. A force on a gap is
/// distributed to the nodes by the gap's gradient, so that its work equals that on the tissue. For
/// objects without edges; with edges see SkinSprings.
class MeanGaps {
 public:
  explicit MeanGaps(const ContactSurface& surface);

  /// Computes gaps, normals and gradients.
  /// @param x  displacements of the body's free nodes [m] (3 free nodes)
  void update(const Shape& object, const Pose<double>& X_PO, const Eigen::VectorXd& x);

  /// Returns the gap of node k [m].
  [[nodiscard]] double gap(std::size_t k) const { return gap_[k]; }
  /// Returns the gap of node k less the distance of the node itself to the object [m].
  [[nodiscard]] double mean_offset(std::size_t k) const { return mean_offset_[k]; }
  /// Returns the object's normal averaged around node k, unit, in the body's frame (3).
  [[nodiscard]] Eigen::Vector3d normal(std::size_t k) const { return mean_normal_.col(k); }
  /// Returns the gradient of a node's gap by its own position (3).
  [[nodiscard]] const Eigen::Vector3d& own_gradient(std::size_t k) const {
    return gradients_[k][0].value;
  }
  /// Returns whether gaps depend on neighbouring nodes, as under all objects but planes.
  [[nodiscard]] bool depends_on_neighbours() const { return depends_on_neighbours_; }
  /// Returns the linear change of all gaps [m] (nodes).
  /// @param moved  motion of the nodes, the object at rest [m] (3, nodes)
  [[nodiscard]] Eigen::VectorXd gap_changes(const Eigen::Matrix3Xd& moved) const;
  /// Gradient of a gap by the position of one node.
  struct Gradient {
    int row;                // index of the gap in the requested list
    int node;               // node of the surface
    Eigen::Vector3d value;  // [1] (3)
  };
  /// Returns all nonzero gradients of the gaps of some nodes.
  [[nodiscard]] std::vector<Gradient> gap_gradients(const std::vector<int>& nodes) const;
  /// Returns the nodal forces of forces that open gaps: the transpose of gap_changes() [N]
  /// (3, nodes).
  /// @param push  force on each gap [N] (nodes)
  [[nodiscard]] Eigen::Matrix3Xd nodal_forces(const Eigen::VectorXd& push) const;

 private:
  /// Adds to the gradient of the gap of node `row` by the position of `node`.
  void add_gradient(int row, int node, const Eigen::Vector3d& value);

  const ContactSurface& surface_;
  Eigen::VectorXd gap_, mean_offset_;
  Eigen::Matrix3Xd normal_, mean_normal_;
  std::vector<std::vector<Gradient>> gradients_;  // gradients of each gap, its own node's first
                                                  // (nodes)
  bool depends_on_neighbours_ = false;
};

}  // namespace thenar
