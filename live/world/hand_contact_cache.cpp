#include "live/world/hand_contact_cache.h"

#include <algorithm>

#include "base/error.h"
#include "grasp/closing/grasp.h"

namespace thenar {

bool may_touch(const StateHand& hand, const StateBody& body, double within) {
  // Compute the poses of the links and the centre of the body's ball.
  const std::vector<Ball>& balls = hand.built->balls;
  const std::vector<LinkSurface>& surfaces = hand.built->model().surfaces();
  const std::vector<Pose<double>> links = hand.built->model().pose(hand.placement.q);
  const Ball& other = body.built->ball;
  const Eigen::Vector3d centre = body.X_WB * other.c;
  // Compare distances of centres with radii.
  for (std::size_t s = 0; s < balls.size(); ++s) {
    const int link = surfaces[s].link;
    const Eigen::Vector3d in_hand = link < 0 ? balls[s].c : links[link] * balls[s].c;
    if ((hand.placement.X_WH * in_hand - centre).norm() <= balls[s].r + other.r + within)
      return true;
  }
  return false;
}

const CollisionHand& HandContactCache::collision_of(const WorldState& state,
                                                    const StateHand& hand) {
  const auto found = models_.find(hand.built.get());
  if (found != models_.end() && found->second.header == state.header)
    return found->second.collision;
  Model model{hand.built, state.header,
              collision_hand(hand.built->model(), state.header->materials)};
  return models_.insert_or_assign(hand.built.get(), std::move(model)).first->second.collision;
}

void HandContactCache::update_setups(const WorldState& state) {
  // Rebuild the setups if bodies or materials have changed.
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
  // Set the poses of the bodies.
  for (std::size_t b = 0; b < setups_.size(); ++b) setups_[b].object.X_WB = state.bodies[b].X_WB;
}

std::vector<HandContact> HandContactCache::contacts_of_pair(const WorldState& state,
                                                            const StateHand& hand,
                                                            const GraspSetup& setup) {
  const PosedCollisionHand posed{collision_of(state, hand), hand.placement.X_WH,
                                 hand.built->model().pose(hand.placement.q)};
  try {
    return find_contacts(posed, setup);
  } catch (const InputError&) {
    return {};  // no coefficient of friction for this pair, see current_contacts()
  }
}

const std::vector<HandObjectContacts>& HandContactCache::contacts(const WorldState& state,
                                                                  unsigned long changes) {
  if (has_contacts_ && contacts_changes_ == changes) return contacts_;
  update_setups(state);
  contacts_.clear();
  // Find the contacts of all pairs whose balls come within the tolerance of contact patches.
  const double within = ContactPatchOptions{}.tolerance;
  for (std::size_t h = 0; h < state.hands.size(); ++h)
    for (std::size_t b = 0; b < state.bodies.size(); ++b) {
      if (!state.bodies[b].built->placed.dynamic || state.hands[h].built->balls.empty() ||
          !may_touch(state.hands[h], state.bodies[b], within))
        continue;
      std::vector<HandContact> contacts = contacts_of_pair(state, state.hands[h], setups_[b]);
      if (!contacts.empty()) contacts_.push_back({h, b, std::move(contacts)});
    }
  has_contacts_ = true;
  contacts_changes_ = changes;
  return contacts_;
}

}  // namespace thenar
