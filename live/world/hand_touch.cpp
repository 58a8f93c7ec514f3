#include "live/world/hand_touch.h"

#include <algorithm>

#include "base/error.h"
#include "grasp/closing/grasp.h"

namespace thenar {

bool may_touch(const StateHand& hand, const StateBody& body, double within) {
  // Compare bounding balls first, because exact distances between surfaces are slow.
  const std::vector<Ball>& balls = hand.built->balls;
  const std::vector<LinkSurface>& surfaces = hand.built->model().surfaces();
  const std::vector<Pose<double>> links = hand.built->model().pose(hand.stand.q);
  const Ball& other = body.built->ball;
  const Eigen::Vector3d there = body.X_WB * other.c;
  for (std::size_t s = 0; s < balls.size(); ++s) {
    const int link = surfaces[s].link;
    const Eigen::Vector3d in_hand = link < 0 ? balls[s].c : links[link] * balls[s].c;
    if ((hand.stand.X_WH * in_hand - there).norm() <= balls[s].r + other.r + within) return true;
  }
  return false;
}

const CollisionHand& HandTouch::collision_of(const WorldState& state, const StateHand& hand) {
  const auto found = models_.find(hand.built.get());
  if (found != models_.end() && found->second.header == state.header)
    return found->second.collision;
  Model model{hand.built, state.header,
              collision_hand(hand.built->model(), state.header->materials)};
  return models_.insert_or_assign(hand.built.get(), std::move(model)).first->second.collision;
}

void HandTouch::take_bodies(const WorldState& state) {
  // The same bodies as before: only their poses are new.
  const bool same =
      header_ == state.header && bodies_.size() == state.bodies.size() &&
      std::equal(bodies_.begin(), bodies_.end(), state.bodies.begin(),
                 [](const auto& built, const StateBody& body) { return built == body.built; });
  if (!same) {
    setups_.clear();
    bodies_.clear();
    header_ = state.header;
    for (const StateBody& body : state.bodies) {
      bodies_.push_back(body.built);
      setups_.push_back({body.built->body, {}, state.header->materials});
    }
  }
  for (std::size_t b = 0; b < setups_.size(); ++b) setups_[b].object.X_WB = state.bodies[b].X_WB;
}

std::vector<HandContact> HandTouch::contacts_of_pair(const WorldState& state, const StateHand& hand,
                                                     const GraspSetup& setup) {
  const PosedCollisionHand posed{collision_of(state, hand), hand.stand.X_WH,
                                 hand.built->model().pose(hand.stand.q)};
  try {
    return find_contacts(posed, setup);
  } catch (const InputError&) {
    return {};  // no friction is known of the pair, which whoever asks for contacts is told
  }
}

const std::vector<HandTouches>& HandTouch::contacts(const WorldState& state,
                                                    unsigned long changes) {
  if (has_found_ && found_at_ == changes) return found_;
  take_bodies(state);
  found_.clear();
  // Look as far as the tolerance of contact patches, and not beyond.
  const double within = ContactPatchOptions{}.tolerance;
  for (std::size_t h = 0; h < state.hands.size(); ++h)
    for (std::size_t b = 0; b < state.bodies.size(); ++b) {
      if (!state.bodies[b].built->placed.dynamic || state.hands[h].built->balls.empty() ||
          !may_touch(state.hands[h], state.bodies[b], within))
        continue;
      std::vector<HandContact> contacts = contacts_of_pair(state, state.hands[h], setups_[b]);
      if (!contacts.empty()) found_.push_back({h, b, std::move(contacts)});
    }
  has_found_ = true;
  found_at_ = changes;
  return found_;
}

}  // namespace thenar
