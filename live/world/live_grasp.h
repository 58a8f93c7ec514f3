#pragma once

/// Actions of a hand in a live world: open, approach, close, grasp. Each that moves the hand is one
/// edit of the world.

#include <string>

#include "api/grasp.h"
#include "live/world/live_world.h"

namespace thenar {

/// Names of a hand and an object; empty: the only ones.
struct LivePair {
  std::string hand, object;
};

/// A hand and an object in their current poses, and the models for closing the hand. Edits of the
/// world do not change it, and it must not outlive the world.
struct LivePairSetup {
  std::size_t hand, object;        // entries of WorldState::hands and ::bodies
  StateHand state_hand;            // a copy: an edit replaces the state
  const CollisionHand& collision;  // entry of LiveWorld::contact_cache(), which keeps it
  GraspSetup setup;
};

/// Finds a hand and an object by name.
/// @throws InputError if there is no such hand or object, or the hand has no surface
[[nodiscard]] LivePairSetup pair_setup(const LiveWorld& live, const LivePair& pair);

/// Opens a hand: sets its coordinates to the posture in which closing begins. Its carrier stays.
/// @throws InputError if there is no such hand
void open_hand(LiveWorld& live, const std::string& hand);

/// Moves a free hand along its palm's direction until it touches the object or an obstacle, by
/// yielding_approach(), as `thenar grasp` does. A hand that touches nothing, or starts in an
/// overlap, stays.
/// @param distance  longest path, > 0 [m]
/// @return the contact that ended the approach
/// @throws InputError for a mounted hand, or if there is no such hand or object; Stopped
ApproachResult approach_object(LiveWorld& live, const LivePair& pair, double distance,
                               const Progress& progress = {});

/// Closes a hand in its current pose, as `thenar close` does. A hand that starts in an overlap
/// stays.
/// @return outcome, and the cause that stopped each joint
/// @throws InputError if there is no such hand or object; Stopped
HandClosing close_on_object(LiveWorld& live, const LivePair& pair, const Progress& progress = {});

/// Approaches the object and closes the hand, by attempt_grasp(), as `thenar grasp` does. A mounted
/// hand closes without an approach. A hand that misses, or starts in an overlap, stays.
/// @param distance  longest path of the approach, > 0 [m]
/// @throws InputError, Stopped as approach_object()
HandClosing grasp_object(LiveWorld& live, const LivePair& pair, double distance = 1,
                         const Progress& progress = {});

}  // namespace thenar
