#pragma once

/// Mechanism as plain data: a tree of rigid bodies connected by joints.

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
/// Returns the number of velocities of a joint: 0, 1, 3 or 6.
[[nodiscard]] inline int speed_count(JointKind kind) {
  if (kind == JointKind::kWeld) return 0;
  if (kind == JointKind::kBall) return 3;
  return kind == JointKind::kFree ? 6 : 1;
}

/// Joint that carries the body of the same index. Frame F is fixed in the parent, frame M in the
/// body; they coincide at value 0 of a hinge or slide, and at the identity of a ball or free joint.
///
/// The value of a hinge or slide follows a coordinate u, of its own or shared with other joints:
///   value = offset + ratio u + curve[0] u^2 + curve[1] u^3 + ..
struct MechanismJoint {
  std::string name;
  JointKind kind = JointKind::kHinge;
  int parent = -1;      // parent body; -1: the world
  Pose<double> X_PF{};  // frame F in the parent's frame
  Pose<double> X_BM{};  // frame M in the body's frame

  // Hinges and slides only.
  int coordinate = -1;          // index in Mechanism::coordinates
  double ratio = 1;             // linear term of the value [1], [m/rad] or [rad/m]
  double offset = 0;            // constant term of the value [rad] or [m]
  std::vector<double> curve{};  // higher terms of the value; empty: linear
  double lower = -std::numeric_limits<double>::infinity();  // lower limit of the value [rad] or [m]
  double upper = std::numeric_limits<double>::infinity();   // upper limit of the value [rad] or [m]
  double stiffness = 0;  // stiffness of a spring to `rest` [N m/rad] or [N/m]
  double rest = 0;       // value at which the spring is relaxed [rad] or [m]
  double damping = 0;    // viscous damping [N m s/rad] or [N s/m]
  double friction = 0;   // largest effort of dry friction [N m] or [N]
};

/// Returns true if a joint is a hinge or slide that a coordinate moves.
[[nodiscard]] inline bool is_moved_by(const MechanismJoint& joint, int coordinate) {
  return is_scalar(joint.kind) && joint.coordinate == coordinate;
}

/// Rigid body.
struct MechanismBody {
  std::string name;
  BodyMass mass{0, {0, 0, 0}, Eigen::Matrix3d::Zero()};  // mass and inertia, body's frame
  std::shared_ptr<const Solid> solid;  // collision shape, body's frame; null: none
  std::string material;                // material of the surface
  std::string digit{};                 // digit of the hand that it is part of; empty: none
};

/// Coordinate of one or several hinges and slides.
struct MechanismCoordinate {
  std::string name;
  double max_effort = 0;     // largest effort of its motor [N m] or [N]; 0: no motor, or unknown
  bool backdrivable = true;  // false: a worm gear or brake, which a drive of the scene must model
};

/// Tree of bodies; parents precede children.
///
/// Positions q and velocities v are in the order of the bodies, a shared coordinate at the first
/// body that it moves. Hinge, slide: q is the coordinate [rad] or [m], v its rate. Ball: q is the
/// unit quaternion (w, x, y, z) of R_FM, v the angular velocity of M in F, axes of F. Free: q is
/// the quaternion and the origin of M in F [m], v the angular velocity and the origin's velocity,
/// axes of F.
struct Mechanism {
  std::vector<MechanismBody> bodies;
  std::vector<MechanismJoint> joints;  // joint of each body
  std::vector<MechanismCoordinate> coordinates;
};

/// Layout of positions q and velocities v.
struct MechanismLayout {
  std::vector<int> first_q, first_v;            // first entries of each joint; -1: weld (bodies)
  std::vector<int> coordinate_q, coordinate_v;  // entries of each coordinate (coordinates)
  std::vector<int> quaternion_joints;           // balls and free joints; empty: v is the rate of q
  int q = 0, v = 0;                             // sizes of q and v
};
/// Computes the layout of a mechanism.
[[nodiscard]] MechanismLayout layout_of(const Mechanism& mechanism);

/// Value of a hinge or slide, and its first and second derivatives by the coordinate.
template <typename T>
struct JointValueOn {
  T value, slope, bend;
};
using JointValue = JointValueOn<double>;
/// Computes the value of a hinge or slide and its derivatives. @param u  coordinate [rad] or [m]
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

/// Returns the reference position: all coordinates 0, all quaternions the identity (q).
[[nodiscard]] Eigen::VectorXd reference_position(const Mechanism& mechanism);

/// Checks a mechanism.
/// @throws InputError if a parent follows its child, a coordinate does not exist or moves no joint,
/// a frame is not a rigid motion, a mass or inertia is not that of a rigid body, a limit or
/// resistance is out of range, or a name is used twice.
void check_mechanism(const Mechanism& mechanism);

/// Appends a copy of `part` to `whole`. The part's world frame is fixed to the carrier, and its
/// names get a prefix.
/// @param carrier  body of `whole`; -1: the world
/// @param X_CW     pose of the part's world frame in the carrier's frame
/// @return index of the part's first body in `whole`
int append(Mechanism& whole, const Mechanism& part, const std::string& prefix = "",
           int carrier = -1, const Pose<double>& X_CW = {});

/// Returns the index of a body. @throws InputError with the nearest name if there is none.
[[nodiscard]] int body_named(const Mechanism& mechanism, const std::string& name);

/// Returns the first body, towards the world, that is not welded to its parent; -1: the world.
[[nodiscard]] int carrier_by_welds(const Mechanism& mechanism, int body);

}  // namespace thenar
