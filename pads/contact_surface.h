#pragma once

/// The surface of a body that may touch a rigid object, and its gaps.

#include <array>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/shape.h"
#include "pads/pressed_face.h"
#include "pads/tissue_body.h"

namespace thenar {

/// A point of a curved surface between nodes.
struct SurfacePoint {
  Eigen::Vector3d offset;         // from the mean of the nodes, at rest [m] (3)
  std::vector<NodeWeight> nodes;  // of the surface, with their shape functions [1]
  double area = 0;                // of the surface that it stands for [m^2]
  double size = 0;                // of its face, the root of its area [m]
};

/// A face of a curved surface, bilinear between corners that are as far out as the true surface
/// around them in the mean.
struct SurfaceFace {
  std::array<std::vector<NodeWeight>, 4> corners;  // nodes of the surface whose mean each goes with
  FaceCorners offsets;                             // from these means [m]
  double area = 0;                                 // [m^2]
  int cell = 0;                                    // of the mesh
};

/// Free nodes of a body that may touch.
struct ContactSurface {
  std::vector<int> nodes;            // places among the free nodes
  Eigen::Matrix3Xd places;           // reference positions [m] (3, nodes)
  Eigen::VectorXd area;              // of the reference surface, a node's share [m^2] (nodes)
  std::vector<SurfacePoint> points;  // Gauss points of faces whose nodes are all free; none: gaps
                                     // of nodes count
  std::vector<SurfaceFace> faces;    // the same faces
};

/// Free nodes of faces all of whose nodes are marked; a hanging node's share goes to its masters.
/// @param marked  (nodes of the mesh)
[[nodiscard]] ContactSurface contact_surface(const HexMesh& mesh, const TissueBody& body,
                                             const std::vector<bool>& marked);

/// Number among the nodes of the mesh of the k-th node of a surface.
[[nodiscard]] int mesh_node(const TissueBody& body, const ContactSurface& surface, std::size_t k);

/// Places of its nodes, deformed [m] (3, nodes). @param x  of the body's free nodes [m] (3 free
/// nodes)
[[nodiscard]] Eigen::Matrix3Xd places_of(const ContactSurface& surface, const Eigen::VectorXd& x);

/// Returns the position of a point of a surface [m] (3). @param places  of the nodes [m] (3, nodes)
[[nodiscard]] Eigen::Vector3d place_of(const SurfacePoint& point, const Eigen::Matrix3Xd& places);

/// Returns the positions of the corners of a face [m]. @param places  of the nodes [m] (3, nodes)
[[nodiscard]] FaceCorners corners_of(const SurfaceFace& face, const Eigen::Matrix3Xd& places);

/// Area of faces that is each node's share, a quarter of each of its faces; shares of hanging nodes
/// go to their masters [m^2] (nodes of the mesh).
/// @param at  places of all nodes [m] (3, nodes of the mesh)
[[nodiscard]] Eigen::VectorXd node_areas(const HexMesh& mesh, const std::vector<HexFace>& faces,
                                         const Eigen::Matrix3Xd& at);

/// Smallest distance of an object to the nodes of a surface and to its true points between [m].
/// @param x  displacements of the body's free nodes [m] (3 free nodes)
[[nodiscard]] double smallest_gap(const ContactSurface& surface, const Shape& object,
                                  const Pose<double>& X_PO, const Eigen::VectorXd& x);

/// Returns whether an edge or a corner of an object lies over a face of the surface near it:
/// between the nearest places of a node and of a point of the face, normals of the object turn by
/// 10 degrees and more as on a radius of less than a quarter of the face.
/// @param x  displacements of the body's free nodes [m] (3 free nodes)
[[nodiscard]] bool meets_edge(const ContactSurface& surface, const Shape& object,
                              const Pose<double>& X_PO, const Eigen::VectorXd& x);

/// Gaps of nodes in the mean over the true surface around them:
///   g_k = d(x_k) + sum_q w_kq [d(X_q + u_q) - sum_B N_B(q) d(x_B)],
///   w_kq = N_k(q) area_q / sum_q N_k(q) area_q,
/// where d is the distance to the object and q are the surface's points. Whatever forces act on
/// these gaps are handed to nodes by their slopes, so that a push does the work that tissue takes
/// up. Of objects without edges: see SkinSprings.
class MeanGaps {
 public:
  explicit MeanGaps(const ContactSurface& surface);

  /// Sets all that follows. @param x  displacements of the body's free nodes [m] (3 free nodes)
  void find(const Shape& object, const Pose<double>& X_PO, const Eigen::VectorXd& x);

  [[nodiscard]] double gap(std::size_t k) const { return gap_[static_cast<Eigen::Index>(k)]; }
  /// Returns the gap of a node less the distance of the node itself to the object [m].
  [[nodiscard]] double more(std::size_t k) const { return more_[static_cast<Eigen::Index>(k)]; }
  /// Unit normal of the object in the mean around a node, body's frame (3).
  [[nodiscard]] Eigen::Vector3d normal(std::size_t k) const {
    return mean_normal_.col(static_cast<Eigen::Index>(k));
  }
  /// Slope of a node's gap by its own place (3).
  [[nodiscard]] const Eigen::Vector3d& own_slope(std::size_t k) const { return slopes_[k][0].by; }
  /// Returns whether gaps depend on neighbouring nodes, as they do under all objects but planes.
  [[nodiscard]] bool neighbours_matter() const { return neighbours_matter_; }
  /// Change of gaps, linear. @param moved  of the nodes, the object at rest [m] (3, nodes)
  [[nodiscard]] Eigen::VectorXd change(const Eigen::Matrix3Xd& moved) const;
  /// d gap / d place of a node.
  struct Slope {
    int row, node;       // of the gap among those that were asked; of the surface
    Eigen::Vector3d by;  // (3)
  };
  /// All slopes of some nodes' gaps.
  [[nodiscard]] std::vector<Slope> slopes(const std::vector<int>& nodes) const;
  /// Forces on nodes of forces that open gaps, its transpose. @param push  [N] (nodes)
  [[nodiscard]] Eigen::Matrix3Xd spread(const Eigen::VectorXd& push) const;

 private:
  /// Adds to the slope of the gap of node `row` by node `node`.
  void add_slope(int row, int node, const Eigen::Vector3d& by);

  const ContactSurface& surface_;
  Eigen::VectorXd gap_, more_;
  Eigen::Matrix3Xd normal_, mean_normal_;
  std::vector<std::vector<Slope>> slopes_;  // of each gap, by its own node first (nodes)
  bool neighbours_matter_ = false;
};

}  // namespace thenar
