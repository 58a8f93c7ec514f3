#pragma once

/// Edits of a live world: what is added, removed, placed, and how joints are set. Each can be
/// undone; one that throws leaves the world as it was. Moves of one thing that name the same
/// gesture, one right after the other, are undone together: a drag, a slider, a key that is held.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "live/world/live_world.h"

namespace thenar {

/// Thing that was added.
struct AddedThing {
  std::string name;                   // as other requests name it
  std::vector<std::string> warnings;  // what was assumed, mended or left out
};

/// Pose at which a thing is to be added.
struct WantedPlace {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  // of its frame (3, 3)
  std::optional<Eigen::Vector3d> position = {};     // absent: the origin, or beside what is there,
                                                    // see free_place() [m] (3)
};

/// Adds an object, or an obstacle that never moves.
/// @param object  a file (TOML, GraspIt! XML, or a mesh, which is written into the world), or the
///                name of one of objects/
/// @throws InputError, DataError where it is not to be found or wrong, or of unknown material
AddedThing add_object(LiveWorld& live, const std::string& object, bool dynamic,
                      const WantedPlace& place);

/// Adds a body that was read. @param placed  its name and pose may change
AddedThing add_body(LiveWorld& live, PlacedBody placed, const WantedPlace& place);

/// Adds a hand, open, by a name or a file as hand_by_name() takes it. A robot that is there already
/// gets a number after its name; the built-in human hand can be there once in each version.
/// @throws InputError, DataError as build_live_hand()
AddedThing add_hand(LiveWorld& live, const std::string& hand, const WantedPlace& place,
                    const Progress& progress = {});

/// Removes an object, an obstacle or a hand, which must not carry another.
/// @throws InputError if there is none of that name
void remove_thing(LiveWorld& live, const std::string& name);

/// Puts an object, an obstacle, a free hand, or what carries hands, somewhere else.
/// @param position  stays where it is if left out [m] (3);  @param R  the same (3, 3)
/// @param gesture   of which the move is a part; empty: it stands alone
/// @throws InputError if there is none of that name, or it is mounted, saying on what
void place_thing(LiveWorld& live, const std::string& name,
                 const std::optional<Eigen::Vector3d>& position,
                 const std::optional<Eigen::Matrix3d>& R, const std::string& gesture = "");

/// Result of setting joints.
struct SetJoints {
  std::map<std::string, double> joints;  // all of the hand [rad] or [m]
  std::vector<std::string> limited;      // those that came to rest at a limit before their target
  std::vector<std::string> parted;       // of the hand: not where the leader of their drive takes
                                         // them, as where a clutch has opened
};

/// Sets joints of a hand, within their limits. A joint that is named alone of its drive moves all
/// joints of the drive, in the ratio of their gears; several that are named stand where they are
/// told to, and the others go with the first of the drive if that is among them.
/// @param hand     name; empty: the only one
/// @param gesture  of which the move is a part; empty: it stands alone
/// @throws InputError for a joint that the hand has not, with the nearest name
SetJoints set_joints(LiveWorld& live, const std::string& hand,
                     const std::map<std::string, double>& joints, const std::string& gesture = "");

/// All joints of a hand. @param hand  of WorldState::hands
[[nodiscard]] std::map<std::string, double> joints_of(const WorldState& state, std::size_t hand);

}  // namespace thenar
