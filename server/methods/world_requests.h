#pragma once

/// Common parts of requests about worlds: the world of the session, poses, names, bytes.

#include <optional>
#include <string>

#include "base/spatial.h"
#include "live/world/live_grasp.h"
#include "live/world/live_world.h"
#include "live/world/world_edits.h"
#include "questions/schema.h"
#include "server/session.h"

namespace thenar::internal {

/// Returns the open world. @throws InputError naming the methods that open one, if there is none
[[nodiscard]] LiveWorld& live_world(Session& session);
/// Returns the open world, or opens an empty one, and shows it.
LiveWorld& open_live_world(Session& session);

/// Largest lengths of a name and of a path [bytes].
inline constexpr std::size_t kMaxNameLength = 300, kMaxPathLength = kMaxOutsidePath;
/// Largest magnitude of a coordinate of a position [m].
inline constexpr double kMaxCoordinate = 1000;

/// Returns the optional members "position" and "rotation" of a request.
[[nodiscard]] SchemaMember position_member();
[[nodiscard]] SchemaMember rotation_member();
/// Returns the members "hand" and "object", names that are optional if there is only one.
[[nodiscard]] SchemaMember hand_member();
[[nodiscard]] SchemaMember object_member();
/// Returns the member "gesture": consecutive moves of one thing with one gesture are undone
/// together.
[[nodiscard]] SchemaMember gesture_member();

/// Reads "hand" and "object".
[[nodiscard]] LivePair pair_param(const Json& params);
/// Reads a text; "" if it is missing.
[[nodiscard]] std::string text_param(const Json& params, const std::string& name);
/// Reads "position" [m] (3); empty if it is missing.
[[nodiscard]] std::optional<Eigen::Vector3d> position_param(const Json& params);
/// Reads "rotation", normalised (3, 3); empty if it is missing.
[[nodiscard]] std::optional<Eigen::Matrix3d> rotation_param(const Json& params);
/// Reads "position" and "rotation" of a new thing.
[[nodiscard]] RequestedPose pose_param(const Json& params);

/// Decodes base64 (RFC 4648, padded). @throws InputError for invalid text
[[nodiscard]] std::string from_base64(const std::string& text);

}  // namespace thenar::internal
