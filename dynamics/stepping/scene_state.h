#pragma once

/// State of a moving scene: positions, velocities, element states and active contacts.

#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "base/lists.h"
#include "contact/contact_solver.h"
#include "dynamics/stepping/energy_flow.h"
#include "dynamics/stepping/moving_scene.h"

namespace thenar {

/// Largest gap at which a contact is searched for, because it may close within a step [m].
inline constexpr double kSearchMargin = 1e-4;

/// State of a scene at an instant.
struct SceneState {
  double t = 0;         // time [s]
  Eigen::VectorXd q;    // positions (q)
  Eigen::VectorXd v;    // generalized velocities (v)
  Eigen::VectorXd z{};  // states of elements, see SceneElements; empty without elements or
                        // where they are not needed (z)
  EnergyFlows w = EnergyFlows::Zero();  // flows since the start, an output only [J]
};

/// Velocities of a contact at the start of a midpoint step, by the Jacobian of its midpoint: the u~
/// of ContactStep::take_midpoint_step(). NaN: the contact did not touch, or stick, before that
/// step.
struct PreviousSpeeds {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double closing = kNone;                      // normal velocity, 2 gap / h [m/s], [rad/s]
  Eigen::Vector3d drift{kNone, kNone, kNone};  // tangential velocity, world [m/s] (3)
  double spin = kNone;                         // angular velocity about the normal [rad/s]
};

/// Active constraint: a contact point of two bodies, a joint limit, or the dry friction of a joint.
struct ActiveContact {
  enum class Kind { kContact, kLowerLimit, kUpperLimit, kJointFriction };
  Kind kind = Kind::kContact;
  int a = 0, b = 0;                       // kContact: bodies, a < b; otherwise a is the joint
  int id = 0;                             // kContact: ManifoldPoint::id
  std::uint64_t feature = 0;              // kContact: ManifoldPoint::feature
  Eigen::Vector3d point{0, 0, 0};         // point of contact, world [m] (3)
  Eigen::Vector3d normal{0, 0, 1};        // unit normal out of b, along which a is pushed (3)
  double gap = 0;                         // gap [m]; of a joint limit [rad] or [m]
  PairFriction friction{};                // friction and restitution of the bodies
  ContactMode mode = ContactMode::kOpen;  // mode of the last step
  Eigen::Vector3d impulse{0, 0, 0};       // impulse on a, world; of joints in x [N s], [N m s] (3)
  double torsion = 0;                     // impulse about the normal [N m s]
  double slip = 0;                        // tangential speed [m/s]
  double approach = 0;        // normal velocity, negative while the gap closes [m/s], [rad/s]
  PreviousSpeeds previous{};  // velocities of the last take_midpoint_step()

  /// Returns true if both are the same contact: the same features touch, even if a search in
  /// between did not find them, or the same manifold point has moved to another feature.
  [[nodiscard]] bool is_same_contact(const ActiveContact& other) const {
    return kind == other.kind && a == other.a && b == other.b &&
           (feature == other.feature || id == other.id);
  }
};

/// Returns the same contact in a list; null: there is none.
[[nodiscard]] inline const ActiveContact* find_contact(const std::vector<ActiveContact>& list,
                                                       const ActiveContact& contact) {
  return find_where(list, [&](const ActiveContact& each) { return each.is_same_contact(contact); });
}

}  // namespace thenar
