#include "dynamics/stepping/scene_contacts.h"

#include <algorithm>

#include "dynamics/stepping/meeting_pairs.h"

namespace thenar {
namespace {

using Kind = ActiveContact::Kind;

}  // namespace

JointValue joint_value_at(const MovingScene& scene, const TreeModel& model, std::size_t joint,
                          const SceneState& state) {
  return joint_value(scene.mechanism.joints[joint], state.q[model.layout.first_q[joint]]);
}

SceneContacts::SceneContacts(const MovingScene& scene, const TreeModel& model)
    : scene_(scene), model_(model) {
  // Build collision bodies of all bodies with a surface.
  std::vector<std::shared_ptr<const CollisionBody>> bodies;
  for (std::size_t i = 0; i < scene.mechanism.bodies.size(); ++i) {
    const std::shared_ptr<const Solid>& solid = scene.mechanism.bodies[i].solid;
    if (!solid) continue;
    bodies.push_back(collision_body(*solid));
    body_of_.push_back(static_cast<int>(i));
  }
  X_WB_.resize(body_of_.size());
  X_before_.resize(body_of_.size());
  displacements_.resize(body_of_.size());
  may_meet_.assign(body_of_.size() * body_of_.size(), false);
  // Mark the pairs that may meet; the collision world excludes all others.
  const std::vector<std::pair<int, int>> pairs = pairs_that_may_meet(scene, model);
  for (std::size_t i = 0; i < body_of_.size(); ++i)
    for (std::size_t j = i + 1; j < body_of_.size(); ++j)
      if (std::binary_search(pairs.begin(), pairs.end(), std::pair(body_of_[i], body_of_[j])))
        may_touch_ = may_meet_[i * body_of_.size() + j] = true;
  set_world(std::move(bodies));
}

void SceneContacts::set_world(std::vector<std::shared_ptr<const CollisionBody>> bodies) {
  world_ = std::make_unique<CollisionWorld>(std::move(bodies));
  for (std::size_t i = 0; i < body_of_.size(); ++i)
    for (std::size_t j = i + 1; j < body_of_.size(); ++j)
      if (!may_meet_[i * body_of_.size() + j])
        world_->exclude(static_cast<int>(i), static_cast<int>(j));
}

void SceneContacts::find_contacts(const SceneMotion& motion, const SceneState& state, double margin,
                                  std::vector<ActiveContact>& out) {
  out.clear();
  if (may_touch_) add_body_contacts(motion.links(), margin, out);
  for (std::size_t i = 0; i < scene_.mechanism.joints.size(); ++i)
    add_joint_contacts(i, state, margin, out);
}

void SceneContacts::add_body_contacts(const TreeMotion<double>& links, double margin,
                                      std::vector<ActiveContact>& out) {
  // Convert the points of all manifolds, with velocities of a relative to b.
  for (std::size_t i = 0; i < body_of_.size(); ++i) X_WB_[i] = links.pose(body_of_[i]);
  for (const BodyContact& pair : world_->update(X_WB_, margin))
    for (const ManifoldPoint& point : *pair.manifold) {
      ActiveContact contact;
      contact.a = body_of_[pair.a];
      contact.b = body_of_[pair.b];
      contact.id = point.id;
      contact.feature = point.feature;
      contact.point = 0.5 * (point.on_a + point.on_b);
      contact.normal = point.normal;
      contact.gap = point.gap;
      contact.friction = pair_friction(scene_, contact.a, contact.b);
      const Eigen::Vector3d u = links.velocity(links.link_of(contact.a), contact.point) -
                                links.velocity(links.link_of(contact.b), contact.point);
      contact.approach = u.dot(contact.normal);
      contact.slip = (u - contact.approach * contact.normal).norm();
      out.push_back(contact);
    }
}

void SceneContacts::add_joint_contacts(std::size_t i, const SceneState& state, double margin,
                                       std::vector<ActiveContact>& out) const {
  // Evaluate the value and rate of a hinge or slide.
  const MechanismJoint& joint = scene_.mechanism.joints[i];
  if (!is_scalar(joint.kind)) return;
  const JointValue at = joint_value_at(scene_, model_, i, state);
  const double rate = at.slope * state.v[model_.layout.first_v[i]];
  // Add limits within the margin, and dry friction.
  const auto add = [&](Kind kind, double gap, double approach) {
    if (!(gap <= margin)) return;
    ActiveContact limit;
    limit.kind = kind;
    limit.a = static_cast<int>(i);
    limit.gap = gap;
    limit.approach = approach;
    out.push_back(limit);
  };
  add(Kind::kLowerLimit, at.value - joint.lower, rate);
  add(Kind::kUpperLimit, joint.upper - at.value, -rate);
  if (joint.friction > 0) add(Kind::kJointFriction, 0, rate);
}

/// Bounds the displacement of any point of a collision body between two poses [m].
double SceneContacts::max_displacement(std::size_t i) const {
  const Ball& ball = world_->bodies()[i]->ball;
  return (X_WB_[i] * ball.c - X_before_[i] * ball.c).norm() +
         (X_WB_[i].R - X_before_[i].R).norm() * ball.r;
}

/// Returns true if two collision bodies have a closed contact.
bool SceneContacts::are_pressed(const std::vector<ActiveContact>& touching, std::size_t i,
                                std::size_t j) const {
  return std::any_of(touching.begin(), touching.end(), [&](const ActiveContact& contact) {
    return contact.kind == Kind::kContact && contact.a == body_of_[i] && contact.b == body_of_[j] &&
           contact.mode != ContactMode::kOpen;
  });
}

double SceneContacts::tunnelling_ratio(SceneMotion& motion, const SceneState& from,
                                       const SceneState& to,
                                       const std::vector<ActiveContact>& touching) {
  const std::size_t n = body_of_.size();
  if (n < 2) return 0;
  // Bound the displacement of each body between the two states.
  motion.set_position(from.q);
  for (std::size_t i = 0; i < n; ++i) X_before_[i] = motion.links().pose(body_of_[i]);
  motion.set_position(to.q);
  for (std::size_t i = 0; i < n; ++i) X_WB_[i] = motion.links().pose(body_of_[i]);
  for (std::size_t i = 0; i < n; ++i) displacements_[i] = max_displacement(i);
  // Find the largest motion of a pair over half the thinner body's thickness.
  double max_ratio = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const double moved = displacements_[i] + displacements_[j];
      const double ratio =
          2 * moved / std::min(world_->bodies()[i]->thickness, world_->bodies()[j]->thickness);
      if (ratio <= max_ratio || !may_meet_[i * n + j]) continue;
      // Skip pairs whose bounding balls stay apart, and those in contact.
      const Ball &a = world_->bodies()[i]->ball, &b = world_->bodies()[j]->ball;
      const double apart = (X_before_[i] * a.c - X_before_[j] * b.c).norm() - a.r - b.r;
      if (apart < moved && !are_pressed(touching, i, j)) max_ratio = ratio;
    }
  return max_ratio;
}

double SceneContacts::max_relative_speed(SceneMotion& motion, const Eigen::VectorXd& v) const {
  // Add the speed of a bounding ball's centre and that of its surface about the centre.
  motion.set_speeds(v);
  const TreeMotion<double>& links = motion.links();
  double max_speed = 0;
  for (std::size_t i = 0; i < body_of_.size(); ++i) {
    const int link = links.link_of(body_of_[i]);
    if (link < 0) continue;
    const Ball& ball = world_->bodies()[i]->ball;
    const Eigen::Vector3d centre = links.pose(body_of_[i]) * ball.c;
    max_speed = std::max(
        max_speed, links.velocity(link, centre).norm() + links.links()[link].w.norm() * ball.r);
  }
  return 2 * max_speed;
}

double SceneContacts::extent(double min_extent) const {
  double size = min_extent;
  for (const Pose<double>& X : X_WB_) size = std::max(size, X.p.norm());
  return size;
}

}  // namespace thenar
