#include "geometry/manifold/collision_world.h"

#include <utility>

#include "base/error.h"

namespace thenar {

CollisionWorld::CollisionWorld(std::vector<std::shared_ptr<const CollisionBody>> bodies)
    : bodies_(std::move(bodies)),
      broad_(static_cast<int>(bodies_.size())),
      boxes_(bodies_.size()),
      pairs_(bodies_.size() * bodies_.size()) {
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    require(bodies_[i] != nullptr, "body {} has no collision surface", i);
}

CollisionPair& CollisionWorld::pair_of(const BodyPair& bodies) {
  const auto a = static_cast<std::size_t>(bodies.a), b = static_cast<std::size_t>(bodies.b);
  std::unique_ptr<CollisionPair>& pair = pairs_[a * bodies_.size() + b];
  if (pair == nullptr) pair = std::make_unique<CollisionPair>(bodies_[a], bodies_[b]);
  return *pair;
}

const std::vector<BodyContact>& CollisionWorld::update(const std::vector<Pose<double>>& X_WB,
                                                       double margin) {
  require(X_WB.size() == bodies_.size(), "{} poses for {} bodies", X_WB.size(), bodies_.size());
  // Enlarge each box by half of the margin.
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    boxes_[i] = world_box(*bodies_[i], X_WB[i], margin / 2);
  contacts_.clear();
  near_pairs_ = 0;
  for (const BodyPair& near : broad_.update(boxes_)) {
    ++near_pairs_;
    const ContactManifold& manifold = pair_of(near).update(X_WB[near.a], X_WB[near.b], margin);
    if (!manifold.empty()) contacts_.push_back({near.a, near.b, &manifold});
  }
  return contacts_;
}

}  // namespace thenar
