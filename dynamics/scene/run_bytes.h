#pragma once

/// Runs of scenes as bytes, for other processes of the same program.

#include <string>

#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// A whole run, every double to the bit.
///
/// Numbers stand as they do in memory, one after the other and without gaps; lists begin with their
/// count (8 bytes):
///
///   status
///   samples:   t, q, v, z, contacts, kinetic energy, weight, springs, energy of elements
///     contacts:  a, b, id, point, normal, force, torsion, gap, mode
///   cost:      counts, then the largest residual, depth, time at rest, processor time
///   message:   letters
///
/// There is no version and no order of bytes: what is written is to be read by the same program on
/// the same kind of machine, at once: processes of one sweep do so (sweep_scene()). Files of runs
/// are HDF5 (write_scene_run()).
[[nodiscard]] std::string bytes_of(const SceneRun& run);

/// The inverse of bytes_of(). A count that promises more than there are bytes asks for no memory.
/// @throws InputError if the bytes are cut short, or go on behind the run.
[[nodiscard]] SceneRun run_of_bytes(const std::string& bytes);

}  // namespace thenar
