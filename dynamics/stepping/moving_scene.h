#pragma once

/// Scene to simulate: a mechanism, its loads, drives and force elements, and contact friction.

#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "dynamics/mechanism/mechanism.h"
#include "dynamics/stepping/force_element.h"

namespace thenar {

/// Time span in which a force or drive acts. Steps end at both of its ends.
struct TimeSpan {
  double from = 0;                                      // first instant [s]
  double to = std::numeric_limits<double>::infinity();  // end, excluded [s]

  [[nodiscard]] bool contains(double t) const { return t >= from && t < to; }
};

/// Constant force and moment on a body, in world axes.
struct SceneForce {
  int body = 0;                     // index of the body
  Eigen::Vector3d point{0, 0, 0};   // point of application, body's frame [m] (3)
  Eigen::Vector3d force{0, 0, 0};   // force, world [N] (3)
  Eigen::Vector3d moment{0, 0, 0};  // additional moment, world [N m] (3)
  TimeSpan when{};                  // time span in which it acts
};

/// Target of a coordinate over time: linear between knots, constant before the first and after the
/// last. Two knots at the same time make a jump.
struct TargetTable {
  Eigen::VectorXd time;    // times of knots, not decreasing [s] (knots)
  Eigen::VectorXd target;  // targets at knots [rad] or [m] (knots)
};

/// Motor of a coordinate u:
///   effort = bias + stiffness (target + speed (t - from) - u) - damping (u_dot - speed),
/// limited to [-max_effort, max_effort]. A table replaces the target and its speed.
struct SceneDrive {
  int coordinate = 0;    // index in Mechanism::coordinates
  double bias = 0;       // constant effort [N m] or [N]
  double stiffness = 0;  // position gain [N m/rad] or [N/m]
  double damping = 0;    // velocity gain [N m s/rad] or [N s/m]
  double target = 0;     // target at the start of its time span [rad] or [m]
  double speed = 0;      // rate of the target [rad/s] or [m/s]
  double max_effort = std::numeric_limits<double>::infinity();  // limit of |effort| [N m] or [N]
  TimeSpan when{};                                              // time span in which it acts
  std::shared_ptr<const TargetTable>
      table{};  // target over time, shared by copies of a scene; null: none
};

/// Target of a drive and its rate.
struct DriveTarget {
  double value = 0;  // target [rad] or [m]
  double speed = 0;  // rate of the target [rad/s] or [m/s]
};

/// Computes the target of a drive at an instant. A step evaluates one line segment of the table
/// throughout, the segment at its start.
/// @param t  [s];  @param selection_time  instant that selects the segment: start of the step [s]
[[nodiscard]] DriveTarget drive_target(const SceneDrive& drive, double t, double selection_time);

/// Computes the effort of a drive at an instant of its time span [N m] or [N].
/// @param u  coordinate [rad] or [m];  @param rate  u_dot [rad/s] or [m/s];  @param t  [s]
/// @param selection_time  as in drive_target()
[[nodiscard]] double drive_effort(const SceneDrive& drive, double u, double rate, double t,
                                  double selection_time);

/// Friction and restitution of two bodies.
struct PairFriction {
  double coefficient = 0;     // mu of Coulomb's law [1]
  double torsion_radius = 0;  // largest torque about the normal over largest tangential force [m]
  double restitution = 0;     // coefficient of restitution of Newton's law, 0..1 [1]
};

/// Scene to simulate; constant during a simulation.
struct MovingScene {
  Mechanism mechanism;                   // bodies and joints
  Eigen::Vector3d gravity{0, 0, -9.81};  // acceleration of free fall [m/s^2] (3)
  std::vector<SceneForce> forces;
  std::vector<SceneDrive> drives;
  std::vector<std::shared_ptr<const ForceElement>> elements;
  PairFriction friction{};  // friction of pairs that are not listed below
  std::vector<std::pair<std::pair<int, int>, PairFriction>>
      friction_pairs;                               // pairs of bodies with own friction
  std::vector<std::pair<int, int>> excluded_pairs;  // pairs of bodies excluded from contact
  Eigen::VectorXd q;                                // positions at the start (q)
  Eigen::VectorXd v;                                // velocities at the start (v)
};

/// Checks a scene.
/// @throws InputError as check_mechanism(); if a body or coordinate does not exist, a number is not
/// finite, a span ends before it begins, a table of targets is empty or decreases in time, friction
/// or restitution is out of range, q or v has the wrong size, or the length of a quaternion differs
/// from 1 by more than 1e-6.
void check_scene(const MovingScene& scene);

/// Returns the friction of two bodies.
[[nodiscard]] const PairFriction& pair_friction(const MovingScene& scene, int a, int b);

/// Returns the largest coefficient of restitution of any pair [1].
[[nodiscard]] double max_restitution(const MovingScene& scene);

/// Advances positions q at constant velocities v for h seconds: quaternions by the exponential map
/// of the angular velocity, other positions linearly. @param v  (v);  @param h  [s];  @param q  (q)
void advance_positions(const Mechanism& mechanism, const MechanismLayout& layout,
                       const Eigen::VectorXd& v, double h, Eigen::VectorXd& q);

/// Computes the rates of positions at velocities v. @param q_dot  (q)
void position_rates(const Mechanism& mechanism, const MechanismLayout& layout,
                    const Eigen::VectorXd& q, const Eigen::VectorXd& v, Eigen::VectorXd& q_dot);

/// Sets the pose of a body on a free joint. @param q  positions, modified (q)
/// @throws InputError if the body's joint is not a free joint to the world.
void set_free_pose(const Mechanism& mechanism, int body, const Pose<double>& X_WB,
                   Eigen::VectorXd& q);

/// Sets the velocity of a body on a free joint. @param v  velocities, modified (v)
/// @param linear  velocity of its origin [m/s] (3);  @param angular  angular velocity [rad/s] (3)
/// @throws InputError as set_free_pose().
void set_free_velocity(const Mechanism& mechanism, int body, const Eigen::VectorXd& q,
                       const Eigen::Vector3d& linear, const Eigen::Vector3d& angular,
                       Eigen::VectorXd& v);

/// Lists the instants at which a force or drive starts or ends, the target of a drive jumps or its
/// slope changes, or the law of an element switches; sorted, without duplicates [s].
[[nodiscard]] std::vector<double> switching_times(const MovingScene& scene);

}  // namespace thenar
