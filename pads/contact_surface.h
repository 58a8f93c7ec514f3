#pragma once

/// The surface of a body that may touch a rigid object, and its gaps.

#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/shape.h"
#include "pads/tissue_body.h"

namespace thenar {

/// A point of a curved surface between nodes, for the mean of a gap.
struct SurfacePoint {
  Eigen::Vector3d offset;         // from the mean of the nodes, at rest [m] (3)
  std::vector<NodeWeight> nodes;  // of the surface, with their shape functions [1]
  double area = 0;                // of the surface that it stands for [m^2]
};

/// Free nodes of a body that may touch.
struct ContactSurface {
  std::vector<int> nodes;            // places among the free nodes
  Eigen::Matrix3Xd places;           // reference positions [m] (3, nodes)
  Eigen::VectorXd area;              // of the reference surface, a node's share [m^2] (nodes)
  std::vector<SurfacePoint> points;  // of faces whose nodes are all free; none: gaps of nodes count
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

/// Area of faces that is each node's share, a quarter of each of its faces; shares of hanging nodes
/// go to their masters [m^2] (nodes of the mesh).
/// @param at  places of all nodes [m] (3, nodes of the mesh)
[[nodiscard]] Eigen::VectorXd node_areas(const HexMesh& mesh, const std::vector<HexFace>& faces,
                                         const Eigen::Matrix3Xd& at);

/// Smallest distance of an object to the nodes of a surface and to its true points between [m].
/// @param x  displacements of the body's free nodes [m] (3 free nodes)
[[nodiscard]] double smallest_gap(const ContactSurface& surface, const Shape& object,
                                  const Pose<double>& X_PO, const Eigen::VectorXd& x);

/// Gaps of nodes in the mean over the true surface around them:
///   g_k = d(x_k) + sum_q w_kq [d(X_q + u_q) - sum_B N_B(q) d(x_B)],
///   w_kq = N_k(q) area_q / sum_q N_k(q) area_q,
/// where d is the distance to the object, q are the surface's points. Points between whose nodes
/// normals of the object differ by 78 degrees and more do not count: an edge lies there, and the
/// difference is not one of curvature. Which do is found once, from the body as it is at the first
/// call, so that gaps are smooth within a step. Whatever forces act on these gaps are handed to
/// nodes by their slopes, so that a push does the work that tissue takes up.
class MeanGaps {
 public:
  explicit MeanGaps(const ContactSurface& surface);

  /// Sets all that follows; the first call finds which points count. @param x  displacements of the
  /// body's free nodes [m] (3 free nodes)
  void find(const Shape& object, const Pose<double>& X_PO, const Eigen::VectorXd& x);

  [[nodiscard]] double gap(std::size_t k) const { return gap_[static_cast<Eigen::Index>(k)]; }
  /// What a gap is more than the distance of its node [m].
  [[nodiscard]] double more(std::size_t k) const { return more_[static_cast<Eigen::Index>(k)]; }
  /// Unit normal of the object in the mean around a node, body's frame (3).
  [[nodiscard]] Eigen::Vector3d normal(std::size_t k) const {
    return mean_normal_.col(static_cast<Eigen::Index>(k));
  }
  /// Slope of a node's gap by its own place (3).
  [[nodiscard]] Eigen::Vector3d own_slope(std::size_t k) const {
    return own_slope_.col(static_cast<Eigen::Index>(k));
  }
  /// Whether gaps depend on neighbours: not under planes.
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
  /// A point that counts.
  struct Near {
    std::size_t point;
    Eigen::Vector3d normal;  // of the object, body's frame
  };
  /// Share of a point in the mean of a node of its own, w_kq [1].
  [[nodiscard]] double share_of(const SurfacePoint& point, const NodeWeight& node) const;
  void find_edges();

  const ContactSurface& surface_;
  std::vector<bool> counts_;  // (points)
  Eigen::VectorXd gap_, more_;
  Eigen::Matrix3Xd normal_, mean_normal_, own_slope_;
  std::vector<Near> near_;
  bool neighbours_matter_ = false;
};

}  // namespace thenar
