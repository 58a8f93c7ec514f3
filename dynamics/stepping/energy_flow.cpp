#include "dynamics/stepping/energy_flow.h"

#include <cmath>

#include "base/lists.h"

namespace thenar {
namespace {

/// Computes the power of all loads on links [W].
double power_of_loads(const TreeMotion<double>& motion) {
  double power = 0;
  for (const MovingLink<double>& link : motion.links())
    power += link.load_m.dot(link.w) + link.load_f.dot(link.vel);
  return power;
}

/// Computes the mean power of a drive over a step [W].
double power_of_drive(const SceneDrive& drive, const MechanismLayout& layout,
                      const StepEfforts& at) {
  // Linearise the effort over the step, unless it is at its limit; multiply by the mean speed.
  const int row = layout.coordinate_v[drive.coordinate];
  const double u = at.q[layout.coordinate_q[drive.coordinate]];
  double effort = drive_effort(drive, u, at.v[row], at.t, at.selection_time);
  if (std::abs(effort) < drive.max_effort)
    effort -= (at.theta * drive.damping + at.theta * at.theta * at.h * drive.stiffness) *
              (at.v_end[row] - at.v[row]);
  return 0.5 * effort * (at.v[row] + at.v_end[row]);
}

}  // namespace

bool has_powers(const MovingScene& scene) {
  return !scene.forces.empty() || !scene.drives.empty() ||
         any_of(scene.mechanism.joints, [](const auto& joint) { return joint.damping > 0; });
}

AppliedPowers applied_powers(const MovingScene& scene, const MechanismLayout& layout,
                             const TreeMotion<double>& motion, const StepEfforts& at) {
  // Sum the powers of forces and active drives.
  AppliedPowers out;
  if (!scene.forces.empty()) out.applied = power_of_loads(motion);
  for (const SceneDrive& drive : scene.drives)
    if (drive.when.contains(at.selection_time)) out.applied += power_of_drive(drive, layout, at);
  // Sum joint dampers, evaluated at the velocity that the step uses, times the mean speed.
  for (std::size_t i = 0; i < scene.mechanism.joints.size(); ++i) {
    const MechanismJoint& joint = scene.mechanism.joints[i];
    if (!is_scalar(joint.kind) || joint.damping == 0) continue;
    const int row = layout.first_v[i];
    const double slope = joint_value(joint, at.q[layout.first_q[i]]).slope;
    const double speed = at.v[row] + at.theta * (at.v_end[row] - at.v[row]);
    out.damped += joint.damping * slope * slope * speed * 0.5 * (at.v[row] + at.v_end[row]);
  }
  return out;
}

}  // namespace thenar
