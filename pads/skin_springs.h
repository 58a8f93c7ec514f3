#pragma once

/// Contact with edges and corners by springs spread over the skin.

#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/shape.h"
#include "pads/contact_surface.h"
#include "pads/tissue_body.h"

namespace thenar {

/// Stiff springs, spread evenly over the skin, that push it out of an object, each along the
/// object's normal at its point (press_face()). They replace node contacts where an edge of the
/// object lies between nodes: gaps of nodes do not measure the depth of such an edge, and a node on
/// the edge has only one normal although forces act from both sides. The springs of a face load its
/// nodes by their shape functions. Friction acts at the nodes by Coulomb's law, with a spring that
/// holds sticking nodes.
class SkinSprings {
 public:
  SkinSprings(const TissueBody& body, const ContactSurface& surface)
      : body_(body), surface_(surface) {}

  /// Anchors and friction forces from which the friction of nodes is computed.
  struct FrictionStart {
    const Eigen::Matrix3Xd& anchor;    // position at the start of the step, object's frame [m]
    const Eigen::Matrix3Xd& friction;  // force predicted by the last iteration [N] (3, nodes)
  };
  /// Computes forces, energy and stiffness at a state of the body.
  /// @param x  displacements of the free nodes [m] (3 free nodes)
  /// @param stiffness  normal stiffness of the springs at each node [N/m] (nodes)
  void update(const Shape& object, const Pose<double>& X_PO, const Eigen::VectorXd& x,
              const std::vector<double>& stiffness, double friction, const FrictionStart& start);

  /// Returns the normal forces on nodes [N] (3, nodes).
  [[nodiscard]] const Eigen::Matrix3Xd& normal_forces() const { return normal_forces_; }
  /// Returns the friction forces on nodes [N] (3, nodes).
  [[nodiscard]] const Eigen::Matrix3Xd& friction_forces() const { return friction_forces_; }
  /// Returns the energy of the normal springs [J].
  [[nodiscard]] double energy() const { return energy_; }
  /// Returns the largest depth of the skin in the object [m].
  [[nodiscard]] double max_depth() const { return max_depth_; }

  /// Returns whether a pressed point of the skin was on the opposite side of the object before.
  /// @param before  earlier displacements of the free nodes [m] (3 free nodes)
  /// @param cosine  cosine of two normals below which they belong to opposite sides [1]
  [[nodiscard]] bool has_changed_sides(const Shape& object, const Pose<double>& X_PO_before,
                                       const Pose<double>& X_PO, const Eigen::VectorXd& before,
                                       double cosine) const;

  /// Adds the stiffness of normal springs and the symmetric part of each node's friction stiffness
  /// to a tangent of the body.
  void add_stiffness(std::vector<double>& values) const;
  /// Returns the loss of contact forces as nodes move against the object [N] (3, nodes).
  /// @param moved  motion of the nodes [m] (3, nodes)
  [[nodiscard]] Eigen::Matrix3Xd force_loss(const Eigen::Matrix3Xd& moved) const;
  /// Returns the part of force_loss() that add_stiffness() leaves out [N] (3, nodes).
  [[nodiscard]] Eigen::Matrix3Xd unfactored_loss(const Eigen::Matrix3Xd& moved) const;
  /// Returns the part of force_loss() due to friction [N] (3, nodes).
  [[nodiscard]] Eigen::Matrix3Xd friction_force_loss(const Eigen::Matrix3Xd& moved) const;

 private:
  /// A face that lies at least partly inside the object.
  struct PressedPart {
    const SurfaceFace* face;
    PressedFace springs;
  };
  /// Friction of a node.
  struct NodeFriction {
    Eigen::Vector3d normal{0, 0, 0};          // direction of the normal force, unit (3)
    Eigen::Vector3d slip_direction{0, 0, 0};  // direction of sliding friction, unit; 0: sticks (3)
    Eigen::Vector3d last_ratio{0, 0, 0};      // friction of the last iterate over the bound of the
                                              // cone, at most unit length [1] (3)
    Eigen::Vector3d trial_force{0, 0, 0};  // force that would hold the node, not yet projected on
                                           // the tangent plane [N] (3)
    double normal_force = 0;               // [N]
    double scale = 1;                      // friction force over the tangential trial force [1]
    double stiffness = 0;                  // tangential stiffness, scaled by `scale` [N/m]
    bool slips = false;
  };
  void update_friction(const Pose<double>& X_PO, const Eigen::Matrix3Xd& places,
                       const std::vector<double>& stiffness, const FrictionStart& start);
  /// Returns the loss of normal forces as nodes move [N] (3, nodes).
  [[nodiscard]] Eigen::Matrix3Xd normal_force_loss(const Eigen::Matrix3Xd& moved) const;
  /// Returns the symmetric part of a node's friction stiffness by its own motion [N/m] (3, 3).
  [[nodiscard]] static Eigen::Matrix3d own_stiffness(const NodeFriction& node);

  const TissueBody& body_;
  const ContactSurface& surface_;
  std::vector<PressedPart> pressed_;
  std::vector<NodeFriction> node_friction_;  // (nodes)
  Eigen::Matrix3Xd normal_forces_, friction_forces_;
  double friction_ = 0, energy_ = 0, max_depth_ = 0;
};

}  // namespace thenar
