#pragma once

/// What `thenar import` tells of a robot, a body, a world or a mesh.

#include <string>

#include <nlohmann/json.hpp>

#include "data/io/robot/import_robot.h"
#include "data/io/world/world.h"

namespace thenar {

/// Counts, mass, leaves at zero, links, joints, degrees of freedom, warnings.
[[nodiscard]] nlohmann::ordered_json report(const RobotSpec& robot, RobotFileKind kind);

/// Name, material, mass, shapes, warnings.
[[nodiscard]] nlohmann::ordered_json report(const BodySpec& body, const std::string& kind,
                                            const std::vector<std::string>& warnings);

/// Hands and bodies with their places, warnings.
[[nodiscard]] nlohmann::ordered_json report(const WorldSpec& world, const std::string& kind,
                                            const std::vector<std::string>& warnings);

/// Vertices, triangles, whether it is closed and where not, box, volume, centre; inertia about it
/// at density 1, "inertia_m5" [m^5].
[[nodiscard]] nlohmann::ordered_json report(const TriangleMesh& mesh, const std::string& name);

/// Puts the exact shapes of a mesh file into the report of its triangles: "exact_shapes", and their
/// volume, centre, inertia and warnings in place of those of the triangles. If there are none, does
/// nothing.
void tell_exact(nlohmann::ordered_json& report, const TriangleMesh& mesh,
                const std::vector<ShapeSpec>& exact);

/// A report as lines for people: numbers and short lists, then what lies deeper, then the warnings.
[[nodiscard]] std::string report_text(const nlohmann::ordered_json& report);

}  // namespace thenar
