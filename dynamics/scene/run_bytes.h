#pragma once

/// Serialization of scene runs, for other processes of the same program.

#include <string>

#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// Serializes a run; every double keeps its bits.
///
/// Numbers are written in their memory representation without padding; lists begin with their
/// count (8 bytes):
///
///   status
///   samples:   t, q, v, z, energy flows, contacts, energies
///     contacts:  members of ContactSample, in the order of pass_contact()
///   cost:      members of SceneCost, in the order of pass_cost()
///   message:   letters
///
/// The format has no version and no fixed byte order: it is meant for processes of one sweep on one
/// machine (sweep_scene()). Files of runs are HDF5 (write_scene_run()).
[[nodiscard]] std::string bytes_of(const SceneRun& run);

/// Restores a run from bytes_of(). Counts are checked against the number of bytes before memory is
/// allocated.
/// @throws InputError if there are too few or too many bytes.
[[nodiscard]] SceneRun run_from_bytes(const std::string& bytes);

}  // namespace thenar
