#include "live/recorded_motion.h"

#include <utility>

#include <Eigen/Geometry>

#include "base/lists.h"
#include "base/numbers.h"

namespace thenar {
namespace {

std::vector<double> times_of(const std::vector<SceneSample>& samples) {
  return transformed(samples, [&](const SceneSample& sample) { return sample.t; });
}

/// Interpolates the positions between two instants. @param fraction  0: from, 1: to
Eigen::VectorXd positions_between(const MechanismLayout& layout, const Eigen::VectorXd& from,
                                  const Eigen::VectorXd& to, double fraction) {
  // Interpolate all positions linearly.
  Eigen::VectorXd q = from + fraction * (to - from);
  // Replace the quaternions of ball and free joints by slerp.
  for (const int i : layout.quaternion_joints) {
    const int k = layout.first_q[i];
    const auto rotation = [&](const Eigen::VectorXd& p) {
      return Eigen::Quaterniond(p[k], p[k + 1], p[k + 2], p[k + 3]).normalized();
    };
    const Eigen::Quaterniond between = rotation(from).slerp(fraction, rotation(to));
    q.segment<4>(k) << between.w(), between.x(), between.y(), between.z();
  }
  return q;
}

}  // namespace

RecordedMotion::RecordedMotion(RecordedScene run)
    : RecordedTimeline(times_of(run.samples)),
      run_(std::move(run)),
      picture_(scene_picture(run_.built, run_.camera)),
      model_(tree_model(run_.built.scene.mechanism)) {
  // Find the recorded tension of each drawn muscle; -1: not recorded.
  for (const std::string& muscle : picture_.tendons.muscles())
    tension_of_.push_back(place_in(run_.muscles, muscle));
}

Eigen::VectorXd RecordedMotion::tension() const {
  Eigen::VectorXd out =
      Eigen::VectorXd::Constant(static_cast<Eigen::Index>(tension_of_.size()), kNaN);
  if (run_.muscles.empty()) return out;
  const Eigen::VectorXd recorded = interpolated(run_.tension);
  for (std::size_t m = 0; m < tension_of_.size(); ++m)
    if (tension_of_[m] >= 0) out[m] = recorded[tension_of_[m]];
  return out;
}

Eigen::VectorXd RecordedMotion::positions() const {
  const Interpolation at = interpolation();
  const Eigen::VectorXd& from = run_.samples[at.from].q;
  if (at.from == at.to) return from;
  return positions_between(model_.layout, from, run_.samples[at.to].q, at.fraction);
}

Eigen::VectorXd RecordedMotion::speeds() const {
  const Interpolation at = interpolation();
  const Eigen::VectorXd& from = run_.samples[at.from].v;
  return at.from == at.to ? from : from + at.fraction * (run_.samples[at.to].v - from);
}

MotionEnergy RecordedMotion::energy() const {
  using Energy = decltype(SceneSample::energy);
  const auto energy_part = [&](double Energy::*part) {
    return interpolated_number([&](std::size_t i) { return run_.samples[i].energy.*part; });
  };
  MotionEnergy out;
  out.kinetic = energy_part(&Energy::kinetic);
  out.weight = energy_part(&Energy::weight);
  out.springs = energy_part(&Energy::springs);
  out.total = out.kinetic + out.weight + out.springs;
  return out;
}

std::vector<Pose<double>> RecordedMotion::poses(const Eigen::VectorXd& q) const {
  TreeMotion<double> motion(model_);
  motion.set_position(q);
  std::vector<Pose<double>> out;
  for (std::size_t i = 0; i < model_.bodies.size(); ++i)
    out.push_back(motion.pose(static_cast<int>(i)));
  return out;
}

LiveInstant RecordedMotion::instant() const {
  const Eigen::VectorXd q = positions();
  const std::vector<Pose<double>> X_WB = poses(q);
  return scene_instant(picture_, run_.built.scene, model_.layout,
                       {shown_time(), q, X_WB, nearest_sample().contacts, tension()});
}

TimelineState RecordedMotion::state(const MotionParts& parts) const {
  const Mechanism& mechanism = run_.built.scene.mechanism;
  const Eigen::VectorXd q = positions(), v = speeds();
  TimelineState out;
  out.t = shown_time();
  // Fill joints and bodies from interpolated positions and speeds; efforts are not recorded.
  if (parts.joints)
    for (std::size_t c = 0; c < mechanism.coordinates.size(); ++c)
      out.joints.push_back({mechanism.coordinates[c].name, q[model_.layout.coordinate_q[c]],
                            v[model_.layout.coordinate_v[c]], std::nullopt});
  if (parts.bodies) {
    const std::vector<Pose<double>> X_WB = poses(q);
    const std::vector<SceneVelocity> velocities = body_velocities(mechanism, model_, q, v);
    for (const std::size_t i : moving_bodies(mechanism, model_))
      out.bodies.push_back({mechanism.bodies[i].name, X_WB[i], velocities[i]});
  }
  // Fill the contacts of the nearest instant, and interpolated energies and tensions.
  if (parts.contacts) {
    out.contacts = nearest_sample().contacts;
    out.body_names = names_of(mechanism.bodies);
  }
  if (parts.energy) out.energy = energy();
  if (parts.muscles && !run_.muscles.empty()) {
    const Eigen::VectorXd tensions = interpolated(run_.tension);
    for (std::size_t m = 0; m < run_.muscles.size(); ++m)
      out.muscles.push_back({run_.muscles[m], "N", tensions[m]});
  }
  return out;
}

MotionQuality RecordedMotion::quality() const {
  MotionQuality out;
  out.steps = run_.steps;
  out.unsolved = run_.unsolved;
  out.worst_residual = run_.worst_residual;
  out.deepest = run_.deepest;
  out.balance = run_.balance;
  out.limits = run_.limits;
  if (run_.built.options.method == SteppingMethod::kTimeStepping)
    out.restitution = max_restitution(run_.built.scene);
  return out;
}

}  // namespace thenar
