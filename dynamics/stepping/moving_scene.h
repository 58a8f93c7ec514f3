#pragma once

/// A scene that moves: a mechanism, what acts on it, and how its bodies rub.

#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "dynamics/mechanism/mechanism.h"
#include "dynamics/stepping/force_element.h"

namespace thenar {

/// Time span in which something acts. Steps end at both ends of it.
struct TimeSpan {
  double from = 0;                                      // [s]
  double to = std::numeric_limits<double>::infinity();  // [s]

  [[nodiscard]] bool holds(double t) const { return t >= from && t < to; }
};

/// A force and a moment on a body, constant in world.
struct SceneForce {
  int body = 0;
  Eigen::Vector3d point{0, 0, 0};   // where the force acts, body's frame [m] (3)
  Eigen::Vector3d force{0, 0, 0};   // [N] (3)
  Eigen::Vector3d moment{0, 0, 0};  // [N m] (3)
  TimeSpan when{};
};

/// Target of a coordinate over time: linear between knots, constant before the first and after the
/// last. Two knots of one time are a jump.
struct TargetTable {
  Eigen::VectorXd time;    // never falling [s] (knots)
  Eigen::VectorXd target;  // [rad] or [m] (knots)
};

/// A motor at a coordinate:
///   effort = bias + stiffness (target + speed (t - from) - u) - damping (u_dot - speed),
/// cut to [-max_effort, max_effort]. With a table, target and speed are those of its line.
struct SceneDrive {
  int coordinate = 0;
  double bias = 0;       // [N m] or [N]
  double stiffness = 0;  // [N m/rad] or [N/m]
  double damping = 0;    // [N m s/rad] or [N s/m]
  double target = 0;     // at the beginning of its time [rad] or [m]
  double speed = 0;      // of the target [rad/s] or [m/s]
  double max_effort = std::numeric_limits<double>::infinity();  // [N m] or [N]
  TimeSpan when{};
  std::shared_ptr<const TargetTable> table{};  // shared by copies of a scene; null: none
};

/// Target of a drive, and the target's speed.
struct DriveTarget {
  double value;  // [rad] or [m]
  double speed;  // [rad/s] or [m/s]
};

/// The target of a drive at an instant, on the line of its table that holds at another: a step
/// keeps to that of its beginning. The line is found by bisection.
/// @param t  [s];  @param acting  instant whose line holds [s]
[[nodiscard]] DriveTarget drive_target(const SceneDrive& drive, double t, double acting);

/// Effort of a drive at an instant of its time [N m] or [N].
/// @param u  its coordinate [rad] or [m];  @param rate  of it;  @param t  [s]
/// @param acting  as of drive_target()
[[nodiscard]] double drive_effort(const SceneDrive& drive, double u, double rate, double t,
                                  double acting);

/// Friction and restitution of two bodies.
struct PairFriction {
  double coefficient = 0;     // mu of Coulomb's law [1]
  double torsion_radius = 0;  // largest torque about the normal over largest tangential force [m]
  double restitution = 0;     // of Newton's law, 0..1 [1]
};

/// A scene, constant while it is simulated.
struct MovingScene {
  Mechanism mechanism;
  Eigen::Vector3d gravity{0, 0, -9.81};  // of free fall [m/s^2] (3)
  std::vector<SceneForce> forces;
  std::vector<SceneDrive> drives;
  std::vector<std::shared_ptr<const ForceElement>> elements;
  PairFriction friction{};  // of pairs that are not named
  std::vector<std::pair<std::pair<int, int>, PairFriction>> friction_pairs;  // by bodies
  std::vector<std::pair<int, int>> apart;  // pairs of bodies that are never asked for contacts
  Eigen::VectorXd q;                       // positions at the start (q)
  Eigen::VectorXd v;                       // speeds at the start (v)
};

/// Checks a scene.
/// @throws InputError as check_mechanism(); if a body or coordinate is not there, a number is not
/// finite, a span ends before it begins, a table of targets is empty or falls in time, friction or
/// restitution is impossible, q or v have the wrong length, or a quaternion has not length 1 to
/// 1e-6.
void check_scene(const MovingScene& scene);

/// Rubbing of two bodies.
[[nodiscard]] const PairFriction& pair_friction(const MovingScene& scene, int a, int b);

/// The largest restitution that a scene states, for all pairs or for one [1].
[[nodiscard]] double largest_restitution(const MovingScene& scene);

/// Positions q after speeds v were held for h seconds: quaternions turn by the exponential of their
/// angular velocity, all else goes straight.
void advance(const Mechanism& mechanism, const MechanismLayout& layout, const Eigen::VectorXd& v,
             double h, Eigen::VectorXd& q);

/// Rates of the positions at speeds v. @param q_dot  (q)
void position_rates(const Mechanism& mechanism, const MechanismLayout& layout,
                    const Eigen::VectorXd& q, const Eigen::VectorXd& v, Eigen::VectorXd& q_dot);

/// Puts a body on a free joint at a pose. @param q  positions, changed (q)
/// @throws InputError if the body has another joint, or does not hang on the world.
void set_free_pose(const Mechanism& mechanism, int body, const Pose<double>& X_WB,
                   Eigen::VectorXd& q);

/// Gives a body on a free joint a velocity. @param v  speeds, changed (v)
/// @param linear  of its origin [m/s] (3);  @param angular  [rad/s] (3)
/// @throws InputError as set_free_pose().
void set_free_velocity(const Mechanism& mechanism, int body, const Eigen::VectorXd& q,
                       const Eigen::Vector3d& linear, const Eigen::Vector3d& angular,
                       Eigen::VectorXd& v);

/// Instants at which a force or drive begins or ends, the target of a drive jumps or its slope
/// changes, or the law of an element changes, in order, each once [s].
[[nodiscard]] std::vector<double> switching_times(const MovingScene& scene);

}  // namespace thenar
