#include "dynamics/stepping/moving_scene.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

constexpr double kSeriesAngle = 1e-4;  // angle below which sin(x) / x is a series [rad]

void check_span(const char* what, const TimeSpan& span) {
  require(std::isfinite(span.from) && span.to > span.from,
          "{}: wanted a beginning before its end, got {} to {} s", what, span.from, span.to);
}

void check_friction(const PairFriction& pair) {
  require(pair.coefficient >= 0 && std::isfinite(pair.coefficient),
          "wanted friction from 0 up, got {}", pair.coefficient);
  require(pair.torsion_radius >= 0 && std::isfinite(pair.torsion_radius),
          "wanted a radius of torsion from 0 up, got {}", pair.torsion_radius);
  require(pair.restitution >= 0 && pair.restitution <= 1, "wanted restitution in 0..1, got {}",
          pair.restitution);
}

void check_body(const MovingScene& scene, int body) {
  require(body >= 0 && body < static_cast<int>(scene.mechanism.bodies.size()),
          "there is no body {}", body);
}

void check_table(const TargetTable& table, const std::string& name) {
  require(table.time.size() > 0 && table.target.size() == table.time.size(),
          "drive of '{}': {} times have {} targets", name, table.time.size(), table.target.size());
  require(table.time.allFinite() && table.target.allFinite(),
          "drive of '{}': wanted finite targets", name);
  require(std::is_sorted(table.time.data(), table.time.data() + table.time.size()),
          "drive of '{}': its table falls in time", name);
}

void check_drives(const MovingScene& scene) {
  // Check that coordinates exist, numbers are finite and spans are ordered.
  for (const SceneDrive& drive : scene.drives) {
    require(drive.coordinate >= 0 &&
                drive.coordinate < static_cast<int>(scene.mechanism.coordinates.size()),
            "there is no coordinate {}", drive.coordinate);
    const std::string& name = scene.mechanism.coordinates[drive.coordinate].name;
    for (const double number : {drive.bias, drive.target, drive.speed})
      require(std::isfinite(number), "drive of '{}': wanted finite numbers", name);
    require(drive.stiffness >= 0 && drive.damping >= 0 && drive.max_effort >= 0 &&
                std::isfinite(drive.stiffness) && std::isfinite(drive.damping),
            "drive of '{}': wanted stiffness, damping and largest effort from 0 up", name);
    check_span("drive", drive.when);
    if (drive.table) check_table(*drive.table, name);
  }
}

/// Returns the slope of a table after a knot; 0 before the first knot (-1) and after the last, not
/// finite between two knots at the same time.
double slope_after(const TargetTable& table, Eigen::Index knot) {
  if (knot < 0 || knot + 1 == table.time.size()) return 0;
  return (table.target[knot + 1] - table.target[knot]) / (table.time[knot + 1] - table.time[knot]);
}

/// Adds the instants within a span at which a table jumps or its slope changes.
void add_knots(const TargetTable& table, const TimeSpan& span, std::vector<double>& times) {
  for (Eigen::Index k = 0; k < table.time.size(); ++k)
    if (table.time[k] > span.from && table.time[k] < span.to &&
        slope_after(table, k) != slope_after(table, k - 1))
      times.push_back(table.time[k]);
}

/// Returns the first entry of a body's free joint in q. @throws InputError as set_free_pose().
int first_free_entry(const Mechanism& mechanism, int body) {
  const MechanismJoint& joint = mechanism.joints.at(static_cast<std::size_t>(body));
  require(joint.kind == JointKind::kFree && joint.parent < 0,
          "body '{}' hangs on a {} joint: its pose follows from coordinates",
          mechanism.bodies[body].name, name_in(kJointKindNames, joint.kind));
  return layout_of(mechanism).first_q[body];
}

}  // namespace

