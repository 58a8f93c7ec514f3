#pragma once

/// Contact with edges and corners by springs spread over the skin.

#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/shape.h"
#include "pads/contact_surface.h"
#include "pads/tissue_body.h"

namespace thenar {

/// Forces of stiff springs, spread evenly over the skin, that push it out of an object, each along
/// the object's normal where it is (press_face()). Where an edge lies between nodes, no gap of a
/// node tells how deep it is, and the one normal of a node that rests on it cannot bear forces from
/// both sides; what lies on both sides of it can. Nodes are pressed by their shares, and rub by
/// Coulomb's law with a spring that holds what sticks.
class SkinSprings {
 public:
  SkinSprings(const TissueBody& body, const ContactSurface& surface)
      : body_(body), surface_(surface) {}

  /// Friction of nodes before.
  struct Before {
    const Eigen::Matrix3Xd& anchor;  // where they were as the step began, object's frame [m]
    const Eigen::Matrix3Xd& shear;   // as the last iteration foretold it [N] (3, nodes)
  };
  /// Sets all that follows. @param x  displacements of the body's free nodes [m] (3 free nodes)
  /// @param stiffness  under nodes [N/m] (nodes)
  void find(const Shape& object, const Pose<double>& X_PO, const Eigen::VectorXd& x,
            const std::vector<double>& stiffness, double friction, const Before& before);

  /// Forces along normals, and friction, on nodes [N] (3, nodes).
  [[nodiscard]] const Eigen::Matrix3Xd& push() const { return push_; }
  [[nodiscard]] const Eigen::Matrix3Xd& shear() const { return shear_; }
  /// Returns the energy of the springs along normals [J].
  [[nodiscard]] double energy() const { return energy_; }
  /// Deepest point [m].
  [[nodiscard]] double deepest() const { return deepest_; }

  /// Returns whether a point inside was last on a side of the object that faces away from where it
  /// is now.
  /// @param before  displacements of the body's free nodes then [m] (3 free nodes)
  /// @param cosine  of the normals, below which sides face away [1]
  [[nodiscard]] bool changed_sides(const Shape& object, const Pose<double>& X_PO_before,
                                   const Pose<double>& X_PO, const Eigen::VectorXd& before,
                                   double cosine) const;

  /// Adds the symmetric part of loss() to a tangent of the body.
  void add_slopes(std::vector<double>& values) const;
  /// Loss of forces as nodes move against the object [N] (3, nodes). @param moved  [m] (3, nodes)
  [[nodiscard]] Eigen::Matrix3Xd loss(const Eigen::Matrix3Xd& moved) const;
  /// Returns the part of loss() that add_slopes() leaves out [N] (3, nodes).
  [[nodiscard]] Eigen::Matrix3Xd loss_left_out(const Eigen::Matrix3Xd& moved) const;
  /// Returns the part of loss() due to friction [N] (3, nodes).
  [[nodiscard]] Eigen::Matrix3Xd friction_loss(const Eigen::Matrix3Xd& moved) const;

 private:
  /// A face that is inside the object in part.
  struct Pressed {
    const SurfaceFace* face;
    PressedFace springs;
  };
  /// Friction of a node.
  struct Rubbing {
    Eigen::Vector3d normal{0, 0, 0};  // unit
    Eigen::Vector3d way{0, 0, 0};     // of friction on a node that slips, unit
    Eigen::Vector3d last{0, 0, 0};    // the same before, over the bound: at most as long
    Eigen::Vector3d trial{0, 0, 0};   // what would hold it, with a part along the normal [N]
    double push = 0;                  // along the normal [N]
    double cut = 1;                   // what the cone leaves of the trial [1]
    double stick = 0;                 // stiffness across the normal, cut [N/m]
    bool slips = false;
  };
  void rub(const Pose<double>& X_PO, const Eigen::Matrix3Xd& places,
           const std::vector<double>& stiffness, const Before& before);
  /// Loss of forces along normals (3, nodes).
  [[nodiscard]] Eigen::Matrix3Xd push_loss(const Eigen::Matrix3Xd& moved) const;
  /// Returns the symmetric part of the slope of a node's friction by its own place (3, 3).
  [[nodiscard]] static Eigen::Matrix3d own_slope(const Rubbing& node);

  const TissueBody& body_;
  const ContactSurface& surface_;
  std::vector<Pressed> pressed_;
  std::vector<Rubbing> rubbing_;  // (nodes)
  Eigen::Matrix3Xd push_, shear_;
  double friction_ = 0, energy_ = 0, deepest_ = 0;
};

}  // namespace thenar
