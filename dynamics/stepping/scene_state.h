#pragma once

/// State of a scene in motion: positions, speeds, states of elements, and what touches.

#include <algorithm>
#include <cstdint>
#include <limits>

#include <Eigen/Core>

#include "contact/contact_solver.h"
#include "dynamics/stepping/energy_flow.h"
#include "dynamics/stepping/moving_scene.h"

namespace thenar {

/// Gaps up to this are looked at for contacts that close within a step [m].
inline constexpr double kNearGap = 1e-4;

/// State of a scene at an instant.
struct SceneState {
  double t = 0;         // [s]
  Eigen::VectorXd q;    // positions (q)
  Eigen::VectorXd v;    // speeds (v)
  Eigen::VectorXd z{};  // states of elements, see SceneElements; empty: not asked for (z)
  EnergyFlows w = EnergyFlows::Zero();  // by steps so far; they steer nothing [J]
};

/// Speeds of a contact at the beginning of a step, by the Jacobian of its middle; NaN: it did not
/// touch, or did not stick, before that step.
struct BeforeSpeeds {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double closing = kNone;                      // 2 gap / h [m/s], [rad/s]
  Eigen::Vector3d drift{kNone, kNone, kNone};  // along the surface, world [m/s] (3)
  double spin = kNone;                         // about the normal [rad/s]
};

/// A contact point of two bodies, a joint limit, or the dry friction of a joint.
struct ActiveContact {
  enum class Kind { kContact, kLowerLimit, kUpperLimit, kJointFriction };
  Kind kind = Kind::kContact;
  int a = 0, b = 0;                 // of kContact: bodies, a < b; else a is the joint
  int id = 0;                       // of kContact: ManifoldPoint::id
  std::uint64_t feature = 0;        // of kContact: ManifoldPoint::feature
  Eigen::Vector3d point{0, 0, 0};   // world [m] (3)
  Eigen::Vector3d normal{0, 0, 1};  // unit, outward of b: a is pushed along it (3)
  double gap = 0;                   // [m]; of limits [rad] or [m]
  PairFriction friction{};
  ContactMode mode = ContactMode::kOpen;
  Eigen::Vector3d impulse{0, 0, 0};  // on a, world [N s] (3); of joints the first entry
  double torsion = 0;                // about the normal [N m s]
  double slip = 0;                   // tangential velocity [m/s]
  double approach = 0;               // normal velocity, negative: they come closer [m/s]
  BeforeSpeeds before{};             // of the last time_step()

  /// Returns whether both are one contact: the same features touch, though a trial in between lost
  /// sight of it, or the point went over from one feature to the next.
  [[nodiscard]] bool same(const ActiveContact& other) const {
    return kind == other.kind && a == other.a && b == other.b &&
           (feature == other.feature || id == other.id);
  }
};

/// The same contact in a list; its end if there is none.
template <class List>
[[nodiscard]] auto find_same(List& list, const ActiveContact& contact) {
  return std::find_if(list.begin(), list.end(),
                      [&](const ActiveContact& each) { return each.same(contact); });
}

}  // namespace thenar
