#pragma once

/// A press carried over to a mesh that was refined.

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pads/contact_surface.h"
#include "pads/hex_mesh.h"
#include "pads/press_step.h"
#include "pads/tissue_body.h"

namespace thenar {

/// Carries states of a body on a mesh to the body on the same mesh, refined.
///
/// A node goes where the tissue takes it: what its place at rest is off the mean of those that it
/// was made from, as on a curved skin, or off its own place while it hung, is turned and stretched
/// by the mean deformation of the old cells around it,
///   x = sum of w_i x_i + F (X - sum of w_i X_i).
/// Where pulp is squeezed to a fifth, cells at the skin would turn inside out without it.
class PressCarrier {
 public:
  /// Keeps mesh, body and surface as they are before the mesh is refined.
  PressCarrier(const HexMesh& mesh, std::unique_ptr<TissueBody> body, ContactSurface surface);

  /// A state of the old body on the new one: displacements, pressures, histories, and tractions on
  /// the skin, from which the forces of nodes follow; new nodes are anchored where they are.
  [[nodiscard]] PressState carry(const PressState& old, const HexMesh& mesh, const TissueBody& body,
                                 const ContactSurface& surface) const;

 private:
  /// Origin of an element of the refined mesh: an old element, or an octant of one (-1: all of it).
  struct Origin {
    std::size_t element;
    int octant;
  };
  [[nodiscard]] std::vector<Origin> origins_in(const HexMesh& mesh) const;
  /// Mean deformation less the identity of old cells around the nodes that they became.
  [[nodiscard]] std::vector<Eigen::Matrix3d> gradients_in(const HexMesh& mesh,
                                                          const Eigen::Matrix3Xd& u) const;
  /// Displacements of all nodes [m] (3, nodes of the refined mesh).
  [[nodiscard]] Eigen::Matrix3Xd displacements_in(const HexMesh& mesh, const PressState& old) const;

  /// Skin quantities, carried to the nodes of the refined mesh.
  struct SkinFields {
    std::vector<double> pressure;                        // [Pa] (nodes)
    std::vector<Eigen::Vector3d> traction;               // of friction [Pa] (nodes)
    std::vector<std::optional<Eigen::Vector3d>> anchor;  // of old nodes, object's frame [m]
  };
  [[nodiscard]] SkinFields fields_in(const HexMesh& mesh, const PressState& old) const;

  std::unique_ptr<TissueBody> body_;
  ContactSurface surface_;
  std::vector<int> active_;  // cells
  Eigen::Matrix3Xd places_;  // at rest [m] (3, nodes)
};

}  // namespace thenar
