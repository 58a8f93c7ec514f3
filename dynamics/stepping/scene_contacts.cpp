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
  // Collision bodies of all bodies with a surface.
  std::vector<std::shared_ptr<const CollisionBody>> bodies;
  for (std::size_t i = 0; i < scene.mechanism.bodies.size(); ++i) {
    const std::shared_ptr<const Solid>& solid = scene.mechanism.bodies[i].solid;
    if (!solid) continue;
    bodies.push_back(collision_body(*solid));
    body_of_.push_back(static_cast<int>(i));
  }
  X_WB_.resize(body_of_.size());
  X_before_.resize(body_of_.size());
  way_.resize(body_of_.size());
  may_meet_.assign(body_of_.size() * body_of_.size(), false);
  // Pairs that may meet; the collision world leaves out all others.
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

void SceneContacts::find(const SceneMotion& motion, const SceneState& state, double margin,
                         std::vector<ActiveContact>& out) {
  out.clear();
  if (may_touch_) find_contacts(motion.links(), margin, out);
  for (std::size_t i = 0; i < scene_.mechanism.joints.size(); ++i)
    find_joint(i, state, margin, out);
}

void SceneContacts::find_contacts(const TreeMotion<double>& links, double margin,
                                  std::vector<ActiveContact>& out) {
  // Points of the manifolds, with velocities of a against b.
  for (std::size_t i = 0; i < body_of_.size(); ++i) X_WB_[i] = links.pose(body_of_[i]);
  for (const BodyContact& pair : world_->update(X_WB_, margin))
    for (const ManifoldPoint& point : *pair.manifold) {
      ActiveContact contact;
      contact.a = body_of_[static_cast<std::size_t>(pair.a)];
      contact.b = body_of_[static_cast<std::size_t>(pair.b)];
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

void SceneContacts::find_joint(std::size_t i, const SceneState& state, double margin,
                               std::vector<ActiveContact>& out) const {
  // Value and rate of a hinge or slide.
  const MechanismJoint& joint = scene_.mechanism.joints[i];
  if (!is_scalar(joint.kind)) return;
  const JointValue at = joint_value_at(scene_, model_, i, state);
  const double rate = at.slope * state.v[model_.layout.first_v[i]];
  // Limits within the margin, and dry friction.
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

/// Largest displacement of a point of a collision body between two poses.
double SceneContacts::displacement(std::size_t i) const {
  const Ball& ball = world_->bodies()[i]->ball;
  return (X_WB_[i] * ball.c - X_before_[i] * ball.c).norm() +
         (X_WB_[i].R - X_before_[i].R).norm() * ball.r;
}

/// Returns whether two collision bodies press on each other.
bool SceneContacts::press(const std::vector<ActiveContact>& touching, std::size_t i,
                          std::size_t j) const {
  return std::any_of(touching.begin(), touching.end(), [&](const ActiveContact& contact) {
    return contact.kind == Kind::kContact && contact.a == body_of_[i] && contact.b == body_of_[j] &&
           contact.mode != ContactMode::kOpen;
  });
}

double SceneContacts::motion_between(SceneMotion& motion, const SceneState& from,
                                     const SceneState& to,
                                     const std::vector<ActiveContact>& touching) {
  const std::size_t n = body_of_.size();
  if (n < 2) return 0;
  // Displacement of each body between the two states.
  motion.move_to(from.q);
  for (std::size_t i = 0; i < n; ++i) X_before_[i] = motion.links().pose(body_of_[i]);
  motion.move_to(to.q);
  for (std::size_t i = 0; i < n; ++i) X_WB_[i] = motion.links().pose(body_of_[i]);
  for (std::size_t i = 0; i < n; ++i) way_[i] = displacement(i);
  // Motion of each pair over half the thinner body's thickness; the largest counts.
  double most = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const double moved = way_[i] + way_[j];
      const double over =
          2 * moved / std::min(world_->bodies()[i]->thickness, world_->bodies()[j]->thickness);
      if (over <= most || !may_meet_[i * n + j]) continue;
      // Balls that stay apart cannot have met.
      const Ball &a = world_->bodies()[i]->ball, &b = world_->bodies()[j]->ball;
      const double apart = (X_before_[i] * a.c - X_before_[j] * b.c).norm() - a.r - b.r;
      if (apart < moved && !press(touching, i, j)) most = over;
    }
  return most;
}

double SceneContacts::fastest(SceneMotion& motion, const Eigen::VectorXd& v) const {
  // Speed of a body's bounding ball: that of its centre, and its turn at the rim.
  motion.speed_up(v);
  const TreeMotion<double>& links = motion.links();
  double most = 0;
  for (std::size_t i = 0; i < body_of_.size(); ++i) {
    const int link = links.link_of(body_of_[i]);
    if (link < 0) continue;
    const Ball& ball = world_->bodies()[i]->ball;
    const Eigen::Vector3d centre = links.pose(body_of_[i]) * ball.c;
    most = std::max(most, links.velocity(link, centre).norm() +
                              links.links()[static_cast<std::size_t>(link)].w.norm() * ball.r);
  }
  return 2 * most;
}

double SceneContacts::extent(double least) const {
  double size = least;
  for (const Pose<double>& X : X_WB_) size = std::max(size, X.p.norm());
  return size;
}

}  // namespace thenar
