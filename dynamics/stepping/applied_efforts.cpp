#include "dynamics/stepping/applied_efforts.h"

#include <algorithm>
#include <cmath>

#include "dynamics/stepping/scene_contacts.h"

namespace thenar {
namespace {

template <typename Each>
bool resists(const Each& each) {
  return each.stiffness > 0 || each.damping > 0;
}

}  // namespace

AppliedEfforts::AppliedEfforts(const MovingScene& scene, const TreeModel& model)
    : elements(scene.elements, model.layout.v), scene_(scene), model_(model) {
  tau = stiffness = damping = Eigen::VectorXd::Zero(model.layout.v);
  for (std::size_t i = 0; i < scene.mechanism.joints.size(); ++i)
    if (is_scalar(scene.mechanism.joints[i].kind) && resists(scene.mechanism.joints[i]))
      resisting_.push_back(i);
  note_what_acts();
}

void AppliedEfforts::note_what_acts() {
  has_slopes_ = !elements.empty() || !resisting_.empty() ||
                std::any_of(scene_.drives.begin(), scene_.drives.end(), resists<SceneDrive>);
  has_flows_ = !elements.empty() || has_powers(scene_);
}

bool AppliedEfforts::load(SceneMotion& motion, const SceneState& state, ElementNeed need) {
  // Springs and dampers of joints, then drives whose time it is.
  tau.setZero();
  stiffness.setZero();
  damping.setZero();
  add_springs(state);
  for (const SceneDrive& drive : scene_.drives)
    if (drive.when.holds(acting_)) add_drive(drive, state);
  // Loads on bodies.
  TreeMotion<double>& links = motion.links();
  if (!scene_.forces.empty()) links.clear_loads();
  for (const SceneForce& force : scene_.forces) {
    if (!force.when.holds(acting_)) continue;
    links.add_load(links.link_of(force.body), links.pose(force.body) * force.point, force.force,
                   force.moment);
  }
  // Elements.
  if (elements.empty()) return true;
  const bool acted = elements.act(input_at(motion, state, need));
  tau += elements.action().tau;
  return acted;
}

void AppliedEfforts::add_springs(const SceneState& state) {
  for (const std::size_t i : resisting_) {
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
  const auto c = static_cast<std::size_t>(drive.coordinate);
  const int row = model_.layout.coordinate_v[c];
  const double effort =
      drive_effort(drive, state.q[model_.layout.coordinate_q[c]], state.v[row], state.t, acting_);
  tau[row] += effort;
  // At its largest effort it is no spring.
  if (std::abs(effort) >= drive.max_effort) return;
  stiffness[row] += drive.stiffness;
  damping[row] += drive.damping;
}

void AppliedEfforts::advance_states(double h, SceneState& state) const {
  if (elements.empty()) return;
  const ElementAction& action = elements.action();
  state.z.array() += h * action.z_rate.array() / (1 + h * action.z_decay.array());
}

void AppliedEfforts::find_powers(const SceneMotion& motion, const StepEfforts& at) {
  if (!has_flows_) return;
  power.head<kFreeFlows>() << applied_powers(scene_, model_.layout, motion.links(), at),
      elements.passive_power();
}

double AppliedEfforts::spring_energy(const SceneState& state) const {
  double out = 0;
  for (std::size_t i = 0; i < scene_.mechanism.joints.size(); ++i) {
    const MechanismJoint& joint = scene_.mechanism.joints[i];
    if (!is_scalar(joint.kind) || joint.stiffness == 0) continue;
    const double stretch = joint_value_at(scene_, model_, i, state).value - joint.rest;
    out += 0.5 * joint.stiffness * stretch * stretch;
  }
  return out;
}

void AppliedEfforts::forget() { elements = SceneElements(scene_.elements, model_.layout.v); }

}  // namespace thenar
