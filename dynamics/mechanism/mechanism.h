#pragma once

/// Moving scenes as plain data: rigid bodies on joints.

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "data/io/scene/joint_kind.h"
#include "data/io/world/world.h"
#include "geometry/solid.h"

namespace thenar {

/// Returns true if a joint has one value: hinges and slides.
[[nodiscard]] inline bool is_scalar(JointKind kind) {
  return kind == JointKind::kHinge || kind == JointKind::kSlide;
}
/// Speeds of a joint: 0, 1, 3 or 6.
[[nodiscard]] inline int speeds_of(JointKind kind) {
  if (kind == JointKind::kWeld) return 0;
  if (kind == JointKind::kBall) return 3;
  return kind == JointKind::kFree ? 6 : 1;
}

/// A joint, which carries the body of the same index. Frame F stands in the parent, frame M in the
/// body; at value 0 of a hinge or slide, and at the identity of a ball or free joint, they
/// coincide.
///
/// The value of a hinge or slide follows a coordinate u, of its own or shared with other joints:
///   value = offset + ratio u + curve[0] u^2 + curve[1] u^3 + ..
struct MechanismJoint {
  std::string name;
  JointKind kind = JointKind::kHinge;
  int parent = -1;    // body; -1: the world
  Pose<double> X_PF;  // in the parent's frame
  Pose<double> X_BM;  // in the body's frame

  // Hinges and slides only.
  int coordinate = -1;                                      // entry of Mechanism::coordinates
  double ratio = 1;                                         // [1], [m/rad] or [rad/m]
  double offset = 0;                                        // [rad] or [m]
  std::vector<double> curve;                                // empty: linear
  double lower = -std::numeric_limits<double>::infinity();  // of the value [rad] or [m]
  double upper = std::numeric_limits<double>::infinity();   // of the value [rad] or [m]
  double stiffness = 0;  // of a spring to `rest` [N m/rad] or [N/m]
  double rest = 0;       // [rad] or [m]
  double damping = 0;    // [N m s/rad] or [N s/m]
  double friction = 0;   // Coulomb's [N m] or [N]
};

/// A rigid body.
struct MechanismBody {
  std::string name;
  BodyMass mass{0, {0, 0, 0}, Eigen::Matrix3d::Zero()};  // in the body's frame
  std::shared_ptr<const Solid> solid;  // what it touches with, body's frame; null: nothing
  std::string material;                // of its surface
  std::string digit{};                 // of a hand that it is part of; empty: palm, arm, no hand
};

/// Coordinate that hinges and slides share.
struct MechanismCoordinate {
  std::string name;
  double max_effort = 0;     // of its motor [N m] or [N]; 0: none, or unknown
  bool backdrivable = true;  // false: a worm gear or brake; drives of a scene must hold it
};

/// A tree of bodies. Parents come before children.
///
/// Positions q and speeds v follow the bodies; a coordinate stands where it first moves one.
/// Hinge, slide: q is the coordinate [rad] or [m], v its rate.
/// Ball: q is the unit quaternion (w, x, y, z) of R_FM, v the angular velocity of M in F, axes of
/// F. Free: q is that and the origin of M in F [m], v is that and the origin's velocity, axes of F.
struct Mechanism {
  std::vector<MechanismBody> bodies;
  std::vector<MechanismJoint> joints;  // one for each body
  std::vector<MechanismCoordinate> coordinates;
};

/// First entries of each joint, and the numbers of entries.
struct MechanismLayout {
  std::vector<int> first_q, first_v;            // (bodies); -1: welds
  std::vector<int> coordinate_q, coordinate_v;  // (coordinates)
  int q = 0, v = 0;                             // entries of positions and of speeds
};
[[nodiscard]] MechanismLayout layout_of(const Mechanism& mechanism);

/// Returns true if there are only hinges and slides: then each speed is the rate of the position of
/// its index.
[[nodiscard]] inline bool has_no_quaternion(const MechanismLayout& layout) {
  return layout.q == layout.v;
}

/// Value of a hinge or slide, and its first two derivatives by the coordinate, on any scalar.
template <typename T>
struct JointValueOn {
  T value, slope, bend;
};
using JointValue = JointValueOn<double>;
template <typename T>
[[nodiscard]] JointValueOn<T> joint_value(const MechanismJoint& joint, const T& u) {
  JointValueOn<T> out{T(joint.offset) + T(joint.ratio) * u, T(joint.ratio), T(0)};
  T power(1);  // u^k, k + 2 the exponent of the term
  for (std::size_t k = 0; k < joint.curve.size(); ++k) {
    const double exponent = static_cast<double>(k) + 2;
    out.value += T(joint.curve[k]) * power * u * u;
    out.slope += T(joint.curve[k] * exponent) * power * u;
    out.bend += T(joint.curve[k] * exponent * (exponent - 1)) * power;
    power *= u;
  }
  return out;
}

/// All coordinates 0, all quaternions the identity. (q)
[[nodiscard]] Eigen::VectorXd reference_position(const Mechanism& mechanism);

/// Checks a mechanism.
/// @throws InputError if parents come late, a coordinate is not there or moves nothing, a frame is
/// no rigid motion, a mass or inertia is that of no body, a limit or resistance is impossible, or a
/// name is given twice.
void check_mechanism(const Mechanism& mechanism);

/// Adds a copy of `part` to `whole`; its world is fixed to a body of `whole`, its names get
/// `prefix` in front.
/// @param carrier  body of `whole`; -1: the world
/// @param X_CW     world of the part in the carrier's frame
/// @return the index of the part's first body
int append(Mechanism& whole, const Mechanism& part, const std::string& prefix = "",
           int carrier = -1, const Pose<double>& X_CW = {});

/// Index of a body. @throws InputError if there is none, with the nearest name.
[[nodiscard]] int body_named(const Mechanism& mechanism, const std::string& name);

}  // namespace thenar
