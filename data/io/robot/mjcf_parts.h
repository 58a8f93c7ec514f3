#pragma once

/// Parts of the reader of MJCF, the format of MuJoCo: bodies, drives, loops, geoms.

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
/// an actuator as compliant ones. Uncoupled joints are degrees of freedom of their own; the largest
/// force of an actuator is their effort. Several joints of one body get links without mass between
/// them. The base is the only top body if it is fixed at the world's origin, otherwise a link
/// "world". Joint values are MuJoCo's qpos with the same zero. `warnings` lists what is not read
/// (sites, sensors, closed loops, spatial tendons, planes..).
/// @throws DataError `path:line: ..`
/// Source: [Todorov2012].
[[nodiscard]] RobotSpec read_mjcf(const std::string& path);

namespace internal {

/// Gives the joints of `robot` their degrees of freedom. Joint equalities and equalities of fixed
/// tendons of two joints couple rigidly. A fixed tendon with an actuator gives its joints one
/// compliant degree of freedom, its length L = sum c_i q_i, with q_i = c_i / sum(c^2) L for each,
/// as equal springs would. Efforts come from the actuators.
/// @param ref  value of each joint in the file's own posture, in the order of `robot.joints`
/// @throws DataError
void drive_mjcf(const MjcfSource& source, const std::vector<double>& ref, RobotSpec& robot);

/// Reads the loop closure of a <connect> or <weld>: two places that coincide, in the file's own
/// posture if one is stated (anchor), otherwise at two sites.
/// @param ref  values of the joints in that posture [rad] or [m] (joints)
/// @returns nothing if a body is left out, with a note in `unread`
/// @throws DataError if it names a body or site that does not exist
[[nodiscard]] std::optional<LoopClosure> read_loop(const MjcfSource& source,
                                                   const pugi::xml_node& node,
                                                   const RobotSpec& robot,
                                                   const std::vector<double>& ref);

/// A geom: shape and mass.
struct MjcfGeom {
  std::optional<ShapeSpec> shape;  // nothing: a plane, or a mesh that is missing
  bool collides = true;
  MassProperties mass;
};

/// Meshes of <asset>, by name.
using MjcfMeshes = std::map<std::string, pugi::xml_node>;

/// Finds the meshes of <asset>; other assets are noted.
[[nodiscard]] MjcfMeshes find_meshes(const MjcfSource& source);

/// Reads a geom; contact settings that a material does not have (friction, condim, solref ..) are
/// noted.
/// @param X_BF       frame of the geom in the body
/// @param warnings   gets missing meshes
/// @throws DataError
[[nodiscard]] MjcfGeom read_geom(const MjcfSource& source, const MjcfMeshes& meshes,
                                 const MjcfElement& geom, const Pose<double>& X_BF,
                                 const std::string& body, std::vector<std::string>& warnings);

/// The <inertial> of a body, with the frame of the element in the body.
struct MjcfInertial {
  MjcfElement element;
  Pose<double> X_BF;
};

/// Computes the mass of a body: that of its <inertial> or of its geoms together, as the compiler's
/// settings decide, and at least their lower bound.
/// @throws DataError if an <inertial> that counts has no mass, or not six numbers of a tensor
[[nodiscard]] MassProperties mass_of_body(const MjcfCompiler& compiler,
                                          const std::optional<MjcfInertial>& inertial,
                                          const std::vector<MassProperties>& geoms);

}  // namespace internal
}  // namespace thenar