void check_scene(const MovingScene& scene) {
  // Check sizes, and that numbers are finite.
  check_mechanism(scene.mechanism);
  const MechanismLayout layout = layout_of(scene.mechanism);
  require(scene.gravity.allFinite(), "gravity is not finite");
  require(scene.q.size() == layout.q && scene.v.size() == layout.v,
          "wanted {} positions and {} speeds, got {} and {}", layout.q, layout.v, scene.q.size(),
          scene.v.size());
  require(scene.q.allFinite() && scene.v.allFinite(), "positions or speeds are not finite");
  // Check that quaternions have length 1.
  for (const int i : layout.quaternion_joints) {
    const double length = scene.q.segment<4>(layout.first_q[i]).norm();
    require(std::abs(length - 1) < 1e-6, "joint '{}': wanted a unit quaternion, its length is {}",
            scene.mechanism.joints[i].name, length);
  }
  // Check forces, drives and friction.
  for (const SceneForce& force : scene.forces) {
    check_body(scene, force.body);
    require(force.point.allFinite() && force.force.allFinite() && force.moment.allFinite(),
            "a force on '{}' is not finite", scene.mechanism.bodies[force.body].name);
    check_span("force", force.when);
  }
  check_drives(scene);
  check_friction(scene.friction);
  for (const auto& [bodies, pair] : scene.friction_pairs) {
    check_body(scene, bodies.first);
    check_body(scene, bodies.second);
    check_friction(pair);
  }
}

DriveTarget drive_target(const SceneDrive& drive, double t, double selection_time) {
  if (!drive.table) return {drive.target + drive.speed * (t - drive.when.from), drive.speed};
  // Find the last knot that is not after the selecting instant, by bisection.
  const TargetTable& table = *drive.table;
  const double* const first = table.time.data();
  const Eigen::Index knot =
      std::upper_bound(first, first + table.time.size(), selection_time) - first - 1;
  if (knot < 0) return {table.target[0], 0};
  const double slope = slope_after(table, knot);
  return {table.target[knot] + slope * (t - table.time[knot]), slope};
}

double drive_effort(const SceneDrive& drive, double u, double rate, double t,
                    double selection_time) {
  const DriveTarget wanted = drive_target(drive, t, selection_time);
  const double effort =
      drive.bias + drive.stiffness * (wanted.value - u) - drive.damping * (rate - wanted.speed);
  return std::clamp(effort, -drive.max_effort, drive.max_effort);
}

const PairFriction& pair_friction(const MovingScene& scene, int a, int b) {
  for (const auto& [bodies, pair] : scene.friction_pairs)
    if (bodies == std::make_pair(a, b) || bodies == std::make_pair(b, a)) return pair;
  return scene.friction;
}

double max_restitution(const MovingScene& scene) {
  double restitution = scene.friction.restitution;
  for (const auto& [bodies, pair] : scene.friction_pairs)
    restitution = std::max(restitution, pair.restitution);
  return restitution;
}

void advance_positions(const Mechanism& mechanism, const MechanismLayout& layout,
                       const Eigen::VectorXd& v, double h, Eigen::VectorXd& q) {
  // Without quaternions, all positions advance linearly.
  if (layout.quaternion_joints.empty()) {
    q += h * v;
    return;
  }
  // Advance hinges and slides linearly, then balls and free joints.
  for (std::size_t c = 0; c < layout.coordinate_q.size(); ++c)
    q[layout.coordinate_q[c]] += h * v[layout.coordinate_v[c]];
  for (const int i : layout.quaternion_joints) {
    const int at_q = layout.first_q[i], at_v = layout.first_v[i];
    // Multiply the quaternion by exp(h w / 2), with w in the axes of the joint's F.
    const Eigen::Vector3d half = 0.5 * h * v.segment<3>(at_v);
    const double angle = half.norm();
    const double sinc = angle > kSeriesAngle ? std::sin(angle) / angle : 1 - angle * angle / 6;
    const Eigen::Vector3d x = sinc * half;
    const double w = std::cos(angle);
    const Eigen::Vector4d old = q.segment<4>(at_q);
    const Eigen::Vector3d y = old.tail<3>();
    q[at_q] = w * old[0] - x.dot(y);
    q.segment<3>(at_q + 1) = w * y + old[0] * x + x.cross(y);
    q.segment<4>(at_q).normalize();
    if (mechanism.joints[i].kind == JointKind::kFree)
      q.segment<3>(at_q + 4) += h * v.segment<3>(at_v + 3);
  }
}

