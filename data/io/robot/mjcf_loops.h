#pragma once

/// What <connect> and <weld> of MJCF hold together.

#include <optional>
#include <vector>

#include "data/io/robot/close_loops.h"
#include "data/io/robot/mjcf_source.h"

namespace pugi {
class xml_node;
}

namespace thenar::internal {

/// The two places that an equality holds together, in the file's own posture where it names them
/// once (anchor), else at two sites.
/// @param ref  values of the joints in that posture [rad] or [m] (joints)
/// @return none where a body is left out, which is in `unread` then
/// @throws DataError if it names a body or site that there is not
[[nodiscard]] std::optional<LoopClosure> read_loop(const MjcfSource& source,
                                                   const pugi::xml_node& node,
                                                   const RobotSpec& robot,
                                                   const std::vector<double>& ref);

}  // namespace thenar::internal
