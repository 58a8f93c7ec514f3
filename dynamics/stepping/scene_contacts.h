#pragma once

/// Search for contacts, joint limits and dry frictions of a scene at a state.

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "dynamics/stepping/scene_motion.h"
#include "geometry/manifold/collision_world.h"

namespace thenar {

/// Returns the value of a hinge or slide at a state, and its derivatives by the coordinate.
[[nodiscard]] JointValue joint_value_at(const MovingScene& scene, const TreeModel& model,
                                        std::size_t joint, const SceneState& state);

/// Contact search of a scene. Pairs of bodies keep their manifolds between searches.
class SceneContacts {
 public:
  /// @param scene, model  must outlive the object
  SceneContacts(const MovingScene& scene, const TreeModel& model);

  /// Returns true if some bodies may touch; find_contacts() then needs the links' motion.
  [[nodiscard]] bool may_touch() const { return may_touch_; }

  /// Finds all contacts and joint limits within a margin, and all dry frictions.
  /// @param motion  set to the state if may_touch()
  /// @param margin  largest gap [m], [rad];  @param out  replaced
  void find_contacts(const SceneMotion& motion, const SceneState& state, double margin,
                     std::vector<ActiveContact>& out);

  /// Computes the largest displacement of a pair of bodies between two states over half the thinner
  /// body's thickness [1]: ContactStep::tunnelling_ratio().
  [[nodiscard]] double tunnelling_ratio(SceneMotion& motion, const SceneState& from,
                                        const SceneState& to,
                                        const std::vector<ActiveContact>& touching);

  /// Computes an upper bound of the relative speed of two bodies' points at velocities v: twice the
  /// largest speed of a bounding ball's surface [m/s].
  [[nodiscard]] double max_relative_speed(SceneMotion& motion, const Eigen::VectorXd& v) const;

  /// Returns the largest distance of a body from the world's origin at the last find_contacts(), at
  /// least `min_extent` [m].
  [[nodiscard]] double extent(double min_extent) const;

  /// Clears the manifolds of all pairs.
  void reset_pairs() { set_world(world_->bodies()); }

 private:
  void set_world(std::vector<std::shared_ptr<const CollisionBody>> bodies);
  void add_body_contacts(const TreeMotion<double>& links, double margin,
                         std::vector<ActiveContact>& out);
  void add_joint_contacts(std::size_t i, const SceneState& state, double margin,
                          std::vector<ActiveContact>& out) const;
  [[nodiscard]] double max_displacement(std::size_t i) const;
  [[nodiscard]] bool are_pressed(const std::vector<ActiveContact>& touching, std::size_t i,
                                 std::size_t j) const;

  const MovingScene& scene_;
  const TreeModel& model_;
  std::vector<int> body_of_;  // body of the mechanism (collision bodies)
  std::unique_ptr<CollisionWorld> world_;
  std::vector<Pose<double>> X_WB_, X_before_;  // poses now and before (collision bodies)
  std::vector<double> displacements_;          // largest displacement [m] (collision bodies)
  std::vector<bool> may_meet_;                 // pairs that may touch (collision bodies squared)
  bool may_touch_ = false;                     // at least one pair may touch
};

}  // namespace thenar
