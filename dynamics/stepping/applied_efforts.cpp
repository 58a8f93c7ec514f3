#include "dynamics/stepping/applied_efforts.h"

#include <cmath>

#include "base/lists.h"
#include "dynamics/stepping/scene_contacts.h"

namespace thenar {
namespace {

/// Returns true if a joint or drive has stiffness or damping.
template <typename Part>
bool resists(const Part& part) {
  return part.stiffness > 0 || part.damping > 0;
}

}  // namespace

AppliedEfforts::AppliedEfforts(const MovingScene& scene, const TreeModel& model)
    : elements(scene.elements, model.layout.v), scene_(scene), model_(model) {
  tau = stiffness = damping = Eigen::VectorXd::Zero(model.layout.v);
  for (std::size_t i = 0; i < scene.mechanism.joints.size(); ++i)
    if (is_scalar(scene.mechanism.joints[i].kind) && resists(scene.mechanism.joints[i]))
      resisting_joints_.push_back(i);
  update_force_kinds();
}

void AppliedEfforts::update_force_kinds() {
  has_slopes_ =
      !elements.empty() || !resisting_joints_.empty() || any_of(scene_.drives, resists<SceneDrive>);
  has_flows_ = !elements.empty() || has_powers(scene_);
}

bool AppliedEfforts::compute(SceneMotion& motion, const SceneState& state, ElementNeed need) {
  // Add springs and dampers of joints, then active drives.
  tau.setZero();
  stiffness.setZero();
  damping.setZero();
  add_springs(state);
  for (const SceneDrive& drive : scene_.drives)
    if (drive.when.contains(selection_time_)) add_drive(drive, state);
  // Set the loads of active forces.
  TreeMotion<double>& links = motion.links();
  if (!scene_.forces.empty()) links.clear_loads();
  for (const SceneForce& force : scene_.forces) {
    if (!force.when.contains(selection_time_)) continue;
    links.add_load(links.link_of(force.body), links.pose(force.body) * force.point, force.force,
                   force.moment);
  }
  // Add elements.
  if (elements.empty()) return true;
  const bool acted = elements.compute_action(element_input(motion, state, need));
  tau += elements.action().tau;
  return acted;
}

void AppliedEfforts::add_springs(const SceneState& state) {
  for (const std::size_t i : resisting_joints_) {
    const MechanismJoint& joint = scene_.mechanism.joints[i];
    const JointValue at = joint_value_at(scene_, model_, i, state);
    const int row = model_.layout.first_v[i];
    tau[row] -= at.slope * (joint.stiffness * (at.value - joint.rest) +
                            joint.damping * at.slope * state.v[row]);
    stiffness[row] += at.slope * at.slope * joint.stiffness;
    damping[row] += at.slope * at.slope * joint.damping;
  }
}

void AppliedEfforts::add_drive(const SceneDrive& drive, const SceneState& state) {
  const int row = model_.layout.coordinate_v[drive.coordinate];
  const double u = state.q[model_.layout.coordinate_q[drive.coordinate]];
  const double effort = drive_effort(drive, u, state.v[row], state.t, selection_time_);
  tau[row] += effort;
  // A drive at its effort limit has no slope.
  if (std::abs(effort) >= drive.max_effort) return;
  stiffness[row] += drive.stiffness;
  damping[row] += drive.damping;
}

void AppliedEfforts::advance_states(double h, SceneState& state) const {
  if (elements.empty()) return;
  const ElementAction& action = elements.action();
  state.z.array() += h * action.z_rate.array() / (1 + h * action.z_decay.array());
}

void AppliedEfforts::compute_powers(const SceneMotion& motion, const StepEfforts& at) {
  if (!has_flows_) return;
  const AppliedPowers powers = applied_powers(scene_, model_.layout, motion.links(), at);
  power[kAppliedWork] = powers.applied;
  power[kDamperLoss] = powers.damped;
  power[kPassiveWork] = elements.passive_power();
}

double AppliedEfforts::spring_energy(const SceneState& state) const {
  double energy = 0;
  for (std::size_t i = 0; i < scene_.mechanism.joints.size(); ++i) {
    const MechanismJoint& joint = scene_.mechanism.joints[i];
    if (!is_scalar(joint.kind) || joint.stiffness == 0) continue;
    const double stretch = joint_value_at(scene_, model_, i, state).value - joint.rest;
    energy += 0.5 * joint.stiffness * stretch * stretch;
  }
  return energy;
}

void AppliedEfforts::reset_elements() {
  elements = SceneElements(scene_.elements, model_.layout.v);
}

}  // namespace thenar
