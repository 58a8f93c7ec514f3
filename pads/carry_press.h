#pragma once

/// Transfer of a press to a refined mesh.

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pads/contact_surface.h"
#include "pads/hex_mesh.h"
#include "pads/press_step.h"
#include "pads/tissue_body.h"

namespace thenar {

/// Transfer of states from the body on a mesh to the body on the refined mesh.
///
/// A new node lies near the mean of the nodes that it was created from. Its offset from that mean
/// at rest, as on a curved skin, is mapped by the mean deformation of the old cells around it:
///   x = sum of w_i x_i + F (X - sum of w_i X_i).
/// A node that no longer hangs is moved likewise from its position while it hung. Without this,
/// cells at the skin would be inverted where the pulp is squeezed to a fifth.
class PressTransfer {
 public:
  /// Stores mesh, body and surface before the mesh is refined.
  PressTransfer(const HexMesh& mesh, std::unique_ptr<TissueBody> body, ContactSurface surface);

  /// Returns a state of the old body on the new one: displacements, pressures, histories, and the
  /// contact forces of nodes from the tractions on the skin. New nodes are anchored at their
  /// present positions.
  [[nodiscard]] PressState transfer_state(const PressState& old, const HexMesh& mesh,
                                          const TissueBody& body,
                                          const ContactSurface& surface) const;

 private:
  /// Origin of an element of the refined mesh: an old element, or one octant of it (-1: all of it).
  struct Origin {
    std::size_t element;
    int octant;
  };
  [[nodiscard]] std::vector<Origin> element_origins(const HexMesh& mesh) const;
  /// Returns the displacement gradient at each node, the mean over the old cells around it (nodes).
  [[nodiscard]] std::vector<Eigen::Matrix3d> node_gradients(const HexMesh& mesh,
                                                            const Eigen::Matrix3Xd& u) const;
  /// Returns the displacements of all nodes [m] (3, nodes of the refined mesh).
  [[nodiscard]] Eigen::Matrix3Xd transferred_displacements(const HexMesh& mesh,
                                                           const PressState& old) const;

  /// Skin quantities at the nodes of the refined mesh.
  struct SkinFields {
    std::vector<double> pressure;                        // [Pa] (nodes)
    std::vector<Eigen::Vector3d> traction;               // friction per area [Pa] (nodes)
    std::vector<std::optional<Eigen::Vector3d>> anchor;  // anchors of old nodes, object's frame [m]
  };
  [[nodiscard]] SkinFields transferred_fields(const HexMesh& mesh, const PressState& old) const;

  std::unique_ptr<TissueBody> body_;
  ContactSurface surface_;
  std::vector<int> active_;          // active cells before the refinement
  Eigen::Matrix3Xd rest_positions_;  // at rest [m] (3, nodes)
};

}  // namespace thenar
