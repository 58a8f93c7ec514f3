#pragma once

/// Messages to watching clients: the scene that frames move, and the state of the session.

#include <cstddef>
#include <string>

#include "live/live_picture.h"
#include "report/json.h"
#include "server/mesh_store.h"
#include "server/session.h"

namespace thenar {

/// All of a shape that never moves: {"revision", "mode", "up", "eye", "target" [m], "bodies",
/// "joints", "lines", "arrows", "clouds"}, entries in the order of frames. Meshes are named by
/// their ids.
/// @param mode    "world"
/// @param meshes  that the shape's meshes are added to
[[nodiscard]] OrderedJson scene_message(const LiveShape& shape, unsigned long revision,
                                        const std::string& mode, MeshStore& meshes);

/// Returns the message of the scene that is shown now; an empty scene if nothing is shown.
[[nodiscard]] OrderedJson scene_message(Session& session);

/// {"mode", "world": {"name", "file", "unsaved"}, "undo", "redo", "motion": null or {"t" [s],
/// "playing", "speed" [1], "duration" [s], "recorded"}, "busy", "clients"}.
/// @param clients  how many there are
[[nodiscard]] OrderedJson state_message(const Session& session, std::size_t clients);

}  // namespace thenar
