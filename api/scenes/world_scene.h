#pragma once

/// A world as it stands, as a scene that moves.

#include <array>
#include <string>

#include "base/enum_names.h"
#include "data/io/world/world.h"
#include "dynamics/scene/build_scene.h"

namespace thenar {

/// Drives that move the hands of a world.
enum class WorldDrives {
  kHold,     // every coordinate is held where it stands by a drive
  kTendons,  // drives of robots as above; muscles of human hands pull, at first without tension
  kNone      // nothing: efforts are given from outside
};
inline constexpr std::array kWorldDrivesNames{EnumName{WorldDrives::kHold, "hold"},
                                              EnumName{WorldDrives::kTendons, "tendons"},
                                              EnumName{WorldDrives::kNone, "none"}};

/// Builds a scene at the present state of a world: obstacles and hands are welded to the world or
/// to what carries them, objects are free, steps have a fixed length.
///
/// A drive that holds has the coordinate's target where it stands, the effort that bears the hand's
/// own weight there as its bias, and at 0.1 rad or 10 mm from its target its largest effort; where
/// that is unknown, the stiffness by which what it moves swings at 5 Hz. It damps critically.
///
/// Of a robot whose clutch or springs have let the joints of a motor go apart, the joints go on
/// from where they stand, rigidly coupled. An object of unknown mass weighs as much as water of its
/// volume. `warnings` say all that was assumed.
/// @param world  whose folder its files are relative to
/// @param data   folder with robots/ ..; empty: the usual ones
/// @throws InputError or DataError as read_scene() and build_scene() for what does not fit.
[[nodiscard]] BuiltScene build_world_scene(const WorldSpec& world, const std::string& data,
                                           WorldDrives drives = WorldDrives::kHold);

}  // namespace thenar
