#pragma once

/// Contacts, joint limits and dry friction of a scene at a state.

#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "dynamics/stepping/scene_motion.h"
#include "geometry/manifold/collision_world.h"

namespace thenar {

/// Value and rate of a joint at a state.
[[nodiscard]] JointValue joint_value_at(const MovingScene& scene, const TreeModel& model,
                                        std::size_t joint, const SceneState& state);

/// Finds what touches in a scene. Pairs of bodies remember their contacts.
class SceneContacts {
 public:
  /// @param scene, model  outlive it
  SceneContacts(const MovingScene& scene, const TreeModel& model);

  /// Returns whether some bodies may touch: then motions are placed before find().
  [[nodiscard]] bool may_touch() const { return may_touch_; }

  /// Finds all contacts within the margin, joint limits within it, and dry frictions.
  /// @param motion  placed at the state, where bodies may touch
  void find(const SceneMotion& motion, const SceneState& state, double margin,
            std::vector<ActiveContact>& out);

  /// Sum of the largest displacements of two bodies over half the thinner one's thickness, the
  /// largest of all pairs that could have met between two states: ContactStep::motion_between()
  /// [1].
  [[nodiscard]] double motion_between(SceneMotion& motion, const SceneState& from,
                                      const SceneState& to,
                                      const std::vector<ActiveContact>& touching);

  /// Twice the largest speed of a point of a body, if the speeds were v [m/s].
  [[nodiscard]] double fastest(SceneMotion& motion, const Eigen::VectorXd& v) const;

  /// Farthest distance of a body from the origin at the last find(), or `least` [m].
  [[nodiscard]] double extent(double least) const;

  /// Goes back to a world in which no pair has met yet.
  void forget() { set_world(world_->bodies()); }

 private:
  void set_world(std::vector<std::shared_ptr<const CollisionBody>> bodies);
  void find_contacts(const TreeMotion<double>& links, double margin,
                     std::vector<ActiveContact>& out);
  void find_joint(std::size_t i, const SceneState& state, double margin,
                  std::vector<ActiveContact>& out) const;
  [[nodiscard]] double displacement(std::size_t i) const;
  [[nodiscard]] bool press(const std::vector<ActiveContact>& touching, std::size_t i,
                           std::size_t j) const;

  const MovingScene& scene_;
  const TreeModel& model_;
  std::vector<int> body_of_;  // of the collision world's bodies
  std::unique_ptr<CollisionWorld> world_;
  std::vector<Pose<double>> X_WB_, X_before_;
  std::vector<double> way_;     // of collision bodies [m]
  std::vector<bool> may_meet_;  // (bodies x bodies)
  bool may_touch_ = false;      // some of them
};

}  // namespace thenar
