#pragma once

/// A URDF made fit for urdfdom, which refuses much that real files hold and drops much silently.

#include <string>
#include <vector>

#include "data/io/robot/import_xml.h"

namespace thenar::internal {

/// Beginning of the name that a capsule's mesh gets, which urdfdom knows nothing of:
/// "capsule:RADIUS LENGTH".
inline constexpr const char* kCapsule = "capsule:";

/// Checks every number and name with its line; takes out what is not read, noting it; fills in what
/// urdfdom insists on and has a plain default (effort, velocity, products of inertia).
/// @return the text for urdfdom
/// @throws DataError `path:line: ..`
[[nodiscard]] std::string prepare_urdf(const XmlFile& file, Unread& unread);

}  // namespace thenar::internal
