#pragma once

/// Common parts of requests about worlds: the world of the session, places, names, bytes.

#include <optional>
#include <string>

#include "base/spatial.h"
#include "live/world/live_grasp.h"
#include "live/world/live_world.h"
#include "live/world/world_edits.h"
#include "questions/schema.h"
#include "server/session.h"

namespace thenar::internal {

/// The world that is open. @throws InputError if none is, saying what opens one
[[nodiscard]] LiveWorld& live_world(Session& session);
/// The world that is open, or else an empty one, opened; it is shown.
LiveWorld& open_live_world(Session& session);

/// Most characters of a name, and of a path.
inline constexpr std::size_t kNameLength = 300, kPathLength = kMaxOutsidePath;
inline constexpr double kFarthest = 1000;  // of a position [m]

/// Returns the schema of a place: "position" and "rotation" of a request; each may be left out.
[[nodiscard]] SchemaMember position_member();
[[nodiscard]] SchemaMember rotation_member();
/// "hand" and "object": names, which may be left out where there is only one.
[[nodiscard]] SchemaMember hand_member();
[[nodiscard]] SchemaMember object_member();
/// "gesture": moves of one thing that name the same one are undone together.
[[nodiscard]] SchemaMember gesture_member();

/// Returns "hand" and "object" of a request.
[[nodiscard]] LivePair pair_param(const Json& params);
/// A text; "" where it is left out.
[[nodiscard]] std::string text_param(const Json& params, const std::string& name);
/// A position [m] (3), or a rotation, made exact (3, 3); nothing where it is left out.
[[nodiscard]] std::optional<Eigen::Vector3d> position_param(const Json& params);
[[nodiscard]] std::optional<Eigen::Matrix3d> rotation_param(const Json& params);
/// Returns the position and rotation of a thing that is added.
[[nodiscard]] WantedPlace place_param(const Json& params);

/// Bytes of a text in base64 (RFC 4648, padded). @throws InputError where it is none
[[nodiscard]] std::string from_base64(const std::string& text);

}  // namespace thenar::internal
