#pragma once

/// Edits of a live world: adding, removing and placing things, setting joints. Each edit can be
/// undone; an edit that throws leaves the world unchanged. Consecutive moves of one thing with the
/// same gesture (a drag, a slider, a held key) are undone together.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "live/world/live_world.h"

namespace thenar {

/// Object, obstacle or hand that was added to a world.
struct AddedThing {
  std::string name;                   // name in the world
  std::vector<std::string> warnings;  // assumptions, repairs and omissions
};

/// Pose that is requested for a new thing.
struct RequestedPose {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  // rotation of its frame (3, 3)
  std::optional<Eigen::Vector3d> position = {};     // absent: free_position() [m] (3)
};

/// Adds an object, or an obstacle that never moves.
/// @param object   name in objects/, or a file: TOML, GraspIt! XML, or a mesh, which is embedded in
///                 the world
/// @param dynamic  false: an obstacle
/// @throws InputError, DataError if it is not found, invalid, or of unknown material
AddedThing add_object(LiveWorld& live, const std::string& object, bool dynamic,
                      const RequestedPose& place);

/// Adds a body. @param placed  body; gets a free name and the requested pose
AddedThing add_body(LiveWorld& live, PlacedBody placed, const RequestedPose& place);

/// Adds an open hand. A second robot of the same name gets a number after its name; the built-in
/// human hand can be added once in each version.
/// @param hand  name or file, as for hand_by_name()
/// @throws InputError, DataError as build_live_hand()
AddedThing add_hand(LiveWorld& live, const std::string& hand, const RequestedPose& place,
                    const Progress& progress = {});

/// Removes an object, an obstacle or a hand that carries no other hand.
/// @throws InputError if there is no such thing, or the hand carries another
void remove_thing(LiveWorld& live, const std::string& name);

/// Moves an object, an obstacle, a free hand or a carrier of hands.
/// @param position  new position; absent: unchanged [m] (3)
/// @param R         new rotation; absent: unchanged (3, 3)
/// @param gesture   gesture that the move belongs to; empty: none
/// @throws InputError if there is no such thing, or if it is a mounted hand
void place_thing(LiveWorld& live, const std::string& name,
                 const std::optional<Eigen::Vector3d>& position,
                 const std::optional<Eigen::Matrix3d>& R, const std::string& gesture = "");

/// Result of set_joints().
struct JointChange {
  std::map<std::string, double> joints;  // all joints of the hand [rad] or [m]
  std::vector<std::string> limited;      // joints that stopped at a limit before their target
  std::vector<std::string> parted;  // joints away from the position that their coupling implies,
                                    // as after a clutch has opened
};

/// Sets joints of a hand, within their limits. If one joint of a drive is named, all joints of the
/// drive follow with the ratio of their gears. If several are named, each takes its own value, and
/// the unnamed ones follow the leading joint if that is named.
/// @param hand     name of the hand; empty: the only one
/// @param joints   joint -> value [rad] or [m]
/// @param gesture  gesture that the change belongs to; empty: none
/// @throws InputError for an unknown joint, with the nearest name
JointChange set_joints(LiveWorld& live, const std::string& hand,
                       const std::map<std::string, double>& joints,
                       const std::string& gesture = "");

/// Returns all joints of a hand [rad] or [m]. @param hand  entry of WorldState::hands
[[nodiscard]] std::map<std::string, double> joints_of(const WorldState& state, std::size_t hand);

}  // namespace thenar
