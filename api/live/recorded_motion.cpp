#include "api/live/recorded_motion.h"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

namespace thenar {
namespace {

constexpr double kShownStep = 1.0 / 240;  // of play [s]

/// The positions a share of the way from one instant to the next.
Eigen::VectorXd positions_between(const Mechanism& mechanism, const MechanismLayout& layout,
                                  const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                  double share) {
  Eigen::VectorXd q = from + share * (to - from);
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const JointKind kind = mechanism.joints[i].kind;
    if (kind != JointKind::kBall && kind != JointKind::kFree) continue;
    const int at = layout.first_q[i];
    const auto turn = [&](const Eigen::VectorXd& of) {
      return Eigen::Quaterniond(of[at], of[at + 1], of[at + 2], of[at + 3]).normalized();
    };
    const Eigen::Quaterniond mean = turn(from).slerp(share, turn(to));
    q.segment<4>(at) << mean.w(), mean.x(), mean.y(), mean.z();
  }
  return q;
}

}  // namespace

RecordedMotion::RecordedMotion(RecordedScene run)
    : run_(std::move(run)),
      picture_(scene_picture(run_.built, run_.camera)),
      model_(tree_model(run_.built.scene.mechanism)),
      t_(run_.samples.front().t) {}

LiveTime RecordedMotion::live_time() const {
  LiveTime out;
  out.t = t_;
  out.step = kShownStep;
  out.playing = playing_;
  out.speed = speed_;
  out.duration = end();
  out.recorded = true;
  return out;
}

MotionQuality RecordedMotion::step(long count, const Progress& /*progress*/) {
  (void)seek(t_ + kShownStep * static_cast<double>(count));
  if (t_ >= end()) playing_ = false;
  MotionQuality out;
  out.steps = count;
  return out;
}

double RecordedMotion::seek(double t) {
  const std::vector<SceneSample>& samples = run_.samples;
  t_ = std::clamp(t, samples.front().t, end());
  const auto behind =
      std::lower_bound(samples.begin(), samples.end(), t_,
                       [](const SceneSample& sample, double time) { return sample.t < time; });
  nearest_ = static_cast<std::size_t>(behind - samples.begin());
  if (nearest_ > 0 && t_ - samples[nearest_ - 1].t < samples[nearest_].t - t_) --nearest_;
  ++changes_;
  return t_;
}

void RecordedMotion::reset() {
  playing_ = false;
  (void)seek(run_.samples.front().t);
}

Eigen::VectorXd RecordedMotion::positions() const {
  const std::vector<SceneSample>& samples = run_.samples;
  const SceneSample& near = nearest();
  const bool before = near.t <= t_;
  const std::size_t other = before ? nearest_ + 1 : nearest_ - 1;  // on the other side of t
  if (near.t == t_ || other >= samples.size()) return near.q;
  const SceneSample &from = before ? near : samples[other], &to = before ? samples[other] : near;
  return positions_between(run_.built.scene.mechanism, model_.layout, from.q, to.q,
                           (t_ - from.t) / (to.t - from.t));
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
                       {t_, q, X_WB, nearest().contacts});
}

TimelineState RecordedMotion::state(const MotionParts& parts) const {
  const Mechanism& mechanism = run_.built.scene.mechanism;
  const SceneSample& near = nearest();
  const Eigen::VectorXd q = positions();
  TimelineState out;
  out.t = t_;
  if (parts.joints)
    for (std::size_t c = 0; c < mechanism.coordinates.size(); ++c)
      out.joints.push_back({mechanism.coordinates[c].name, q[model_.layout.coordinate_q[c]],
                            near.v[model_.layout.coordinate_v[c]], std::nullopt});
  if (parts.bodies) {
    const std::vector<Pose<double>> X_WB = poses(q);
    const std::vector<SceneVelocity> velocities =
        body_velocities(mechanism, model_, near.q, near.v);
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i)
      if (model_.bodies[i].link >= 0 &&
          (mechanism.bodies[i].mass.mass > 0 || mechanism.bodies[i].solid))
        out.bodies.push_back({mechanism.bodies[i].name, X_WB[i], velocities[i]});
  }
  if (parts.contacts) {
    out.contacts = near.contacts;
    for (const MechanismBody& body : mechanism.bodies) out.body_names.push_back(body.name);
  }
  if (parts.energy)
    out.energy = MotionEnergy{near.energy.kinetic, near.energy.weight, near.energy.springs, {}};
  if (parts.muscles)
    for (std::size_t m = 0; m < run_.muscles.size(); ++m)
      out.muscles.push_back(
          {run_.muscles[m], "N",
           run_.tension(static_cast<Eigen::Index>(nearest_), static_cast<Eigen::Index>(m))});
  return out;
}

MotionQuality RecordedMotion::quality() const {
  return {run_.steps, run_.unsolved, run_.worst_residual, run_.deepest};
}

}  // namespace thenar
