#pragma once

/// Actions of a hand in a live world: open, approach, close, grasp.

#include <string>
#include <vector>

#include "api/grasp.h"
#include "live/world/live_world.h"

namespace thenar {

/// Names of a hand and an object; empty: the only ones.
struct LivePair {
  std::string hand, object;
};

/// Such a pair as it stands, and the collision model of the hand.
struct LiveMeeting {
  std::size_t hand, object;  // of WorldState
  const StateHand& stands;
  const CollisionHand& collision;
  GraspSetup setup;
};

/// @throws InputError if there is no such hand or object, or the hand has no surface
[[nodiscard]] LiveMeeting meeting_of(const LiveWorld& live, const LivePair& pair);

/// Opens a hand: its coordinates go where closing begins; what carries it stays. One edit.
/// @throws InputError if there is no such hand
void open_hand(LiveWorld& live, const std::string& hand);

/// Moves a free hand along its palm's direction until it meets the object or an obstacle, digits
/// giving way, as `thenar grasp` does. A hand that meets nothing, or begins in something, stays.
/// @param distance  longest way [m], > 0
/// @return  what it met
/// @throws InputError for a mounted hand, or if there is no such hand or object; Stopped
ApproachResult approach_object(LiveWorld& live, const LivePair& pair, double distance,
                               const Progress& progress = {});

/// Closes a hand where it stands, as `thenar close` does.
/// @return  outcome, and what stopped each joint; a hand that begins in something stays
/// @throws InputError if there is no such hand or object; Stopped
HandClosing close_on_object(LiveWorld& live, const LivePair& pair, const Progress& progress = {});

/// Approaches and closes, as `thenar grasp` does: an object between jaws of which one touches first
/// makes the hand give way. A mounted hand closes where it is. One that misses, or begins in
/// something, stays.
/// @throws InputError, Stopped as approach_object()
HandClosing grasp_object(LiveWorld& live, const LivePair& pair, double distance = 1,
                         const Progress& progress = {});

}  // namespace thenar
