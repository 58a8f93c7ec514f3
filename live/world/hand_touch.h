#pragma once

/// Contacts of the hands of a live world with its objects, found only where they are near.

#include <map>
#include <memory>
#include <vector>

#include "grasp/closing/collision_hand.h"
#include "grasp/contact/contact.h"
#include "live/world/world_state.h"

namespace thenar {

/// A hand that touches an object.
struct HandTouches {
  std::size_t hand = 0, body = 0;     // of WorldState
  std::vector<HandContact> contacts;  // in the object's frame, hard points
};

/// Collision models of hands and the contacts of the last state that was asked about. What it
/// remembers changes time, never an answer.
class HandTouch {
 public:
  /// All contacts of hands with objects. Pairs whose materials have no friction are left out:
  /// touching_pair() says so of them.
  /// @param changes  a number that is another one whenever the state is
  [[nodiscard]] const std::vector<HandTouches>& contacts(const WorldState& state,
                                                         unsigned long changes);

  /// The collision model of a hand, built when it is first asked for.
  [[nodiscard]] const CollisionHand& collision_of(const WorldState& state, const StateHand& hand);

 private:
  struct Model {
    std::shared_ptr<const LiveHand> hand;     // outlives its collision model
    std::shared_ptr<const WorldSpec> header;  // whose materials it was built with
    CollisionHand collision;
  };
  [[nodiscard]] std::vector<HandContact> contacts_of_pair(const WorldState& state,
                                                          const StateHand& hand,
                                                          const GraspSetup& setup);
  void take_bodies(const WorldState& state);

  std::map<const LiveHand*, Model> models_;
  std::vector<std::shared_ptr<const BuiltBody>> bodies_;  // that `setups_` were made of
  std::vector<GraspSetup> setups_;           // of each body, the object alone; posed when asked
  std::shared_ptr<const WorldSpec> header_;  // whose materials they have
  std::vector<HandTouches> found_;
  unsigned long found_at_ = 0;
  bool has_found_ = false;
};

/// Returns true if any surface of a hand may be within a distance of a body, by balls around them.
[[nodiscard]] bool may_touch(const StateHand& hand, const StateBody& body, double within);

}  // namespace thenar
