#pragma once

/// Robots from MJCF, the format of MuJoCo.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "data/io/robot/close_loops.h"
#include "data/io/robot/mjcf_source.h"
#include "data/io/robot/robot.h"
#include "geometry/shape_mass.h"
#include "geometry/shape_spec.h"

namespace thenar {

/// Reads an MJCF model: bodies, inertials (or masses from geoms), joints, geoms, defaults, included
/// files; joint equalities and equalities of fixed tendons as rigid couplings, fixed tendons with
/// an actuator as compliant ones. Joints that nothing couples are degrees of freedom of their own;
/// the largest force of an actuator becomes their effort. Several joints of a body get links
/// without mass between them. The base is the one body on top if it stands at the world's origin
/// and does not move, else a link "world". Joint values are MuJoCo's qpos: zero is zero. What is
/// not read (sites, sensors, closed loops, spatial tendons, planes..) is in `warnings`.
/// @throws DataError `path:line: ..`
/// Source: [Todorov2012].
[[nodiscard]] RobotSpec read_mjcf(const std::string& path);

}  // namespace thenar

namespace thenar::internal {

// What couples and drives the joints of an MJCF model.

/// Gives the joints of `robot` their degrees of freedom: joint equalities and equalities of fixed
/// tendons of two joints couple rigidly; a fixed tendon with an actuator gives the joints it spans
/// one compliant degree of freedom, its length L = sum c_i q_i, each with q_i = c_i / sum(c^2) L,
/// what equal springs would do. Efforts come from the actuators.
/// @param ref  of each joint, its value in the file's own posture, in the order of `robot.joints`
/// @throws DataError
void drive_mjcf(const MjcfSource& source, const std::vector<double>& ref, RobotSpec& robot);

}  // namespace thenar::internal

namespace pugi {

// What <connect> and <weld> of MJCF hold together.
class xml_node;
}  // namespace pugi

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

// Geoms of MJCF: shapes and what they weigh.

struct MjcfGeom {
  std::optional<ShapeSpec> shape;  // none: a plane, or a mesh that is missing
  bool collides = true;
  MassProperties mass;
};

/// The meshes of <asset>, by name.
using MjcfMeshes = std::map<std::string, pugi::xml_node>;
[[nodiscard]] MjcfMeshes find_meshes(const MjcfSource& source);

/// Settings of contact that a material does not tell (friction, condim, solref ..) are noted.
/// @param X_BF       frame that the geom is given in
/// @param warnings   gets what is missing
/// @throws DataError
[[nodiscard]] MjcfGeom read_geom(const MjcfSource& source, const MjcfMeshes& meshes,
                                 const pugi::xml_node& node, const std::string& childclass,
                                 const Pose<double>& X_BF, const std::string& body,
                                 std::vector<std::string>& warnings);

}  // namespace thenar::internal
