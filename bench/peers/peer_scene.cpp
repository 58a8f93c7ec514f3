#include "bench/peers/peer_scene.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "dynamics/mechanism/tree_motion.h"

namespace thenar::bench {
namespace {

/// Frame of a joint in the world, on its parent.
Pose<double> frame_on_parent(const MechanismJoint& joint, const std::vector<BodyMotion>& bodies) {
  if (joint.parent < 0) return joint.X_PF;
  return bodies[static_cast<std::size_t>(joint.parent)].X_WB * joint.X_PF;
}

/// Velocity of a point that moves with a body.
Eigen::Vector3d point_velocity(const Mechanism& mechanism, int body, const Eigen::Vector3d& p_W,
                               const std::vector<BodyMotion>& bodies) {
  if (body < 0) return Eigen::Vector3d::Zero();
  const BodyMotion& motion = bodies[static_cast<std::size_t>(body)];
  const Eigen::Vector3d com =
      motion.X_WB * mechanism.bodies[static_cast<std::size_t>(body)].mass.com;
  return motion.linear + motion.angular.cross(p_W - com);
}

bool finite(const std::vector<BodyMotion>& bodies) {
  return std::all_of(bodies.begin(), bodies.end(), [](const BodyMotion& body) {
    return body.X_WB.p.allFinite() && body.X_WB.R.allFinite();
  });
}

}  // namespace

PeerRun run_world(PeerWorld& world, const PeerScene& scene, double step) {
  PeerRun run;
  run.samples.push_back({0, world.motion()});
  const long steps = std::lround(scene.seconds / step);
  const long every = std::max(1L, std::lround(scene.sample / step));
  for (long done = 0; done < steps;) {
    const double start = thread_seconds();
    const long until = std::min(steps, done + every);
    for (; done < until; ++done) world.step();
    run.cpu_seconds += thread_seconds() - start;
    run.samples.push_back({step * static_cast<double>(done), world.motion()});
    if (!finite(run.samples.back().bodies)) run.message = "not finite";
    if (run.cpu_seconds > kPatience) run.message = "too slow";
    if (!run.message.empty()) break;
  }
  return run;
}

void check_peer_scene(const PeerScene& peer) {
  const MovingScene& scene = peer.scene;
  check_scene(scene);
  std::vector<int> users(scene.mechanism.coordinates.size(), 0);
  for (const MechanismJoint& joint : scene.mechanism.joints) {
    const bool fixed = joint.kind == JointKind::kWeld && joint.parent < 0;
    require(is_scalar(joint.kind) || joint.kind == JointKind::kFree || fixed,
            "joint '{}' of scene '{}' is not for every engine", joint.name, peer.name);
    if (!is_scalar(joint.kind)) continue;
    require(joint.ratio == 1 && joint.offset == 0 && joint.curve.empty() && joint.friction == 0 &&
                ++users[static_cast<std::size_t>(joint.coordinate)] == 1,
            "the coordinate of joint '{}' of scene '{}' is not its value", joint.name, peer.name);
  }
  for (const SceneDrive& drive : scene.drives)
    require(std::isinf(drive.max_effort) && drive.when.from == 0 && std::isinf(drive.when.to),
            "a drive of scene '{}' has a limit", peer.name);
  require(scene.forces.empty(), "scene '{}' has forces", peer.name);
  require(scene.friction_pairs.empty() && scene.friction.torsion_radius == 0 &&
              scene.friction.restitution == 0,
          "scene '{}' has more than one coefficient of friction", peer.name);
}

std::vector<BodyMotion> motion_at(const MovingScene& scene, const Eigen::VectorXd& q,
                                  const Eigen::VectorXd& v) {
  const TreeModel model = tree_model(scene.mechanism);
  TreeMotion<double> tree(model);
  tree.set_position(q);
  tree.set_speed(v);
  std::vector<BodyMotion> out(scene.mechanism.bodies.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const int link = model.bodies[i].link;
    out[i].X_WB = tree.pose(static_cast<int>(i));
    if (link < 0) continue;
    out[i].linear = tree.velocity(link, out[i].X_WB * scene.mechanism.bodies[i].mass.com);
    out[i].angular = tree.links()[static_cast<std::size_t>(link)].w;
  }
  return out;
}

JointMotion joint_motion(const Mechanism& mechanism, std::size_t i,
                         const std::vector<BodyMotion>& bodies) {
  const MechanismJoint& joint = mechanism.joints[i];
  const Pose<double> X_WF = frame_on_parent(joint, bodies);
  const Pose<double> X_FM = X_WF.inverse() * bodies[i].X_WB * joint.X_BM;
  const Eigen::Vector3d axis = X_WF.R.col(2);
  if (joint.kind == JointKind::kHinge) {
    Eigen::Vector3d w = bodies[i].angular;
    if (joint.parent >= 0) w -= bodies[static_cast<std::size_t>(joint.parent)].angular;
    return {std::atan2(X_FM.R(1, 0), X_FM.R(0, 0)), axis.dot(w)};
  }
  const Eigen::Vector3d p_W = bodies[i].X_WB * joint.X_BM.p;
  const Eigen::Vector3d u = point_velocity(mechanism, static_cast<int>(i), p_W, bodies) -
                            point_velocity(mechanism, joint.parent, p_W, bodies);
  return {X_FM.p.z(), axis.dot(u)};
}

double joint_effort(const MovingScene& scene, std::size_t i, double t, const JointMotion& motion) {
  const MechanismJoint& joint = scene.mechanism.joints[i];
  double effort = -joint.stiffness * (motion.value - joint.rest) - joint.damping * motion.rate;
  for (const SceneDrive& drive : scene.drives)
    if (drive.coordinate == joint.coordinate)
      effort += drive_effort(drive, motion.value, motion.rate, t, t);
  return effort;
}

bool effort_varies(const MovingScene& scene, std::size_t i) {
  const MechanismJoint& joint = scene.mechanism.joints[i];
  return joint.stiffness != 0 || joint.damping != 0 ||
         std::any_of(scene.drives.begin(), scene.drives.end(), [&](const SceneDrive& drive) {
           return drive.coordinate == joint.coordinate &&
                  (drive.stiffness != 0 || drive.damping != 0);
         });
}

std::vector<ShapeSpec> shapes_of(const MechanismBody& body) {
  std::vector<ShapeSpec> shapes;
  if (body.solid)
    for (const SolidPart& part : body.solid->parts) shapes.push_back(part.spec);
  return shapes;
}

bool may_touch(const MovingScene& scene, std::size_t a, std::size_t b) {
  const std::vector<MechanismJoint>& joints = scene.mechanism.joints;
  const auto fixed = [&](std::size_t i) { return joints[i].kind == JointKind::kWeld; };
  const auto hangs_on = [&](std::size_t i, std::size_t on) {
    if (joints[i].kind == JointKind::kFree) return false;
    return joints[i].parent == static_cast<int>(on);
  };
  const auto is_excluded = [&](std::size_t i, std::size_t j) {
    return std::count(scene.excluded_pairs.begin(), scene.excluded_pairs.end(),
                      std::pair<int, int>(static_cast<int>(i), static_cast<int>(j))) > 0;
  };
  return !(fixed(a) && fixed(b)) && !hangs_on(a, b) && !hangs_on(b, a) && !is_excluded(a, b) &&
         !is_excluded(b, a);
}

}  // namespace thenar::bench
