#pragma once

/// Conversion of a world in its present state to a scene.

#include <array>
#include <string>

#include "base/enum_names.h"
#include "data/io/world/world.h"
#include "dynamics/scene/build_scene.h"

namespace thenar {

/// Drives that move the hands of a world.
enum class WorldDrives {
  kHold,     // a drive holds every coordinate at its present value
  kTendons,  // as kHold for robots; muscles of human hands pull, initially without tension
  kNone      // no drives: the caller sets efforts
};
inline constexpr std::array kWorldDrivesNames{EnumName{WorldDrives::kHold, "hold"},
                                              EnumName{WorldDrives::kTendons, "tendons"},
                                              EnumName{WorldDrives::kNone, "none"}};

/// Builds a scene at the present state of a world: obstacles and hands are welded to the world or
/// to what carries them, objects are free, steps have a fixed length.
///
/// A holding drive has the coordinate's present value as its target and the effort that balances
/// the hand's own weight as its bias. It reaches its largest effort at 0.1 rad or 10 mm from the
/// target; where that effort is unknown, its stiffness gives the moved mass a natural frequency of
/// 5 Hz. Its damping is critical.
///
/// Where a clutch or springs have let the joints of a motor move apart, the joints keep their
/// values and are rigidly coupled from then on. An object of unknown mass has the density of water.
/// `warnings` state all assumptions.
/// @param world  world; its files are relative to its folder
/// @param data   folder with robots/ ..; empty: the usual ones
/// @throws InputError or DataError as read_scene() and build_scene().
[[nodiscard]] BuiltScene build_world_scene(const WorldSpec& world, const std::string& data,
                                           WorldDrives drives = WorldDrives::kHold);

}  // namespace thenar
