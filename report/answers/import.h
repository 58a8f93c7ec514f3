#pragma once

/// What a robot, an object, a world or a mesh of another format holds.

#include <string>

#include "api/import.h"
#include "report/json.h"

namespace thenar {

/// Numbers and short lists as lines, then what lies deeper, then the warnings.
[[nodiscard]] std::string text_of(const Imported& imported);
/// Of robots counts, mass, leaves at zero, links, joints, degrees of freedom; of bodies material,
/// mass, shapes; of worlds hands and bodies with their places; of meshes whether they are closed
/// and where not, box, volume, centre, and inertia about it at density 1, "inertia_m5" [m^5].
/// Warnings.
[[nodiscard]] OrderedJson json_of(const Imported& imported);

}  // namespace thenar
