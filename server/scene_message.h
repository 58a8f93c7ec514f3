#pragma once

/// Messages to watching clients: the scene that frames refer to, and the state of the session.

#include <cstddef>
#include <string>

#include "live/live_picture.h"
#include "report/json.h"
#include "server/mesh_store.h"
#include "server/session.h"

namespace thenar {

/// Returns the constant parts of a picture: {"revision", "mode", "up", "eye", "target" [m],
/// "bodies", "joints", "lines", "arrows", "clouds"}, with entries in the order of frames. Meshes
/// are given by their ids.
/// @param meshes  store to which the meshes are added
[[nodiscard]] OrderedJson scene_message(const LiveShape& shape, unsigned long revision,
                                        LiveMode mode, MeshStore& meshes);

/// Returns the message of the scene that is shown; an empty scene if nothing is shown.
[[nodiscard]] OrderedJson scene_message(Session& session);

/// Returns the state of a session: {"mode", "world": {"name", "file", "unsaved"}, "undo", "redo",
/// "motion": null or {"t" [s], "playing", "speed" [1], "duration" [s], "recorded", "shown"},
/// "busy", "clients"}.
/// @param clients  number of connected clients
[[nodiscard]] OrderedJson state_message(const Session& session, std::size_t clients);

}  // namespace thenar
