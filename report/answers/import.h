#pragma once

/// Content of a robot, an object, a world or a mesh of another format.

#include <string>

#include "api/import.h"
#include "report/fields.h"

namespace thenar {

/// Returns a text with numbers and short lists as lines, then nested parts, then warnings.
[[nodiscard]] std::string text_of(const Imported& imported);
/// Returns fields of an import. For robots: counts, mass, leaves at zero, links, joints, degrees of
/// freedom. For bodies: material, mass, shapes. For worlds: hands and bodies with their places. For
/// meshes: whether they are closed and where not, box, volume, centre, and inertia about the centre
/// at density 1, "inertia_m5" [m^5]. Always: warnings.
[[nodiscard]] Fields fields_of(const Imported& imported);

}  // namespace thenar
