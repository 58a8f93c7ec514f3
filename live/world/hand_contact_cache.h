#pragma once

/// Contacts of the hands of a live world with its objects, computed once for each state.

#include <map>
#include <memory>
#include <vector>

#include "grasp/closing/collision_hand.h"
#include "grasp/contact/contact.h"
#include "live/world/world_state.h"

namespace thenar {

/// Contacts of a hand with an object.
struct HandObjectContacts {
  std::size_t hand = 0, body = 0;     // entries of WorldState::hands and ::bodies
  std::vector<HandContact> contacts;  // hard point contacts in the object's frame
};

/// Cache of the collision models of hands and of the contacts of the last state. Caching affects
/// computing time only, never a result.
class HandContactCache {
 public:
  /// Returns the contacts of all hands with all objects. Pairs of materials without a friction
  /// coefficient are left out; current_contacts() throws for them.
  /// @param changes  number that differs for each state
  [[nodiscard]] const std::vector<HandObjectContacts>& contacts(const WorldState& state,
                                                                unsigned long changes);

  /// Returns the collision model of a hand; builds it on first use.
  [[nodiscard]] const CollisionHand& collision_of(const WorldState& state, const StateHand& hand);

 private:
  struct Model {
    std::shared_ptr<const LiveHand> hand;     // keeps the hand alive for its collision model
    std::shared_ptr<const WorldSpec> header;  // world whose materials the model was built with
    CollisionHand collision;
  };
  [[nodiscard]] std::vector<HandContact> contacts_of_pair(const WorldState& state,
                                                          const StateHand& hand,
                                                          const GraspSetup& setup);
  /// Rebuilds setups_ if the bodies have changed, and sets their poses.
  void update_setups(const WorldState& state);

  std::map<const LiveHand*, Model> models_;
  std::vector<std::shared_ptr<const BuiltBody>> bodies_;  // bodies that setups_ were built from
  std::vector<GraspSetup> setups_;                        // one for each body, without obstacles
  std::shared_ptr<const WorldSpec> header_;               // world whose materials setups_ have
  std::vector<HandObjectContacts> contacts_;
  unsigned long contacts_changes_ = 0;  // value of `changes` that contacts_ belong to
  bool has_contacts_ = false;
};

/// Returns true if the bounding balls of a hand's surfaces come within a distance of a body's ball.
/// @param within  distance [m]
[[nodiscard]] bool may_touch(const StateHand& hand, const StateBody& body, double within);

}  // namespace thenar