void position_rates(const Mechanism& mechanism, const MechanismLayout& layout,
                    const Eigen::VectorXd& q, const Eigen::VectorXd& v, Eigen::VectorXd& q_dot) {
  // Without quaternions, rates are velocities.
  if (layout.quaternion_joints.empty()) {
    q_dot = v;
    return;
  }
  for (std::size_t c = 0; c < layout.coordinate_q.size(); ++c)
    q_dot[layout.coordinate_q[c]] = v[layout.coordinate_v[c]];
  for (const int i : layout.quaternion_joints) {
    const int at_q = layout.first_q[i], at_v = layout.first_v[i];
    // Multiply (0, w / 2) by the quaternion.
    const Eigen::Vector3d half = 0.5 * v.segment<3>(at_v), y = q.segment<3>(at_q + 1);
    q_dot[at_q] = -half.dot(y);
    q_dot.segment<3>(at_q + 1) = q[at_q] * half + half.cross(y);
    if (mechanism.joints[i].kind == JointKind::kFree)
      q_dot.segment<3>(at_q + 4) = v.segment<3>(at_v + 3);
  }
}

void set_free_pose(const Mechanism& mechanism, int body, const Pose<double>& X_WB,
                   Eigen::VectorXd& q) {
  const int first = first_free_entry(mechanism, body);
  // Express the pose of M in F as a quaternion and a position.
  const MechanismJoint& joint = mechanism.joints[body];
  const Pose<double> X_FM = joint.X_PF.inverse() * X_WB * joint.X_BM;
  const Eigen::Quaterniond turn(X_FM.R);
  q.segment<4>(first) << turn.w(), turn.x(), turn.y(), turn.z();
  q.segment<3>(first + 4) = X_FM.p;
}

void set_free_velocity(const Mechanism& mechanism, int body, const Eigen::VectorXd& q,
                       const Eigen::Vector3d& linear, const Eigen::Vector3d& angular,
                       Eigen::VectorXd& v) {
  const int first_q = first_free_entry(mechanism, body);
  const MechanismJoint& joint = mechanism.joints[body];
  const int first = layout_of(mechanism).first_v[body];
  // Find the vector from the body's origin to that of M.
  const Eigen::Quaterniond turn(q[first_q], q[first_q + 1], q[first_q + 2], q[first_q + 3]);
  const Eigen::Matrix3d R_WM = joint.X_PF.R * turn.toRotationMatrix();
  const Eigen::Vector3d arm = R_WM * (joint.X_BM.R.transpose() * joint.X_BM.p);
  // Transfer the velocity to M, in the axes of F.
  v.segment<3>(first) = joint.X_PF.R.transpose() * angular;
  v.segment<3>(first + 3) = joint.X_PF.R.transpose() * (linear + angular.cross(arm));
}

std::vector<double> switching_times(const MovingScene& scene) {
  // Collect ends of time spans, knots of tables and switching times of elements.
  std::vector<double> times;
  const auto add = [&](const TimeSpan& span) {
    times.push_back(span.from);
    if (std::isfinite(span.to)) times.push_back(span.to);
  };
  for (const SceneForce& force : scene.forces) add(force.when);
  for (const SceneDrive& drive : scene.drives) {
    add(drive.when);
    if (drive.table) add_knots(*drive.table, drive.when, times);
  }
  for (const std::shared_ptr<const ForceElement>& element : scene.elements)
    append_all(times, element->switching_times());
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace thenar
